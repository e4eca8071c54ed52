#pragma once

#include <limits>

#include "cage_source.h"

namespace candela_plugins::gltf {

/// The index of a vertex or face of the file that is not in the cage.
inline constexpr std::uint32_t notInCage = std::numeric_limits<std::uint32_t>::max();

/// The topology of a cage. Vertices that the file splits along seams are joined again, and there is a seam
/// only where texture coordinates differ.
struct JoinedCage {
    std::vector<std::uint32_t>
        vertices;  ///< For each vertex of the cage one of the vertices it was split into.
    std::vector<std::uint32_t> cageVertices;  ///< A vertex of `CageVertices`: that of the cage, or notInCage.
    std::vector<std::uint32_t> cageFaces;     ///< A face of `CageSource`: that of the cage, or notInCage.
    std::vector<std::uint32_t> faceSizes, faceVertices;
    std::vector<std::int32_t> faceMaterials;
    std::vector<float> uvs;              ///< 2 each; empty for none.
    std::vector<std::uint32_t> faceUvs;  ///< A corner; empty for none.
};

/// Joins the vertices of equal position, joints, joint weights and morph offsets. Faces that then have a
/// vertex twice are left out, and so are the vertices of no face.
JoinedCage joinCage(const CageSource& source);

}  // namespace candela_plugins::gltf
