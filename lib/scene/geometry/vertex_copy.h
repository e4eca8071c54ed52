#pragma once

#include <candela/mesh.h>

#include <cstdint>

namespace candela {

/// Appends a copy of a vertex, with all that the mesh has of it, and returns its index. Throws `Error`
/// (limit) when the mesh has more vertices than 32 bits count then.
std::uint32_t appendVertexCopy(Mesh& mesh, std::uint32_t vertex);

}  // namespace candela
