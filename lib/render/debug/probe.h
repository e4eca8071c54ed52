#pragma once

#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_lights.h"
#include "render/layout.h"

#include <candela/frame_data.h>

#include <optional>

namespace candela {

/// A pixel of a frame; y counts from the bottom.
struct ProbedPixel {
    const GBufferTargets& targets;
    const layout::FrameUniforms& frame;
    const GpuLights& lights;
    int x, y;
};

/// Reads back what the targets hold of a pixel and counts its lights: all but its node, its emission
/// and its radiance. None
/// on the background.
std::optional<PixelProbe> probeSurface(const ProbedPixel& pixel);

}  // namespace candela
