#include "render/frame_uniforms.h"

#include <cmath>

namespace candela {

namespace {

glm::vec4 depthRange(const CameraView& view) {
    if (view.orthographicHeight) return {0.0f, *view.farPlane, *view.farPlane - view.nearPlane, 1.0f};
    const double end = view.farPlane ? static_cast<double>(view.nearPlane) / *view.farPlane : 0.0;
    return {end, 1.0 - end, 0.0, 0.0};
}

}  // namespace

ViewWindow FramePixels::pictureWindow(const CameraView& view) const {
    return viewWindow(view, static_cast<double>(pictureWidth) / pictureHeight);
}

ViewWindow FramePixels::window(const CameraView& view) const {
    const ViewWindow picture = pictureWindow(view);
    if (left == 0 && bottom == 0 && width == pictureWidth && height == pictureHeight) return picture;
    return partOf(picture, {pictureWidth, pictureHeight}, {left, bottom}, {width, height});
}

FramePixels framePixels(const FrameSettings& settings) {
    const int width = settings.width, height = settings.height;
    if (!settings.region) return {width, height, width, height};
    const PictureRegion& region = *settings.region;
    return {width, height, region.width, region.height, region.x, region.height - region.y - height};
}

layout::FrameUniforms frameUniforms(const CameraView& view, const FramePixels& pixels,
                                    const glm::dmat3& workingFromRec709, const LightCounts& lights) {
    const glm::dmat4 frameOfCamera(view.worldFromCamera);
    const glm::dvec3 right(frameOfCamera[0]), up(frameOfCamera[1]), forward(-frameOfCamera[2]);
    // From the picture and not from the frame, so that parts of a picture have the picture's rays.
    const ViewWindow picture = pixels.pictureWindow(view), window = pixels.window(view);
    const glm::dvec2 whole(pixels.pictureWidth, pixels.pictureHeight);
    const glm::dvec2 step = 2.0 * picture.halfExtent / whole;
    const glm::dvec3 middle = view.orthographicHeight ? glm::dvec3(0.0) : forward;
    const glm::dvec2 first =
        step * (glm::dvec2(pixels.left, pixels.bottom) + 0.5 - 0.5 * whole + picture.shift * whole);
    const glm::dvec3 corner = middle + right * first.x + up * first.y;

    layout::FrameUniforms frame{};
    frame.clipFromWorld = projection(view, window) * glm::inverse(view.worldFromCamera);
    frame.eye = glm::vec4(view.eye(), view.nearPlane);
    frame.rayCorner = glm::vec4(corner, 0.0);
    frame.rayStepX = glm::vec4(right * step.x, window.shift.x);
    frame.rayStepY = glm::vec4(up * step.y, window.shift.y);
    frame.cameraRight = glm::vec4(right, window.halfExtent.x);
    frame.cameraUp = glm::vec4(up, window.halfExtent.y);
    frame.cameraForward = glm::vec4(forward, 0.0);
    frame.depthRange = depthRange(view);
    frame.workingFromRed = glm::vec4(workingFromRec709[0], 0.0);
    frame.workingFromGreen = glm::vec4(workingFromRec709[1], 0.0);
    frame.workingFromBlue = glm::vec4(workingFromRec709[2], 0.0);
    frame.size = {pixels.width, pixels.height, pixels.left, pixels.bottom};
    frame.lightCounts = {lights.points, lights.spots, lights.directionals, pixels.pictureWidth};
    return frame;
}

glm::vec3 worldPosition(const layout::FrameUniforms& frame, int x, int y, float depth) {
    const glm::vec3 ray = glm::vec3(frame.rayCorner) + static_cast<float>(x) * glm::vec3(frame.rayStepX) +
                          static_cast<float>(y) * glm::vec3(frame.rayStepY);
    if (frame.depthRange.w != 0.0f)
        return glm::vec3(frame.eye) + ray + glm::vec3(frame.cameraForward) * viewDistance(frame, depth);
    return glm::vec3(frame.eye) + ray * viewDistance(frame, depth);
}

float viewDistance(const layout::FrameUniforms& frame, float depth) {
    if (frame.depthRange.w != 0.0f) return frame.depthRange.y - depth * frame.depthRange.z;
    return frame.eye.w / (depth * frame.depthRange.y + frame.depthRange.x);
}

}  // namespace candela
