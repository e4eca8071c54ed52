#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "render/lighting/lighting_technique.h"

#include <cstdint>

namespace candela {

/// The technique `tiles` on a GPU, all in compute: boxes of the tiles' surfaces, count, prefix sum and fill
/// of the lists, shading. The frame never waits for the lists' length. Where the lists outgrow their buffer,
/// the tiles that do not fit iterate over all lights in that frame (the picture is the same), and a later
/// frame has a larger buffer, or shades the lights in several spans where the buffer is as large as it may
/// be.
class ComputeTiles final : public LightingTechnique {
  public:
    static constexpr std::size_t defaultListBytes = std::size_t{1} << 30;

    /// The buffer of the lists grows to `maxListBytes` and to what the device allows for a storage block.
    explicit ComputeTiles(std::size_t maxListBytes = defaultListBytes, LightsPerInvocation limit = {});
    ComputeTiles(const ComputeTiles&) = delete;
    ComputeTiles& operator=(const ComputeTiles&) = delete;
    ~ComputeTiles() override;

    LoadOp radianceLoadOp() const override { return LoadOp::dontCare; }
    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;
    std::uint64_t lightListBytes() const override;

    /// Into how many spans the lights of the next frame fall.
    std::uint32_t spanCount() const { return spans_; }

  private:
    struct Grid {
        GLuint columns, rows;
        std::size_t tiles() const { return std::size_t{columns} * rows; }
    };
    /// Point and spot lights whose lists are in the buffer at a time.
    struct LightSpan {
        int first, end;
        int count() const { return end - first; }
    };

    static Grid gridOf(const LightingInputs& inputs);
    LightSpan spanOf(std::uint32_t index, const LightCounts& counts) const;
    /// Adapts the buffer and the spans to the lists of the last frame that has ended; does not wait for it.
    void adaptLists();
    void growLists(std::size_t bytes);
    void bindStorage(const Grid& grid, const LightingInputs& inputs);
    void findBoxes(const Grid& grid) const;
    void fillLists(const LightSpan& span, int partLights) const;
    void shade(const LightingInputs& inputs, const LightSpan& span) const;
    void scatter(const gl::Program& program, const LightSpan& span) const;
    void copyTotal();

    gl::Program boxes_, count_, prefix_, fill_;
    ModelPrograms shade_;     ///< Overwrites the radiance target.
    ModelPrograms addLight_;  ///< Adds to what it holds.
    gl::Buffer boxBuffer_, countBuffer_, startBuffer_, listBuffer_, totalBuffer_, groupBuffer_,
        readbackBuffer_;
    std::size_t maxListBytes_;
    LightsPerInvocation limit_;
    std::uint32_t spans_ = 1;
    GLsync totalCopied_ = nullptr;
};

}  // namespace candela
