#pragma once

#include <candela/mesh.h>

#include <cstdint>

namespace candela {

/// Generates `Mesh::tangents` from set `uvSet` of texture coordinates as MikkTSpace does, which
/// glTF 2.0 requires where a file has none. Bitangents are cross(normal, tangent) × w and point against
/// increasing v: v increases down the image, and a normal map's +Y is up.
///
/// The rules are those of MikkTSpace (after Mikkelsen, "Simulation of wrinkled surfaces revisited", 2008, and
/// the behaviour of his reference implementation):
///  - Tangents are generated per triangle corner. Vertices of equal position, normal and texture coordinate
///  count
///    as one, however the mesh is indexed.
///  - Corners at such a vertex share a tangent when a chain of triangles around it joins them, each sharing
///    an edge with the next, in opposite direction, and all having the same orientation of texture
///    coordinates: mirrored halves split.
///  - A corner adds its triangle's direction of increasing u, projected into the plane of the vertex normal
///  and
///    brought to unit length, weighted by the corner's angle in that plane.
///  - A triangle whose texture coordinates span no area (at most 2^-126) does not contribute, but connects
///    its neighbors. It has the handedness of the first group, by order of corners, that reaches it.
///  - A triangle of which two positions coincide neither contributes nor connects. Its corners have the
///    tangent of another triangle at the same vertex.
/// Where these rules give no tangent, it is that of the first group at the same vertex, else any
/// perpendicular to the normal with w = 1 (the reference implementation has an axis or zero there). Its
/// angular threshold, which by default never splits, is not implemented, and quads are not treated specially.
///
/// A vertex whose corners need different tangents is split: the first keeps its place, others are appended.
/// Throws `Error`: badInput when an index is out of range or an array does not have one element per vertex;
/// limit when splitting leaves more vertices than 32 bits count. Takes O(n log n), in parallel; the result
/// does not depend on the number of threads.
void generateTangents(Mesh& mesh, std::uint32_t uvSet);

}  // namespace candela
