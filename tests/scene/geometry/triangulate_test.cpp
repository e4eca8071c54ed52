#include "scene/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

namespace candela {
namespace {

using Polygon = std::vector<glm::vec3>;
using Corners = std::vector<std::uint32_t>;

constexpr double pi = std::numbers::pi;

Corners triangulated(const Polygon& polygon) {
    Corners triangles;
    triangulate(polygon, triangles);
    return triangles;
}

// Twice the area, as a vector along the normal.
glm::dvec3 area(const Polygon& polygon, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::dvec3 from(polygon[a]);
    return glm::cross(glm::dvec3(polygon[b]) - from, glm::dvec3(polygon[c]) - from);
}

glm::dvec3 area(const Polygon& polygon) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t corner = 2; corner < polygon.size(); ++corner)
        sum += area(polygon, 0, corner - 1, corner);
    return sum;
}

void expectNumberOfTriangles(const Polygon& polygon, const Corners& triangles) {
    ASSERT_EQ(triangles.size(), polygon.size() < 3 ? 0 : 3 * (polygon.size() - 2));
    std::vector<bool> used(polygon.size(), polygon.size() < 3);
    for (const std::uint32_t corner : triangles) {
        ASSERT_LT(corner, polygon.size());
        used[corner] = true;
    }
    EXPECT_EQ(std::find(used.begin(), used.end(), false), used.end())
        << "a corner is not used by any triangle";
}

// Expects the triangles to cover a simple polygon once: each has the polygon's winding, and their areas add
// up to that of the polygon.
void expectCovered(const Polygon& polygon) {
    const Corners triangles = triangulated(polygon);
    expectNumberOfTriangles(polygon, triangles);
    const glm::dvec3 whole = area(polygon), normal = glm::normalize(whole);
    double sum = 0.0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const double part = glm::dot(area(polygon, triangles[i], triangles[i + 1], triangles[i + 2]), normal);
        // Slivers may be flipped by the rounding of a corner to a float, here on a length of up to 2.
        EXPECT_GE(part, -4e-7) << "triangle " << i / 3 << " of " << polygon.size() - 2;
        sum += part;
    }
    // Rounding of doubles, at worst one for each triangle, all of them far smaller than the polygon.
    EXPECT_NEAR(sum, glm::length(whole), 1e-12 * static_cast<double>(polygon.size()));
}

// A star-shaped polygon about the origin in a plane of random direction: the angle of the corners increases.
Polygon randomStar(std::mt19937& random, std::uint32_t size) {
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const glm::dvec3 x = glm::normalize(glm::dvec3(uniform(random), uniform(random), uniform(random)));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(uniform(random), uniform(random), 2.0)));
    Polygon polygon;
    for (std::uint32_t corner = 0; corner < size; ++corner) {
        const double angle = 2.0 * pi * corner / size, radius = 0.55 + 0.45 * uniform(random);
        polygon.emplace_back(x * (radius * std::cos(angle)) + y * (radius * std::sin(angle)));
    }
    return polygon;
}

TEST(Triangulate, GivesNothingBelowThreeCorners) {
    for (std::size_t size = 0; size < 3; ++size)
        EXPECT_TRUE(triangulated(Polygon(size, glm::vec3(1))).empty());
}

TEST(Triangulate, AppendsToTheOutput) {
    Corners triangles = {7, 8, 9};
    triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, triangles);
    EXPECT_EQ(triangles, (Corners{7, 8, 9, 0, 1, 2}));
}

TEST(Triangulate, SplitsQuadsAtTheFirstCorner) {
    const Polygon square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(triangulated(square), (Corners{0, 1, 2, 0, 2, 3}));
    const Polygon saddle = {{0, 0, 1}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}};
    EXPECT_EQ(triangulated(saddle), (Corners{0, 1, 2, 0, 2, 3}));
    const Polygon concaveAt2 = {{0, 0, 0}, {1, 0, 0}, {0.2f, 0.2f, 0}, {0, 1, 0}};
    EXPECT_EQ(triangulated(concaveAt2), (Corners{0, 1, 2, 0, 2, 3}));
}

TEST(Triangulate, SplitsConcaveQuadsAlongTheOtherDiagonal) {
    const Polygon concaveAt1 = {{0, 0, 0}, {0.4f, 0.4f, 0}, {1, 0, 0}, {0.4f, 1, 0}};
    EXPECT_EQ(triangulated(concaveAt1), (Corners{1, 2, 3, 1, 3, 0}));
    const Polygon flatAt3 = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5f, 0.5f, 0}};
    EXPECT_EQ(triangulated(flatAt3), (Corners{1, 2, 3, 1, 3, 0}));
}

TEST(Triangulate, KeepsTheWindingOfAClockwisePolygon) {
    Polygon polygon = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5f, 0}, {0, 2, 0}};
    std::reverse(polygon.begin(), polygon.end());
    const Corners triangles = triangulated(polygon);
    expectNumberOfTriangles(polygon, triangles);
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        EXPECT_LT(area(polygon, triangles[i], triangles[i + 1], triangles[i + 2]).z, 0.0);
}

TEST(Triangulate, CoversRandomStars) {
    std::mt19937 random(1);
    for (std::uint32_t size = 4; size < 120; ++size) {
        SCOPED_TRACE(size);
        expectCovered(randomStar(random, size));
    }
}

TEST(Triangulate, DoesNotDependOnScale) {
    std::mt19937 random(2);
    const Polygon polygon = randomStar(random, 40);
    const Corners expected = triangulated(polygon);
    // Scaling by powers of two is exact.
    for (const float size : {0x1p-100f, 0x1p-60f, 0x1p60f, 0x1p100f}) {
        Polygon scaled = polygon;
        for (glm::vec3& corner : scaled) corner *= size;
        EXPECT_EQ(triangulated(scaled), expected) << size;
    }
}

// Polygons with heights from a small grid: many corners are collinear, and many lie on a diagonal of others.
TEST(Triangulate, CoversHeightProfilesWithCollinearCorners) {
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(round);
        Polygon polygon;
        const int width = 3 + round % 40;
        for (int x = width; x >= 0; --x)
            polygon.emplace_back(x, 0.25 * static_cast<double>(1 + random() % 3), 0);
        for (int x = 0; x <= width; ++x)
            polygon.emplace_back(x, -0.25 * static_cast<double>(random() % 3), 0);
        expectCovered(polygon);
    }
}

TEST(Triangulate, UsesCollinearCornersWithoutSlivers) {
    Polygon square;
    for (float t = 0.0f; t < 1.0f; t += 0.125f) square.emplace_back(t, 0, 0);
    for (float t = 0.0f; t < 1.0f; t += 0.125f) square.emplace_back(1, t, 0);
    for (float t = 1.0f; t > 0.0f; t -= 0.125f) square.emplace_back(t, 1, 0);
    for (float t = 1.0f; t > 0.0f; t -= 0.125f) square.emplace_back(0, t, 0);
    expectCovered(square);
    const Corners triangles = triangulated(square);
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        EXPECT_GT(area(square, triangles[i], triangles[i + 1], triangles[i + 2]).z, 0.0);
}

TEST(Triangulate, CoversASpiral) {
    Polygon polygon;
    const auto addCorner = [&](int i, double width) {
        const double angle = i * 0.1, radius = 0.02 + i * 0.002 + width;
        polygon.emplace_back(radius * std::cos(angle), 0, -radius * std::sin(angle));
    };
    // A revolution has 63 steps: its radius grows by 0.126, and the spiral is 0.06 wide.
    for (int i = 0; i < 400; ++i) addCorner(i, 0.06);
    for (int i = 399; i >= 0; --i) addCorner(i, 0.0);
    expectCovered(polygon);
}

// A square with two square holes, each connected by a slit, an edge that is used twice.
TEST(Triangulate, CoversAPolygonWithSlitsToHoles) {
    const Polygon polygon = {{0, 0, 0}, {4, 0, 0},    {4, 4, 0},                                            //
                             {3, 3, 0}, {3, 2, 0},    {2, 2, 0},       {2, 3, 0},    {3, 3, 0}, {4, 4, 0},  //
                             {0, 4, 0}, {0, 1, 0},                                                          //
                             {1, 1, 0}, {1, 1.5f, 0}, {1.5f, 1.5f, 0}, {1.5f, 1, 0}, {1, 1, 0}, {0, 1, 0}};
    expectCovered(polygon);
}

TEST(Triangulate, ProjectsANonPlanarPolygonAlongItsNormal) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> height(-0.2f, 0.2f);
    Polygon polygon;
    for (int corner = 0; corner < 50; ++corner) {
        const double angle = 2.0 * pi * corner / 50, radius = corner % 2 == 0 ? 1.0 : 0.6;
        polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height(random));
    }
    const Corners triangles = triangulated(polygon);
    expectNumberOfTriangles(polygon, triangles);
    const glm::dvec3 normal = glm::normalize(area(polygon));
    EXPECT_GT(normal.z, 0.9) << "the polygon of the test";
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        EXPECT_GT(glm::dot(area(polygon, triangles[i], triangles[i + 1], triangles[i + 2]), normal), 0.0);
}

TEST(Triangulate, KeepsTheTriangleCountForPolygonsWithoutArea) {
    for (const std::size_t size : {3, 4, 5, 9, 100}) {
        SCOPED_TRACE(size);
        Polygon point(size, glm::vec3(1, 2, 3)), line, backAndForth;
        for (std::size_t i = 0; i < size; ++i) {
            line.emplace_back(static_cast<float>(i) * 0.1f, static_cast<float>(i) * 0.3f, 0);
            backAndForth.emplace_back(i % 2 == 0 ? 0 : 1, 0, 0);
        }
        for (const Polygon& polygon : {point, line, backAndForth})
            expectNumberOfTriangles(polygon, triangulated(polygon));
    }
}

TEST(Triangulate, KeepsTheTriangleCountForPolygonsThatAreNotSimple) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    for (int round = 0; round < 2000; ++round) {
        SCOPED_TRACE(round);
        Polygon polygon;
        const int size = 3 + round % 60;
        // A third each: any points, points of a small grid (many of them equal), points of a plane.
        for (int i = 0; i < size; ++i) {
            const glm::vec3 any(uniform(random), uniform(random), uniform(random));
            polygon.push_back(round % 3 == 0   ? any
                              : round % 3 == 1 ? glm::round(any * 1.4f)
                                               : glm::vec3(any.x, any.y, any.x));
        }
        expectNumberOfTriangles(polygon, triangulated(polygon));
    }
}

TEST(Triangulate, AcceptsRepeatedCorners) {
    std::mt19937 random(6);
    Polygon polygon;
    for (const glm::vec3& corner : randomStar(random, 30))
        polygon.insert(polygon.end(), 1 + random() % 3, corner);
    expectCovered(polygon);
}

TEST(Triangulate, AcceptsTheRangeOfFloats) {
    const float huge = 3e38f, tiny = 1e-45f;
    for (const float size : {huge, tiny}) {
        const Polygon polygon = {{-size, 0, 0}, {0, -size, 0}, {size, 0, 0}, {0, size, 0}, {-size, size, 0}};
        expectNumberOfTriangles(polygon, triangulated(polygon));
    }
}

// An algorithm of quadratic time would take minutes.
TEST(Triangulate, CoversPolygonsOf100000Corners) {
    std::mt19937 random(7);
    expectCovered(randomStar(random, 100'000));
    Polygon comb;
    for (int tooth = 50'000; tooth > 0; --tooth) {
        comb.emplace_back(tooth * 2e-5, tooth * 2e-5 + 1, 0);
        comb.emplace_back(tooth * 2e-5 - 1e-5, tooth * 2e-5, 0);
    }
    comb.emplace_back(0, -1, 0);
    comb.emplace_back(1, -1, 0);
    expectCovered(comb);
}

}  // namespace
}  // namespace candela
