#pragma once

#include "render/lighting/lighting_technique.h"
#include "render/lighting/tiled/light_bins.h"
#include "render/lighting/tiled/tile_kernel.h"

#include <array>
#include <memory>
#include <vector>

namespace candela {

/// The technique `tiles` where OpenGL itself runs on the CPU: the G-buffer is read back, lights are binned
/// and pixels shaded by vector code on all cores, and the radiance is written into its texture. On such a
/// machine that copies memory once each way, and the code shades several times faster than the rasteriser's
/// own shaders do (docs/benchmarks.md).
class SoftwareTiles final : public LightingTechnique {
  public:
    explicit SoftwareTiles(const TileKernel& kernel = tileKernel());

    bool overwritesRadiance() const override { return true; }
    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;
    std::uint64_t lightListBytes() const override { return bins_.bytes(); }

  private:
    /// A worker's lists, in one allocation.
    struct Worker {
        std::unique_ptr<TileScratch> scratch = std::make_unique<TileScratch>();
        std::vector<float> floats;
        std::vector<std::uint32_t> indices;

        void reserve(std::size_t lights);
    };

    void readTargets(const LightingInputs& inputs);
    TileFrame frameOf(const LightingInputs& inputs);

    const TileKernel& kernel_;
    LightBins bins_;
    std::vector<Worker> workers_;
    std::vector<std::uint32_t> surfaces_;
    std::vector<float> depth_, radiance_;
    std::array<float, 256> srgbDecode_;
};

}  // namespace candela
