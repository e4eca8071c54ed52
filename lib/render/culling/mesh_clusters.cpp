#include "render/culling/mesh_clusters.h"

#include "base/thread_pool.h"

#include <algorithm>

namespace candela {

namespace {

constexpr std::uint32_t clusterIndices = 3 * layout::CLUSTER_TRIANGLES;

std::uint32_t clustersOf(std::uint32_t indexCount) {
    return (indexCount + clusterIndices - 1) / clusterIndices;
}

}  // namespace

/// Consecutive clusters of one part, for one thread.
struct MeshClusters::Task {
    MeshTriangles mesh;
    std::uint32_t firstIndex, endIndex, firstCluster;
};

MeshClusters::MeshClusters(std::span<const Mesh> meshes, const TriangleFilterKernel& kernel)
    : kernel_(&kernel), parts_(meshes.size()) {
    std::vector<Task> tasks;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        // What joints or morph targets move is drawn from other vertices.
        if (meshes[i].influenceCount != 0 || !meshes[i].morphTargets.empty()) continue;
        parts_[i] = partsOf(meshes[i].submeshes, meshes[i].indices.size(), count);
        addTasks(parts_[i], {meshes[i].positions, meshes[i].indices}, tasks);
    }
    clusters_.resize(count);
    compute(tasks);
}

std::vector<MeshClusters::Part> MeshClusters::partsOf(std::span<const Submesh> submeshes,
                                                      std::size_t indexCount, std::uint32_t& end) {
    std::vector<Part> parts;
    const Submesh whole{0, static_cast<std::uint32_t>(indexCount), std::nullopt};
    for (const Submesh& submesh : submeshes.empty() ? std::span(&whole, 1) : submeshes) {
        if (submesh.topology != Topology::triangles || submesh.indexCount < minIndices) continue;
        parts.push_back({submesh.firstIndex, submesh.indexCount, end});
        end += clustersOf(submesh.indexCount);
    }
    return parts;
}

void MeshClusters::addTasks(std::span<const Part> parts, const MeshTriangles& mesh,
                            std::vector<Task>& tasks) {
    constexpr std::uint32_t clustersPerTask = 32, step = clustersPerTask * clusterIndices;
    for (const Part& part : parts) {
        std::uint32_t end = 0;
        for (std::uint32_t first = 0; first < part.indexCount; first = end) {
            end = first + std::min(step, part.indexCount - first);
            tasks.push_back({mesh, part.firstIndex + first, part.firstIndex + end,
                             part.firstCluster + first / clusterIndices});
        }
    }
}

void MeshClusters::compute(std::span<const Task> tasks) {
    ThreadPool::shared()->run(tasks.size(), [&](std::size_t i, unsigned) {
        const Task& task = tasks[i];
        kernel_->bound({&task.mesh.positions.front().x, task.mesh.indices.data() + task.firstIndex,
                        (task.endIndex - task.firstIndex) / 3, clusters_.data() + task.firstCluster});
    });
    ++version_;
}

std::optional<ClusterRange> MeshClusters::of(std::uint32_t mesh, std::uint32_t firstIndex,
                                             std::uint32_t indexCount) const {
    for (const Part& part : parts_[mesh]) {
        if (part.firstIndex == firstIndex && part.indexCount == indexCount)
            return ClusterRange{part.firstCluster, clustersOf(indexCount)};
    }
    return std::nullopt;
}

void MeshClusters::move(std::uint32_t mesh, const MeshTriangles& moved) {
    std::vector<Task> tasks;
    addTasks(parts_[mesh], moved, tasks);
    compute(tasks);
}

void MeshClusters::forget(std::uint32_t mesh) {
    for (const Part& part : parts_[mesh]) {
        for (std::uint32_t i = 0; i < clustersOf(part.indexCount); ++i) {
            clusters_[part.firstCluster + i] = {};
            clusters_[part.firstCluster + i].radius = 1.0e30f;
        }
    }
    ++version_;
}

void MeshClusters::replace(std::uint32_t mesh, const Mesh& content) {
    if (mesh == parts_.size()) parts_.emplace_back();
    std::uint32_t first = 0, end = 0, count = 0;
    for (std::uint32_t i = 0; i < mesh; ++i)
        for (const Part& part : parts_[i]) first += clustersOf(part.indexCount);
    for (const Part& part : parts_[mesh]) count += clustersOf(part.indexCount);
    end = first;
    parts_[mesh] = partsOf(content.submeshes, content.indices.size(), end);
    const auto from = clusters_.begin() + first;
    clusters_.erase(from, from + count);
    clusters_.insert(clusters_.begin() + first, end - first, {});
    for (std::uint32_t i = mesh + 1; i < parts_.size(); ++i)
        for (Part& part : parts_[i]) part.firstCluster = part.firstCluster - count + (end - first);
    move(mesh, {content.positions, content.indices});
}

}  // namespace candela
