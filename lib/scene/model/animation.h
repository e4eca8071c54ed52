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

/// The same for a channel of morph weights: one a morph target.
std::vector<float> sampleMorphWeights(const AnimationChannel& channel, double time);

/// A node as animations pose it.
struct PosedNode {
    std::uint32_t node = 0;
    Transform trs;
};

/// The nodes whose transforms are animated, at `time`, in growing order of node; where two animations move
/// the same property, the later one in the scene holds.
std::vector<PosedNode> poseAnimatedNodes(const Scene& scene, double time);

/// The local matrix of a node's transform.
glm::mat4 localMatrix(const std::variant<Transform, glm::mat4>& transform);

/// The weights at `time` of the morph targets of the cage that `node` shows: those of the last channel that
/// animates them, else the node's own. May be empty: all 0.
std::vector<float> morphWeightsAt(const Scene& scene, std::uint32_t node, double time);

}  // namespace candela
