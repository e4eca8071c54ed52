#include "scene/model/deformation.h"

#include "base/thread_pool.h"
#include "scene/model/animation.h"
#include "scene/model/frame_callback.h"
#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace candela {

DeformableVertices::DeformableVertices(const Mesh& mesh)
    : kind("mesh"),
      positions(mesh.positions),
      influenceCount(mesh.influenceCount),
      joints(mesh.joints),
      jointWeights(mesh.jointWeights),
      morphTargets(mesh.morphTargets) {}

DeformableVertices::DeformableVertices(const Cage& cage)
    : kind("cage"),
      positions(cage.positions),
      influenceCount(cage.influenceCount),
      joints(cage.joints),
      jointWeights(cage.jointWeights),
      morphTargets(cage.morphTargets) {}

std::size_t morphTargetCount(const Scene& scene, const Node& node) {
    const bool hasMesh = node.mesh && *node.mesh < scene.meshes.size();
    if (hasMesh && !scene.meshes[*node.mesh].morphTargets.empty())
        return scene.meshes[*node.mesh].morphTargets.size();
    const bool hasCage = node.cage && *node.cage < scene.cages.size();
    return hasCage ? scene.cages[*node.cage].morphTargets.size() : 0;
}

glm::dmat4x3 jointMatrix(const glm::mat4& worldFromJoint, const glm::mat4& inverseBind,
                         const glm::vec3& origin) {
    glm::dmat4 fromWorld(worldFromJoint);
    fromWorld[3] -= glm::dvec4(origin, 0.0);
    return glm::dmat4x3(fromWorld * glm::dmat4(inverseBind));
}

namespace {

void addMorphTargets(const DeformableVertices& shape, const std::vector<float>& weights,
                     const ErrorContext& element, std::vector<glm::vec3>& points) {
    if (!weights.empty())
        element.requireCount("morph weights", weights.size(), "targets", shape.morphTargets.size());
    for (std::size_t target = 0; target < weights.size(); ++target) {
        if (weights[target] == 0.0f) continue;
        const std::vector<glm::vec3>& offsets = shape.morphTargets[target].offsets;
        element.requireCount("offsets of a morph target", offsets.size(), "vertices", points.size());
        for (std::size_t i = 0; i < points.size(); ++i) points[i] += weights[target] * offsets[i];
    }
}

// For each joint the matrix that takes a point of the mesh or the cage to the world.
std::vector<glm::dmat4x3> jointMatrices(const Skin& skin, const std::vector<glm::mat4>& world,
                                        const ErrorContext& element) {
    element.requireCount("inverse bind matrices", skin.inverseBindMatrices.size(), "joints",
                         skin.joints.size());
    std::vector<glm::dmat4x3> matrices;
    matrices.reserve(skin.joints.size());
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        element.requireIndex("node", skin.joints[i], world.size());
        matrices.push_back(jointMatrix(world[skin.joints[i]], skin.inverseBindMatrices[i]));
    }
    return matrices;
}

// Linear blend skinning of one vertex.
glm::vec3 blended(const DeformableVertices& shape, std::size_t vertex, const glm::vec3& point,
                  const std::vector<glm::dmat4x3>& joints, const ErrorContext& element) {
    const glm::dvec4 rest(point, 1.0);
    glm::dvec3 position(0.0);
    double sum = 0.0;
    const std::size_t first = vertex * shape.influenceCount;
    for (std::size_t i = first; i < first + shape.influenceCount; ++i) {
        const double weight = shape.jointWeights[i];
        if (weight == 0.0) continue;
        const std::uint32_t joint = shape.joints[i];
        if (joint >= joints.size())
            element.refuse(std::string("its ") + shape.kind + " names a joint that its skin does not have");
        position += weight * (joints[joint] * rest);
        sum += weight;
    }
    if (!(sum > 0.0))
        element.refuse(std::string("the joint weights of a vertex of its ") + shape.kind +
                       " have no sum over 0");
    // Without the division, rounded weights would move the point towards the world's origin.
    return glm::vec3(position / sum);
}

void blendJoints(const DeformableVertices& shape, const std::vector<glm::dmat4x3>& joints,
                 const ErrorContext& element, std::vector<glm::vec3>& points) {
    const std::uint64_t influences = std::uint64_t{points.size()} * shape.influenceCount;
    element.requireCount("joints of its vertices", shape.joints.size(), "influences", influences);
    element.requireCount("joint weights of its vertices", shape.jointWeights.size(), "influences",
                         influences);
    constexpr std::size_t blockSize = 4096;
    ThreadPool::shared()->run((points.size() + blockSize - 1) / blockSize, [&](std::size_t block, unsigned) {
        const std::size_t end = std::min((block + 1) * blockSize, points.size());
        for (std::size_t i = block * blockSize; i < end; ++i)
            points[i] = blended(shape, i, points[i], joints, element);
    });
}

void requirePose(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world, double time) {
    ErrorContext("scene").requireIndex("node", node, scene.nodes.size());
    requireWorldMatrices(scene, world);
    requireTime(time);
}

// `shape` is what `node` shows. All but `shape`, skin and morph weights has been checked.
PosedPoints posePoints(const Scene& scene, std::uint32_t node, const DeformableVertices& shape,
                       const std::vector<glm::mat4>& world, double time) {
    const Node& shown = scene.nodes[node];
    const ErrorContext element("node", node, shown.name);
    element.requireIndex("skin", shown.skin, scene.skins.size());
    PosedPoints posed{{shape.positions.begin(), shape.positions.end()}, world[node]};
    if (!shape.morphTargets.empty())
        addMorphTargets(shape, morphWeightsAt(scene, node, time), element, posed.points);
    if (!isSkinned(shown, shape)) return posed;
    blendJoints(shape, jointMatrices(scene.skins[*shown.skin], world, element), element, posed.points);
    posed.worldFromPoints = glm::mat4(1.0f);
    return posed;
}

/// The vertices of a mesh or a cage as the frame callback has them.
template <typename Vertices>
PosedPoints posedBy(const Vertices* moved, std::size_t vertices, const ErrorContext& element,
                    const glm::mat4& worldFromNode) {
    element.require(moved != nullptr,
                    "the frame callback does not tell where the vertices of what it shows are");
    element.requireCount("vertices of the frame callback", moved->positions.size(), "vertices", vertices);
    return {moved->positions, worldFromNode};
}

}  // namespace

std::vector<float> morphWeightsAt(const Scene& scene, std::uint32_t node, double time) {
    std::vector<float> weights = scene.nodes[node].morphWeights;
    for (std::size_t a = 0; a < scene.animations.size(); ++a) {
        const Animation& animation = scene.animations[a];
        if (!animation.plays) continue;
        for (std::size_t c = 0; c < animation.channels.size(); ++c) {
            const AnimationChannel& channel = animation.channels[c];
            if (channel.node != node || channel.path != AnimationPath::morphWeights) continue;
            requireChannel(channel, c, scene, ErrorContext("animation", a, animation.name));
            weights.resize(morphTargetCount(scene, scene.nodes[node]));
            applyMorphWeights(channel, time, weights);
        }
    }
    return weights;
}

PosedPoints poseMesh(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world,
                     double time) {
    requirePose(scene, node, world, time);
    const ErrorContext element("node", node, scene.nodes[node].name);
    const std::optional<std::uint32_t> mesh = scene.nodes[node].mesh;
    element.require(mesh.has_value(), "it has no mesh to pose");
    element.requireIndex("mesh", mesh, scene.meshes.size());
    if (!movesMesh(scene, *mesh))
        return posePoints(scene, node, DeformableVertices(scene.meshes[*mesh]), world, time);
    const std::shared_ptr<const SceneUpdate> update = updateAt(scene, time);
    return posedBy(update->ofMesh(*mesh), scene.meshes[*mesh].positions.size(), element, world[node]);
}

PosedPoints poseCage(const Scene& scene, std::uint32_t node, const std::vector<glm::mat4>& world,
                     double time) {
    requirePose(scene, node, world, time);
    const ErrorContext element("node", node, scene.nodes[node].name);
    const std::optional<std::uint32_t> cage = scene.nodes[node].cage;
    element.require(cage.has_value(), "it has no cage to pose");
    element.requireIndex("cage", cage, scene.cages.size());
    if (!movesCage(scene, *cage))
        return posePoints(scene, node, DeformableVertices(scene.cages[*cage]), world, time);
    const std::shared_ptr<const SceneUpdate> update = updateAt(scene, time);
    return posedBy(update->ofCage(*cage), scene.cages[*cage].positions.size(), element, world[node]);
}

}  // namespace candela
