#include "render/deformation/gpu_deformations.h"

#include "base/thread_pool.h"
#include "scene/model/animation.h"
#include "scene/model/deformation.h"

#include <algorithm>
#include <utility>

namespace candela {

namespace {

bool animatesWeights(const AnimationChannel& channel, std::uint32_t node) {
    return channel.node == node && channel.path == AnimationPath::morphWeights;
}

bool hasMorphAnimation(const Scene& scene, std::uint32_t node) {
    return std::ranges::any_of(scene.animations, [&](const Animation& animation) {
        return std::ranges::any_of(animation.channels, [&](const AnimationChannel& channel) {
            return animatesWeights(channel, node);
        });
    });
}

/// The channels that play and animate the morph weights of `node`; the later ones apply.
std::vector<AnimationChannel> morphAnimations(const Scene& scene, std::uint32_t node) {
    std::vector<AnimationChannel> channels;
    for (const Animation& animation : scene.animations) {
        if (!animation.plays) continue;
        for (const AnimationChannel& channel : animation.channels) {
            if (!animatesWeights(channel, node)) continue;
            if (!channel.morphTarget) channels.clear();
            channels.push_back(channel);
        }
    }
    return channels;
}

bool areAllZero(const std::vector<float>& weights) {
    return std::ranges::all_of(weights, [](float weight) { return weight == 0.0f; });
}

}  // namespace

GpuDeformations::GpuDeformations(const Context& context, const Scene& scene, const Scene& kept,
                                 GpuMeshes::Detail detail, VertexEvaluator evaluator)
    : scene_(kept), detail_(detail), deformer_(context, evaluator) {
    addInstances(scene, detail);
    if (!empty()) listJoints();
}

void GpuDeformations::addInstances(const Scene& scene, GpuMeshes::Detail detail) {
    meshes_.resize(scene.meshes.size());
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        const Node& node = scene.nodes[i];
        if (!node.mesh) continue;
        const Mesh& mesh = scene.meshes[*node.mesh];
        const bool isAnimated = !mesh.morphTargets.empty() && hasMorphAnimation(scene, i);
        const bool isMorphed = isAnimated || (!mesh.morphTargets.empty() && !areAllZero(node.morphWeights));
        if (!isSkinned(node, mesh) && !isMorphed) continue;
        std::unique_ptr<MeshDeformation>& deformation = meshes_[*node.mesh];
        if (!deformation) deformation = std::make_unique<MeshDeformation>(mesh, detail);
        Instance& instance = *instances_.emplace_back(std::make_unique<Instance>());
        instance.placement.node = i;
        instance.placement.mesh = *node.mesh;
        instance.deformation = deformation.get();
        if (isSkinned(node, mesh)) instance.skin = node.skin;
        if (isMorphed && !areAllZero(node.morphWeights)) instance.morphWeights = node.morphWeights;
        instance.isAnimated = isAnimated;
        if (isAnimated) instance.animations = morphAnimations(scene, i);
    }
}

void GpuDeformations::listJoints() {
    instancesOfNode_.resize(scene_.nodes.size());
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        instancesOfNode_[instances_[i]->placement.node].push_back(i);
        if (!instances_[i]->skin) continue;
        for (const std::uint32_t joint : scene_.skins[*instances_[i]->skin].joints)
            instancesOfNode_[joint].push_back(i);
    }
}

std::optional<std::uint32_t> GpuDeformations::ofNode(std::uint32_t node) const {
    if (node >= instancesOfNode_.size()) return std::nullopt;
    for (const std::uint32_t index : instancesOfNode_[node]) {
        if (instances_[index]->placement.node == node) return index;
    }
    return std::nullopt;
}

void GpuDeformations::describe(const GpuMeshes& meshes, const gl::Buffer& drawRecords,
                               const DefaultDetail& defaultDetail) {
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        if (!isFree(i)) describe(i, meshes, drawRecords, defaultDetail);
    }
}

void GpuDeformations::describe(std::uint32_t index, const GpuMeshes& meshes, const gl::Buffer& drawRecords,
                               const DefaultDetail& defaultDetail) {
    Instance& instance = *instances_[index];
    MeshDeformation& deformation = *instance.deformation;
    instance.buffers.surface.reserve(deformation.surfaceBytes());
    if (deformation.hasTangents()) instance.buffers.tangents.reserve(deformation.tangentBytes());
    const gl::Buffer* tangents = deformation.hasTangents() ? &instance.buffers.tangents : nullptr;
    meshes.describeDeformed(instance.vertexArray, instance.placement.mesh,
                            {instance.buffers.surface, tangents}, drawRecords, defaultDetail);
}

void GpuDeformations::setMesh(std::uint32_t mesh, const Mesh& from) {
    if (mesh >= meshes_.size()) meshes_.resize(mesh + 1);
    meshes_[mesh].reset();
    if (from.influenceCount > 0 || !from.morphTargets.empty())
        meshes_[mesh] = std::make_unique<MeshDeformation>(from, detail_);
}

std::uint32_t GpuDeformations::add(std::uint32_t nodeIndex) {
    const Node& node = scene_.nodes[nodeIndex];
    // The place of a removed one would be taken for it by what knows deformed meshes by their versions.
    const auto index = static_cast<std::uint32_t>(instances_.size());
    Instance& instance = *instances_.emplace_back(std::make_unique<Instance>());
    instance.placement.node = nodeIndex;
    instance.placement.mesh = *node.mesh;
    instance.deformation = meshes_[*node.mesh].get();
    instance.skin = node.skin;
    if (!areAllZero(node.morphWeights)) instance.morphWeights = node.morphWeights;
    if (instancesOfNode_.size() < scene_.nodes.size()) instancesOfNode_.resize(scene_.nodes.size());
    instancesOfNode_[nodeIndex].push_back(index);
    if (instance.skin) {
        for (const std::uint32_t joint : scene_.skins[*instance.skin].joints)
            instancesOfNode_[joint].push_back(index);
    }
    mark(index);
    return index;
}

void GpuDeformations::remove(std::uint32_t index) {
    const Instance& instance = *instances_[index];
    std::erase(instancesOfNode_[instance.placement.node], index);
    if (instance.skin) {
        for (const std::uint32_t joint : scene_.skins[*instance.skin].joints)
            std::erase(instancesOfNode_[joint], index);
    }
    std::erase(marked_, index);
    instances_[index].reset();
}

bool GpuDeformations::deforms(std::uint32_t mesh) const {
    return std::ranges::any_of(
        instances_, [&](const auto& instance) { return instance && instance->placement.mesh == mesh; });
}

void GpuDeformations::mark(std::uint32_t index) {
    if (std::exchange(instances_[index]->isMarked, true)) return;
    marked_.push_back(index);
}

void GpuDeformations::markNode(std::uint32_t node) {
    if (node >= instancesOfNode_.size()) return;
    for (const std::uint32_t index : instancesOfNode_[node]) mark(index);
}

void GpuDeformations::markAnimated() {
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        if (!isFree(i) && !instances_[i]->animations.empty()) mark(i);
    }
}

void GpuDeformations::selectAnimations() {
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        if (isFree(i)) continue;
        Instance& instance = *instances_[i];
        if (!instance.isAnimated) continue;
        instance.animations = morphAnimations(scene_, instance.placement.node);
        mark(i);
        if (!instance.animations.empty()) continue;
        instance.morphWeights = scene_.nodes[instance.placement.node].morphWeights;
        instance.isStale = true;
    }
}

std::span<const std::uint32_t> GpuDeformations::pose(const std::vector<glm::mat4>& world, double time) {
    posed_.swap(marked_);
    marked_.clear();
    if (posed_.empty()) return posed_;
    ThreadPool::shared()->run(
        posed_.size(), [&](std::size_t i, unsigned) { poseInstance(*instances_[posed_[i]], world, time); });
    return posed_;
}

void GpuDeformations::poseInstance(Instance& instance, const std::vector<glm::mat4>& world,
                                   double time) const {
    instance.isMarked = false;
    if (!instance.animations.empty()) {
        const Node& node = scene_.nodes[instance.placement.node];
        std::vector<float> weights = node.morphWeights;
        weights.resize(morphTargetCount(scene_, node));
        for (const AnimationChannel& channel : instance.animations) applyMorphWeights(channel, time, weights);
        if (weights != instance.morphWeights) instance.isStale = true;
        instance.morphWeights = std::move(weights);
    }
    if (!instance.skin) {
        instance.placement.worldFromLocal = world[instance.placement.node];
        instance.placement.sphere = instance.deformation->bounds(instance.morphWeights);
        return;
    }
    const Skin& skin = scene_.skins[*instance.skin];
    // Relative to a joint: far from the world's origin the vertices keep their digits.
    const glm::vec3 origin(world[skin.joints.front()][3]);
    std::vector<glm::dmat4x3> matrices;
    matrices.reserve(skin.joints.size());
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
        matrices.push_back(jointMatrix(world[skin.joints[i]], skin.inverseBindMatrices[i], origin));
    PosedJoints joints = posedJoints(matrices);
    if (joints.rows != instance.joints.rows) instance.isStale = true;
    instance.joints = std::move(joints);
    instance.placement.worldFromLocal = glm::mat4(1.0f);
    instance.placement.worldFromLocal[3] = glm::vec4(origin, 1.0f);
    instance.placement.sphere = instance.deformation->bounds(matrices, instance.morphWeights);
    instance.placement.winding = instance.joints.winding;
}

void GpuDeformations::deform(std::span<const std::uint32_t> indices) {
    requests_.clear();
    for (const std::uint32_t index : indices) {
        Instance& instance = *instances_[index];
        instance.isStale = false;
        ++instance.version;
        requests_.push_back({*instance.deformation, instance.skin ? &instance.joints : nullptr,
                             instance.morphWeights, instance.buffers});
    }
    deformer_.deform(requests_);
}

void GpuDeformations::keep() {
    for (const auto& instance : instances_) {
        if (!instance) continue;
        instance->keptJoints = instance->joints;
        instance->keptWeights = instance->morphWeights;
    }
}

std::vector<glm::vec3> GpuDeformations::keptPositions(std::uint32_t index) {
    const Instance& instance = *instances_[index];
    if (instance.keptJoints.rows == instance.joints.rows && instance.keptWeights == instance.morphWeights)
        return {};
    MeshDeformation& deformation = *instance.deformation;
    DeformedBuffers buffers;
    buffers.surface.reserve(deformation.surfaceBytes());
    if (deformation.hasTangents()) buffers.tangents.reserve(deformation.tangentBytes());
    const DeformRequest request{deformation, instance.skin ? &instance.keptJoints : nullptr,
                                instance.keptWeights, buffers};
    deformer_.deform({&request, 1});
    struct Vertex {
        glm::vec3 position, normal;
    };
    std::vector<glm::vec3> positions;
    for (const Vertex& vertex : buffers.surface.read<Vertex>(0, deformation.vertexCount()))
        positions.push_back(vertex.position);
    return positions;
}

DeformationReport GpuDeformations::report() const {
    DeformationReport report;
    for (const auto& instance : instances_) {
        if (!instance) continue;
        ++report.meshes;
        report.vertices += instance->deformation->vertexCount();
    }
    if (deformer_.lastUsed() != VertexEvaluator::automatic) report.evaluator = toString(deformer_.lastUsed());
    return report;
}

}  // namespace candela
