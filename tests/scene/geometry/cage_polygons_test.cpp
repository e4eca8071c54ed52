#include <candela/refined_cage.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {
namespace {

Cage cube() {
    Cage cage;
    for (int i = 0; i < 8; ++i) cage.positions.emplace_back(i & 1, i >> 1 & 1, i >> 2);
    cage.faceSizes.assign(6, 4);
    cage.faceVertices = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    return cage;
}

// A cage of one face in the plane through `origin` with the edges x and y.
Cage polygonIn(const glm::vec3& origin, const glm::vec3& x, const glm::vec3& y,
               const std::vector<glm::vec2>& corners) {
    Cage cage;
    cage.faceSizes = {static_cast<std::uint32_t>(corners.size())};
    for (const glm::vec2& corner : corners) {
        cage.faceVertices.push_back(static_cast<std::uint32_t>(cage.positions.size()));
        cage.positions.push_back(origin + x * corner.x + y * corner.y);
    }
    return cage;
}

const std::vector<glm::vec2> arrow = {{0, 0}, {1, 0.5f}, {2, 0}, {1.5f, 2}, {1, 1.25f}, {0.5f, 2}};

struct Evaluated {
    std::vector<glm::vec3> positions, normals, du, dv;
};

Evaluated evaluate(const RefinedCage& refined, const std::vector<glm::vec3>& points) {
    Evaluated result;
    for (auto* array : {&result.positions, &result.normals, &result.du, &result.dv})
        array->resize(refined.vertexCount());
    evaluateLimit(refined, points, {result.positions, result.normals, result.du, result.dv});
    return result;
}

void expectConsistentSizes(const RefinedCage& refined) {
    for (const StencilTable* table : {&refined.positions, &refined.uvs}) {
        if (table == &refined.uvs && table->stencilCount() == 0) continue;
        ASSERT_EQ(table->stencilCount(), refined.vertexCount());
        if (table->stencilCount() == 0) continue;
        EXPECT_EQ(table->offsets.front(), 0u);
        EXPECT_EQ(table->offsets.back(), table->controlIndices.size());
    }
    EXPECT_EQ(refined.faceVertices.size(), 3 * refined.cageFaces.size());
}

// The length of the difference, for vectors of about unit length: some roundings of each component.
void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = 2e-6f) {
    EXPECT_LE(glm::distance(actual, expected), tolerance)
        << actual.x << " " << actual.y << " " << actual.z << " for " << expected.x << " " << expected.y << " "
        << expected.z;
}

TEST(CagePolygons, OfACubeAreItsTriangles) {
    const Cage cage = cube();
    const RefinedCage refined = cagePolygons(cage);
    expectConsistentSizes(refined);
    EXPECT_EQ(refined.level, 0u);
    EXPECT_EQ(refined.faceSize, 3u);
    EXPECT_EQ(refined.pointCount, 8u);
    EXPECT_EQ(refined.vertexCount(), 24u);
    EXPECT_EQ(refined.uvs.stencilCount(), 0u);
    ASSERT_EQ(refined.cageFaces.size(), 12u);
    const Evaluated vertices = evaluate(refined, cage.positions);
    for (std::uint32_t triangle = 0; triangle < 12; ++triangle) {
        const std::uint32_t face = triangle / 2;
        EXPECT_EQ(refined.cageFaces[triangle], face);
        glm::vec3 outwards(0.0f);
        outwards[face / 2 == 0 ? 2 : face / 2 == 1 ? 1 : 0] = face % 2 == 0 ? -1.0f : 1.0f;
        const std::uint32_t* corners = &refined.faceVertices[3 * triangle];
        const glm::vec3 a = vertices.positions[corners[0]];
        EXPECT_EQ(glm::cross(vertices.positions[corners[1]] - a, vertices.positions[corners[2]] - a),
                  outwards);
        for (int i = 0; i < 3; ++i) expectNear(vertices.normals[corners[i]], outwards);
    }
}

TEST(CagePolygons, HaveThePositionsOfTheCage) {
    Cage cage = cube();
    for (glm::vec3& position : cage.positions) position = position * 0.3f + glm::vec3(1000.1f, -7.7f, 0.01f);
    const RefinedCage refined = cagePolygons(cage);
    const Evaluated vertices = evaluate(refined, cage.positions);
    std::vector<int> users(8, 0);
    for (std::uint32_t vertex = 0; vertex < 24; ++vertex) {
        // Bit for bit: the other corners of a polygon do not change a corner's position.
        const auto at = std::find(cage.positions.begin(), cage.positions.end(), vertices.positions[vertex]);
        ASSERT_NE(at, cage.positions.end());
        ++users[at - cage.positions.begin()];
        EXPECT_EQ(vertices.positions[vertex], vertices.positions[refined.pointOf(vertex)]);
    }
    EXPECT_EQ(users, std::vector<int>(8, 3));
}

TEST(CagePolygons, OmitHolesAndUnusedVertices) {
    Cage cage = cube();
    cage.positions.insert(cage.positions.begin(), glm::vec3(99));
    for (std::uint32_t& vertex : cage.faceVertices) ++vertex;
    cage.holes = {1, 3, 5};
    const RefinedCage refined = cagePolygons(cage);
    expectConsistentSizes(refined);
    // The three remaining faces meet at vertex 0 of the cube, and none has vertex 7.
    EXPECT_EQ(refined.pointCount, 7u);
    EXPECT_EQ(refined.vertexCount(), 12u);
    EXPECT_EQ(refined.cageFaces, (std::vector<std::uint32_t>{0, 0, 2, 2, 4, 4}));
    for (const std::uint32_t control : refined.positions.controlIndices) {
        EXPECT_NE(control, 0u);
        EXPECT_NE(control, 8u);
    }
}

TEST(CagePolygons, OfAnEmptyCage) {
    Cage cage;
    EXPECT_EQ(cagePolygons(cage).vertexCount(), 0u);
    cage = cube();
    cage.holes = {0, 1, 2, 3, 4, 5};
    const RefinedCage refined = cagePolygons(cage);
    EXPECT_EQ(refined.vertexCount(), 0u);
    EXPECT_EQ(refined.positions.stencilCount(), 0u);
    EXPECT_TRUE(evaluate(refined, cage.positions).positions.empty());
}

TEST(CagePolygons, FollowAnAffineTransform) {
    const Cage cage = polygonIn({0.5f, -1, 2}, {1, 0, 0.5f}, {0.25f, 1, 0}, arrow);
    const RefinedCage refined = cagePolygons(cage);
    const Evaluated rest = evaluate(refined, cage.positions);
    const glm::mat3 motion(1.5f, 0.25f, -0.5f, 0.5f, 2.0f, 0.75f, -1.0f, 0.5f, 1.25f);
    std::vector<glm::vec3> moved;
    for (const glm::vec3& position : cage.positions) moved.push_back(motion * position + glm::vec3(3, 1, -2));
    const Evaluated after = evaluate(refined, moved);
    const glm::vec3 normal = glm::normalize(glm::cross(glm::vec3(1, 0, 0.5f), glm::vec3(0.25f, 1, 0)));
    const glm::vec3 movedNormal =
        glm::normalize(glm::cross(motion * glm::vec3(1, 0, 0.5f), motion * glm::vec3(0.25f, 1, 0)));
    for (std::uint32_t vertex = 0; vertex < refined.vertexCount(); ++vertex) {
        expectNear(rest.normals[vertex], normal);
        EXPECT_NEAR(glm::length(rest.du[vertex]), 1.0f, 2e-6f);
        EXPECT_NEAR(glm::length(rest.dv[vertex]), 1.0f, 2e-6f);
        EXPECT_NEAR(glm::dot(rest.du[vertex], rest.dv[vertex]), 0.0f, 2e-6f);
        expectNear(after.normals[vertex], movedNormal);
        // The points are up to 10 m long, and some weights 0.4: each product is rounded by 4e-7 at most.
        expectNear(after.du[vertex], motion * rest.du[vertex], 5e-6f);
        expectNear(after.dv[vertex], motion * rest.dv[vertex], 5e-6f);
    }
}

TEST(CagePolygons, HaveTheNormalOfTheLeastSquaresPlane) {
    Cage cage = polygonIn({}, {1, 0, 0}, {0, 1, 0}, {{0, 0}, {3, 0}, {3, 3}, {0, 3}});
    // The least-squares plane of a saddle is horizontal.
    const float heights[] = {0.5f, -0.5f, 0.5f, -0.5f};
    for (int i = 0; i < 4; ++i) cage.positions[i].z = heights[i];
    const Evaluated vertices = evaluate(cagePolygons(cage), cage.positions);
    for (const glm::vec3& normal : vertices.normals) expectNear(normal, {0, 0, 1});
}

TEST(CagePolygons, HaveFlatNormalsForThousandsOfCorners) {
    std::vector<glm::vec2> corners;
    for (int i = 0; i < 5000; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 5000, radius = i % 2 == 0 ? 1.0 : 0.9;
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const Cage cage = polygonIn({1, 2, 3}, {0, 1, 0}, {0, 0, 1}, corners);
    const RefinedCage refined = cagePolygons(cage);
    expectConsistentSizes(refined);
    EXPECT_EQ(refined.cageFaces.size(), 4998u);
    // Stencils of all corners would have 25 million entries.
    EXPECT_LE(refined.positions.controlIndices.size(), 20'000u);
    const Evaluated vertices = evaluate(refined, cage.positions);
    for (std::uint32_t vertex = 0; vertex < refined.vertexCount(); ++vertex) {
        EXPECT_EQ(vertices.positions[vertex], cage.positions[vertex]);
        // The corners are rounded to 2e-7 m, 2 m apart.
        expectNear(vertices.normals[vertex], {1, 0, 0});
    }
}

TEST(CagePolygons, HaveTextureCoordinatesAndTheirDerivatives) {
    Cage cage = polygonIn({0.5f, -1, 2}, {1, 0, 0.5f}, {0.25f, 1, 0}, arrow);
    // u grows along x, and v along y and x; the texture coordinates are in another order than the corners.
    for (std::uint32_t corner = 0; corner < arrow.size(); ++corner) {
        const glm::vec2& at = arrow[arrow.size() - 1 - corner];
        cage.uvs.emplace_back(0.25f * at.x, 0.5f * at.y + 0.125f * at.x);
        cage.faceUvs.push_back(static_cast<std::uint32_t>(arrow.size()) - 1 - corner);
    }
    const RefinedCage refined = cagePolygons(cage);
    expectConsistentSizes(refined);
    const LimitUvs uvs = evaluateLimitUvs(refined, cage.uvs);
    const Evaluated vertices = evaluate(refined, cage.positions);
    ASSERT_EQ(uvs.uvs.size(), refined.vertexCount());
    const glm::vec3 x(1, 0, 0.5f), y(0.25f, 1, 0);
    for (std::uint32_t vertex = 0; vertex < refined.vertexCount(); ++vertex) {
        EXPECT_EQ(uvs.uvs[vertex], cage.uvs[cage.faceUvs[vertex]]);
        // The derivatives of the texture coordinates along du = a x + b y are a times those along x plus b
        // times those along y.
        const glm::vec3 derivatives[] = {vertices.du[vertex], vertices.dv[vertex]};
        const glm::vec2 gradients[] = {uvs.du[vertex], uvs.dv[vertex]};
        for (int i = 0; i < 2; ++i) {
            const float b = derivatives[i].y, a = derivatives[i].z / 0.5f;
            expectNear(a * x + b * y, derivatives[i]);
            EXPECT_NEAR(gradients[i].x, 0.25f * a, 1e-6f);
            EXPECT_NEAR(gradients[i].y, 0.5f * b + 0.125f * a, 1e-6f);
        }
    }
}

TEST(CagePolygons, OfTrianglesHaveTheirNormalAtEverySizeAndShape) {
    for (const float size : {1e-30f, 1e-10f, 1.0f, 1e10f}) {
        for (const float height : {1e-12f, 1e-6f, 1.0f}) {
            const Cage cage = polygonIn({}, {0, size, 0}, {0, 0, size * height}, {{0, 0}, {1, 0}, {0.5f, 1}});
            for (const glm::vec3& normal : evaluate(cagePolygons(cage), cage.positions).normals)
                expectNear(normal, {1, 0, 0});
        }
    }
}

TEST(CagePolygons, OfThinShapesKeepTheirOrientation) {
    // The cross product of the edges at the first corner, which is concave, points to the other side.
    const std::vector<glm::vec2> fromConcave = {{1, 1.25f}, {0.5f, 2}, {0, 0}, {1, 0.5f}, {2, 0}, {1.5f, 2}};
    for (const float width : {1e-5f, 1e-3f, 1.0f}) {
        const Cage cage = polygonIn({}, {1, 0, 0}, {0, width, 0}, fromConcave);
        for (const glm::vec3& normal : evaluate(cagePolygons(cage), cage.positions).normals)
            expectNear(normal, {0, 0, 1});
    }
}

TEST(CagePolygons, WithoutAreaHaveFiniteWeights) {
    const std::vector<std::vector<glm::vec2>> shapes = {
        {{0, 0}, {0, 0}, {0, 0}},           {{0, 0}, {1, 0}, {2, 0}},
        {{0, 0}, {1, 1}, {1, 0}, {0, 1}},  // Self-intersecting: its signed area is 0.
        {{0, 0}, {1e-43f, 0}, {0, 1e-43f}}, std::vector<glm::vec2>(100, glm::vec2(1, 1)),
    };
    for (const std::vector<glm::vec2>& shape : shapes) {
        const Cage cage = polygonIn({}, {1, 0, 0}, {0, 1, 0}, shape);
        const RefinedCage refined = cagePolygons(cage);
        expectConsistentSizes(refined);
        EXPECT_EQ(refined.cageFaces.size(), shape.size() - 2);
        for (const auto* weights :
             {&refined.positions.weights, &refined.positions.duWeights, &refined.positions.dvWeights})
            for (const float weight : *weights) EXPECT_TRUE(std::isfinite(weight));
        for (const glm::vec3& normal : evaluate(refined, cage.positions).normals)
            EXPECT_TRUE(normal == glm::vec3(0) || std::abs(glm::length(normal) - 1.0f) < 1e-6f);
    }
}

}  // namespace
}  // namespace candela
