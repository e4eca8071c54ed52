#include "generated_cages.h"
#include "plugin_refinement.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

/// A hemisphere of quads whose last ring of vertices lies at the pole: the faces there are degenerate
/// triangles, and the surface has a boundary of length 0.
Cage collapsedPole(std::uint32_t around, std::uint32_t rings) {
    std::vector<glm::vec3> points;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t j = 0; j <= rings; ++j) {
        const float latitude =
            0.5f * std::numbers::pi_v<float> * static_cast<float>(j) / static_cast<float>(rings);
        const float radius = j == rings ? 0.0f : std::cos(latitude);
        for (std::uint32_t i = 0; i < around; ++i) {
            const float angle =
                2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(around);
            points.emplace_back(radius * std::cos(angle), std::sin(latitude), -radius * std::sin(angle));
            if (j == rings) continue;
            const std::uint32_t next = (i + 1) % around;
            faces.push_back(
                {j * around + i, j * around + next, (j + 1) * around + next, (j + 1) * around + i});
        }
    }
    return makeCage("hemisphere", points, faces);
}

TEST(Degenerate, poleUsesANormalNearIt) {
    const Cage cage = collapsedPole(8, 4);
    for (const std::uint32_t level : {1u, 3u, 6u}) {
        const RefinedCage refined = refineWithPlugin(cage, level);
        const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
        int atPole = 0;
        for (const GridVertex& at : gridVertices(cage, refined)) {
            const glm::vec3 normal = limit.normals[at.vertex];
            EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
            EXPECT_GT(normal.y, -0.5f);
            if (at.face / 8 != 3 || at.t != 1.0) continue;
            ++atPole;
            // du is 0 there. The slope of the faces at the pole is at most 0.2, in different directions.
            EXPECT_GT(normal.y, 0.9f) << level;
            EXPECT_GT(glm::length(limit.dv[at.vertex]), 0.1f);
        }
        EXPECT_EQ(atPole, 8 * ((1 << level) + 1));
    }
}

// Where the boundary is a smooth curve through the corner of a single face, du and dv are parallel.
TEST(Degenerate, roundedCornerUsesANormalNearIt) {
    Cage cage = sheet(3, 3);
    cage.boundaryInterpolation = BoundaryInterpolation::edges;
    for (glm::vec3& point : cage.positions) point.y = 0.2f * point.x;
    const glm::vec3 flat = glm::normalize(glm::vec3(-0.2f, 1.0f, 0.0f));
    for (const std::uint32_t level : {1u, 4u, 8u}) {
        const EvaluatedLimit limit = evaluateCage(refineWithPlugin(cage, level), cage.positions);
        for (const glm::vec3& normal : limit.normals) {
            // du × dv is 1e-3 of their lengths at level 8, and they are rounded by some 1e-7.
            EXPECT_LT(glm::length(normal - flat), 1e-3f) << level;
        }
    }
}

TEST(Degenerate, collapsedQuadHasNormals) {
    for (const SubdivisionScheme scheme : {SubdivisionScheme::catmullClark, SubdivisionScheme::bilinear}) {
        Cage cage = sheet(3, 3);
        cage.scheme = scheme;
        // Face 4 in the middle becomes a triangle: two of its corners coincide.
        cage.positions[9] = cage.positions[5];
        for (const std::uint32_t level : {1u, 3u}) {
            const EvaluatedLimit limit = evaluateCage(refineWithPlugin(cage, level), cage.positions);
            for (const glm::vec3& normal : limit.normals) {
                EXPECT_LT(glm::length(normal - glm::vec3(0.0f, 1.0f, 0.0f)), 1e-3f);
            }
        }
    }
}

// All vertices coincide: normals are undefined, but refinement succeeds.
TEST(Degenerate, cageOfZeroExtentIsRefined) {
    Cage cage = cube();
    for (glm::vec3& point : cage.positions) point = glm::vec3(1.0f, 2.0f, 3.0f);
    const EvaluatedLimit limit = evaluateCage(refineWithPlugin(cage, 2), cage.positions);
    for (const glm::vec3& position : limit.positions) {
        EXPECT_LT(glm::length(position - glm::vec3(1.0f, 2.0f, 3.0f)), 1e-5f);
    }
}

}  // namespace
}  // namespace candela
