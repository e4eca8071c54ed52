#include "scene/model/deformation.h"
#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace candela {

void requireInfluences(const DeformableVertices& shape, const ErrorContext& element) {
    const std::size_t each = shape.influenceCount;
    const std::uint64_t count = std::uint64_t{shape.positions.size()} * each;
    element.requireCount("joints", shape.joints.size(), "influences", count);
    element.requireCount("joint weights", shape.jointWeights.size(), "influences", count);
    if (each == 0) return;
    for (std::size_t vertex = 0; vertex < shape.positions.size(); ++vertex) {
        float sum = 0.0f;
        for (std::size_t i = vertex * each; i < (vertex + 1) * each; ++i) {
            // False for a NaN; an infinite weight makes an infinite sum.
            if (!(shape.jointWeights[i] >= 0.0f))
                element.refuse("a joint weight of vertex " + std::to_string(vertex) + " is not 0 or more");
            sum += shape.jointWeights[i];
        }
        if (std::abs(sum - 1.0f) <= weightSumTolerance) continue;
        element.refuse("the joint weights of vertex " + std::to_string(vertex) + " have the sum " +
                       shortNumber(sum) + ", but 1 was expected");
    }
}

void requireMorphTargets(const DeformableVertices& shape, const ErrorContext& element) {
    for (std::size_t i = 0; i < shape.morphTargets.size(); ++i) {
        const MorphTarget& target = shape.morphTargets[i];
        const std::string label = "morph target " + std::to_string(i);
        const auto requireOffsets = [&](const std::vector<glm::vec3>& offsets, const std::string& what) {
            element.requireCount((what + "offsets in " + label).c_str(), offsets.size(), "vertices",
                                 shape.positions.size());
            element.requireEachFinite((label + ": " + what + "offset").c_str(), offsets);
        };
        requireOffsets(target.offsets, "");
        if (!target.normalOffsets.empty()) requireOffsets(target.normalOffsets, "normal ");
        if (!target.tangentOffsets.empty()) requireOffsets(target.tangentOffsets, "tangent ");
    }
}

void validateSkin(const Skin& skin, const Scene& scene, const ErrorContext& element) {
    element.require(!skin.joints.empty(), "it must have at least one joint");
    for (const std::uint32_t joint : skin.joints) element.requireIndex("node", joint, scene.nodes.size());
    element.requireCount("inverse bind matrices", skin.inverseBindMatrices.size(), "joints",
                         skin.joints.size());
    element.requireEach("inverse bind matrix", skin.inverseBindMatrices, "must be finite numbers",
                        [](const glm::mat4& matrix) { return allFinite(matrix); });
    element.requireEach("inverse bind matrix", skin.inverseBindMatrices,
                        "must be affine: a last row of 0, 0, 0, 1", isAffine);
}

namespace {

// How many joints a skin must have for the meshes or the cages.
template <typename Shape>
std::vector<std::size_t> jointsNeededBy(const std::vector<Shape>& shapes) {
    std::vector<std::size_t> counts;
    counts.reserve(shapes.size());
    for (const Shape& shape : shapes) {
        const auto max = std::max_element(shape.joints.begin(), shape.joints.end());
        counts.push_back(max == shape.joints.end() ? 0 : std::size_t{*max} + 1);
    }
    return counts;
}

void requireWeights(const Node& node, const DeformableVertices& shape, const ErrorContext& element) {
    if (node.morphWeights.empty() || shape.morphTargets.empty()) return;
    if (node.morphWeights.size() == shape.morphTargets.size()) return;
    element.refuse("has " + std::to_string(node.morphWeights.size()) + " morph weights, but its " +
                   shape.kind + " has " + std::to_string(shape.morphTargets.size()) + " morph targets");
}

void requireJoints(const Node& node, const DeformableVertices& shape, std::size_t needed, const Scene& scene,
                   const ErrorContext& element) {
    if (!isSkinned(node, shape)) return;
    const std::size_t joints = scene.skins[*node.skin].joints.size();
    if (needed <= joints) return;
    element.refuse(std::string("its ") + shape.kind + " names joint " + std::to_string(needed - 1) +
                   ", but its skin has " + std::to_string(joints));
}

}  // namespace

void validateDeformations(const Scene& scene) {
    const std::vector<std::size_t> ofMeshes = jointsNeededBy(scene.meshes);
    const std::vector<std::size_t> ofCages = jointsNeededBy(scene.cages);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        const ErrorContext element("node", i, node.name);
        element.requireEach("morph weight", node.morphWeights, "must be a finite number of at most 1e9",
                            [](float weight) { return std::abs(weight) <= maxAnimated; });
        bool hasJoints = false, hasTargets = false;
        const auto requireFit = [&](const DeformableVertices& shape, std::size_t joints) {
            hasJoints = hasJoints || shape.influenceCount > 0;
            hasTargets = hasTargets || !shape.morphTargets.empty();
            requireWeights(node, shape, element);
            requireJoints(node, shape, joints, scene, element);
            const bool equal =
                shape.morphTargets.empty() || shape.morphTargets.size() == morphTargetCount(scene, node);
            element.require(equal, "its mesh and its cage have different numbers of morph targets");
        };
        if (node.mesh) requireFit(DeformableVertices(scene.meshes[*node.mesh]), ofMeshes[*node.mesh]);
        if (node.cage) requireFit(DeformableVertices(scene.cages[*node.cage]), ofCages[*node.cage]);
        element.require(!node.skin || hasJoints,
                        "has a skin, but no joint moves a vertex of its mesh or its cage");
        element.require(node.morphWeights.empty() || hasTargets,
                        "has morph weights, but its mesh and its cage have no morph targets");
    }
}

}  // namespace candela
