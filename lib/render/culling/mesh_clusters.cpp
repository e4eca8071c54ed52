#include "render/culling/mesh_clusters.h"

#include "base/thread_pool.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

constexpr std::uint32_t clusterIndices = 3 * layout::CLUSTER_TRIANGLES;

std::uint32_t clustersOf(std::uint32_t indexCount) {
    return (indexCount + clusterIndices - 1) / clusterIndices;
}

/// The vertices of a mesh and the triangles of a cluster.
struct ClusterTriangles {
    std::span<const glm::vec3> positions;
    std::span<const std::uint32_t> indices;

    const glm::vec3& corner(std::size_t i) const { return positions[indices[i]]; }
};

void boundPoints(const ClusterTriangles& triangles, layout::TriangleCluster& cluster) {
    glm::vec3 low = triangles.corner(0), high = low;
    for (std::size_t i = 1; i < triangles.indices.size(); ++i) {
        low = glm::min(low, triangles.corner(i));
        high = glm::max(high, triangles.corner(i));
    }
    const glm::vec3 center = low + 0.5f * (high - low);
    double farthest2 = 0.0;
    for (std::size_t i = 0; i < triangles.indices.size(); ++i) {
        const glm::dvec3 way = glm::dvec3(triangles.corner(i)) - glm::dvec3(center);
        farthest2 = std::max(farthest2, glm::dot(way, way));
    }
    for (int i = 0; i < 3; ++i) cluster.center[i] = center[i];
    // A little more, for what the tests round.
    cluster.radius = static_cast<float>(std::sqrt(farthest2) * 1.0001);
}

/// The normal, or zero where two corners are one: such a triangle covers nothing, however it is rounded.
struct Facet {
    glm::dvec3 normal{0.0};
    double altitude = 0.0;
};

Facet facetOf(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a, ac = c - a, bc = c - b;
    const double shortest2 = std::min({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    if (shortest2 == 0.0) return {};
    const glm::dvec3 doubled = glm::cross(ab, ac);
    const double area = glm::length(doubled);
    const double longest2 = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    return {area > 0.0 ? doubled / area : glm::dvec3(0.0, 0.0, 1.0), area / std::sqrt(longest2)};
}

void boundNormals(const ClusterTriangles& triangles, layout::TriangleCluster& cluster) {
    Facet facets[layout::CLUSTER_TRIANGLES];
    const std::size_t count = triangles.indices.size() / 3;
    glm::dvec3 sum(0.0);
    double altitude = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
        facets[i] =
            facetOf(triangles.corner(3 * i), triangles.corner(3 * i + 1), triangles.corner(3 * i + 2));
        sum += facets[i].normal;
        if (facets[i].normal != glm::dvec3(0.0)) altitude = std::min(altitude, facets[i].altitude);
    }
    const double length = glm::length(sum);
    if (length == 0.0) return;
    const glm::vec3 axis(sum / length);
    double cosine = 1.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (facets[i].normal != glm::dvec3(0.0))
            cosine = std::min(cosine, glm::dot(facets[i].normal, glm::dvec3(axis)));
    }
    for (int i = 0; i < 3; ++i) cluster.axis[i] = axis[i];
    // A little less, for what the axis and the tests round.
    cluster.cosine = std::max(static_cast<float>(cosine - 1.0e-5), 0.0f);
    cluster.altitude = static_cast<float>(0.9999 * altitude);
}

layout::TriangleCluster boundsOf(const ClusterTriangles& triangles) {
    layout::TriangleCluster cluster{};
    boundPoints(triangles, cluster);
    boundNormals(triangles, cluster);
    return cluster;
}

}  // namespace

/// Consecutive clusters of one part, for one thread.
struct MeshClusters::Task {
    MeshTriangles mesh;
    std::uint32_t firstIndex, endIndex, firstCluster;
};

MeshClusters::MeshClusters(std::span<const Mesh> meshes) : parts_(meshes.size()) {
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
        for (std::uint32_t first = 0; first < part.indexCount; first += step) {
            const std::uint32_t end = std::min(first + step, part.indexCount);
            tasks.push_back({mesh, part.firstIndex + first, part.firstIndex + end,
                             part.firstCluster + first / clusterIndices});
        }
    }
}

void MeshClusters::compute(std::span<const Task> tasks) {
    ThreadPool::shared()->run(tasks.size(), [&](std::size_t i, unsigned) {
        const Task& task = tasks[i];
        layout::TriangleCluster* cluster = clusters_.data() + task.firstCluster;
        for (std::uint32_t first = task.firstIndex; first < task.endIndex; first += clusterIndices) {
            const std::uint32_t count = std::min(task.endIndex - first, clusterIndices);
            *cluster++ = boundsOf({task.mesh.positions, task.mesh.indices.subspan(first, count)});
        }
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
