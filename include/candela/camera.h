#pragma once

#include <candela/export.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace candela {

/// A camera of a scene. It looks along -Z of its node's frame with +Y up.
struct Camera {
    std::string name = {};          ///< The camera's own; its node may have another one.
    float verticalFov = 0.785398f;  ///< Radians, over 0 and under pi; default 45 degrees.
    /// Metres, over 0: an orthographic camera. None: a perspective one.
    std::optional<float> orthographicHeight = {};
    /// Metres, over 0 (of an orthographic camera 0 or more). None: `defaultNearPlane` of what the scene
    /// shows, and 0 of an orthographic camera.
    std::optional<float> nearPlane = {};
    std::optional<float> farPlane = {};      ///< Metres, over the near plane; none: at infinity.
    std::optional<std::uint32_t> node = {};  ///< Index into `Scene::nodes`; none: the world's frame.
    /// The camera's number in its file, by which a user may name it. None: its index in `Scene::cameras`.
    std::optional<std::uint32_t> number = {};
};

/// A camera in world space, which a picture is rendered from.
struct CameraView {
    glm::mat4 worldFromCamera{1.0f};  ///< A rigid transform.
    float verticalFov = 0.785398f;    ///< Radians, over 0 and under pi; not used by an orthographic view.
    float nearPlane = 0.01f;          ///< Metres, over 0; of an orthographic view 0 or more.
    /// Metres, over 0: an orthographic view of a frame that is so high. None: a perspective view.
    std::optional<float> orthographicHeight = {};
    /// Metres, over the near plane: nothing beyond is drawn. None: at infinity.
    std::optional<float> farPlane = {};
    /// Off-centre projection: how far right of and above the view axis the middle of the picture lies, in
    /// units of the picture's width and height; finite. (0.5, 0) has the axis at the left edge.
    glm::vec2 shift{0.0f};
    /// Width over height of what the picture shows on a plane across the view axis; finite and over 0. None:
    /// that of its counts of pixels, so that pixels are squares.
    std::optional<float> aspect = {};

    glm::vec3 eye() const { return glm::vec3(worldFromCamera[3]); }
};

/// A view from `eye` towards `target`, world space, metres, +Y up (+Z up when looking along Y). Throws
/// `Error` (badInput) when the two coincide, when a number is not finite, or when `verticalFov` (radians)
/// does not lie between 0 and pi.
CANDELA_API CameraView lookAt(const glm::vec3& eye, const glm::vec3& target, float verticalFov);

/// Clip space from camera space, with reversed depth: 1 at the near plane, and 0 at the far plane or at
/// infinity where there is none. `aspect` is width over height; read where `CameraView::aspect` is none.
/// Throws `Error` (badInput) when `aspect` or a member of the view is not in the range that it states, or an
/// orthographic view has no far plane.
CANDELA_API glm::mat4 projection(const CameraView& view, float aspect);

/// What clip space has at the near and the far plane, as z / w.
enum class ClipDepth {
    negativeOneToOne,  ///< -1 at the near plane, 1 at the far one: OpenGL's default.
    zeroToOne,         ///< 0 at the near plane, 1 at the far one: Vulkan, Direct3D, Metal.
    oneToZero,         ///< Reversed, 1 at the near plane, 0 at the far one: candela's own.
};

/// The view that a projection matrix of a host describes: perspective or orthographic, off-centre, with any
/// field of view in each direction, with or without a far plane. `clipFromCamera` takes camera space (it
/// looks along -Z, +Y up) to clip space with +Y up. Throws `Error` (badInput) that names what the matrix has
/// beyond that: numbers that are not finite, rotation, skew, mirroring, or planes that the depth does not
/// tell.
CANDELA_API CameraView viewOfProjection(const glm::mat4& worldFromCamera, const glm::mat4& clipFromCamera,
                                        ClipDepth depth);

/// A pinhole camera as computer vision describes it, pixels: x to the right and y down from the upper left
/// corner of the picture.
struct CameraIntrinsics {
    double focalX = 0.0, focalY = 0.0;    ///< Over 0 and finite.
    double centerX = 0.0, centerY = 0.0;  ///< The principal point: (width / 2, height / 2) is the middle.
    int width = 0, height = 0;            ///< Of the picture, 1 or more.
};

/// The view of such a camera, for pictures of its size. The middle of the upper left pixel is (0.5, 0.5):
/// intrinsics that have it at (0, 0), as OpenCV's, take 0.5 more as their centre. Throws `Error` (badInput)
/// when a number is not in the range that it states.
CANDELA_API CameraView viewOfIntrinsics(const glm::mat4& worldFromCamera, const CameraIntrinsics& camera);

/// The views of two eyes, left and right, side by side across the view axis: parallel, with off-centre
/// projections that meet in the plane `convergence` metres away, which has no parallax on the screen.
/// `eyeDistance`: metres, 0 or more. `aspect`: width over height of the picture of one eye; read where the
/// view has none. Throws `Error` (badInput) when a number is not finite or out of its range, or the view is
/// orthographic.
CANDELA_API std::array<CameraView, 2> stereoViews(const CameraView& view, float eyeDistance,
                                                  float convergence, float aspect);

/// The views of the faces of a cube around the eye of `view`, 90 degrees each, for square pictures: right,
/// left, up, down, ahead, behind (the order +X, -X, +Y, -Y, -Z, +Z in camera space). Up is up in those to the
/// sides; up has behind at its top, down has ahead there. `margin` is the share of a face's side by which it
/// extends beyond each of its edges, 0 to 1. Near and far planes are those of `view`. Throws `Error`
/// (badInput) when `margin` is out of its range or the view is orthographic.
CANDELA_API std::array<CameraView, 6> cubeViews(const CameraView& view, float margin = 0.0f);

}  // namespace candela
