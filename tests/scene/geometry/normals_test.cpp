#include "scene/geometry/normals.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace candela {
namespace {

// Two triangles that share an edge: one in the plane z = 0, one in x = 0.
Mesh roof() {
    Mesh mesh;
    mesh.name = "roof";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.uv0 = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    mesh.uv1 = {{0, 5}, {1, 5}, {2, 5}, {3, 5}};
    mesh.furtherUvs = {{}, {{0, 7}, {1, 7}, {2, 7}, {3, 7}}};
    mesh.colors = {glm::vec4(0), glm::vec4(1), glm::vec4(2), glm::vec4(3)};
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.submeshes = {{0, 3, {}}, {3, 3, 7}};
    return mesh;
}

TEST(FlatNormals, EachTriangleHasItsOwn) {
    Mesh mesh = roof();
    const Mesh before = mesh;
    generateFlatNormals(mesh);
    ASSERT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.normals.size(), 6u);
    ASSERT_EQ(mesh.indices.size(), 6u);
    for (std::size_t corner = 0; corner < 6; ++corner) {
        const std::uint32_t old = before.indices[corner], now = mesh.indices[corner];
        EXPECT_EQ(mesh.positions[now], before.positions[old]);
        EXPECT_EQ(mesh.uv0[now], before.uv0[old]);
        EXPECT_EQ(mesh.uv1[now], before.uv1[old]);
        EXPECT_EQ(mesh.furtherUvs[1][now], before.furtherUvs[1][old]);
        EXPECT_EQ(mesh.colors[now], before.colors[old]);
        EXPECT_EQ(mesh.normals[now], corner < 3 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
    }
    EXPECT_TRUE(mesh.tangents.empty());
    EXPECT_EQ(mesh.submeshes[1].firstIndex, 3u);
    EXPECT_EQ(mesh.submeshes[1].material, 7u);
}

TEST(FlatNormals, AreThoseOfTriangles) {
    Mesh mesh = roof();
    mesh.submeshes = {{0, 2, {}, Topology::lines}, {2, 1, {}, Topology::points}, {3, 3, {}}};
    generateFlatNormals(mesh);
    ASSERT_EQ(mesh.normals.size(), 6u);
    for (std::size_t corner = 0; corner < 6; ++corner)
        EXPECT_EQ(mesh.normals[corner], corner < 3 ? glm::vec3(0.0f) : glm::vec3(1, 0, 0));
    Mesh points = roof();
    points.submeshes = {{0, 6, {}, Topology::points}};
    generateFlatNormals(points);
    EXPECT_EQ(points.indices, roof().indices) << "they keep their vertices";
    EXPECT_EQ(points.normals, std::vector<glm::vec3>(4, glm::vec3(0.0f)));
}

TEST(FlatNormals, KeepWhatDeformsTheVertices) {
    Mesh mesh = roof();
    mesh.influenceCount = 2;
    for (std::uint32_t vertex = 0; vertex < 4; ++vertex) {
        mesh.joints.insert(mesh.joints.end(), {vertex, 7});
        mesh.jointWeights.insert(mesh.jointWeights.end(), {0.75f, 0.25f});
    }
    // Turns the first triangle from the plane z = 0 into the plane y = 0.
    mesh.morphTargets.resize(1);
    mesh.morphTargets[0].offsets = {{0, 0, 0}, {0, 0, 0}, {0, -1, -1}, {0, 0, 0}};
    mesh.morphTargets[0].normalOffsets.assign(4, {5, 5, 5});
    const Mesh before = mesh;
    generateFlatNormals(mesh);
    ASSERT_EQ(mesh.joints.size(), 12u);
    ASSERT_EQ(mesh.jointWeights.size(), 12u);
    const MorphTarget& target = mesh.morphTargets[0];
    ASSERT_EQ(target.offsets.size(), 6u);
    for (std::size_t corner = 0; corner < 6; ++corner) {
        EXPECT_EQ(mesh.joints[2 * corner], before.indices[corner]);
        EXPECT_EQ(mesh.jointWeights[2 * corner], 0.75f);
        EXPECT_EQ(target.offsets[corner], before.morphTargets[0].offsets[before.indices[corner]]);
    }
    EXPECT_EQ(target.normalOffsets[0], glm::vec3(0, 1, -1)) << "from the flat normal to that of the target";
}

TEST(FlatNormals, OfTrianglesWithoutAreaAreUp) {
    Mesh mesh;
    mesh.positions = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    mesh.indices = {0, 1, 2, 0, 0, 0};
    generateFlatNormals(mesh);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 1, 0));
}

TEST(FlatNormals, HaveUnitLengthAtEverySize) {
    for (const float size : {1e-30f, 1e-15f, 1.0f, 1e15f, 1e30f}) {
        Mesh mesh;
        mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, size}};
        mesh.indices = {0, 1, 2};
        generateFlatNormals(mesh);
        // A rounding of each component.
        EXPECT_NEAR(glm::length(mesh.normals[0]), 1.0f, 2e-7f) << size;
        EXPECT_NEAR(mesh.normals[0].z, std::sqrt(0.5f), 2e-7f) << size;
    }
}

TEST(FlatNormals, OfAnEmptyMesh) {
    Mesh mesh;
    generateFlatNormals(mesh);
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(FlatNormals, RefuseIndicesOutOfRange) {
    Mesh mesh = roof();
    mesh.indices[4] = 4;
    try {
        generateFlatNormals(mesh);
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "mesh 'roof': index 4 names vertex 4, but there are 4");
    }
}

TEST(ZeroNormals, AreReplacedByThatOfTheFirstTriangle) {
    Mesh mesh = roof();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    mesh.normals = {{0, 0, 0}, {0.6f, 0.8f, 0}, {INFINITY, 0, 0}, {0, nan, 0}};
    EXPECT_EQ(replaceZeroNormals(mesh), 3u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[1], glm::vec3(0.6f, 0.8f, 0)) << "a valid normal has changed";
    EXPECT_EQ(mesh.normals[2], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[3], glm::vec3(1, 0, 0));
}

TEST(ZeroNormals, IgnoreTrianglesWithoutArea) {
    Mesh mesh = roof();
    mesh.normals.assign(4, glm::vec3(0));
    mesh.positions.push_back({9, 9, 9});
    mesh.normals.push_back(glm::vec3(0));
    mesh.indices = {0, 0, 3, 0, 2, 3};
    EXPECT_EQ(replaceZeroNormals(mesh), 5u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[4], glm::vec3(0, 1, 0)) << "no triangle uses it";
}

TEST(ZeroNormals, ValidOnesAreKept) {
    Mesh mesh = roof();
    mesh.normals.assign(4, {0, 1, 0});
    EXPECT_EQ(replaceZeroNormals(mesh), 0u);
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 1, 0));
}

TEST(ZeroNormals, RefuseAMeshWithoutNormals) {
    Mesh mesh = roof();
    EXPECT_THROW(replaceZeroNormals(mesh), Error);
}

}  // namespace
}  // namespace candela
