#pragma once

#include "render/gbuffer/gbuffer_targets.h"
#include "render/gpu_scene/gpu_lights.h"
#include "render/layout.h"

#include <candela/renderer.h>

#include <optional>

namespace candela {

/// A pixel of a frame; y counts from the bottom.
struct ProbedPixel {
    const GBufferTargets& targets;
    const layout::FrameUniforms& frame;
    const GpuLights& lights;
    int x, y;
};

/// What the G-buffer and the lights tell of a pixel: all but its node and its emission. None on the
/// background. Reads that pixel alone back.
std::optional<PixelProbe> probeSurface(const ProbedPixel& pixel);

}  // namespace candela
