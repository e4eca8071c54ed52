#pragma once

#include <vector>

#include "document.h"
#include "host.h"

namespace candela_gltf {

/// Pushes the animations of drawn nodes' translation, rotation and scale, and notes morph weights, which are
/// not applied. `nodes` are the host's indices of the file's nodes.
void pushAnimations(const Document& document, const std::vector<std::int32_t>& nodes, const Host& host);

}  // namespace candela_gltf
