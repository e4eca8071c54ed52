#include <candela/camera.h>

#include "scene/model/frame.h"
#include "scene/validate/finite.h"

#include <candela/error.h>
#include <candela/scene.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

// Below this sine of the angle between the line of sight and Y, +Y can not say where up is.
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

void requireView(bool holds, const char* rule) {
    if (!holds) throw Error(ErrorKind::badInput, {}, rule);
}

}  // namespace

CameraView lookAt(const glm::vec3& eye, const glm::vec3& target, float verticalFov) {
    requireView(allFinite(eye) && allFinite(target), "the camera's eye and target must be finite numbers");
    requireView(eye != target, "the camera's eye and target must not be the same point");
    requireView(verticalFov > 0.0f && verticalFov < std::numbers::pi_v<float>,
                "the camera's field of view must lie between 0 and 180 degrees");
    const glm::dvec3 back = glm::normalize(glm::dvec3(eye) - glm::dvec3(target));
    CameraView view;
    view.worldFromCamera = rigid(axesLooking(back), eye);
    view.verticalFov = verticalFov;
    return view;
}

glm::mat4 projection(const CameraView& view, float aspect) {
    assert(aspect > 0.0f && view.nearPlane > 0.0f);
    const double focal = 1.0 / std::tan(0.5 * view.verticalFov);
    glm::mat4 clip(0.0f);
    clip[0][0] = static_cast<float>(focal / aspect);
    clip[1][1] = static_cast<float>(focal);
    clip[2][3] = -1.0f;
    clip[3][2] = view.nearPlane;
    return clip;
}

CameraView cameraView(const Scene& scene, std::uint32_t index, const std::vector<glm::mat4>& world) {
    assert(index < scene.cameras.size() && world.size() == scene.nodes.size());
    const Camera& camera = scene.cameras[index];
    CameraView view;
    view.verticalFov = camera.verticalFov;
    view.nearPlane = camera.nearPlane;
    if (!camera.node) return view;
    const glm::mat4& node = world[*camera.node];
    glm::dmat3 axes = unscaledFrame(node);
    axes[0] = glm::cross(axes[1], axes[2]);  // A mirrored node does not mirror the picture.
    view.worldFromCamera = rigid(axes, glm::dvec3(node[3]));
    return view;
}

CameraView frameBounds(const Bounds& bounds, float aspect) {
    assert(aspect > 0.0f);
    constexpr float fov = std::numbers::pi_v<float> / 4.0f;
    if (bounds.empty()) return lookAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f), fov);

    constexpr double margin = 1.05;  // Leaves a little air around the box.
    const glm::dvec3 from(0.4, 0.3, 1.0);
    const glm::dmat3 axes = axesLooking(glm::normalize(from));
    const double tanY = std::tan(0.5 * fov) / margin;
    const double tanX = tanY * aspect;
    const glm::dvec3 low(bounds.min), high(bounds.max);
    const glm::dvec3 center = 0.5 * (low + high);

    // A corner at (x, y, z) of the camera's axes, seen from `distance`, is inside when |x| and |y| are at
    // most (distance - z) times the tangents.
    double distance = 0.0, nearest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 position((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                  (corner & 4) != 0 ? high.z : low.z);
        const glm::dvec3 seen = (position - center) * axes;
        distance = std::max({distance, seen.z + std::abs(seen.x) / tanX, seen.z + std::abs(seen.y) / tanY});
        nearest = std::max(nearest, seen.z);
    }
    // A point, a line along the sight, and a box of a few float steps far from the origin still need room.
    const glm::dvec3 reach = glm::max(glm::abs(low), glm::abs(high));
    const double size = glm::length(high - low);
    const double room =
        std::max(size > 0.0 ? 0.01 * size : 1.0, 1e-5 * std::max({reach.x, reach.y, reach.z}));
    distance = std::max(distance, nearest + room);

    CameraView view;
    view.worldFromCamera = rigid(axes, center + axes[2] * distance);
    view.verticalFov = fov;
    view.nearPlane = static_cast<float>(std::min(0.01 * distance, 0.5 * (distance - nearest)));
    return view;
}

}  // namespace candela
