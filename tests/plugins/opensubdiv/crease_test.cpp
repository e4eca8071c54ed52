#include "generated_cages.h"
#include "plugin_refinement.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace candela {
namespace {

/// The vertices of faces at one point.
std::set<std::uint32_t> verticesAt(const RefinedCage& refined, std::uint32_t point) {
    std::set<std::uint32_t> vertices;
    for (const std::uint32_t vertex : refined.faceVertices) {
        if (refined.pointOf(vertex) == point) vertices.insert(vertex);
    }
    return vertices;
}

/// The vertex that a face has at (s, t).
std::uint32_t vertexAt(const Cage& cage, const RefinedCage& refined, std::uint32_t face, double s, double t) {
    for (const GridVertex& at : gridVertices(cage, refined)) {
        if (at.face == face && at.patch == 0 && at.s == s && at.t == t) return at.vertex;
    }
    ADD_FAILURE() << "face " << face << " has no such vertex";
    return 0;
}

float angleBetween(const glm::vec3& a, const glm::vec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// A sheet of 6 × 6 faces, folded along its middle column of vertices: both halves rise by `slope`.
Cage foldedSheet(float slope) {
    Cage cage = sheet(6, 6);
    for (glm::vec3& point : cage.positions) point.y = slope * std::abs(point.x - 3.0f);
    return cage;
}

/// Creases along the fold, from row `first` to row `last` of the vertices.
void crease(Cage& cage, std::uint32_t first, std::uint32_t last, float sharpness) {
    for (std::uint32_t row = first; row < last; ++row) {
        cage.creases.push_back({row * 7 + 3, (row + 1) * 7 + 3, sharpness});
    }
}

// The faces 20 and 21 lie left and right of the fold.
TEST(Crease, thatIsInfinitelySharpSeparatesNormals) {
    Cage cage = foldedSheet(1.0f);
    crease(cage, 0, 6, infiniteSharpness);
    const RefinedCage refined = refineWithPlugin(cage, 2);
    const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
    for (const double t : {0.0, 0.25, 0.5, 1.0}) {
        const std::uint32_t left = vertexAt(cage, refined, 20, 1.0, t);
        const std::uint32_t right = vertexAt(cage, refined, 21, 0.0, t);
        EXPECT_NE(left, right);
        EXPECT_EQ(refined.pointOf(left), refined.pointOf(right));
        // Both sides are planes at 45 degrees; across the crease they do not affect each other.
        EXPECT_NEAR(angleBetween(limit.normals[left], limit.normals[right]), std::numbers::pi / 2, 1e-5);
        EXPECT_NEAR(angleBetween(limit.normals[left], glm::vec3(1.0f, 1.0f, 0.0f)), 0.0, 1e-5);
    }
}

TEST(Crease, thatIsSemiSharpIsSmooth) {
    for (const float sharpness : {0.0f, 0.5f, 1.0f, 2.3f, 4.0f, 9.9f}) {
        for (const CreaseMethod method : {CreaseMethod::uniform, CreaseMethod::chaikin}) {
            Cage cage = foldedSheet(1.0f);
            cage.creaseMethod = method;
            crease(cage, 0, 6, sharpness);
            const RefinedCage refined = refineWithPlugin(cage, 2);
            EXPECT_TRUE(refined.seamPoints.empty());
            const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
            for (const double t : {0.0, 0.25, 0.5, 1.0}) {
                const std::uint32_t left = vertexAt(cage, refined, 20, 1.0, t);
                EXPECT_EQ(left, vertexAt(cage, refined, 21, 0.0, t));
                // The fold is symmetric.
                EXPECT_NEAR(angleBetween(limit.normals[left], glm::vec3(0.0f, 1.0f, 0.0f)), 0.0, 1e-4);
            }
        }
    }
}

TEST(Crease, thatEndsInASmoothVertexIsADart) {
    Cage cage = foldedSheet(0.7f);
    crease(cage, 0, 3, infiniteSharpness);
    const RefinedCage refined = refineWithPlugin(cage, 2);
    const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
    // The dart's vertex is the far right corner of face 14 and the far left one of face 15.
    const std::uint32_t dart = vertexAt(cage, refined, 14, 1.0, 1.0);
    EXPECT_EQ(dart, vertexAt(cage, refined, 15, 0.0, 1.0));
    EXPECT_EQ(dart, vertexAt(cage, refined, 20, 1.0, 0.0));
    EXPECT_EQ(verticesAt(refined, dart).size(), 1u);
    EXPECT_NEAR(limit.normals[dart].x, 0.0f, 1e-5f);
    // The normals differ along the crease, and not beyond the dart.
    EXPECT_NE(vertexAt(cage, refined, 14, 1.0, 0.75), vertexAt(cage, refined, 15, 0.0, 0.75));
    EXPECT_EQ(vertexAt(cage, refined, 20, 1.0, 0.25), vertexAt(cage, refined, 21, 0.0, 0.25));
}

TEST(Crease, aroundOneFaceOfACubeAddsOneSeamVertexPerPoint) {
    Cage cage = cube();
    cage.creases = {{0, 2, 10.0f}, {2, 3, 10.0f}, {3, 1, 10.0f}, {1, 0, 10.0f}};
    const RefinedCage refined = refineWithPlugin(cage, 2);
    EXPECT_EQ(refined.seamPoints.size(), 4u * 4u);
    const std::set<std::uint32_t> points(refined.seamPoints.begin(), refined.seamPoints.end());
    EXPECT_EQ(points.size(), refined.seamPoints.size());
}

TEST(Crease, onAllEdgesOfACubeKeepsItACube) {
    Cage cage = cube();
    for (const auto& [vertex0, vertex1] : edgesOf(cage)) cage.creases.push_back({vertex0, vertex1, 10.0f});
    const RefinedCage refined = refineWithPlugin(cage, 2);
    // Six faces of 5 × 5 vertices each.
    EXPECT_EQ(refined.vertexCount(), 6u * 25u);
    const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
    for (std::size_t i = 0; i < limit.normals.size(); ++i) {
        const glm::vec3 size = glm::abs(limit.normals[i]);
        EXPECT_NEAR(std::max({size.x, size.y, size.z}), 1.0f, 1e-5f);
    }
}

TEST(Corner, thatIsInfinitelySharpSeparatesItsFaces) {
    Cage cage = cube();
    cage.corners = {{7, infiniteSharpness}};
    RefinedCage refined = refineWithPlugin(cage, 2);
    EXPECT_EQ(refined.seamPoints.size(), 2u);
    cage.corners = {{7, 4.0f}};
    refined = refineWithPlugin(cage, 2);
    EXPECT_TRUE(refined.seamPoints.empty());
}

TEST(Bilinear, facesDoNotShareNormals) {
    Cage cage = pyramid(5);
    cage.scheme = SubdivisionScheme::bilinear;
    const RefinedCage refined = refineWithPlugin(cage, 2);
    // All faces are split into sub-faces of 2 × 2 quads with 9 vertices each: 5 × 3 of the triangles, 5 of
    // the base.
    EXPECT_EQ(refined.vertexCount(), 20u * 9u);
}

TEST(Seam, hasSeamVerticesWithTheTextureCoordinatesOfBothSides) {
    Cage cage = sheet(2, 1);
    cage.faceVaryingInterpolation = FaceVaryingInterpolation::all;
    cage.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    cage.faceUvs = {0, 1, 2, 3, 0, 1, 2, 3};
    const RefinedCage refined = refineWithPlugin(cage, 1);
    // The seam has three points: both ends and the middle.
    EXPECT_EQ(refined.seamPoints.size(), 3u);
    const LimitUvs uvs = evaluateLimitUvs(refined, cage.uvs);
    const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
    const std::uint32_t left = vertexAt(cage, refined, 0, 1.0, 0.5);
    const std::uint32_t right = vertexAt(cage, refined, 1, 0.0, 0.5);
    EXPECT_EQ(refined.pointOf(left), refined.pointOf(right));
    EXPECT_EQ(uvs.uvs[left], glm::vec2(1.0f, 0.5f));
    EXPECT_EQ(uvs.uvs[right], glm::vec2(0.0f, 0.5f));
    EXPECT_LT(angleBetween(limit.normals[left], limit.normals[right]), 1e-5f);
}

// A seam that ends inside the surface: its last vertex has one texture coordinate.
TEST(Seam, endsInASharedVertex) {
    Cage cage = sheet(4, 4);
    addSmoothUvs(cage);
    // Vertices 2 and 7 get separate coordinates on the right side of the line between columns 1 and 2.
    const auto first = static_cast<std::uint32_t>(cage.uvs.size());
    cage.uvs.insert(cage.uvs.end(), {{9.0f, 0.0f}, {9.0f, 1.0f}});
    cage.faceUvs[4 * 2] = first;
    cage.faceUvs[4 * 2 + 3] = first + 1;
    cage.faceUvs[4 * 6] = first + 1;
    const RefinedCage refined = refineWithPlugin(cage, 2);
    // Two edges of four points each; their common end is shared with all faces around it.
    EXPECT_EQ(refined.seamPoints.size(), 8u);
    EXPECT_EQ(verticesAt(refined, vertexAt(cage, refined, 5, 1.0, 1.0)).size(), 1u);
}

}  // namespace
}  // namespace candela
