#pragma once

#include <vector>

#include "document.h"
#include "hierarchy.h"
#include "host.h"

namespace candela_gltf {

/// Pushes a camera for each drawn node that refers to a perspective camera, and notes the orthographic ones.
/// `nodes` are the host's indices of the file's nodes.
void pushCameras(const Document& document, const std::vector<DrawnNode>& drawn,
                 const std::vector<std::int32_t>& nodes, const Host& host);

}  // namespace candela_gltf
