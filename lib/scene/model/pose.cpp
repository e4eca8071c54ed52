#include "scene/model/animation.h"
#include "scene/validate/scene_rules.h"

#include <candela/scene.h>

#include <glm/mat4x3.hpp>

#include <cmath>

namespace candela {

namespace {

void addMorphTargets(const Cage& cage, const std::vector<float>& weights, const ErrorContext& element,
                     std::vector<glm::vec3>& points) {
    if (!weights.empty())
        element.requireCount("morph weights", weights.size(), "targets", cage.morphTargets.size());
    for (std::size_t target = 0; target < weights.size(); ++target) {
        if (weights[target] == 0.0f) continue;
        const std::vector<glm::vec3>& offsets = cage.morphTargets[target].offsets;
        element.requireCount("offsets of a morph target", offsets.size(), "vertices", points.size());
        for (std::size_t i = 0; i < points.size(); ++i) points[i] += weights[target] * offsets[i];
    }
}

// For each joint the matrix that takes a point of the cage to the world. In double precision: far from the
// origin the translations of the two factors cancel.
std::vector<glm::dmat4x3> jointMatrices(const Skin& skin, const std::vector<glm::mat4>& world,
                                        const ErrorContext& element) {
    element.requireCount("inverse bind matrices", skin.inverseBindMatrices.size(), "joints",
                         skin.joints.size());
    std::vector<glm::dmat4x3> matrices;
    matrices.reserve(skin.joints.size());
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        element.requireIndex("node", skin.joints[i], world.size());
        matrices.emplace_back(glm::dmat4(world[skin.joints[i]]) * glm::dmat4(skin.inverseBindMatrices[i]));
    }
    return matrices;
}

// Linear blend skinning.
void blendJoints(const Cage& cage, const std::vector<glm::dmat4x3>& joints, const ErrorContext& element,
                 std::vector<glm::vec3>& points) {
    const std::uint64_t influences = std::uint64_t{points.size()} * cage.influenceCount;
    element.requireCount("joints of its cage", cage.joints.size(), "influences", influences);
    element.requireCount("joint weights of its cage", cage.jointWeights.size(), "influences", influences);
    std::size_t influence = 0;
    for (glm::vec3& point : points) {
        const glm::dvec4 rest(point, 1.0);
        glm::dvec3 blended(0.0);
        double sum = 0.0;
        for (const std::size_t end = influence + cage.influenceCount; influence < end; ++influence) {
            const double weight = cage.jointWeights[influence];
            if (weight == 0.0) continue;
            const std::uint32_t joint = cage.joints[influence];
            element.require(joint < joints.size(), "its cage names a joint that its skin does not have");
            blended += weight * (joints[joint] * rest);
            sum += weight;
        }
        element.require(sum > 0.0, "the joint weights of a vertex of its cage have no sum over 0");
        // Without the division, rounded weights would move the point towards the world's origin.
        point = glm::vec3(blended / sum);
    }
}

}  // namespace

PosedCage poseCage(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
    ErrorContext("scene").requireIndex("node", node, scene.nodes.size());
    requireWorldMatrices(scene, world);
    requireTime(time);
    const ErrorContext element("node", node, scene.nodes[node].name);
    element.require(scene.nodes[node].cage.has_value(), "it has no cage to pose");
    const CageInstance& instance = *scene.nodes[node].cage;
    element.requireIndex("cage", instance.cage, scene.cages.size());
    element.requireIndex("skin", instance.skin, scene.skins.size());
    const Cage& cage = scene.cages[instance.cage];
    PosedCage posed{cage.positions, world[node]};
    if (!cage.morphTargets.empty())
        addMorphTargets(cage, morphWeightsAt(scene, node, time), element, posed.points);
    if (!instance.skin) return posed;
    blendJoints(cage, jointMatrices(scene.skins[*instance.skin], world, element), element, posed.points);
    posed.worldFromPoints = glm::mat4(1.0f);
    return posed;
}

}  // namespace candela
