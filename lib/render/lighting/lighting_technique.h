#pragma once

#include "gl/pass_timer.h"
#include "render/frustum.h"
#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_lights.h"

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
    const layout::FrameUniforms& uniforms;
    BrdfModel brdf;
    bool emissionDrawn;  ///< `targets.radiance` holds emission; else it is black, or undefined for a
                         ///< technique that overwrites it.
};

/// A way of bringing lights to pixels. Each adds the light of all its lights to `targets.radiance`.
class LightingTechnique {
  public:
    virtual ~LightingTechnique() = default;

    /// Does `render` write every pixel of the radiance target, so that it need not be cleared?
    virtual bool overwritesRadiance() const { return false; }

    virtual void render(const LightingInputs& inputs, gl::PassTimer& timer) = 0;
    /// How often the frame that `render` drew last ran the BRDF for a point or spot. May draw anew with
    /// `counter`, outside of timed frames.
    /// Bytes of the lists of lights that the last frame was drawn with.
    virtual std::uint64_t lightListBytes() const = 0;
    virtual std::uint64_t countEvaluated(const LightingInputs& inputs, PairCounter& counter) = 0;
};

}  // namespace candela
