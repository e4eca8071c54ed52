#pragma once

#include "scene/validate/error_context.h"

#include <candela/mesh.h>

namespace candela {

/// Throws `Error` (badInput) unless the indices are whole triangles and name vertices of the mesh, at most
/// 2^32 - 1 of each.
void requireIndices(const Mesh& mesh, const ErrorContext& element);

}  // namespace candela
