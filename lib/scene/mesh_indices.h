#pragma once

#include "scene/element.h"

#include <candela/mesh.h>

namespace candela {

/// Throws `Error` (badInput) unless the indices are whole triangles and name vertices of the mesh, at most
/// 2^32 - 1 of each.
void requireIndices(const Mesh& mesh, const Element& element);

}  // namespace candela
