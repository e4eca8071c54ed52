#pragma once

#include <candela/mesh.h>

#include <cstddef>

namespace candela {

/// Brings the normals of a mesh to unit length. One without length becomes the normal of a face that uses the
/// vertex (`replaceZeroNormals`). Returns how many those were. The numbers of the mesh are finite and its
/// indices in range.
std::size_t repairNormals(Mesh& mesh);

/// Brings the directions of tangents to unit length and their signs to -1 or 1 (0 counts as 1). One without
/// length becomes a direction perpendicular to the normal. Returns how many those were. Normals are of unit
/// length.
std::size_t repairTangents(Mesh& mesh);

}  // namespace candela
