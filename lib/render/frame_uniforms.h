#pragma once

#include "render/gpu_scene/gpu_lights.h"
#include "render/layout.h"

#include <candela/camera.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace candela {

/// The uniform block of a frame of `width` × `height` pixels, without specular antialiasing. An orthographic
/// view has a far plane.
layout::FrameUniforms frameUniforms(const CameraView& view, int width, int height,
                                    const glm::dmat3& workingFromRec709, const LightCounts& lights);

/// World position of a pixel's surface (y up), as shaders/lib/frame.glsl computes it; `depth` is the reversed
/// depth, over 0.
glm::vec3 worldPosition(const layout::FrameUniforms& frame, int x, int y, float depth);

/// The distance along the view axis, metres, of a reversed depth over 0.
float viewDistance(const layout::FrameUniforms& frame, float depth);

}  // namespace candela
