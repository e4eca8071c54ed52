// Clusters of triangles: their bounds hold what they are of, and they follow edits of their meshes.

#include "render/culling/mesh_clusters.h"

#include <candela/scene.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace candela::test {
namespace {

/// A ring of `count` triangles around the axis z, each turned by `tilt` out of the plane z = 0; the seventh
/// has two equal corners.
Mesh ring(std::uint32_t count, float tilt) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
        const glm::vec3 out(std::cos(angle), std::sin(angle), 0.0f), along(-out.y, out.x, 0.0f);
        const glm::vec3 in = -std::cos(tilt) * out + glm::vec3(0.0f, 0.0f, std::sin(tilt));
        const glm::vec3 corner = 2.0f * out;
        mesh.positions.insert(mesh.positions.end(),
                              {corner, i == 6 ? corner : corner + 0.3f * along, corner + 0.2f * in});
        mesh.indices.insert(mesh.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    mesh.normals.resize(mesh.positions.size());
    return mesh;
}

void expectBounds(const layout::TriangleCluster& cluster, const Mesh& mesh, std::size_t first,
                  std::size_t end) {
    const glm::dvec3 center(cluster.center[0], cluster.center[1], cluster.center[2]);
    const glm::dvec3 axis(cluster.axis[0], cluster.axis[1], cluster.axis[2]);
    double farthest = 0.0, widest = 1.0, flattest = std::numeric_limits<double>::max();
    for (std::size_t i = first; i < end; i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        farthest = std::max(
            {farthest, glm::distance(a, center), glm::distance(b, center), glm::distance(c, center)});
        if (a == b) continue;
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        widest = std::min(widest, glm::dot(glm::normalize(normal), axis));
        flattest =
            std::min(flattest, glm::length(normal) /
                                   std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}));
    }
    EXPECT_GE(cluster.radius, farthest);
    EXPECT_LE(cluster.cosine, widest);
    EXPECT_LE(cluster.altitude, flattest);
    // By no more than what is added for rounding, of which the cosine's 1e-5 is a constant.
    EXPECT_NEAR(cluster.radius, farthest, 2.0e-4 * farthest);
    EXPECT_NEAR(cluster.cosine, std::max(widest, 0.0), 2.0e-5);
    EXPECT_NEAR(cluster.altitude, flattest, 2.0e-4 * flattest);
}

TEST(MeshClustersTest, boundsHoldTheirTriangles) {
    // All normals of a ring are as far from its axis as it is tilted.
    const Mesh mesh = ring(layout::CLUSTER_TRIANGLES, 0.5f);
    const MeshClusters clusters(std::span(&mesh, 1));
    ASSERT_EQ(clusters.clusters().size(), 1u);
    const layout::TriangleCluster& cluster = clusters.clusters().front();
    expectBounds(cluster, mesh, 0, mesh.indices.size());
    EXPECT_NEAR(cluster.axis[2], 1.0f, 1.0e-2f);
    EXPECT_NEAR(cluster.cosine, std::cos(0.5f), 1.0e-2f) << "the axis leans by what is missing of the ring";
}

// Also of clusters that are no whole vectors of triangles.
TEST(MeshClustersTest, eachKernelBoundsClustersOfAllSizes) {
    for (const TriangleFilterKernel* kernel : triangleFilterKernels()) {
        for (std::uint32_t count = layout::CLUSTER_TRIANGLES; count <= 2 * layout::CLUSTER_TRIANGLES;
             ++count) {
            SCOPED_TRACE(std::string(kernel->name) + ", triangles: " + std::to_string(count));
            const Mesh mesh = ring(count, 0.5f);
            const MeshClusters clusters(std::span(&mesh, 1), *kernel);
            const std::size_t end = mesh.indices.size();
            for (std::size_t i = 0; i < clusters.clusters().size(); ++i) {
                const std::size_t first = i * 3 * layout::CLUSTER_TRIANGLES;
                expectBounds(clusters.clusters()[i], mesh, first,
                             std::min<std::size_t>(first + 3 * layout::CLUSTER_TRIANGLES, end));
            }
        }
    }
}

// They bound what is drawn at all: nothing of these is.
TEST(MeshClustersTest, trianglesWithoutAnAreaHaveNoCone) {
    Mesh mesh = ring(layout::CLUSTER_TRIANGLES, 0.5f);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) mesh.indices[i + 1] = mesh.indices[i];
    for (const TriangleFilterKernel* kernel : triangleFilterKernels()) {
        const MeshClusters clusters(std::span(&mesh, 1), *kernel);
        EXPECT_EQ(clusters.clusters().front().cosine, 0.0f) << kernel->name;
        EXPECT_EQ(clusters.clusters().front().altitude, 0.0f) << kernel->name;
    }
}

TEST(MeshClustersTest, trianglesOnALineHaveNoAltitude) {
    Mesh mesh = ring(layout::CLUSTER_TRIANGLES, 0.5f);
    mesh.positions[30] = {1.0f, 0.0f, 0.0f};
    mesh.positions[31] = {2.0f, 0.0f, 0.0f};
    mesh.positions[32] = {4.0f, 0.0f, 0.0f};
    for (const TriangleFilterKernel* kernel : triangleFilterKernels()) {
        const MeshClusters clusters(std::span(&mesh, 1), *kernel);
        EXPECT_EQ(clusters.clusters().front().altitude, 0.0f) << kernel->name;
        EXPECT_TRUE(std::isfinite(clusters.clusters().front().axis[2])) << kernel->name;
    }
}

TEST(MeshClustersTest, normalsOfAllDirectionsHaveNoCone) {
    Mesh mesh = ring(layout::CLUSTER_TRIANGLES, 0.5f);
    std::swap(mesh.indices[0], mesh.indices[1]);
    const MeshClusters clusters(std::span(&mesh, 1));
    EXPECT_EQ(clusters.clusters().front().cosine, 0.0f);
}

/// A mesh whose submeshes are of many triangles, of few, of lines, and of many again.
Mesh partsOfAllKinds() {
    Mesh mesh = ring(700, 0.2f);
    mesh.submeshes = {{0, 3 * 200, 0}, {600, 30, 0}, {630, 600, 0, Topology::lines}, {1230, 870, 0}};
    return mesh;
}

TEST(MeshClustersTest, eachLargeSubmeshOfTrianglesHasItsOwn) {
    const std::array meshes{ring(1000, 0.1f), partsOfAllKinds()};
    const MeshClusters clusters(meshes);
    constexpr std::uint32_t size = 3 * layout::CLUSTER_TRIANGLES;
    const auto count = [](std::uint32_t indices) { return (indices + size - 1) / size; };
    const std::optional<ClusterRange> whole = clusters.of(0, 0, 3000), first = clusters.of(1, 0, 600),
                                      last = clusters.of(1, 1230, 870);
    ASSERT_TRUE(whole && first && last);
    EXPECT_EQ(whole->count, count(3000));
    EXPECT_EQ(first->first, whole->first + whole->count);
    EXPECT_EQ(last->first, first->first + first->count);
    EXPECT_EQ(last->count, count(870));
    EXPECT_FALSE(clusters.of(1, 600, 30)) << "few triangles";
    EXPECT_FALSE(clusters.of(1, 630, 600)) << "lines";
    for (std::uint32_t i = 0; i < last->count; ++i)
        expectBounds(clusters.clusters()[last->first + i], meshes[1], 1230 + i * size,
                     std::min(1230 + (i + 1) * size, 2100u));
}

bool equal(const MeshClusters& a, const MeshClusters& b) {
    return a.clusters().size() == b.clusters().size() &&
           std::memcmp(a.clusters().data(), b.clusters().data(), a.clusters().size_bytes()) == 0;
}

TEST(MeshClustersTest, followEdits) {
    std::vector<Mesh> meshes{ring(1000, 0.1f), partsOfAllKinds(), ring(300, 0.3f)};
    MeshClusters clusters(meshes);
    for (glm::vec3& position : meshes[1].positions) position *= 1.5f;
    clusters.move(1, {meshes[1].positions, meshes[1].indices});
    EXPECT_TRUE(equal(clusters, MeshClusters(meshes)));
    for (const std::uint32_t triangles : {5000u, 100u, 0u}) {
        meshes[1] = ring(triangles, 0.7f);
        clusters.replace(1, meshes[1]);
        EXPECT_TRUE(equal(clusters, MeshClusters(meshes)));
        EXPECT_EQ(clusters.of(2, 0, 900)->first, MeshClusters(meshes).of(2, 0, 900)->first);
    }
    meshes.push_back(ring(200, 0.2f));
    clusters.replace(3, meshes[3]);
    EXPECT_TRUE(equal(clusters, MeshClusters(meshes))) << "a mesh is added";
}

}  // namespace
}  // namespace candela::test
