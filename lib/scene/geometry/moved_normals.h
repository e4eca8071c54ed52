#pragma once

#include <candela/mesh.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// The normals of a mesh whose vertices move. A triangle counts with its angle at the vertex, as
/// `computeNormals` has it.
class MovedNormals {
  public:
    enum class Vertices {
        separate,  ///< Each has the normal of the triangles that use it.
        welded,    ///< Those of the same position and the same normal at rest have one normal.
    };
    /// `rest` has passed `validate`, and is not kept.
    MovedNormals(const Mesh& rest, Vertices vertices);

    /// The normal of each vertex at `positions`, one per vertex: finite numbers of at most 1e9. Vertices of
    /// no triangle with an area keep their normal at rest.
    std::vector<glm::vec3> at(std::span<const glm::vec3> positions) const;

  private:
    std::vector<glm::vec3> restNormals_;
    std::vector<std::uint32_t> corners_;  ///< Vertices, three a triangle.
    std::vector<std::uint32_t> groups_;   ///< For each vertex the first one that it is welded to.
};

}  // namespace candela
