#pragma once

#include "base/thread_pool.h"
#include "render/gbuffer/gbuffer_copy.h"
#include "render/lighting/lighting_technique.h"
#include "render/lighting/tiled/light_bins.h"
#include "render/lighting/tiled/tile_kernel.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace candela {

/// The members of a tile frame that describe the view.
void readView(TileFrame& frame, const layout::FrameUniforms& uniforms);

/// The technique `tiles` as vector code, for devices where OpenGL itself runs on the CPU: the G-buffer is
/// read (in place or copied: `GBufferCopy`), lights are binned and pixels shaded on all cores, and the
/// radiance stays in memory until something asks for its texture. The vector code shades several times faster
/// than the rasteriser's own shaders (docs/benchmarks.md).
class CpuTiles final : public LightingTechnique {
  public:
    /// Lights whose lists need more than `maxListWords` 32-bit words are shaded in several parts.
    explicit CpuTiles(const TileKernel& kernel = tileKernel(),
                      std::uint64_t maxListWords = std::uint64_t{1} << 26);

    LoadOp radianceLoadOp() const override { return LoadOp::dontCare; }
    bool drawsEnvironment() const override { return true; }
    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    /// The two halves of `render`: reads what the geometry pass has drawn, then shades it. `shade` uses no
    /// OpenGL and may run on another thread, while the context draws something else; the lights and the
    /// occlusion structure of the inputs must stay as they are until it ends.
    void capture(const LightingInputs& inputs);
    /// What `capture` has read, where the inputs have no copy.
    GBufferCopy& captured() { return copy_; }
    /// How `capture` reads mapped targets then; copied at first, so that they may be drawn to before `shade`
    /// ends.
    void setMapped(GBufferCopy::Mapped mapped) { copy_.setMapped(mapped); }
    /// Copies the lights of `capture`, which may change then before `shade` ends.
    void keepLights(const GpuLights& lights);
    /// As `LightingInputs::environmentVisibility`, which `capture` did not have yet.
    void setEnvironmentVisibility(const std::uint8_t* visibility) {
        frame_.environmentVisibility = visibility;
    }
    void shade();
    /// As `shade`, but adds to `sum`, RGBA of as many pixels, and leaves `result` alone; alpha is undefined
    /// then. Not for a frame with emission (`hasEmission`), which the light is added to.
    void shadeOnto(std::span<float> sum);
    bool hasEmission() const { return frame_.loadRadiance; }
    /// What the last `shade` has written, until the next `capture`.
    GBufferTargets::Memory result() const {
        return {radiance_, {frame_.depth, radiance_.size() / 4}, rectangle_};
    }
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;
    std::uint64_t lightListBytes() const override { return listBytes_; }
    ShadowCounts shadowCounts() const override;

    /// How many lights are hidden from each pixel that they would light: rows from the bottom. The frame has
    /// shadows. Shades nothing, and counts as the last rendered frame for the members above.
    std::vector<float> shadowedPerPixel(const LightingInputs& inputs);

  private:
    /// A worker's lists, in one allocation each.
    struct Worker {
        std::unique_ptr<TileScratch> scratch = std::make_unique<TileScratch>();
        std::vector<float> floats;
        std::vector<std::uint32_t> indices;
        std::vector<InstanceList> instances;
        std::vector<std::uint32_t> lightOfSlot;
        std::vector<std::uint16_t> pixels;
        std::vector<float> transmittance;

        void reserve(std::size_t lights);
        void reserveShadows(std::size_t lights, std::size_t directionals, const OcclusionView& occlusion);
    };

    GBufferCopy& copyOf(const LightingInputs& inputs);
    TileFrame frameOf(const LightingInputs& inputs);
    bool isShaded(int tileX, int tileY) const;
    void shadeTiles(const TileFrame& frame, BrdfModel brdf, ThreadPool& pool);
    void shadeAll(TileFrame frame, BrdfModel brdf);

    const TileKernel& kernel_;
    LightBins bins_;
    std::uint64_t listBytes_ = 0;
    std::vector<Worker> workers_;
    /// Where the inputs have none.
    GBufferCopy copy_{GBufferCopy::Mapped::copied};
    LightReaches keptReaches_;
    std::vector<glm::vec4> keptRecords_, keptCones_;
    std::vector<float> radiance_;
    std::array<float, 256> srgbDecode_;
    TileFrame frame_{};             ///< Of the last `capture`.
    gl::PixelRectangle rectangle_;  ///< Whose tiles are shaded.
    BrdfModel brdf_ = BrdfModel::course;
};

}  // namespace candela
