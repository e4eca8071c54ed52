#pragma once

#include "render/gpu_scene/gpu_lights.h"
#include "render/layout.h"
#include "scene/model/view_window.h"

#include <candela/camera.h>
#include <candela/frame_settings.h>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace candela {

/// The pixels of a frame among those of its picture.
struct FramePixels {
    int width, height;                ///< Of the frame.
    int pictureWidth, pictureHeight;  ///< Of the picture that it is a part of, or all of.
    int left = 0, bottom = 0;         ///< The frame's lower left pixel in the picture.

    /// The window of the frame in that of its picture.
    ViewWindow window(const CameraView& view) const;
    /// That of the picture.
    ViewWindow pictureWindow(const CameraView& view) const;
};
FramePixels framePixels(const FrameSettings& settings);

/// The uniform block of a frame, without specular antialiasing. An orthographic view has a far plane.
layout::FrameUniforms frameUniforms(const CameraView& view, const FramePixels& pixels,
                                    const glm::dmat3& workingFromRec709, const LightCounts& lights);
/// Of a frame that is all of its picture.
inline layout::FrameUniforms frameUniforms(const CameraView& view, int width, int height,
                                           const glm::dmat3& workingFromRec709, const LightCounts& lights) {
    return frameUniforms(view, {width, height, width, height}, workingFromRec709, lights);
}

/// World position of a pixel's surface (y up), as shaders/lib/frame.glsl computes it; `depth` is the reversed
/// depth, over 0.
glm::vec3 worldPosition(const layout::FrameUniforms& frame, int x, int y, float depth);

/// The distance along the view axis, metres, of a reversed depth over 0.
float viewDistance(const layout::FrameUniforms& frame, float depth);

}  // namespace candela
