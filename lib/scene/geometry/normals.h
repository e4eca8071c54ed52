#pragma once

#include <candela/mesh.h>

#include <cstdint>

namespace candela {

/// Gives each triangle separate vertices with the triangle's geometric normal; a triangle without area gets
/// +Y. Other arrays are copied to the new vertices, but tangents are removed: they belong to the old normals
/// (glTF 2.0, 3.7.2.1). Morph targets get the offsets that lead to the flat normals of their own shapes.
/// Submeshes stay as they are. Lines and points get no normals: (0, 0, 0). Throws `Error` (badInput) when an
/// index is out of range or an array has neither no element nor one per vertex; the old normals are not read.
void generateFlatNormals(Mesh& mesh);

/// Gives vertices whose normal has no length (below 1e-12) or is not finite the geometric normal of the first
/// triangle with an area that uses them, and +Y where there is none. Returns how many it replaced. Throws
/// `Error` (badInput) when an index is out of range or there is not one normal per vertex.
std::uint32_t replaceZeroNormals(Mesh& mesh);

}  // namespace candela
