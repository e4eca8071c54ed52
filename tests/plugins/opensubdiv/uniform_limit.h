#pragma once

#include <candela/cage.h>

#include <vector>

namespace candela {

/// The limit at the vertices of a cage by uniform refinement and Far's limit masks: the definition of the
/// surface, without any patches.
struct UniformLimit {
    std::vector<glm::dvec3> positions, normals;  ///< Of each vertex; normals of any length and sign.
    std::vector<glm::dvec3> uvs;                 ///< Of each corner of a face.
};
UniformLimit uniformLimit(const Cage& cage);

}  // namespace candela
