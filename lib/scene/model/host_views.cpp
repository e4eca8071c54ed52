// Views from what hosts describe cameras by: projection matrices, intrinsics, pairs of eyes, cubes.

#include "base/error_context.h"
#include "scene/model/view_window.h"

#include <candela/camera.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <string>

namespace candela {

namespace {

constexpr const char* matrixName = "projection matrix";

/// A projection matrix, with w of clip space the distance along the axis, or 1 of an orthographic one.
struct Projection {
    bool orthographic;
    glm::dmat4 clip;
};

Projection readProjection(const glm::mat4& clipFromCamera) {
    const ErrorContext element(matrixName);
    element.requireFinite("it", clipFromCamera);
    const glm::dmat4 clip(clipFromCamera);
    const bool orthographic = clip[2][3] == 0.0;
    const double scale = orthographic ? clip[3][3] : -clip[2][3];
    element.require(
        scale > 0.0 && (orthographic || clip[3][3] == 0.0) && clip[0][3] == 0.0 && clip[1][3] == 0.0,
        "its last row must be (0, 0, -1, 0) of a perspective view, which looks along -Z, or "
        "(0, 0, 0, 1) of an orthographic one");
    element.require(clip[0][1] == 0.0 && clip[1][0] == 0.0 && clip[0][2] == 0.0 && clip[1][2] == 0.0,
                    "it must not rotate or skew: what is across the axis must not mix");
    element.require(clip[0][0] > 0.0 && clip[1][1] > 0.0,
                    "its scales of X and Y must be over 0: it must not mirror");
    const int across = orthographic ? 2 : 3;
    element.require(clip[across][0] == 0.0 && clip[across][1] == 0.0,
                    orthographic ? "an orthographic one must look along -Z"
                                 : "the eye of a perspective one must be the origin of camera space");
    return {orthographic, clip / scale};
}

/// What z / w is at the near and the far plane.
glm::dvec2 endsOf(ClipDepth depth) {
    switch (depth) {
        case ClipDepth::negativeOneToOne:
            return {-1.0, 1.0};
        case ClipDepth::zeroToOne:
            return {0.0, 1.0};
        default:
            return {1.0, 0.0};
    }
}

/// The distance at which z / w is `value`; infinity for none.
double distanceAt(const Projection& projection, double value) {
    const double slope = projection.clip[2][2], offset = projection.clip[3][2];
    if (projection.orthographic) return (offset - value) / slope;
    // z / w is offset / distance - slope. Matrices are in single precision.
    const double limit = value + slope;
    return std::abs(limit) <= std::numeric_limits<float>::epsilon() ? std::numeric_limits<double>::infinity()
                                                                    : offset / limit;
}

CameraView faceView(const CameraView& view, const glm::dvec3& forward, const glm::dvec3& up, float fov) {
    const glm::dmat4 axes(glm::dvec4(glm::cross(forward, up), 0.0), glm::dvec4(up, 0.0),
                          glm::dvec4(-forward, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0));
    CameraView face = view;
    face.worldFromCamera = glm::mat4(glm::dmat4(view.worldFromCamera) * axes);
    face.verticalFov = fov;
    face.shift = glm::vec2(0.0f);
    face.aspect = 1.0f;
    return face;
}

void requirePerspective(const CameraView& view) {
    ErrorContext("camera view").require(!view.orthographicHeight, "it must be a perspective one");
}

}  // namespace

CameraView viewOfProjection(const glm::mat4& worldFromCamera, const glm::mat4& clipFromCamera,
                            ClipDepth depth) {
    const Projection projection = readProjection(clipFromCamera);
    const ErrorContext element(matrixName);
    const glm::dvec2 ends = endsOf(depth);
    double nearPlane = distanceAt(projection, ends.x), farPlane = distanceAt(projection, ends.y);
    element.require(std::isfinite(nearPlane) && (projection.orthographic || nearPlane > 0.0),
                    "it has no near plane in front of the eye: is its clip depth another one?");
    element.require(farPlane > nearPlane,
                    "its far plane is not behind its near plane: is its clip depth another one?");
    const glm::dvec2 halfExtent(1.0 / projection.clip[0][0], 1.0 / projection.clip[1][1]);
    CameraView view;
    view.worldFromCamera = worldFromCamera;
    view.aspect = static_cast<float>(halfExtent.x / halfExtent.y);
    if (projection.orthographic) {
        element.require(std::isfinite(farPlane), "an orthographic one must have a far plane");
        view.orthographicHeight = static_cast<float>(2.0 * halfExtent.y);
        view.shift = glm::vec2(-0.5 * glm::dvec2(projection.clip[3]));
        if (nearPlane < 0.0) {  // Hosts may have it behind the eye, which goes back then.
            view.worldFromCamera[3] -= static_cast<float>(nearPlane) * worldFromCamera[2];
            farPlane -= nearPlane;
            nearPlane = 0.0;
        }
    } else {
        view.verticalFov = static_cast<float>(2.0 * std::atan(halfExtent.y));
        view.shift = glm::vec2(0.5 * glm::dvec2(projection.clip[2]));
    }
    view.nearPlane = static_cast<float>(nearPlane);
    if (std::isfinite(farPlane)) view.farPlane = static_cast<float>(farPlane);
    return view;
}

CameraView viewOfIntrinsics(const glm::mat4& worldFromCamera, const CameraIntrinsics& camera) {
    const ErrorContext element("camera intrinsics");
    element.requirePositive("the focal length focalX", camera.focalX);
    element.requirePositive("the focal length focalY", camera.focalY);
    element.requireFinite("the principal point", glm::dvec2(camera.centerX, camera.centerY));
    element.require(camera.width >= 1 && camera.height >= 1, "width and height must be 1 or more");
    const double width = camera.width, height = camera.height;
    CameraView view;
    view.worldFromCamera = worldFromCamera;
    view.verticalFov = static_cast<float>(2.0 * std::atan(0.5 * height / camera.focalY));
    view.aspect = static_cast<float>(width / camera.focalX * camera.focalY / height);
    view.shift = glm::vec2(0.5 - camera.centerX / width, camera.centerY / height - 0.5);
    return view;
}

std::array<CameraView, 2> stereoViews(const CameraView& view, float eyeDistance, float convergence,
                                      float aspect) {
    requirePerspective(view);
    const ErrorContext element("stereo views");
    element.requireNotNegative("the distance of the eyes", eyeDistance);
    element.requirePositive("the convergence", convergence);
    element.requirePositive("the aspect ratio", aspect);
    const ViewWindow window = viewWindow(view, aspect);
    const double half = 0.5 * static_cast<double>(eyeDistance);
    const double width = 2.0 * window.halfExtent.x * static_cast<double>(convergence);
    const auto eye = [&](double side) {
        CameraView seen = view;
        const glm::dmat4 frame(view.worldFromCamera);
        seen.worldFromCamera[3] = glm::vec4(frame[3] + side * half * frame[0]);
        seen.shift.x = static_cast<float>(window.shift.x - side * half / width);
        return seen;
    };
    return {eye(-1.0), eye(1.0)};
}

std::array<CameraView, 6> cubeViews(const CameraView& view, float margin) {
    requirePerspective(view);
    ErrorContext("cube views").require(margin >= 0.0f && margin <= 1.0f, "the margin must be from 0 to 1");
    const auto fov = static_cast<float>(2.0 * std::atan(1.0 + 2.0 * static_cast<double>(margin)));
    const glm::dvec3 right(1.0, 0.0, 0.0), up(0.0, 1.0, 0.0), behind(0.0, 0.0, 1.0);
    return {faceView(view, right, up, fov),   faceView(view, -right, up, fov),
            faceView(view, up, behind, fov),  faceView(view, -up, -behind, fov),
            faceView(view, -behind, up, fov), faceView(view, behind, up, fov)};
}

}  // namespace candela
