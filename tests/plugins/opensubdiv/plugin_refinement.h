#pragma once

#include <candela/cage.h>
#include <candela/refined_cage.h>

#include <cstdint>
#include <vector>

namespace candela {

/// Refines a cage with the plugin, through the library, which validates the result.
RefinedCage refineWithPlugin(const Cage& cage, std::uint32_t level);

/// Where a vertex of a refined cage lies on a face of the cage.
struct GridVertex {
    std::uint32_t vertex;
    std::uint32_t face;
    std::uint32_t patch;  ///< The sub-face of a face of other than 4 corners; else 0.
    double s, t;          ///< Parameters of the patch, 0 to 1: where Far's ptex face has them.
};

/// All vertices of all faces, in the order of the faces and their patches; a shared vertex is listed once per
/// face and patch. The location of a polygon follows from its index, since the plugin writes the polygons of
/// a patch row by row. Expects adjacent polygons of a patch to have the same vertices.
std::vector<GridVertex> gridVertices(const Cage& cage, const RefinedCage& refined);

/// The evaluated positions, normals and derivatives of a refined cage.
struct EvaluatedLimit {
    std::vector<glm::vec3> positions, normals, du, dv;
};
EvaluatedLimit evaluateCage(const RefinedCage& refined, const std::vector<glm::vec3>& points);

}  // namespace candela
