#pragma once

#include "render/debug/instance_pass.h"
#include "render/frame_uniforms.h"
#include "render/gpu_scene/gpu_instances.h"

#include <candela/camera.h>

#include <span>
#include <vector>

namespace candela {

/// What the AOV `motion` is computed from. Rows from the bottom.
struct MotionInputs {
    const layout::FrameUniforms& frame;
    const FramePixels& pixels;
    const CameraView& view;
    const CameraView& previousView;
    const GpuInstances& instances;  ///< Where they are, and where they were (`GpuInstances::keep`).
    std::span<const float> depth;   ///< Reversed.
    std::span<const SurfaceId> ids;
    /// As `InstancePass::readPreviousPositions`; empty: the vertices of all instances rest.
    std::span<const float> previousPositions;
};

/// The way of each pixel's surface in the picture since the previous view and poses, pixels: x to the right
/// and y down in the first two of four floats a pixel. 0 where nothing has moved, on the background and where
/// the surface was behind the eye.
std::vector<float> motionOf(const MotionInputs& inputs);

}  // namespace candela
