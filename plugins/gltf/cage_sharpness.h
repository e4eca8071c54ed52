#pragma once

#include "cage_settings.h"
#include "joined_cage.h"

namespace candela_gltf {

/// Creases, sharp vertices and holes in the numbers of a cage.
struct CageSharpness {
    std::vector<std::uint32_t> creaseEdges;  ///< 2 vertices a crease.
    std::vector<float> creaseSharpness;
    std::vector<std::uint32_t> cornerVertices;
    std::vector<float> cornerSharpness;
    std::vector<std::uint32_t> holes;
};

/// Translates what `settings` say in the numbers of the file. Holes among the faces that were left out are
/// dropped. Throws `Failure` for `element` when a vertex, an edge or a face does not exist, and when one edge
/// or vertex gets two values.
CageSharpness resolveSharpness(const CageSettings& settings, const CageSource& source, const JoinedCage& cage,
                               const std::string& element);

}  // namespace candela_gltf
