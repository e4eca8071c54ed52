#include "generated_cages.h"
#include "refining.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace candela {
namespace {

/// Where an edge of a refined face lies, if on an edge of the cage: the edge's ends and the part of it.
using EdgePart = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

std::vector<Cage> variedCages() {
    Random random(21);
    std::vector<Cage> cages{cube(),  torus(5, 4), pyramid(5),        sheet(3, 4),
                            star(3), star(7),     strangePolygons(), book()};
    for (std::size_t i = 0, count = cages.size(); i < count; ++i) cages.push_back(triangulated(cages[i]));
    for (std::size_t i = 0; i < 8; ++i) {
        cages.push_back(cages[i]);
        cages.back().scheme = SubdivisionScheme::bilinear;
    }
    for (Cage& cage : cages) {
        cage.name += ", scheme " + std::to_string(static_cast<int>(cage.scheme));
        shake(cage, 0.15f, random);
        giveTornUvs(cage, random);
        sharpenSome(cage, random);
    }
    return cages;
}

/// Calls `visit(edge, t, vertex)` for the vertices of all faces on edges of the cage; t counts from the
/// smaller end.
template <typename Visit>
void eachEdgeVertex(const Cage& cage, const RefinedCage& refined, Visit visit) {
    const double segments = static_cast<double>(1u << refined.level);
    std::vector<std::size_t> starts{0};
    for (const std::uint32_t size : cage.faceSizes) starts.push_back(starts.back() + size);
    for (const GridVertex& at : gridVertices(cage, refined)) {
        const std::uint32_t size = cage.faceSizes[at.face];
        const bool hasSubfaces = refined.faceSize == 4 && size != 4;
        const auto onEdge = [&](std::uint32_t edge, double part) {
            const std::uint32_t from = cage.faceVertices[starts[at.face] + edge % size];
            const std::uint32_t to = cage.faceVertices[starts[at.face] + (edge + 1) % size];
            const double along = from < to ? part : 1.0 - part;
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
        const EvaluatedLimit limit = evaluated(refined, cage.positions);
        std::map<EdgePart, std::uint32_t> points;
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

// The numbers of points, counted another way: each vertex in use, each edge, and the insides of the faces.
TEST(Table, hasOnePointAPlace) {
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
            std::vector<bool> named(refined.vertexCount(), false);
            for (const std::uint32_t vertex : refined.faceVertices) named[vertex] = true;
            EXPECT_EQ(std::count(named.begin(), named.end(), false), 0);
        }
    }
}

TEST(Table, rowsHaveNoIdleOrRepeatedColumns) {
    for (const Cage& cage : variedCages()) {
        const RefinedCage refined = refineWithPlugin(cage, 2);
        for (const StencilTable* rows : {&refined.positions, &refined.uvs}) {
            for (std::size_t row = 0; row < rows->rowCount(); ++row) {
                std::set<std::uint32_t> columns;
                double sum = 0.0, du = 0.0, dv = 0.0;
                for (std::uint32_t i = rows->rowStarts[row]; i < rows->rowStarts[row + 1]; ++i) {
                    EXPECT_TRUE(columns.insert(rows->columns[i]).second);
                    EXPECT_TRUE(rows->weights[i] != 0.0f || rows->duWeights[i] != 0.0f ||
                                rows->dvWeights[i] != 0.0f);
                    sum += rows->weights[i];
                    du += rows->duWeights[i];
                    dv += rows->dvWeights[i];
                }
                // Up to 40 weights, those of derivatives up to 4, each rounded by 6e-8 of it.
                EXPECT_NEAR(sum, 1.0, 2e-6);
                EXPECT_NEAR(du, 0.0, 1e-5);
                EXPECT_NEAR(dv, 0.0, 1e-5);
            }
        }
    }
}

TEST(Table, normalsPointOutwards) {
    for (const Cage& plain : {cube(), torus(12, 8)}) {
        for (const SubdivisionScheme scheme :
             {SubdivisionScheme::catmullClark, SubdivisionScheme::loop, SubdivisionScheme::bilinear}) {
            Cage cage = scheme == SubdivisionScheme::loop ? triangulated(plain) : plain;
            cage.scheme = scheme;
            const EvaluatedLimit limit = evaluated(refineWithPlugin(cage, 3), cage.positions);
            for (std::size_t i = 0; i < limit.normals.size(); ++i) {
                const glm::vec3 position = limit.positions[i];
                // The torus is a tube around a circle of radius 3.
                const glm::vec3 ring(position.x, 0.0f, position.z);
                const glm::vec3 inside = plain.name == "cube" ? glm::vec3(0.0f) : 3.0f * glm::normalize(ring);
                EXPECT_GT(glm::dot(limit.normals[i], position - inside), 0.0f) << cage.name;
            }
        }
    }
}

bool operator==(const StencilTable& a, const StencilTable& b) {
    return a.rowStarts == b.rowStarts && a.columns == b.columns && a.weights == b.weights &&
           a.duWeights == b.duWeights && a.dvWeights == b.dvWeights;
}

// Only the topology counts, where no normal has to be looked for beside its place.
TEST(Table, isTheSameForAMovedCage) {
    Random random(22);
    for (Cage cage : {cube(), torus(6, 5), pyramid(5), triangulated(torus(6, 5))}) {
        giveTornUvs(cage, random);
        sharpenSome(cage, random);
        cage.corners.clear();
        const RefinedCage before = refineWithPlugin(cage, 3);
        shake(cage, 0.1f, random);
        const RefinedCage after = refineWithPlugin(cage, 3);
        EXPECT_EQ(before.faceVertices, after.faceVertices);
        EXPECT_EQ(before.seamPoints, after.seamPoints);
        EXPECT_EQ(before.uvs.weights, after.uvs.weights);
        EXPECT_EQ(before.positions.weights, after.positions.weights);
        EXPECT_TRUE(before.positions == after.positions) << cage.name;
    }
}

TEST(Table, isTheSameEachTime) {
    Random random(23);
    Cage cage = torus(40, 30);
    giveTornUvs(cage, random);
    sharpenSome(cage, random);
    const RefinedCage first = refineWithPlugin(cage, 3), second = refineWithPlugin(cage, 3);
    EXPECT_TRUE(first.positions == second.positions);
    EXPECT_TRUE(first.uvs == second.uvs);
    EXPECT_EQ(first.faceVertices, second.faceVertices);
}

}  // namespace
}  // namespace candela
