// The shapes have the volume, the area, the normals and the texture coordinates that they promise.

#include <candela/error.h>
#include <candela/scene.h>
#include <candela/shapes.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

namespace candela {
namespace {

constexpr double pi = std::numbers::pi;

struct Measures {
    double area = 0.0, volume = 0.0;
};

/// Of triangles, the volume by the divergence theorem.
Measures measuresOf(const Mesh& mesh) {
    Measures sum;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
            c(mesh.positions[mesh.indices[i + 2]]);
        const glm::dvec3 cross = glm::cross(b - a, c - a);
        sum.area += 0.5 * glm::length(cross);
        sum.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

using Point = std::tuple<float, float, float>;
Point pointOf(const glm::vec3& p) {
    return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
}

/// How many edges have no counterpart in the opposite direction.
std::size_t openEdges(const Mesh& mesh) {
    std::map<std::pair<Point, Point>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t end = i % 3 == 2 ? i - 2 : i + 1;
        const Point a = pointOf(mesh.positions[mesh.indices[i]]),
                    b = pointOf(mesh.positions[mesh.indices[end]]);
        if (a < b)
            ++edges[{a, b}];
        else
            --edges[{b, a}];
    }
    std::size_t open = 0;
    for (const auto& [ends, sum] : edges) open += sum != 0;
    return open;
}

void expectWellFormed(const Mesh& mesh) {
    SCOPED_TRACE(mesh.name);
    Scene scene;
    scene.meshes.push_back(mesh);
    scene.nodes.emplace_back().mesh = 0;
    EXPECT_NO_THROW(validate(scene));
    std::vector<bool> used(mesh.positions.size(), false);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> corners{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
        const glm::vec3 a = mesh.positions[corners[0]], b = mesh.positions[corners[1]],
                        c = mesh.positions[corners[2]];
        const glm::vec3 face = glm::normalize(glm::cross(b - a, c - a));
        const glm::dvec2 u(mesh.uv0[corners[0]]), v(mesh.uv0[corners[1]]), w(mesh.uv0[corners[2]]);
        // v points down: a front face that shows the picture unmirrored has a negative area.
        EXPECT_LT((v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x), 0.0) << i;
        for (const std::uint32_t corner : corners) {
            used[corner] = true;
            EXPECT_GT(glm::dot(mesh.normals[corner], face), 0.0f) << i;
            EXPECT_NEAR(glm::length(mesh.normals[corner]), 1.0f, 1e-6f);
            EXPECT_TRUE(mesh.uv0[corner].x >= 0.0f && mesh.uv0[corner].x <= 1.0f &&
                        mesh.uv0[corner].y >= 0.0f && mesh.uv0[corner].y <= 1.0f);
        }
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

/// Of a regular polygon in a circle of radius 1.
double polygonArea(double corners) {
    return 0.5 * corners * std::sin(2.0 * pi / corners);
}

// Vertices are rounded to floats.
constexpr double relative = 1e-6;

TEST(Shapes, AreWellFormed) {
    for (const Mesh& mesh : {sphereMesh(2.0f, 16, 8), boxMesh({1, 2, 3}), planeMesh(2, 3, 4), discMesh(2, 7),
                             cylinderMesh(1, 2, 12), coneMesh(1, 2, 12), torusMesh(1, 0.25f, 12, 8),
                             sphereMesh(1.0f, 3, 2), torusMesh(1, 1, 3, 3), coneMesh(1e-3f, 1e3f, 3)}) {
        expectWellFormed(mesh);
    }
}

TEST(Shapes, AreClosed) {
    for (const Mesh& mesh : {sphereMesh(2.0f, 16, 8), boxMesh({1, 2, 3}), cylinderMesh(1, 2, 12),
                             coneMesh(1, 2, 12), torusMesh(1, 0.25f, 12, 8)}) {
        EXPECT_EQ(openEdges(mesh), 0u) << mesh.name;
    }
}

TEST(Shapes, HaveTheVolumesOfTheirPolyhedra) {
    const double base = polygonArea(12);
    EXPECT_NEAR(measuresOf(boxMesh({1, 2, 3})).volume, 6.0, 6.0 * relative);
    EXPECT_NEAR(measuresOf(cylinderMesh(2, 3, 12)).volume, 4.0 * base * 3.0, 12.0 * base * relative);
    EXPECT_NEAR(measuresOf(coneMesh(2, 3, 12)).volume, 4.0 * base, 4.0 * base * relative);
    EXPECT_NEAR(measuresOf(planeMesh(2, 3, 5)).area, 6.0, 6.0 * relative);
    EXPECT_NEAR(measuresOf(discMesh(2, 12)).area, 4.0 * base, 4.0 * base * relative);
    // Inscribed: less by about the squares of half an angle of a facet.
    const double sphere = measuresOf(sphereMesh(1, 128, 64)).volume / (4.0 / 3.0 * pi);
    EXPECT_LT(sphere, 1.0);
    EXPECT_GT(sphere, 1.0 - 2.0 * std::pow(pi / 64.0, 2));
    const double torus = measuresOf(torusMesh(1, 0.25f, 128, 64)).volume / (2.0 * pi * pi / 16.0);
    EXPECT_LT(torus, 1.0);
    EXPECT_GT(torus, 1.0 - 2.0 * std::pow(pi / 64.0, 2));
}

TEST(Shapes, NormalsAreThoseOfTheSmoothSurface) {
    const Mesh sphere = sphereMesh(2.0f, 16, 8), torus = torusMesh(1, 0.25f, 12, 8);
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        // At a pole each segment has its own vertex, of one normal.
        EXPECT_LE(glm::distance(sphere.normals[i], sphere.positions[i] / 2.0f), 1e-6f);
    }
    for (std::size_t i = 0; i < torus.positions.size(); ++i) {
        const glm::vec3& p = torus.positions[i];
        const glm::vec3 middle = glm::normalize(glm::vec3(p.x, 0, p.z));
        EXPECT_LE(glm::distance(torus.normals[i], (p - middle) / 0.25f), 4e-6f);
    }
}

TEST(Shapes, RefuseWhatIsOutOfRange) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(sphereMesh(0.0f), Error);
    EXPECT_THROW(sphereMesh(nan), Error);
    EXPECT_THROW(sphereMesh(1.0f, 2, 2), Error);
    EXPECT_THROW(sphereMesh(1.0f, 3, 1), Error);
    EXPECT_THROW(sphereMesh(1.0f, maxShapeParts + 1, 2), Error);
    EXPECT_THROW(boxMesh({1, -1, 1}), Error);
    EXPECT_THROW(planeMesh(1, 1, 0), Error);
    EXPECT_THROW(discMesh(1, 2), Error);
    EXPECT_THROW(cylinderMesh(1, 0), Error);
    EXPECT_THROW(coneMesh(-1, 1), Error);
    EXPECT_THROW(torusMesh(1, 2), Error);
}

}  // namespace
}  // namespace candela
