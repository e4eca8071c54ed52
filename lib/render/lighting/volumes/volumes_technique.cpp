#include "render/lighting/volumes/volumes_technique.h"

#include "render/lighting/pair_counter.h"

namespace candela {

VolumesTechnique::VolumesTechnique(const FullscreenPass& fullscreen)
    : fullscreen_(fullscreen),
      pointPrograms_("light_volume.vert", "light_volume.frag", {"SPOT 0"}),
      spotPrograms_("light_volume.vert", "light_volume.frag", {"SPOT 1"}) {}

void VolumesTechnique::render(const LightingInputs& inputs, gl::PassTimer& timer) {
    const gl::PassTimer::Scope pass(timer, "lighting");
    if (volumes_.prepare(inputs) > 0) {
        depth_.bind(inputs.targets, inputs.targets.radiance);
        volumes_.drawInside(pointPrograms_.get(inputs.brdf), spotPrograms_.get(inputs.brdf));
    }
    fullscreen_.addDirectionals(inputs);
}

std::uint64_t VolumesTechnique::countEvaluated(const LightingInputs& inputs, PairCounter& counter) {
    return counter.countInside(inputs);
}

}  // namespace candela
