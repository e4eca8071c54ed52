#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace candela {

/// Moves every vertex of a mesh or a cage by its weight times the offsets (glTF 2.0, 3.7.2.2).
struct MorphTarget {
    std::vector<glm::vec3> offsets = {};  ///< Of the positions, metres, one per vertex.
    /// Of a mesh's normals and tangents, one per vertex; empty: all 0. A cage has none.
    std::vector<glm::vec3> normalOffsets = {}, tangentOffsets = {};
};

/// The joints that move meshes and cages (glTF 2.0, 3.7.3.3).
struct Skin {
    std::string name = {};
    std::vector<std::uint32_t> joints = {};           ///< Indices into `Scene::nodes`, one or more.
    std::vector<glm::mat4> inverseBindMatrices = {};  ///< Affine, one per joint.
};

}  // namespace candela
