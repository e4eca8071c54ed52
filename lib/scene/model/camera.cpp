#include <candela/camera.h>

#include "scene/geometry/axes.h"
#include "scene/model/property_animation.h"
#include "scene/validate/scene_rules.h"

#include <candela/error.h>
#include <candela/scene.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

// Below this sine of the angle between the view direction and Y, +Y does not define the up direction.
constexpr double minSine = 1e-6;

glm::mat4 rigid(const glm::dmat3& axes, const glm::dvec3& eye) {
    return glm::mat4(glm::dmat4(glm::dvec4(axes[0], 0.0), glm::dvec4(axes[1], 0.0), glm::dvec4(axes[2], 0.0),
                                glm::dvec4(eye, 1.0)));
}

// Camera axes for a view whose +Z, away from the target, is the unit vector `back`.
glm::dmat3 axesLooking(const glm::dvec3& back) {
    glm::dvec3 right = glm::cross(glm::dvec3(0.0, 1.0, 0.0), back);
    if (glm::length(right) < minSine) right = glm::cross(glm::dvec3(0.0, 0.0, 1.0), back);
    right = glm::normalize(right);
    return {right, glm::cross(back, right), back};
}

void require(bool holds, const char* rule) {
    if (!holds) throw Error(ErrorKind::badInput, {}, rule);
}

void requireFov(float verticalFov) {
    require(verticalFov > 0.0f && verticalFov < std::numbers::pi_v<float>,
            "the camera's field of view must lie between 0 and 180 degrees");
}

void requireAspect(float aspect) {
    ErrorContext("image").requirePositive("its aspect ratio", aspect);
}

void requireFiniteBox(const Bounds& bounds) {
    const ErrorContext box("box");
    box.requireFinite("its minimum", bounds.min);
    box.requireFinite("its maximum", bounds.max);
}

float nearPlaneOf(const Camera& camera, const Scene& scene, const std::vector<glm::mat4>& world,
                  double time) {
    if (camera.nearPlane) return *camera.nearPlane;
    if (camera.orthographicHeight) return 0.0f;
    const float nearPlane = defaultNearPlane(worldBounds(scene, world, time));
    return camera.farPlane ? std::min(nearPlane, 0.5f * *camera.farPlane) : nearPlane;
}

}  // namespace

CameraView lookAt(const glm::vec3& eye, const glm::vec3& target, float verticalFov) {
    require(allFinite(eye) && allFinite(target), "the camera's eye and target must be finite numbers");
    require(eye != target, "the camera's eye and target must not be the same point");
    requireFov(verticalFov);
    const glm::dvec3 back = glm::normalize(glm::dvec3(eye) - glm::dvec3(target));
    CameraView view;
    view.worldFromCamera = rigid(axesLooking(back), eye);
    view.verticalFov = verticalFov;
    return view;
}

CameraView cameraView(const Scene& scene, std::uint32_t index, const std::vector<glm::mat4>& world,
                      double time) {
    ErrorContext("scene").requireIndex("camera", index, scene.cameras.size());
    requireWorldMatrices(scene, world);
    const std::map<std::uint32_t, Camera> posed = posedElements<Camera>(scene, time);
    const auto animated = posed.find(index);
    const Camera& camera = animated == posed.end() ? scene.cameras[index] : animated->second;
    const ErrorContext element("camera", index, camera.name);
    validateCamera(camera, scene, element);
    CameraView view;
    view.verticalFov = camera.verticalFov;
    view.orthographicHeight = camera.orthographicHeight;
    view.nearPlane = nearPlaneOf(camera, scene, world, time);
    view.farPlane = camera.farPlane;
    if (!camera.node) return view;
    const glm::mat4& node = world[*camera.node];
    element.requireFinite("the world matrix of its node", node);
    glm::dmat3 axes = unscaledFrame(node);
    axes[0] = glm::cross(axes[1], axes[2]);  // A mirrored node does not mirror the image.
    view.worldFromCamera = rigid(axes, glm::dvec3(node[3]));
    return view;
}

float defaultNearPlane(const Bounds& bounds) {
    constexpr double share = 0.01, most = 0.01;
    if (bounds.empty()) return static_cast<float>(most);
    requireFiniteBox(bounds);
    const double size = glm::distance(glm::dvec3(bounds.min), glm::dvec3(bounds.max));
    return static_cast<float>(size > 0.0 ? std::min(share * size, most) : most);
}

CameraView frameBounds(const Bounds& bounds, float aspect, float fov) {
    requireAspect(aspect);
    requireFov(fov);
    if (bounds.empty()) return lookAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f), fov);
    requireFiniteBox(bounds);

    constexpr double margin = 1.05;  // Some room around the box.
    const glm::dvec3 from(0.4, 0.3, 1.0);
    const glm::dmat3 axes = axesLooking(glm::normalize(from));
    const double tanY = std::tan(0.5 * fov) / margin;
    const double tanX = tanY * aspect;
    const glm::dvec3 min(bounds.min), max(bounds.max);
    const glm::dvec3 center = 0.5 * (min + max);

    // A corner at (x, y, z) along the camera's axes lies inside the view from `distance` when |x| and |y| are
    // at most (distance - z) times the tangents.
    double distance = 0.0, nearest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 position((corner & 1) != 0 ? max.x : min.x, (corner & 2) != 0 ? max.y : min.y,
                                  (corner & 4) != 0 ? max.z : min.z);
        const glm::dvec3 inCamera = (position - center) * axes;
        distance = std::max(
            {distance, inCamera.z + std::abs(inCamera.x) / tanX, inCamera.z + std::abs(inCamera.y) / tanY});
        nearest = std::max(nearest, inCamera.z);
    }
    // A point, a line along the view direction, and a box of a few float steps far from the origin need a
    // distance too.
    const glm::dvec3 extent = glm::max(glm::abs(min), glm::abs(max));
    const double size = glm::length(max - min);
    const double clearance =
        std::max(size > 0.0 ? 0.01 * size : 1.0, 1e-5 * std::max({extent.x, extent.y, extent.z}));
    distance = std::max(distance, nearest + clearance);

    CameraView view;
    view.worldFromCamera = rigid(axes, center + axes[2] * distance);
    view.verticalFov = fov;
    view.nearPlane = static_cast<float>(std::min(0.01 * distance, 0.5 * (distance - nearest)));
    return view;
}

}  // namespace candela
