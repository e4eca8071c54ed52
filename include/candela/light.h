#pragma once

#include <candela/export.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace candela {

enum class LightType { point, spot, directional };

/// A punctual light of a scene, as in KHR_lights_punctual. It is given in the frame of its node.
struct Light {
    std::string name = {};
    LightType type = LightType::point;
    glm::vec3 color{1.0f};   ///< Linear Rec.709, 0 or more.
    float intensity = 1.0f;  ///< Luminous intensity in candela; for a directional light illuminance in lux.
    /// Metres, over 0. None: the renderer sets one: `GpuSceneOptions::rangeLoss`.
    std::optional<float> range = {};
    float innerConeAngle = 0.0f;             ///< Spot: radians, 0 or more, less than `outerConeAngle`.
    float outerConeAngle = 0.785398f;        ///< Spot: radians, at most pi / 2.
    glm::vec3 position{0.0f};                ///< In the node's frame.
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< In the node's frame, unit length: where the light goes.
    std::optional<std::uint32_t> node = {};  ///< Index into `Scene::nodes`; none: the world's frame.
    /// Whether surfaces keep its light from what lies behind them. False: it reaches all that is within its
    /// range.
    bool castsShadow = true;
    /// The radius of the sphere that emits the light, which softens the edges of shadows: metres, 0 (a point)
    /// or more; nodes do not scale it. It has no effect on a frame with one sample a pixel, whose shadows are
    /// those of a point. Directional: ignored.
    float radius = 0.0f;
};

/// A light in world space, as the renderer takes it (`GpuScene::setLights`). 100,000 of them make one upload.
struct WorldLight {
    LightType type = LightType::point;
    glm::vec3 position{0.0f};                ///< World, metres. Directional: ignored.
    float range = 0.0f;                      ///< Metres; 0: none given. Directional: ignored.
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< World, unit length. Point: ignored.
    glm::vec3 intensity{1.0f};               ///< Colour × candela (directional: × lux), linear Rec.709.
    float innerConeAngle = 0.0f;             ///< Radians.
    float outerConeAngle = 0.785398f;        ///< Radians.
    bool castsShadow = true;                 ///< As `Light::castsShadow`.
    float radius = 0.0f;                     ///< As `Light::radius`: metres.
};

/// A light of a scene in world space, below a node of the matrix `worldFromNode`: the identity for a light
/// without a node. As KHR_lights_punctual says, the node moves and rotates the light, but does not scale its
/// range or its intensity. Throws `Error` (badInput) when the matrix is not finite and affine, or the light
/// breaks what `Light` states; which node it names does not matter.
CANDELA_API WorldLight worldLight(const Light& light, const glm::mat4& worldFromNode = glm::mat4(1.0f));

/// The luminous intensity, in candela, of a point light that gives `lumen` over the whole sphere: lumen / 4
/// pi. Throws `Error` (badInput) unless `lumen` is finite and 0 or more.
CANDELA_API float candelaFromLumen(float lumen);

/// The luminous intensity, in candela, of a spot light of half angle `outerConeAngle` (radians) whose `lumen`
/// all fall evenly into its cone: lumen / (2 pi (1 - cos(outerConeAngle))). Throws `Error` (badInput) unless
/// `lumen` is finite and 0 or more, the angle over 0 and at most pi, and the result a finite float.
CANDELA_API float candelaFromLumen(float lumen, float outerConeAngle);

/// Lumen from radiant watt at the luminous efficacy of 683 lm/W, which glTF exporters use for "watt". Throws
/// `Error` (badInput) unless `watt` is finite and 0 or more, and the result a finite float.
CANDELA_API float lumenFromWatt(float watt);

}  // namespace candela
