#include "plugin_refinement.h"

#include <candela/plugin_registry.h>

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace candela {
namespace {

using Cell = std::pair<std::uint32_t, std::uint32_t>;

/// The grid positions of the corners of each polygon of a patch.
std::vector<std::vector<Cell>> quadCells(std::uint32_t segments) {
    std::vector<std::vector<Cell>> cells;
    for (std::uint32_t j = 0; j < segments; ++j) {
        for (std::uint32_t i = 0; i < segments; ++i) {
            cells.push_back({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        }
    }
    return cells;
}

std::vector<std::vector<Cell>> triangleCells(std::uint32_t segments) {
    std::vector<std::vector<Cell>> cells;
    for (std::uint32_t j = 0; j < segments; ++j) {
        for (std::uint32_t i = 0; i + j < segments; ++i) {
            cells.push_back({{i, j}, {i + 1, j}, {i, j + 1}});
            if (i + j + 1 < segments) cells.push_back({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}});
        }
    }
    return cells;
}

}  // namespace

RefinedCage refineWithPlugin(const Cage& cage, std::uint32_t level) {
    static const PluginRegistry registry({CANDELA_TEST_PLUGINS});
    return registry.subdivider().value().refine(cage, level);
}

std::vector<GridVertex> gridVertices(const Cage& cage, const RefinedCage& refined) {
    const std::uint32_t segments = std::uint32_t{1} << refined.level;
    std::vector<GridVertex> vertices;
    std::size_t polygon = 0;
    while (polygon < refined.cageFaces.size()) {
        const std::uint32_t face = refined.cageFaces[polygon];
        const bool hasSubfaces = refined.faceSize == 4 && cage.faceSizes[face] != 4;
        const std::uint32_t patchSegments = hasSubfaces ? segments / 2 : segments;
        const auto cells = refined.faceSize == 4 ? quadCells(patchSegments) : triangleCells(patchSegments);
        const double step = 1.0 / patchSegments;
        for (std::uint32_t patch = 0; patch < (hasSubfaces ? cage.faceSizes[face] : 1); ++patch) {
            std::map<Cell, std::uint32_t> grid;
            for (const auto& cell : cells) {
                EXPECT_EQ(refined.cageFaces[polygon], face);
                for (std::size_t corner = 0; corner < cell.size(); ++corner) {
                    const std::uint32_t vertex = refined.faceVertices[polygon * refined.faceSize + corner];
                    const auto [place, isNew] = grid.emplace(cell[corner], vertex);
                    EXPECT_EQ(place->second, vertex);
                }
                ++polygon;
            }
            for (const auto& [cell, vertex] : grid) {
                vertices.push_back({vertex, face, patch, cell.first * step, cell.second * step});
            }
        }
    }
    return vertices;
}

EvaluatedLimit evaluateCage(const RefinedCage& refined, const std::vector<glm::vec3>& points) {
    EvaluatedLimit limit;
    for (auto* array : {&limit.positions, &limit.normals, &limit.du, &limit.dv}) {
        array->resize(refined.vertexCount());
    }
    evaluateLimit(refined, points, {limit.positions, limit.normals, limit.du, limit.dv});
    return limit;
}

}  // namespace candela
