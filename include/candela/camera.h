#pragma once

#include <candela/export.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace candela {

/// A camera of a scene. It looks along -Z of its node's frame with +Y up.
struct Camera {
    std::string name;               ///< The camera's own; its node may have another one.
    float verticalFov = 0.785398f;  ///< Radians, over 0 and under pi; default 45 degrees.
    std::optional<float> nearPlane =
        {};                             ///< Metres, over 0. None: `defaultNearPlane` of what the scene shows.
    std::optional<std::uint32_t> node;  ///< Index into `Scene::nodes`; none: the world's frame.
    /// The camera's number in its file, by which a user may name it. None: its index in `Scene::cameras`.
    std::optional<std::uint32_t> number = {};
};

/// A camera in world space, which a picture is rendered from.
struct CameraView {
    glm::mat4 worldFromCamera{1.0f};  ///< A rigid transform.
    float verticalFov = 0.785398f;    ///< Radians, over 0 and under pi.
    float nearPlane = 0.01f;          ///< Metres, over 0.

    glm::vec3 eye() const { return glm::vec3(worldFromCamera[3]); }
};

/// A view from `eye` towards `target`, world space, metres, +Y up (+Z up when looking along Y). Throws
/// `Error` (badInput) when the two coincide, when a number is not finite, or when `verticalFov` (radians)
/// does not lie between 0 and pi.
CANDELA_API CameraView lookAt(const glm::vec3& eye, const glm::vec3& target, float verticalFov);

/// Clip space from camera space: reversed depth in 0..1 with 1 at the near plane and 0 at infinity. `aspect`
/// is width over height. Throws `Error` (badInput) when `aspect` or the near plane is not finite and over 0,
/// or the field of view does not lie between 0 and pi.
CANDELA_API glm::mat4 projection(const CameraView& view, float aspect);

}  // namespace candela
