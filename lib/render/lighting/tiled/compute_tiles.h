#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "render/lighting/lighting_bindings.h"
#include "render/lighting/lighting_technique.h"

#include <cstdint>

namespace candela {

/// The technique `tiles` on a GPU, all in compute: boxes of the tiles' surfaces, count, prefix sum and fill
/// of the lists, shading. Nothing about the lists comes back to the CPU in the frame. When the lists outgrow
/// their buffer, the tiles that do not fit walk all lights in that frame (the picture is the same), and the
/// next frame finds a larger buffer.
class ComputeTiles final : public LightingTechnique {
  public:
    ComputeTiles();
    ComputeTiles(const ComputeTiles&) = delete;
    ComputeTiles& operator=(const ComputeTiles&) = delete;
    ~ComputeTiles() override;

    bool overwritesRadiance() const override { return true; }
    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;
    std::uint64_t lightListBytes() const override;

  private:
    struct Grid {
        GLuint columns, rows;
        std::size_t tiles() const { return std::size_t{columns} * rows; }
    };
    static Grid gridOf(const LightingInputs& inputs);
    /// Grows the lists to what the last frame that has ended by now needed; does not wait for it.
    void growLists();
    void bindStorage(const Grid& grid, const LightCounts& counts);
    void shade(const LightingInputs& inputs) const;
    void scatter(const gl::Program& program, const LightCounts& counts) const;

    gl::Program boxes_, count_, prefix_, fill_;
    ModelPrograms shade_;
    gl::Buffer boxBuffer_, countBuffer_, startBuffer_, listBuffer_, totalBuffer_, groupBuffer_,
        readbackBuffer_;
    GLsync totalCopied_ = nullptr;
};

}  // namespace candela
