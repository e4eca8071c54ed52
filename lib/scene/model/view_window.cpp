#include "scene/model/view_window.h"

#include "base/error_context.h"

#include <candela/error.h>

#include <cmath>
#include <numbers>

namespace candela {

namespace {

void require(bool holds, const char* rule) {
    if (!holds) throw Error(ErrorKind::badInput, {}, rule);
}

void requirePlanes(const CameraView& view) {
    const ErrorContext element("camera view");
    if (view.orthographicHeight) {
        element.requirePositive("its orthographic height", *view.orthographicHeight);
        element.requireNotNegative("its near plane", view.nearPlane);
    } else {
        element.requirePositive("its near plane", view.nearPlane);
    }
    if (!view.farPlane) return;
    element.requireFinite("its far plane", *view.farPlane);
    element.require(*view.farPlane > view.nearPlane, "its far plane must be over its near plane");
}

// Depth is (far - distance) / (far - near).
glm::mat4 orthographicProjection(const CameraView& view, const ViewWindow& window) {
    require(view.farPlane.has_value(), "the projection of an orthographic view needs a far plane");
    const double range = static_cast<double>(*view.farPlane) - view.nearPlane;
    glm::mat4 clip(0.0f);
    clip[0][0] = static_cast<float>(1.0 / window.halfExtent.x);
    clip[1][1] = static_cast<float>(1.0 / window.halfExtent.y);
    clip[2][2] = static_cast<float>(1.0 / range);
    clip[3][2] = static_cast<float>(*view.farPlane / range);
    clip[3][3] = 1.0f;
    clip[3][0] = static_cast<float>(-2.0 * window.shift.x);
    clip[3][1] = static_cast<float>(-2.0 * window.shift.y);
    return clip;
}

}  // namespace

ViewWindow viewWindow(const CameraView& view, double aspect) {
    require(view.verticalFov > 0.0f && view.verticalFov < std::numbers::pi_v<float>,
            "the camera's field of view must lie between 0 and 180 degrees");
    const ErrorContext element("camera view");
    element.requireFinite("its shift", glm::vec3(view.shift, 0.0f));
    if (view.aspect) element.requirePositive("its aspect ratio", *view.aspect);
    if (view.orthographicHeight) element.requirePositive("its orthographic height", *view.orthographicHeight);
    const double halfHeight = view.orthographicHeight ? 0.5 * static_cast<double>(*view.orthographicHeight)
                                                      : std::tan(0.5 * static_cast<double>(view.verticalFov));
    const double ratio = view.aspect ? static_cast<double>(*view.aspect) : aspect;
    return {halfHeight * glm::dvec2(ratio, 1.0), view.shift};
}

ViewWindow partOf(const ViewWindow& window, const glm::dvec2& whole, const glm::dvec2& first,
                  const glm::dvec2& size) {
    return {window.halfExtent * size / whole, (window.shift * whole + first + 0.5 * (size - whole)) / size};
}

glm::mat4 projection(const CameraView& view, const ViewWindow& window) {
    requirePlanes(view);
    if (view.orthographicHeight) return orthographicProjection(view, window);
    glm::mat4 clip(0.0f);
    clip[0][0] = static_cast<float>(1.0 / window.halfExtent.x);
    clip[1][1] = static_cast<float>(1.0 / window.halfExtent.y);
    clip[2][3] = -1.0f;
    // The way along the axis is -z.
    clip[2][0] = static_cast<float>(2.0 * window.shift.x);
    clip[2][1] = static_cast<float>(2.0 * window.shift.y);
    clip[3][2] = view.nearPlane;
    if (!view.farPlane) return clip;
    // Depth is (near / distance - near / far) / (1 - near / far).
    const double end = static_cast<double>(view.nearPlane) / *view.farPlane;
    clip[2][2] = static_cast<float>(end / (1.0 - end));
    clip[3][2] = static_cast<float>(view.nearPlane / (1.0 - end));
    return clip;
}

glm::mat4 projection(const CameraView& view, float aspect) {
    ErrorContext("image").requirePositive("its aspect ratio", aspect);
    return projection(view, viewWindow(view, aspect));
}

}  // namespace candela
