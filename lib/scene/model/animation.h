#pragma once

#include <candela/scene.h>

#include <glm/vec4.hpp>

#include <cstdint>
#include <variant>
#include <vector>

namespace candela {

/// The value of a channel at `time` (seconds): x, y, z, and for rotations a unit quaternion x, y, z, w.
/// Follows glTF 2.0, appendix C. The channel keeps the rules of `AnimationChannel`, and is not one of morph
/// weights.
glm::dvec4 sampleChannel(const AnimationChannel& channel, double time);

/// Sets the weights that a channel of morph weights animates to their values at `time`. There is one weight
/// per morph target.
void applyMorphWeights(const AnimationChannel& channel, double time, std::vector<float>& weights);

/// A node as animations pose it.
struct PosedNode {
    std::uint32_t node = 0;
    Transform transform;
    glm::dvec3 translation{0.0};  ///< That of the transform in double precision.
};

/// Sets the property that the channel animates to its value at `time`; nothing for morph weights.
void applyChannel(const AnimationChannel& channel, double time, PosedNode& pose);

/// The nodes whose transforms are animated, at `time`, in ascending order of node; where two animations move
/// the same property, the later one in the scene applies. Throws `Error` (badInput) when a channel does not
/// fit its node.
std::vector<PosedNode> poseAnimatedNodes(const Scene& scene, double time);

/// The local matrix of a node's transform.
glm::mat4 localMatrix(const std::variant<Transform, glm::mat4>& transform);

/// The local translation of a node in double precision.
glm::dvec3 exactTranslation(const Node& node);

/// The local matrix in double precision, with `translation` in place of that of the transform.
glm::dmat4 exactLocalMatrix(const std::variant<Transform, glm::mat4>& transform,
                            const glm::dvec3& translation);

/// Whether world space is not that of the file, so that world matrices are composed in double precision.
inline bool isFar(const Scene& scene) {
    return scene.origin != glm::dvec3(0.0);
}

/// The world matrix of a node without parent, from its local one.
inline glm::dmat4 exactRootMatrix(const Scene& scene, glm::dmat4 local) {
    local[3] -= glm::dvec4(scene.origin, 0.0);
    return local;
}

/// One of `worldLights`. The light has passed `validate`, and `world` has one matrix per node.
WorldLight worldLight(const Light& light, const std::vector<glm::mat4>& world);

}  // namespace candela
