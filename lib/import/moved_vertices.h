#pragma once

#include "scene/geometry/moved_normals.h"

#include <candela/cage.h>
#include <candela/mesh.h>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Numbers the vertices of a mesh in a set of texture coordinates behind its own: copies of vertices, which
/// normals and tangents of their own split off, keep the number of their vertex. To be called before these
/// are made.
void numberVertices(Mesh& mesh);

/// A mesh that a frame callback may move, as the plugin added it.
struct AddedMovedMesh {
    std::uint32_t mesh = 0;
    std::uint32_t vertices = 0;  ///< As the plugin counts them.
    MovedNormals::Vertices normals = MovedNormals::Vertices::welded;
};

/// The same once it has all attributes.
class MovedMesh {
  public:
    /// Takes the numbers of `numberVertices` out of `mesh`. What is needed of the mesh is copied.
    MovedMesh(const AddedMovedMesh& added, Mesh& mesh);

    std::uint32_t mesh() const { return added_.mesh; }
    std::uint32_t vertices() const { return added_.vertices; }
    const std::vector<glm::vec3>& restPositions() const { return positions_; }
    const std::vector<glm::vec3>& restNormals() const { return normals_; }

    /// One value for each vertex of the mesh, of one for each that the plugin counts.
    std::vector<glm::vec3> spread(const std::vector<glm::vec3>& values) const;
    /// The normals where the vertices of the mesh are at `positions`.
    std::vector<glm::vec3> normalsAt(std::span<const glm::vec3> positions) const {
        return computed_.at(positions);
    }

  private:
    AddedMovedMesh added_;
    std::vector<std::uint32_t> sources_;  ///< Of each vertex the plugin's.
    std::vector<glm::vec3> positions_, normals_;
    MovedNormals computed_;
};

/// A cage that a frame callback may move.
struct MovedCage {
    std::uint32_t cage = 0;
    std::vector<glm::vec3> restPositions;
};

}  // namespace candela
