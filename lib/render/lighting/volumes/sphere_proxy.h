#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// A convex polyhedron of triangles that holds the unit sphere: the shape that light volumes are rasterised
/// as.
struct SphereProxy {
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise from outside.
    float radius = 1.0f;                                  ///< Of the sphere that holds the polyhedron.
};

/// The icosahedron: 12 vertices, 20 triangles. Software rasterisers pay more for a triangle than for the
/// pixels that a rounder proxy would save.
SphereProxy makeSphereProxy();

}  // namespace candela
