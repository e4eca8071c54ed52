#include "scene/geometry/tangents.h"

#include <candela/error.h>
#include <candela/scene.h>
#include <candela/threads.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace candela {
namespace {

// A few roundings of single precision.
constexpr float rounding = 1e-6f;

void expectNear(const glm::vec4& actual, const glm::vec4& expected, float tolerance = rounding) {
    EXPECT_LE(glm::distance(actual, expected), tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z << ' ' << actual.w << " is not " << expected.x
        << ' ' << expected.y << ' ' << expected.z << ' ' << expected.w;
}

// A square of 1 m in the plane z = 0 that faces +Z: corners bottom left, bottom right, top right, top left.
Mesh square() {
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    // The image is upright: v grows downwards.
    mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.submeshes = {{0, 6, {}}};
    return mesh;
}

// Expects tangents that `validate` accepts and that are perpendicular to their normals.
void expectValidTangents(const Mesh& mesh) {
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        const glm::vec4& tangent = mesh.tangents[i];
        EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, rounding);
        EXPECT_NEAR(glm::dot(glm::vec3(tangent), mesh.normals[i]), 0.0f, 2.0f * rounding);
        EXPECT_TRUE(tangent.w == 1.0f || tangent.w == -1.0f);
    }
}

TEST(Tangents, OfAnUprightImage) {
    Mesh mesh = square();
    generateTangents(mesh, 0);
    ASSERT_EQ(mesh.positions.size(), 4u) << "no vertex is split";
    // u grows along +X, and cross(+Z, +X) × 1 = +Y is up in the image.
    for (const glm::vec4& tangent : mesh.tangents) expectNear(tangent, {1, 0, 0, 1});
}

TEST(Tangents, OfARotatedImage) {
    Mesh mesh = square();
    for (glm::vec2& uv : mesh.uv0) uv = {uv.y, 1.0f - uv.x};  // Rotated by 90 degrees: u increases downwards.
    generateTangents(mesh, 0);
    for (const glm::vec4& tangent : mesh.tangents) expectNear(tangent, {0, -1, 0, 1});
}

TEST(Tangents, OfAMirroredImage) {
    Mesh mesh = square();
    for (glm::vec2& uv : mesh.uv0) uv.x = 1.0f - uv.x;
    generateTangents(mesh, 0);
    // u grows along -X; the bitangent is still up: cross(+Z, -X) × -1 = +Y.
    for (const glm::vec4& tangent : mesh.tangents) expectNear(tangent, {-1, 0, 0, -1});
}

TEST(Tangents, FromAnotherUvSet) {
    Mesh mesh = square();
    mesh.uv1 = mesh.uv0;
    for (glm::vec2& uv : mesh.uv0) uv = glm::vec2(0.0f);
    generateTangents(mesh, 1);
    expectNear(mesh.tangents[0], {1, 0, 0, 1});
    mesh.furtherUvs = {mesh.uv0, mesh.uv1};
    mesh.uv1.clear();
    generateTangents(mesh, 3);
    expectNear(mesh.tangents[0], {1, 0, 0, 1});
}

TEST(Tangents, DoNotDependOnScaleAndOffsetOfTheImage) {
    Mesh mesh = square();
    for (glm::vec2& uv : mesh.uv0) uv = uv * glm::vec2(1e-6f, 300.0f) + glm::vec2(5e-6f, -20.0f);
    generateTangents(mesh, 0);
    // The coordinates themselves are rounded: 5e-6 has steps of 5e-13, of 1e-6.
    for (const glm::vec4& tangent : mesh.tangents) expectNear(tangent, {1, 0, 0, 1}, 1e-5f);
}

// Two squares side by side; the right one has the left one's image mirrored at the seam x = 1.
Mesh mirroredPair() {
    Mesh mesh = square();
    mesh.positions.insert(mesh.positions.end(), {{2, 0, 0}, {2, 1, 0}});
    mesh.normals.insert(mesh.normals.end(), 2, {0, 0, 1});
    mesh.uv0.insert(mesh.uv0.end(), {{0, 1}, {0, 0}});
    mesh.colors.assign(6, glm::vec4(0.25f));
    mesh.indices.insert(mesh.indices.end(), {1, 4, 5, 1, 5, 2});
    return mesh;
}

TEST(Tangents, MirroredHalvesSplitAtTheSeam) {
    Mesh mesh = mirroredPair();
    const Mesh before = mesh;
    generateTangents(mesh, 0);
    expectValidTangents(mesh);
    EXPECT_EQ(mesh.positions.size(), 8u) << "the two vertices of the seam are split";
    EXPECT_EQ(mesh.colors.size(), 8u);
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        const std::uint32_t vertex = mesh.indices[corner];
        EXPECT_EQ(mesh.positions[vertex], before.positions[before.indices[corner]]);
        EXPECT_EQ(mesh.uv0[vertex], before.uv0[before.indices[corner]]);
        expectNear(mesh.tangents[vertex], corner < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1));
    }
}

TEST(Tangents, SplitVerticesKeepWhatDeformsThem) {
    Mesh mesh = mirroredPair();
    mesh.influenceCount = 1;
    mesh.morphTargets.resize(1);
    for (std::uint32_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
        mesh.joints.push_back(vertex);
        mesh.jointWeights.push_back(1.0f);
        mesh.morphTargets[0].offsets.emplace_back(static_cast<float>(vertex));
    }
    const Mesh before = mesh;
    generateTangents(mesh, 0);
    ASSERT_EQ(mesh.joints.size(), 8u);
    ASSERT_EQ(mesh.jointWeights.size(), 8u);
    ASSERT_EQ(mesh.morphTargets[0].offsets.size(), 8u);
    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        EXPECT_EQ(mesh.joints[mesh.indices[corner]], before.indices[corner]);
        EXPECT_EQ(mesh.morphTargets[0].offsets[mesh.indices[corner]],
                  before.morphTargets[0].offsets[before.indices[corner]]);
    }
}

// A mesh without shared vertices has the same tangents.
TEST(Tangents, WeldEqualVertices) {
    Mesh shared = mirroredPair();
    // A fold, so that tangents are averaged over the triangles of a vertex.
    shared.positions[4].z = shared.positions[5].z = 0.7f;
    shared.positions[3].z = -0.4f;
    Mesh single = shared;
    for (auto* values : {&single.positions, &single.normals}) {
        std::vector<glm::vec3> corners;
        for (const std::uint32_t index : shared.indices) corners.push_back((*values)[index]);
        *values = corners;
    }
    single.uv0.clear();
    for (const std::uint32_t index : shared.indices) single.uv0.push_back(shared.uv0[index]);
    single.colors.clear();
    for (std::uint32_t i = 0; i < single.indices.size(); ++i) single.indices[i] = i;
    generateTangents(shared, 0);
    generateTangents(single, 0);
    EXPECT_EQ(single.positions.size(), single.indices.size()) << "no vertex is split";
    for (std::size_t corner = 0; corner < shared.indices.size(); ++corner) {
        expectNear(single.tangents[single.indices[corner]], shared.tangents[shared.indices[corner]]);
    }
}

TEST(Tangents, WeightByTheAngleOfTheCorner) {
    // Around the origin, in the plane z = 0: a corner of 90 degrees with u = x, v = -y, and one of 45 degrees
    // with u = x, v = -y - x / 2, where u grows along (1, -1/2) while v stays.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.uv0 = {{0, 0}, {1, 0}, {0, -1}, {-1, -0.5f}};
    generateTangents(mesh, 0);
    ASSERT_EQ(mesh.positions.size(), 4u);
    const float pi = std::numbers::pi_v<float>;
    const glm::vec3 first(1, 0, 0), second = glm::normalize(glm::vec3(1, -0.5f, 0));
    expectNear(mesh.tangents[0], glm::vec4(glm::normalize(first * (pi / 2) + second * (pi / 4)), 1));
    expectNear(mesh.tangents[1], glm::vec4(first, 1));
    expectNear(mesh.tangents[3], glm::vec4(second, 1));
}

TEST(Tangents, LieInThePlaneOfTheVertexNormal) {
    Mesh mesh = square();
    mesh.normals.assign(4, glm::normalize(glm::vec3(1, 0, 1)));
    generateTangents(mesh, 0);
    const float root = std::sqrt(0.5f);
    for (const glm::vec4& tangent : mesh.tangents) expectNear(tangent, {root, 0, -root, 1});
}

// A sphere of latitude and longitude; u grows eastwards, v southwards, poles and the seam have own vertices.
Mesh sphere(int rings, int segments) {
    Mesh mesh;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment <= segments; ++segment) {
            const float u = static_cast<float>(segment) / static_cast<float>(segments);
            const float v = static_cast<float>(ring) / static_cast<float>(rings);
            const float phi = 2.0f * std::numbers::pi_v<float> * u, theta = std::numbers::pi_v<float> * v;
            const glm::vec3 normal(std::sin(theta) * std::sin(phi), std::cos(theta),
                                   std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(normal);
            mesh.normals.push_back(normal);
            mesh.uv0.emplace_back(u, v);
        }
    }
    const auto row = static_cast<std::uint32_t>(segments + 1);
    for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(rings); ++ring) {
        for (std::uint32_t segment = 0; segment + 1 < row; ++segment) {
            const std::uint32_t a = ring * row + segment, b = a + row;
            mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return mesh;
}

TEST(Tangents, OfASpherePointEast) {
    constexpr int rings = 32, segments = 64;
    Mesh mesh = sphere(rings, segments);
    generateTangents(mesh, 0);
    expectValidTangents(mesh);
    EXPECT_EQ(mesh.positions.size(), std::size_t{rings + 1} * (segments + 1)) << "no vertex is split";
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.uv0[i].y < 0.1f || mesh.uv0[i].y > 0.9f)
            continue;  // Near the poles the direction of east changes quickly.
        const float phi = 2.0f * std::numbers::pi_v<float> * mesh.uv0[i].x;
        // At the seam only the triangles of one side contribute, whose edge is off by half a segment: 2 pi /
        // 128.
        expectNear(mesh.tangents[i], {std::cos(phi), 0, -std::sin(phi), 1}, 0.05f);
        if (mesh.uv0[i].x == 0.0f || mesh.uv0[i].x == 1.0f) continue;
        // Elsewhere the error is of second order: the two triangles of a quad are not symmetric.
        expectNear(mesh.tangents[i], {std::cos(phi), 0, -std::sin(phi), 1}, 0.005f);
    }
}

TEST(Tangents, TrianglesWithoutUvAreaHaveTheTangentsOfTheirNeighbors) {
    Mesh mesh = square();
    mesh.uv0[3] = {0.5f, 0.5f};  // On the diagonal between 0 and 2: the second triangle has no area.
    generateTangents(mesh, 0);
    ASSERT_EQ(mesh.positions.size(), 4u);
    for (const int i : {0, 1, 2}) expectNear(mesh.tangents[i], {1, 0, 0, 1});
    // Only that triangle has this corner: any perpendicular is valid.
    expectValidTangents(mesh);
}

TEST(Tangents, TrianglesWithoutUvAreaHaveTheHandednessOfTheirNeighbors) {
    Mesh mesh = square();
    for (glm::vec2& uv : mesh.uv0) uv.x = 1.0f - uv.x;
    mesh.uv0[3] = {0.5f, 0.5f};
    generateTangents(mesh, 0);
    for (const int i : {0, 1, 2}) expectNear(mesh.tangents[i], {-1, 0, 0, -1});
    ASSERT_EQ(mesh.positions.size(), 4u) << "the corners share the vertices of the mirrored neighbor";
}

TEST(Tangents, WithoutAnyUvAreaAreAnyPerpendicular) {
    Mesh mesh = square();
    for (glm::vec2& uv : mesh.uv0) uv = {0.3f, 0.3f};
    generateTangents(mesh, 0);
    expectValidTangents(mesh);
    EXPECT_EQ(mesh.positions.size(), 4u);
}

TEST(Tangents, DegenerateTrianglesHaveTheTangentsAtTheirVertices) {
    Mesh mesh = square();
    mesh.indices.insert(mesh.indices.begin(), {0, 0, 1, 2, 2, 2});
    generateTangents(mesh, 0);
    ASSERT_EQ(mesh.positions.size(), 4u);
    for (const glm::vec4& tangent : mesh.tangents) expectNear(tangent, {1, 0, 0, 1});
}

TEST(Tangents, UnusedVerticesGetAnyPerpendicular) {
    Mesh mesh = square();
    mesh.positions.push_back(glm::vec3(7));
    mesh.normals.push_back({0, 1, 0});
    mesh.uv0.push_back(glm::vec2(0));
    generateTangents(mesh, 0);
    expectValidTangents(mesh);
}

TEST(Tangents, TrianglesThatShareOnlyAVertexAreSeparate) {
    // Two triangles that share one vertex and no edge, with images rotated by 90 degrees.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
    mesh.normals.assign(5, {0, 0, 1});
    mesh.uv0 = {{0, 0}, {1, 0}, {0, -1}, {0, -1}, {-1, 0}};
    mesh.indices = {0, 1, 2, 0, 3, 4};
    generateTangents(mesh, 0);
    ASSERT_EQ(mesh.positions.size(), 6u);
    expectNear(mesh.tangents[mesh.indices[0]], {1, 0, 0, 1});
    expectNear(mesh.tangents[mesh.indices[3]], {0, 1, 0, 1});
}

TEST(Tangents, ManyTrianglesAtOneEdgeAndOneVertex) {
    // 10,000 triangles that share one edge: a search per triangle would be quadratic.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 1, 0}};
    mesh.uv0 = {{0, 1}, {0, 0}};
    for (int i = 0; i < 10'000; ++i) {
        const auto outer = static_cast<std::uint32_t>(mesh.positions.size());
        const float angle = 6.2831853f * static_cast<float>(i) / 10'000.0f;
        mesh.positions.emplace_back(std::cos(angle), 0.5f, std::sin(angle));
        mesh.uv0.emplace_back(1.0f, static_cast<float>(i) / 10'000.0f);
        if (i % 2 == 0) {
            mesh.indices.insert(mesh.indices.end(), {0, outer, 1});
        } else {
            mesh.indices.insert(mesh.indices.end(), {1, outer, 0});
        }
    }
    mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
    generateTangents(mesh, 0);
    expectValidTangents(mesh);
}

TEST(Tangents, AcceptNonFiniteNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float value : {nan, INFINITY, 3e38f, 1e-45f}) {
        Mesh mesh = square();
        mesh.positions[0].x = value;
        mesh.uv0[1].y = value;
        mesh.uv0[2].x = -value;
        generateTangents(mesh, 0);
        expectValidTangents(mesh);
    }
}

TEST(Tangents, DoNotDependOnTheNumberOfThreads) {
    Mesh grid;
    constexpr std::uint32_t side = 200;  // Enough vertices and edges for several runs of the sorts.
    for (std::uint32_t y = 0; y <= side; ++y) {
        for (std::uint32_t x = 0; x <= side; ++x) {
            const glm::vec2 p = glm::vec2(x, y) / static_cast<float>(side);
            grid.positions.emplace_back(p, p.x * p.y);
            grid.normals.push_back(glm::normalize(glm::vec3(-p.y, -p.x, 1.0f)));
            grid.uv0.emplace_back(p.x + 0.3f * p.y * p.y, p.y);
        }
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t a = y * (side + 1) + x, b = a + side + 1;
            grid.indices.insert(grid.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
        }
    }
    setThreadCount(1);
    Mesh serial = grid;
    generateTangents(serial, 0);
    for (const unsigned threads : {2u, 3u, 8u}) {
        setThreadCount(threads);
        Mesh parallel = grid;
        generateTangents(parallel, 0);
        EXPECT_EQ(parallel.tangents, serial.tangents) << threads;
        EXPECT_EQ(parallel.indices, serial.indices) << threads;
    }
    setThreadCount(0);
}

TEST(Tangents, RefuseInvalidMeshes) {
    const auto expectRefused = [](const Mesh& mesh, std::uint32_t set, const std::string& reason) {
        Mesh copy = mesh;
        try {
            generateTangents(copy, set);
            ADD_FAILURE() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(std::string(error.what()), "mesh 'square': " + reason);
        }
    };
    expectRefused(square(), 1, "tangents need one texture coordinate per vertex");
    expectRefused(square(), 2, "tangents need one texture coordinate per vertex");
    Mesh mesh = square();
    mesh.normals.clear();
    expectRefused(mesh, 0, "tangents need one normal per vertex");
    mesh = square();
    mesh.indices[0] = 9;
    expectRefused(mesh, 0, "index 0 names vertex 9, but there are 4");
    mesh = square();
    mesh.colors.resize(1);
    expectRefused(mesh, 0, "an array has neither no element nor one per vertex");
}

}  // namespace
}  // namespace candela
