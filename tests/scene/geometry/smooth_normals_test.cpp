// Normals by a crease angle and tangents of MikkTSpace, through the public functions.

#include <candela/error.h>
#include <candela/geometry.h>
#include <candela/shapes.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
// A few roundings of single precision on numbers near 1.
constexpr float rounding = 1e-6f;

/// A cube of 8 vertices at ±1 and 12 triangles, whose diagonals go any way.
Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                    2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return mesh;
}

/// The normal of a triangle of the mesh.
glm::vec3 faceNormal(const Mesh& mesh, std::size_t first) {
    const glm::vec3 a = mesh.positions[mesh.indices[first]], b = mesh.positions[mesh.indices[first + 1]],
                    c = mesh.positions[mesh.indices[first + 2]];
    return glm::normalize(glm::cross(b - a, c - a));
}

TEST(SmoothNormals, OfACubeAreFlatBelowARightAngle) {
    for (const float angle : {0.0f, 0.5f, pi / 2.0f - 0.01f}) {
        Mesh mesh = cube();
        mesh.uv0.assign(8, glm::vec2(0.5f));
        mesh.tangents.assign(8, glm::vec4(1, 0, 0, 1));
        computeNormals(mesh, angle);
        EXPECT_EQ(mesh.positions.size(), 24u) << angle;
        EXPECT_EQ(mesh.uv0.size(), 24u);
        EXPECT_TRUE(mesh.tangents.empty());
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
            const glm::vec3 expected = faceNormal(mesh, i / 3 * 3);
            EXPECT_LE(glm::distance(mesh.normals[mesh.indices[i]], expected), rounding) << i;
        }
    }
}

TEST(SmoothNormals, OfACubeAreItsDiagonalsAboveARightAngle) {
    for (const float angle : {pi / 2.0f + 0.01f, pi}) {
        Mesh mesh = cube();
        computeNormals(mesh, angle);
        ASSERT_EQ(mesh.positions.size(), 8u);
        // Each side counts with a right angle, however its two triangles share it.
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_LE(glm::distance(mesh.normals[i], mesh.positions[i] / std::sqrt(3.0f)), rounding);
    }
}

TEST(SmoothNormals, DoNotDependOnTheIndexing) {
    Mesh shared = cube(), separate;
    for (const std::uint32_t index : shared.indices) {
        separate.indices.push_back(static_cast<std::uint32_t>(separate.positions.size()));
        separate.positions.push_back(shared.positions[index]);
    }
    computeNormals(shared, pi);
    computeNormals(separate, pi);
    EXPECT_EQ(separate.positions.size(), 36u);
    for (std::size_t i = 0; i < shared.indices.size(); ++i)
        EXPECT_EQ(separate.normals[i], shared.normals[shared.indices[i]]);
}

TEST(SmoothNormals, OfASpherePointAwayFromItsMiddle) {
    Mesh sphere = sphereMesh(2.0f, 96, 48);
    const std::size_t before = sphere.positions.size();
    sphere.normals.clear();
    computeNormals(sphere, pi / 4.0f);
    EXPECT_EQ(sphere.positions.size(), before);
    // Facets of at most 2 pi / 96: their mean is off by the square of that, times less than 1.
    constexpr float error = 0.0043f;
    for (std::size_t i = 0; i < before; ++i)
        EXPECT_LE(glm::distance(sphere.normals[i], sphere.positions[i] / 2.0f), error);
}

TEST(SmoothNormals, OfACylinderAreCreasedAtItsRims) {
    Mesh cylinder = cylinderMesh(1.0f, 3.0f, 32);
    cylinder.normals.clear();
    computeNormals(cylinder, pi / 4.0f);
    for (std::size_t i = 0; i < cylinder.indices.size(); ++i) {
        const glm::vec3 position = cylinder.positions[cylinder.indices[i]],
                        normal = cylinder.normals[cylinder.indices[i]],
                        face = faceNormal(cylinder, i / 3 * 3);
        // By symmetry the mean of two neighbouring facets points away from the axis.
        const glm::vec3 expected =
            std::abs(face.y) > 0.5f ? face : glm::normalize(glm::vec3(position.x, 0, position.z));
        EXPECT_LE(glm::distance(normal, expected), 4.0f * rounding) << i;
    }
}

TEST(SmoothNormals, OfMorphTargetsLeadToThoseOfTheirShapes) {
    Mesh mesh = sphereMesh(1.0f, 24, 12);
    MorphTarget target;
    // Twice as high: an ellipsoid, whose normals are (x, y / 4, z) of its points.
    for (const glm::vec3& p : mesh.positions) target.offsets.emplace_back(0.0f, p.y, 0.0f);
    mesh.morphTargets.push_back(target);
    Mesh stretched = mesh;
    for (glm::vec3& p : stretched.positions) p.y *= 2.0f;
    stretched.morphTargets.clear();
    computeNormals(mesh, pi);
    computeNormals(stretched, pi);
    ASSERT_EQ(mesh.morphTargets[0].normalOffsets.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        EXPECT_LE(
            glm::distance(mesh.normals[i] + mesh.morphTargets[0].normalOffsets[i], stretched.normals[i]),
            rounding);
}

TEST(SmoothNormals, LeaveLinesAndPointsAlone) {
    Mesh mesh = cube();
    mesh.indices.insert(mesh.indices.end(), {0, 7, 3});
    mesh.submeshes = {{0, 36, {}}, {36, 2, {}, Topology::lines}, {38, 1, {}, Topology::points}};
    computeNormals(mesh, 0.1f);
    for (const std::size_t place : {36u, 37u, 38u}) {
        EXPECT_EQ(mesh.normals[mesh.indices[place]], glm::vec3(0.0f));
        EXPECT_LT(mesh.indices[place], 8u);
    }
    for (std::size_t i = 0; i < 36; ++i)
        EXPECT_LE(glm::distance(mesh.normals[mesh.indices[i]], faceNormal(mesh, i / 3 * 3)), rounding);
}

TEST(SmoothNormals, OfTrianglesWithoutAreaAreThoseOfNeighbours) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {5, 5, 5}};
    mesh.indices = {0, 1, 2, 0, 1, 3, 4, 4, 4};
    computeNormals(mesh, 1.0f);
    EXPECT_EQ(mesh.normals[mesh.indices[3]], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[mesh.indices[5]], glm::vec3(0, 1, 0)) << "nothing else meets there";
    EXPECT_EQ(mesh.normals[4], glm::vec3(0, 1, 0));
}

TEST(SmoothNormals, ManyTrianglesAtOneEdgeStayApart) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 1}};
    for (std::uint32_t i = 0; i < 2000; ++i) {
        mesh.positions.emplace_back(std::cos(0.003f * float(i)), std::sin(0.003f * float(i)), 0.0f);
        mesh.indices.insert(mesh.indices.end(), {0, 1, 2 + i});
    }
    computeNormals(mesh, pi);
    EXPECT_EQ(mesh.indices.size(), 6000u);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        EXPECT_LE(glm::distance(mesh.normals[mesh.indices[i]], faceNormal(mesh, i / 3 * 3)), rounding);
}

TEST(SmoothNormals, RefuseWhatIsNoMesh) {
    Mesh mesh = cube();
    for (const float angle : {-0.1f, 3.2f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_THROW(computeNormals(mesh, angle), Error);
    mesh.positions[3].x = std::numeric_limits<float>::infinity();
    EXPECT_THROW(computeNormals(mesh, 1.0f), Error);
    mesh = cube();
    mesh.indices[5] = 8;
    EXPECT_THROW(computeNormals(mesh, 1.0f), Error);
    mesh = cube();
    mesh.uv0.resize(3);
    EXPECT_THROW(computeNormals(mesh, 1.0f), Error);
    Mesh empty;
    computeNormals(empty, 1.0f);
    EXPECT_TRUE(empty.normals.empty());
}

TEST(ComputedTangents, PointAlongU) {
    Mesh plane = planeMesh(2.0f, 3.0f, 4);
    computeTangents(plane);
    // Bitangents, cross(normal, tangent) × w, point against increasing v, which grows with z.
    for (const glm::vec4& tangent : plane.tangents) EXPECT_EQ(tangent, glm::vec4(1, 0, 0, 1));
    Mesh sphere = sphereMesh(1.0f, 64, 32);
    computeTangents(sphere);
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        const glm::vec3& p = sphere.positions[i];
        if (std::abs(p.y) > 0.9f) continue;
        const glm::vec3 east = glm::normalize(glm::vec3(p.z, 0.0f, -p.x));
        // At a seam the triangles of one side alone count: half a segment.
        EXPECT_GT(glm::dot(glm::vec3(sphere.tangents[i]), east), std::cos(pi / 64.0f)) << i;
        EXPECT_EQ(sphere.tangents[i].w, 1.0f);
    }
}

TEST(ComputedTangents, NeedNormalsAndTheSet) {
    Mesh plane = planeMesh();
    EXPECT_THROW(computeTangents(plane, 1), Error);
    EXPECT_THROW(computeTangents(plane, 40), Error);
    plane.normals.clear();
    EXPECT_THROW(computeTangents(plane), Error);
}

}  // namespace
}  // namespace candela
