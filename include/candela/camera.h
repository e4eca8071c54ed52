#pragma once

#include <candela/export.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace candela {

/// A camera of a scene. It looks along -Z of its node's frame with +Y up.
struct Camera {
    std::string name;               ///< The camera's own; its node may have another one.
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

    glm::vec3 eye() const { return glm::vec3(worldFromCamera[3]); }
};

/// A view from `eye` towards `target`, world space, metres, +Y up (+Z up when looking along Y). Throws
/// `Error` (badInput) when the two coincide, when a number is not finite, or when `verticalFov` (radians)
/// does not lie between 0 and pi.
CANDELA_API CameraView lookAt(const glm::vec3& eye, const glm::vec3& target, float verticalFov);

/// Clip space from camera space, with reversed depth: 1 at the near plane, and 0 at the far plane or at
/// infinity where there is none. `aspect` is width over height. Throws `Error` (badInput) when `aspect` or a
/// member of the view is not in the range that it states, or an orthographic view has no far plane.
CANDELA_API glm::mat4 projection(const CameraView& view, float aspect);

}  // namespace candela
