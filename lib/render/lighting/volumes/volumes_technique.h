#pragma once

#include "render/lighting/fullscreen/fullscreen_technique.h"
#include "render/lighting/lighting_bindings.h"
#include "render/lighting/lighting_technique.h"
#include "render/lighting/volumes/light_volumes.h"
#include "render/lighting/volumes/stencilled_depth.h"

namespace candela {

/// Rasterises each light's bounding volume against the depth buffer and shades the pixels whose surface lies
/// inside it.
class VolumesTechnique final : public LightingTechnique {
  public:
    explicit VolumesTechnique(const FullscreenPass& fullscreen);

    void render(const LightingInputs& inputs, gl::PassTimer& timer) override;
    std::uint64_t lightListBytes() const override { return volumes_.listBytes(); }
    std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) override;

  private:
    const FullscreenPass& fullscreen_;
    ModelPrograms pointPrograms_, spotPrograms_;
    LightVolumes volumes_;
    StencilledDepth depth_;
};

}  // namespace candela
