#include "render/occlusion/occlusion_scene.h"

#include "render/gpu_scene/gpu_scene_state.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>
#include <optional>

namespace candela {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::uint64_t versionOf(const GpuScene::State& scene, const DrawGeometry& geometry, std::uint32_t mesh) {
    switch (geometry.kind) {
        case DrawGeometry::Kind::deformedMesh:
            return scene.deformations.version(geometry.index);
        case DrawGeometry::Kind::cage:
            return scene.cages.surface(geometry.index).version();
        default:
            return scene.meshes.version(mesh);
    }
}

glm::mat4 worldFromLocal(const GpuScene::State& scene, std::uint32_t index) {
    const Instance& instance = scene.instances[index];
    if (!instance.mesh) return scene.cages.instances()[instance.cageInstance].worldFromPoints;
    if (const std::optional<std::uint32_t> deformed = scene.deformations.ofNode(instance.node))
        return scene.deformations.placement(*deformed).worldFromLocal;
    return scene.transforms.world()[instance.node];
}

/// An instance that shows the geometry. That of a limit surface may show another one by now.
std::optional<std::uint32_t> instanceShowing(const GpuScene::State& scene, const DrawGeometry& geometry,
                                             std::uint32_t first) {
    if (geometry.kind != DrawGeometry::Kind::cage) return first;
    const std::span<const std::uint32_t> users = scene.cages.instancesOf(geometry.index);
    if (users.empty()) return std::nullopt;
    return scene.instances.cageOf(scene.cages.instances()[users.front()].node);
}

/// A box around the transformed box, with more than the rounding of its corners and of rays' positions.
Bounds transformed(const Bounds& box, const glm::mat4& matrix) {
    Bounds result;
    if (box.empty()) return result;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                          corner & 4 ? box.max.z : box.min.z);
        const glm::vec3 q(matrix * glm::vec4(p, 1.0f));
        result.add({q, q});
    }
    constexpr float rounding = 1.0e-6f;
    const glm::vec3 largest = glm::max(glm::abs(result.min), glm::abs(result.max));
    const float margin = rounding * std::max({largest.x, largest.y, largest.z});
    return {result.min - margin, result.max + margin};
}

/// Three rows of four numbers.
void writeRows(float (&rows)[12], const glm::mat4& matrix) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) rows[4 * row + column] = matrix[column][row];
    }
}

}  // namespace

void OcclusionScene::update(GpuScene::State& scene) {
    const Clock::time_point start = Clock::now();
    std::vector<std::uint32_t> changed = scene.instances.takeChanged();
    if (instances_.empty()) {
        changed.resize(scene.instances.size());
        std::iota(changed.begin(), changed.end(), 0u);
    }
    // Instances that are new come in the order of their indices.
    std::ranges::sort(changed);
    instances_.resize(scene.instances.size());
    instanceViews_.resize(scene.instances.size());
    if (imagesVersion_ != scene.imagesVersion) alphaImages_.clear();
    imagesVersion_ = scene.imagesVersion;
    for (const std::uint32_t index : changed) updateUsers(scene, index);
    updateMeshes(scene);
    for (const std::uint32_t index : changed) updateInstance(scene, index);
    if (meshesChanged_) listUsersOfNewMeshes(changed);
    if (!changed.empty() || meshesChanged_) {
        embree_.commit();
        placeInstances(changed);
    }
    updateMilliseconds_ = millisecondsSince(start);
}

/// Adds the mesh of an instance where no other shows it.
std::uint32_t OcclusionScene::meshOf(const GpuScene::State& scene, std::uint32_t instance) {
    const DrawGeometry geometry = scene.draws.geometryOf(instance);
    const bool shared = geometry.kind == DrawGeometry::Kind::meshes;
    const MeshKey key{geometry, shared ? scene.instances[instance].mesh.value_or(0) : 0};
    const auto [entry, added] = meshIndices_.try_emplace(key, static_cast<std::uint32_t>(meshes_.size()));
    if (added) {
        meshes_.emplace_back().geometry = geometry;
        meshes_.back().sceneMesh = key.second;
    }
    return entry->second;
}

void OcclusionScene::updateUsers(const GpuScene::State& scene, std::uint32_t instance) {
    std::uint32_t& mesh = instances_[instance].mesh;
    const std::uint32_t before = mesh;
    mesh = scene.instances[instance].isRemoved ? noMesh : meshOf(scene, instance);
    if (mesh != noMesh) {
        ++meshes_[mesh].users;
        meshes_[mesh].instance = instance;
    }
    if (before == noMesh) return;
    MeshEntry& left = meshes_[before];
    --left.users;
    if (left.users == 0 || left.instance != instance || mesh == before) return;
    const auto other = std::ranges::find(instances_, before, &InstanceEntry::mesh);
    left.instance = static_cast<std::uint32_t>(other - instances_.begin());
}

/// Frees what belongs to a mesh that no instance shows any more.
void OcclusionScene::release(std::uint32_t index) {
    MeshEntry& entry = meshes_[index];
    entry.version = 0;
    if (!entry.mesh || entry.mesh->triangles.empty()) return;
    const auto nothing = std::make_shared<OcclusionMesh>();
    entry.tree = {};
    entry.blocks.clear();
    entry.blends = false;
    entry.mesh = nothing;
    entry.isNew = entry.isNewToShaders = true;
    embree_.setMesh(index, nothing);
    meshesChanged_ = true;
}

void OcclusionScene::updateMeshes(const GpuScene::State& scene) {
    meshesChanged_ = false;
    for (std::uint32_t i = 0; i < meshes_.size(); ++i) {
        MeshEntry& mesh = meshes_[i];
        if (mesh.users == 0) {
            release(i);
            continue;
        }
        const std::uint64_t version = versionOf(scene, mesh.geometry, mesh.sceneMesh);
        bool stale = mesh.version != version;
        if (mesh.alphaVersion != scene.alphaVersion) {
            const bool readsAlpha = hasAlphaPart(scene, mesh.instance);
            stale = stale || readsAlpha || mesh.readsAlpha;
            mesh.readsAlpha = readsAlpha;
            mesh.alphaVersion = scene.alphaVersion;
        }
        if (!stale) continue;
        mesh.version = version;
        build(scene, i);
        meshesChanged_ = true;
    }
}

void OcclusionScene::build(const GpuScene::State& scene, std::uint32_t index) {
    MeshEntry& entry = meshes_[index];
    const std::optional<std::uint32_t> instance = instanceShowing(scene, entry.geometry, entry.instance);
    if (!instance) return;
    const Clock::time_point start = Clock::now();
    const auto mesh = std::make_shared<OcclusionMesh>(readOcclusionMesh(scene, *instance, alphaImages_));
    const TriangleSpan triangles{mesh->positions, mesh->triangles};
    if (entry.mesh && entry.mesh->triangles == mesh->triangles) {
        refit(entry.tree, triangles);
    } else {
        entry.tree = buildWideTree(triangles);
    }
    fillTriangleBlocks(entry.tree, triangles, entry.blocks);
    entry.blends = std::ranges::any_of(mesh->cutouts, &CutoutTriangle::dims);
    entry.mesh = mesh;
    entry.isNew = entry.isNewToShaders = true;
    embree_.setMesh(index, mesh);
    entry.buildMilliseconds = millisecondsSince(start);
}

void OcclusionScene::updateInstance(const GpuScene::State& scene, std::uint32_t index) {
    InstanceEntry& instance = instances_[index];
    if (instance.mesh == noMesh) {
        instance.casts = false;
        embree_.disableInstance(index);
        return;
    }
    instance.casts =
        !scene.instances.isHidden(index) && scene.sceneState.nodes[scene.instances[index].node].castsShadow;
    instance.worldFromLocal = worldFromLocal(scene, index);
    embree_.setInstance(index, {instance.mesh, instance.worldFromLocal, instance.casts});
}

/// The boxes of their meshes are other ones.
void OcclusionScene::listUsersOfNewMeshes(std::vector<std::uint32_t>& instances) {
    for (std::uint32_t i = 0; i < instances_.size(); ++i) {
        if (instances_[i].mesh != noMesh && meshes_[instances_[i].mesh].isNew) instances.push_back(i);
    }
    for (MeshEntry& mesh : meshes_) mesh.isNew = false;
    std::ranges::sort(instances);
    const auto repeated = std::ranges::unique(instances);
    instances.erase(repeated.begin(), repeated.end());
}

void OcclusionScene::placeInstances(std::span<const std::uint32_t> instances) {
    std::vector<InstanceTree::Change> boxes;
    boxes.reserve(instances.size());
    for (const std::uint32_t index : instances) {
        InstanceEntry& instance = instances_[index];
        boxes.push_back({index, placeInstance(index)});
        const bool blends = isTraceable(boxes.back().box) && meshes_[instance.mesh].blends;
        blending_ = blending_ - (instance.blends ? 1 : 0) + (blends ? 1 : 0);
        instance.blends = blends;
        if (!instance.isNewToShaders) newToShaders_.push_back(index);
        instance.isNewToShaders = true;
    }
    top_.update(boxes);
    view_ = {top_.empty() ? nullptr : top_.nodes().data(), instanceViews_.data(), &embree_,
             EmbreeScene::tracePacket, blending_ > 0};
}

/// Returns its world-space box, which is empty where it hides nothing.
Bounds OcclusionScene::placeInstance(std::uint32_t index) {
    const InstanceEntry& instance = instances_[index];
    if (!instance.casts || !isInvertible(instance.worldFromLocal)) return {};
    const MeshEntry& mesh = meshes_[instance.mesh];
    const Bounds box = transformed(mesh.tree.bounds, instance.worldFromLocal);
    if (!isTraceable(box)) return {};
    OcclusionInstanceView& view = instanceViews_[index];
    writeRows(view.localFromWorld, glm::inverse(instance.worldFromLocal));
    view.nodes = mesh.tree.nodes.data();
    view.blocks = mesh.blocks.data();
    view.opaqueCount = static_cast<std::uint32_t>(mesh.mesh->opaqueCount());
    return box;
}

void OcclusionScene::updateShaderForm() {
    const Clock::time_point start = Clock::now();
    if (!shaderForm_) shaderForm_.emplace();
    for (std::uint32_t i = 0; i < meshes_.size(); ++i) {
        MeshEntry& entry = meshes_[i];
        if (!entry.isNewToShaders || !entry.mesh) continue;
        shaderForm_->setMesh(i, *entry.mesh, entry.tree);
        entry.isNewToShaders = false;
    }
    if (!newToShaders_.empty()) updateShaderInstances();
    updateMilliseconds_ += millisecondsSince(start);
}

void OcclusionScene::updateShaderInstances() {
    for (const std::uint32_t index : newToShaders_) {
        const InstanceEntry& instance = instances_[index];
        const std::uint32_t mesh = instance.mesh == noMesh ? 0 : instance.mesh;
        shaderForm_->setInstance(index, {mesh, instance.worldFromLocal, instance.casts});
    }
    shaderForm_->setTree(top_.nodes(), top_.depth(), top_.takeChanges());
    for (const std::uint32_t index : newToShaders_) instances_[index].isNewToShaders = false;
    newToShaders_.clear();
}

OcclusionReport OcclusionScene::report() const {
    OcclusionReport report;
    report.bytes = embree_.bytes() + top_.bytes() + (shaderForm_ ? shaderForm_->bytes() : 0);
    for (const MeshEntry& entry : meshes_) {
        if (!entry.mesh) continue;
        report.triangles += entry.mesh->triangles.size();
        report.buildMilliseconds += entry.buildMilliseconds;
        report.bytes +=
            entry.tree.bytes() + entry.blocks.size() * sizeof(TriangleBlock) + entry.mesh->bytes();
    }
    report.instances = top_.size();
    report.updateMilliseconds = updateMilliseconds_;
    return report;
}

}  // namespace candela
