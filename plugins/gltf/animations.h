#pragma once

#include <vector>

#include "cages.h"
#include "document.h"
#include "host.h"

namespace candela_gltf {

/// Pushes the animations of drawn nodes' translation, rotation and scale, and of the morph weights of nodes
/// that show a cage. Notes morph weights of other nodes, which are not applied. `nodes` are the host's
/// indices of the file's nodes.
void pushAnimations(const Document& document, const std::vector<std::int32_t>& nodes,
                    const PushedCages& cages, const Host& host);

}  // namespace candela_gltf
