#include "scene/model/animation.h"

#include <candela/scene.h>

#include <glm/mat4x3.hpp>

#include <cassert>

namespace candela {

namespace {

void addMorphTargets(const Cage& cage, const std::vector<float>& weights, std::vector<glm::vec3>& points) {
    for (std::size_t target = 0; target < weights.size(); ++target) {
        if (weights[target] == 0.0f) continue;
        const std::vector<glm::vec3>& offsets = cage.morphTargets[target].offsets;
        for (std::size_t i = 0; i < points.size(); ++i) points[i] += weights[target] * offsets[i];
    }
}

// What takes a point from the cage's frame to where each joint carries it in the world. In double precision:
// far from the origin the translations of the two factors cancel.
std::vector<glm::dmat4x3> jointMatrices(const Skin& skin, const std::vector<glm::mat4>& world) {
    std::vector<glm::dmat4x3> matrices;
    matrices.reserve(skin.joints.size());
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        matrices.emplace_back(glm::dmat4(world[skin.joints[i]]) * glm::dmat4(skin.inverseBindMatrices[i]));
    }
    return matrices;
}

void carryByJoints(const Cage& cage, const std::vector<glm::dmat4x3>& joints,
                   std::vector<glm::vec3>& points) {
    std::size_t influence = 0;
    for (glm::vec3& point : points) {
        const glm::dvec4 rest(point, 1.0);
        glm::dvec3 carried(0.0);
        double sum = 0.0;
        for (const std::size_t end = influence + cage.influenceCount; influence < end; ++influence) {
            const double weight = cage.jointWeights[influence];
            if (weight == 0.0) continue;
            carried += weight * (joints[cage.joints[influence]] * rest);
            sum += weight;
        }
        // Rounded weights would pull the point towards the world's origin.
        point = glm::vec3(carried / sum);
    }
}

}  // namespace

PosedCage poseCage(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
    assert(world.size() == scene.nodes.size() && scene.nodes[node].cage);
    const CageInstance& shown = *scene.nodes[node].cage;
    const Cage& cage = scene.cages[shown.cage];
    PosedCage posed{cage.positions, world[node]};
    if (!cage.morphTargets.empty()) addMorphTargets(cage, morphWeightsAt(scene, node, time), posed.points);
    if (!shown.skin) return posed;
    carryByJoints(cage, jointMatrices(scene.skins[*shown.skin], world), posed.points);
    posed.worldFromPoints = glm::mat4(1.0f);
    return posed;
}

}  // namespace candela
