#pragma once

#include <limits>

#include "cage_source.h"

namespace candela_gltf {

/// Stands for a vertex or a face of the file that is not in the cage.
inline constexpr std::uint32_t notInCage = std::numeric_limits<std::uint32_t>::max();

/// The topology of a cage: the vertices that the file had to split along seams are one again, and what shows
/// no seam in the texture coordinates has no seam there.
struct JoinedCage {
    std::vector<std::uint32_t> vertices;  ///< A vertex of the cage: one of the vertices it was split into.
    std::vector<std::uint32_t> cageVertices;  ///< A vertex of `CageVertices`: that of the cage, or notInCage.
    std::vector<std::uint32_t> cageFaces;     ///< A face of `CageSource`: that of the cage, or notInCage.
    std::vector<std::uint32_t> faceSizes, faceVertices;
    std::vector<std::int32_t> faceMaterials;
    std::vector<float> uvs;              ///< 2 each; empty for none.
    std::vector<std::uint32_t> faceUvs;  ///< A corner; empty for none.
};

/// Joins the vertices that have the same position, joints, joint weights and morph offsets. Faces that then
/// pass twice through a vertex are left out, and so are the vertices of no face.
JoinedCage joinCage(const CageSource& source);

}  // namespace candela_gltf
