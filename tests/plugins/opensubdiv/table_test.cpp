#include "generated_cages.h"
#include "plugin_refinement.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace candela {
namespace {

/// A point on an edge of the cage: the edge's two vertices and the segment.
using EdgePoint = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

std::vector<Cage> variedCages() {
    Random random(21);
    std::vector<Cage> cages{cube(),  torus(5, 4), pyramid(5),      sheet(3, 4),
                            star(3), star(7),     mixedPolygons(), threeSheets()};
    for (std::size_t i = 0, count = cages.size(); i < count; ++i) cages.push_back(triangulated(cages[i]));
    for (std::size_t i = 0; i < 8; ++i) {
        cages.push_back(cages[i]);
        cages.back().scheme = SubdivisionScheme::bilinear;
    }
    for (Cage& cage : cages) {
        cage.name += ", scheme " + std::to_string(static_cast<int>(cage.scheme));
        jitter(cage, 0.15f, random);
        addUvsWithSeams(cage, random);
        addRandomSharpness(cage, random);
    }
    return cages;
}

/// Calls `visit(edge, t, vertex)` for the vertices of all faces on edges of the cage; t counts segments from
/// the vertex of lower index.
template <typename Visit>
void eachEdgeVertex(const Cage& cage, const RefinedCage& refined, Visit visit) {
    const double segments = static_cast<double>(1u << refined.level);
    std::vector<std::size_t> starts{0};
    for (const std::uint32_t size : cage.faceSizes) starts.push_back(starts.back() + size);
    for (const GridVertex& at : gridVertices(cage, refined)) {
        const std::uint32_t size = cage.faceSizes[at.face];
        const bool hasSubfaces = refined.faceSize == 4 && size != 4;
        const auto onEdge = [&](std::uint32_t edge, double fraction) {
            const std::uint32_t from = cage.faceVertices[starts[at.face] + edge % size];
            const std::uint32_t to = cage.faceVertices[starts[at.face] + (edge + 1) % size];
            const double along = from < to ? fraction : 1.0 - fraction;
            visit(std::minmax(from, to), static_cast<std::uint32_t>(along * segments + 0.5), at.vertex);
        };
        if (hasSubfaces) {
            if (at.t == 0.0) onEdge(at.patch, at.s / 2);
            if (at.s == 0.0) onEdge(at.patch + size - 1, 1.0 - at.t / 2);
        } else if (size == 4) {
            if (at.t == 0.0) onEdge(0, at.s);
            if (at.s == 1.0) onEdge(1, at.t);
            if (at.t == 1.0) onEdge(2, 1.0 - at.s);
            if (at.s == 0.0) onEdge(3, 1.0 - at.t);
        } else {
            if (at.t == 0.0) onEdge(0, at.s);
            if (at.s + at.t == 1.0) onEdge(1, at.t);
            if (at.s == 0.0) onEdge(2, 1.0 - at.t);
        }
    }
}

TEST(Table, hasNoCracks) {
    for (const Cage& cage : variedCages()) {
        SCOPED_TRACE(cage.name);
        const RefinedCage refined = refineWithPlugin(cage, 2);
        const EvaluatedLimit limit = evaluateCage(refined, cage.positions);
        std::map<EdgePoint, std::uint32_t> points;
        std::map<std::uint32_t, glm::vec3> positions;
        eachEdgeVertex(cage, refined, [&](auto edge, std::uint32_t t, std::uint32_t vertex) {
            const std::uint32_t point = refined.pointOf(vertex);
            EXPECT_EQ(points.try_emplace({edge.first, edge.second, t}, point).first->second, point);
            const glm::vec3 position = limit.positions[vertex];
            EXPECT_EQ(positions.try_emplace(point, position).first->second, position);
        });
        EXPECT_EQ(points.size(), edgesOf(cage).size() * 5);
    }
}

// The expected numbers of points: used vertices, points inside edges, and points inside faces.
TEST(Table, hasNoDuplicatePoints) {
    for (const Cage& cage : variedCages()) {
        for (const std::uint32_t level : {1u, 3u}) {
            SCOPED_TRACE(cage.name);
            const RefinedCage refined = refineWithPlugin(cage, level);
            const std::size_t segments = std::size_t{1} << level;
            const std::set<std::uint32_t> used(cage.faceVertices.begin(), cage.faceVertices.end());
            std::size_t points = used.size() + edgesOf(cage).size() * (segments - 1), polygons = 0;
            for (const std::uint32_t size : cage.faceSizes) {
                const std::size_t half = segments / 2 - 1;
                if (cage.scheme == SubdivisionScheme::loop) {
                    points += (segments - 1) * (segments - 2) / 2;
                    polygons += segments * segments;
                } else if (size == 4) {
                    points += (segments - 1) * (segments - 1);
                    polygons += segments * segments;
                } else {
                    points += 1 + size * (half + half * half);
                    polygons += size * segments * segments / 4;
                }
            }
            EXPECT_EQ(refined.pointCount, points);
            EXPECT_EQ(refined.cageFaces.size(), polygons);
            std::vector<bool> isUsed(refined.vertexCount(), false);
            for (const std::uint32_t vertex : refined.faceVertices) isUsed[vertex] = true;
            EXPECT_EQ(std::count(isUsed.begin(), isUsed.end(), false), 0);
        }
    }
}

TEST(Table, stencilsHaveNoZeroOrRepeatedControls) {
    for (const Cage& cage : variedCages()) {
        const RefinedCage refined = refineWithPlugin(cage, 2);
        for (const StencilTable* table : {&refined.positions, &refined.uvs}) {
            for (std::size_t stencil = 0; stencil < table->stencilCount(); ++stencil) {
                std::set<std::uint32_t> controls;
                double sum = 0.0, du = 0.0, dv = 0.0;
                for (std::uint32_t i = table->offsets[stencil]; i < table->offsets[stencil + 1]; ++i) {
                    EXPECT_TRUE(controls.insert(table->controlIndices[i]).second);
                    EXPECT_TRUE(table->weights[i] != 0.0f || table->duWeights[i] != 0.0f ||
                                table->dvWeights[i] != 0.0f);
                    sum += table->weights[i];
                    du += table->duWeights[i];
                    dv += table->dvWeights[i];
                }
                // Up to 40 weights, those of derivatives up to 4, each with a relative rounding error of
                // 6e-8.
                EXPECT_NEAR(sum, 1.0, 2e-6);
                EXPECT_NEAR(du, 0.0, 1e-5);
                EXPECT_NEAR(dv, 0.0, 1e-5);
            }
        }
    }
}

TEST(Table, normalsPointOutwards) {
    for (const Cage& original : {cube(), torus(12, 8)}) {
        for (const SubdivisionScheme scheme :
             {SubdivisionScheme::catmullClark, SubdivisionScheme::loop, SubdivisionScheme::bilinear}) {
            Cage cage = scheme == SubdivisionScheme::loop ? triangulated(original) : original;
            cage.scheme = scheme;
            const EvaluatedLimit limit = evaluateCage(refineWithPlugin(cage, 3), cage.positions);
            for (std::size_t i = 0; i < limit.normals.size(); ++i) {
                const glm::vec3 position = limit.positions[i];
                // The torus is a tube around a circle of radius 3.
                const glm::vec3 ring(position.x, 0.0f, position.z);
                const glm::vec3 inside =
                    original.name == "cube" ? glm::vec3(0.0f) : 3.0f * glm::normalize(ring);
                EXPECT_GT(glm::dot(limit.normals[i], position - inside), 0.0f) << cage.name;
            }
        }
    }
}

bool operator==(const StencilTable& a, const StencilTable& b) {
    return a.offsets == b.offsets && a.controlIndices == b.controlIndices && a.weights == b.weights &&
           a.duWeights == b.duWeights && a.dvWeights == b.dvWeights;
}

// The table depends on positions only where a normal is evaluated beside a degenerate point.
TEST(Table, doesNotDependOnPositions) {
    Random random(22);
    for (Cage cage : {cube(), torus(6, 5), pyramid(5), triangulated(torus(6, 5))}) {
        addUvsWithSeams(cage, random);
        addRandomSharpness(cage, random);
        cage.corners.clear();
        const RefinedCage before = refineWithPlugin(cage, 3);
        jitter(cage, 0.1f, random);
        const RefinedCage after = refineWithPlugin(cage, 3);
        EXPECT_EQ(before.faceVertices, after.faceVertices);
        EXPECT_EQ(before.seamPoints, after.seamPoints);
        EXPECT_EQ(before.uvs.weights, after.uvs.weights);
        EXPECT_EQ(before.positions.weights, after.positions.weights);
        EXPECT_TRUE(before.positions == after.positions) << cage.name;
    }
}

TEST(Table, isDeterministic) {
    Random random(23);
    Cage cage = torus(40, 30);
    addUvsWithSeams(cage, random);
    addRandomSharpness(cage, random);
    const RefinedCage first = refineWithPlugin(cage, 3), second = refineWithPlugin(cage, 3);
    EXPECT_TRUE(first.positions == second.positions);
    EXPECT_TRUE(first.uvs == second.uvs);
    EXPECT_EQ(first.faceVertices, second.faceVertices);
}

}  // namespace
}  // namespace candela
