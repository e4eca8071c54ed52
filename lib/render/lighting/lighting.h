#pragma once

#include "render/lighting/fullscreen/fullscreen_technique.h"
#include "render/lighting/lighting_technique.h"
#include "render/lighting/pair_counter.h"
#include "render/lighting/tiled/cpu_tiles.h"

#include <candela/context.h>
#include <candela/frame_settings.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace candela {

/// The lighting techniques of a renderer, each created when it is first needed.
class Lighting {
  public:
    explicit Lighting(const Context& context);

    /// What runs `tiles` where `backend` is asked for: never `automatic`, which is `cpu` on a software device
    /// and `compute` on a GPU.
    TileBackend tileBackend(TileBackend backend) const;

    /// `technique` is not `automatic`. `backend` is read for `tiles` only.
    LightingTechnique& technique(Technique technique, TileBackend backend);
    /// The technique `tiles` on the CPU, and another one of it, which shade two frames at the same time.
    CpuTiles& cpuTiles();
    CpuTiles& otherCpuTiles();
    PairCounter& counter();
    /// How many lights that cast shadows would light each pixel but are hidden from it: rows from the bottom.
    /// All 0 in a frame without shadows. The rays are those of the technique `tiles` on the CPU.
    std::vector<float> shadowedPerPixel(const LightingInputs& inputs);

    /// Do shaders light pixels and trace the occlusion rays of the technique? `backend` as above.
    bool shadesInShaders(Technique technique, TileBackend backend) const;

    /// How many rays one invocation of a shader traces at most.
    std::uint32_t raysPerInvocation() const { return static_cast<std::uint32_t>(limit_.traced); }

    /// Binds the textures that all techniques read which shade in shaders.
    void bind(const LightingInputs& inputs);

  private:
    std::unique_ptr<LightingTechnique> create(Technique technique, TileBackend backend) const;

    TileBackend deviceBackend_;
    LightsPerInvocation limit_;
    std::array<std::optional<gl::Texture>, 2> albedo_;  ///< For each `BrdfModel`, made when first needed.
    std::optional<gl::Texture> sheen_;                  ///< Made for the first frame with lobe words.
    FullscreenPass fullscreen_;
    std::map<std::pair<Technique, TileBackend>, std::unique_ptr<LightingTechnique>> techniques_;
    std::unique_ptr<PairCounter> counter_;
    std::unique_ptr<CpuTiles> shadowTiles_, otherTiles_;
};

}  // namespace candela
