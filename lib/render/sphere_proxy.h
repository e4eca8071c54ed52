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

/// The icosahedron with each face divided in four: 42 vertices, 80 triangles.
SphereProxy makeSphereProxy();

}  // namespace candela
