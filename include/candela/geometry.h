#pragma once

#include <candela/export.h>
#include <candela/mesh.h>

#include <cstdint>

namespace candela {

/// Replaces the normals of a mesh of triangles. At each corner the normals of those triangles are averaged
/// that meet there and that a chain of edges joins to it, across which surfaces meet at less than
/// `creaseAngle`: radians, 0 to pi. 0 gives flat normals, pi smooth ones everywhere. A triangle counts with
/// its angle at the corner (G. Thürmer, C. Wüthrich: "Computing vertex normals from polygonal facets",
/// Journal of Graphics Tools 3(1), 1998). Vertices of equal position count as one, however the mesh is
/// indexed; across an edge that more than two triangles share, those of opposite direction are joined. A
/// vertex whose corners need different normals is split: the first keeps its place, others are appended.
/// Tangents are removed, as they belong to the old normals; morph targets get the offsets that lead to the
/// normals of their own shapes. The corners of a triangle without an area have the normal of another one that
/// meets there, or +Y. Lines and points keep the normals that they have.
///
/// Throws `Error`: badInput when the angle is out of its range, an index is out of range, a position is not
/// finite, or an array has neither no element nor one per vertex; limit when splitting leaves more vertices
/// than 32 bits count. Takes O(n log n).
CANDELA_API void computeNormals(Mesh& mesh, float creaseAngle);

/// Replaces the tangents of a mesh that has normals and the set `uvSet` of texture coordinates by those of
/// MikkTSpace, as normal textures and anisotropy need them. A vertex whose corners need different tangents is
/// split: the first keeps its place, others are appended. Throws `Error`: badInput when the mesh has no
/// normals or no such set, an index is out of range or an array does not have one element per vertex; limit
/// when splitting leaves more vertices than 32 bits count.
CANDELA_API void computeTangents(Mesh& mesh, std::uint32_t uvSet = 0);

}  // namespace candela
