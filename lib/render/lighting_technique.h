#pragma once

#include "gl/pass_timer.h"
#include "render/frustum.h"
#include "render/gbuffer_targets.h"
#include "render/gpu_lights.h"

#include <candela/brdf.h>

#include <cstdint>

namespace candela {

class PairCounter;

/// What a lighting technique works on. The frame's uniform block and the textures of `bindForLighting` are
/// bound.
struct LightingInputs {
    const GBufferTargets& targets;
    const GpuLights& lights;
    const Frustum& frustum;
    BrdfModel brdf;
};

/// A way of bringing lights to pixels. Each adds the light of all its lights to `targets.radiance`.
class LightingTechnique {
  public:
    virtual ~LightingTechnique() = default;

    virtual void render(const LightingInputs& inputs, gl::PassTimer& timer) = 0;
    /// How often the frame that `render` drew last ran the BRDF for a point or spot. May draw anew with
    /// `counter`, outside of timed frames.
    virtual std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) = 0;
};

}  // namespace candela
