#pragma once

#include <vector>

#include "document.h"
#include "hierarchy.h"
#include "host.h"
#include "meshes.h"

namespace candela_gltf {

/// Pushes the drawn nodes, and a child for each further part of a node's mesh. Returns the host's index of
/// each node of the file, -1 for those that are not drawn.
std::vector<std::int32_t> pushNodes(const Document& document, const std::vector<DrawnNode>& drawn,
                                    const MeshParts& meshes, const Host& host);

}  // namespace candela_gltf
