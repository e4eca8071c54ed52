#pragma once

#include <candela/scene.h>

#include <glm/mat4x3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The vertices of a mesh or a cage, with what deforms them. Refers to the arrays of the mesh or the cage.
struct DeformableVertices {
    explicit DeformableVertices(const Mesh& mesh);
    explicit DeformableVertices(const Cage& cage);

    const char* kind;  ///< "mesh" or "cage", as errors say.
    std::span<const glm::vec3> positions;
    std::uint32_t influenceCount;
    std::span<const std::uint32_t> joints;
    std::span<const float> jointWeights;
    std::span<const MorphTarget> morphTargets;
};

/// Does the skin of its node move this?
template <typename Shape>
bool isSkinned(const Node& node, const Shape& shape) {
    return node.skin.has_value() && shape.influenceCount > 0;
}

/// Does its skin or a morph target move this?
template <typename Shape>
bool isDeformed(const Node& node, const Shape& shape) {
    return isSkinned(node, shape) || !shape.morphTargets.empty();
}

/// The number of morph targets of what a node shows: those of its mesh, or else of its cage. Mesh and cage
/// that do not exist have none.
std::size_t morphTargetCount(const Scene& scene, const Node& node);

/// The weights at `time` of the morph targets of what `node` shows: those of the last channels that play and
/// animate them, else the node's own. May be empty: all 0. Throws `Error` (badInput) when a channel does not
/// fit the node.
std::vector<float> morphWeightsAt(const Scene& scene, std::uint32_t node, double time);

/// The matrix that takes a point from where the joint found it when it was bound to `origin` of the world. In
/// double precision: far from the world's origin the translations of the factors cancel.
glm::dmat4x3 jointMatrix(const glm::mat4& worldFromJoint, const glm::mat4& inverseBind,
                         const glm::vec3& origin = glm::vec3(0.0f));

}  // namespace candela
