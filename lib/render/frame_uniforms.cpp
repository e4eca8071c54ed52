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

layout::FrameUniforms frameUniforms(const CameraView& view, int width, int height,
                                    const glm::dmat3& workingFromRec709, const LightCounts& lights) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const glm::dmat4 frameOfCamera(view.worldFromCamera);
    const glm::dvec3 right(frameOfCamera[0]), up(frameOfCamera[1]), forward(-frameOfCamera[2]);
    const double halfHeight = view.orthographicHeight ? 0.5 * static_cast<double>(*view.orthographicHeight)
                                                      : std::tan(0.5 * static_cast<double>(view.verticalFov));
    const double step = 2.0 * halfHeight / height;
    const glm::dvec3 middle = view.orthographicHeight ? glm::dvec3(0.0) : forward;
    const glm::dvec2 shift = glm::dvec2(view.shift) * glm::dvec2(width, height);
    const glm::dvec3 corner = middle + right * (step * (0.5 - 0.5 * width + shift.x)) +
                              up * (step * (0.5 - 0.5 * height + shift.y));

    layout::FrameUniforms frame{};
    frame.clipFromWorld = projection(view, aspect) * glm::inverse(view.worldFromCamera);
    frame.eye = glm::vec4(view.eye(), view.nearPlane);
    frame.rayCorner = glm::vec4(corner, 0.0);
    frame.rayStepX = glm::vec4(right * step, view.shift.x);
    frame.rayStepY = glm::vec4(up * step, view.shift.y);
    frame.cameraRight = glm::vec4(right, halfHeight * width / height);
    frame.cameraUp = glm::vec4(up, halfHeight);
    frame.cameraForward = glm::vec4(forward, 0.0);
    frame.depthRange = depthRange(view);
    frame.workingFromRed = glm::vec4(workingFromRec709[0], 0.0);
    frame.workingFromGreen = glm::vec4(workingFromRec709[1], 0.0);
    frame.workingFromBlue = glm::vec4(workingFromRec709[2], 0.0);
    frame.size = {width, height, 0, 0};
    frame.lightCounts = {lights.points, lights.spots, lights.directionals, 0};
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
