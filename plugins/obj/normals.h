#pragma once

#include "document.h"

namespace candela_plugins::obj {

/// The unit normal of a face by Newell's method, which suits concave and non-planar faces too; (0, 0, 0)
/// where the face has no area.
Vec3 faceNormal(const Document& document, std::size_t face);

/// Turns the faces whose corners run clockwise as seen from the side of the normals that the file gives them:
/// that side is their front. Faces without normals stay as they are.
void turnFacesToNormals(Document& document);

/// Gives the corners of faces in smoothing groups that name no normals one: the mean over the faces of the
/// group at the vertex, weighted by their angles there (Thürmer and Wüthrich, "Computing Vertex Normals from
/// Polygonal Facets", 1998). Corners of flat faces keep none.
void addSmoothNormals(Document& document);

}  // namespace candela_plugins::obj
