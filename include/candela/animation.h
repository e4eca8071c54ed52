#pragma once

#include <candela/export.h>
#include <candela/material.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

enum class AnimationPath { translation, rotation, scale, morphWeights };
enum class Interpolation { linear, step, cubicSpline };

/// The values of one property of one node over time.
struct AnimationChannel {
    /// Index into `Scene::nodes`. Its transform is a `Transform`, not a matrix. For morph weights the node
    /// shows a mesh or a cage with morph targets.
    std::uint32_t node = 0;
    AnimationPath path = AnimationPath::translation;
    Interpolation interpolation = Interpolation::linear;  ///< Linear is spherical for rotations.
    std::vector<float> times = {};                        ///< Seconds, strictly increasing, one or more.
    /// 3 numbers per key, 4 (x, y, z, w) for rotations, one per morph target for morph weights; cubic
    /// splines hold in-tangent, value and out-tangent.
    std::vector<float> values = {};
    /// Of morph weights: the only target whose weight changes, one number per key. None: all of them.
    std::optional<std::uint32_t> morphTarget = {};
};

/// A value of a node, a material, a light or a camera that animations may change: the member of that name. A
/// value is one number unless another count is given.
enum class AnimatedProperty {
    visibility,  ///< `Node::visible`, by step interpolation: 0 is false, every other number true.
    // Of a material.
    baseColor,  ///< 4 numbers.
    metallic,
    roughness,
    emission,  ///< 3 numbers.
    emissionStrength,
    normalScale,
    occlusionStrength,
    alphaCutoff,
    ior,
    specularFactor,
    specularColor,  ///< 3 numbers.
    clearcoatFactor,
    clearcoatRoughness,
    clearcoatNormalScale,
    sheenColor,  ///< 3 numbers.
    sheenRoughness,
    anisotropyStrength,
    anisotropyRotation,
    iridescenceFactor,
    iridescenceIor,
    iridescenceMinThickness,
    iridescenceMaxThickness,
    transmissionFactor,
    thickness,
    attenuationDistance,
    attenuationColor,  ///< 3 numbers.
    dispersion,
    diffuseTransmissionFactor,
    diffuseTransmissionColor,  ///< 3 numbers.
    // Of a texture of a material, which it has.
    textureOffset,  ///< 2 numbers.
    textureRotation,
    textureScale,  ///< 2 numbers.
    // Of a light.
    lightColor,  ///< 3 numbers.
    lightIntensity,
    lightRange,  ///< Of a light that has one.
    innerConeAngle,
    outerConeAngle,
    lightPosition,  ///< 3 numbers.
    // Of a camera, which has the value.
    verticalFov,  ///< Of a perspective camera.
    orthographicHeight,
    nearPlane,
    farPlane,
};

/// What a property is of.
enum class AnimatedElement { node, material, light, camera };

/// Throws `Error` (badInput) when there is no such property.
CANDELA_API AnimatedElement elementOf(AnimatedProperty property);

/// The values of one property over time. Values are in the range of the member that they change; one that is
/// over 0 is at least 1e-6, and one without a limit at most 1e9. Where a cubic spline leaves the range
/// between two keys, the nearest value within it counts.
struct PropertyChannel {
    AnimatedProperty property = AnimatedProperty::baseColor;
    /// Index into `Scene::nodes`, `materials`, `lights` or `cameras`, as `elementOf` says.
    std::uint32_t element = 0;
    TextureSlot texture = TextureSlot::baseColor;  ///< Of properties of textures.
    Interpolation interpolation = Interpolation::linear;
    std::vector<float> times = {};   ///< As in `AnimationChannel`.
    std::vector<float> values = {};  ///< So many numbers per key as a value has, three times as many for
                                     ///< cubic splines.
};

/// Channels that play together. Before its first key a channel holds its first value, after its last key its
/// last.
struct Animation {
    std::string name = {};
    std::vector<AnimationChannel> channels = {};
    bool plays = true;  ///< False: `worldTransforms` and the like pose nodes as if it were not there.
    std::vector<PropertyChannel> properties = {};
};

}  // namespace candela
