#pragma once

#include <vector>

#include "../common/host.h"
#include "cages.h"
#include "document.h"

namespace candela_plugins::gltf {

/// Adds the animations of drawn nodes' translation, rotation and scale, and of the morph weights of nodes
/// that show a cage. Notes morph weights of other nodes, which are not applied. `nodes` are the host's
/// indices of the file's nodes.
void addAnimations(const Document& document, const std::vector<std::int32_t>& nodes, const AddedCages& cages,
                   const Host& host);

}  // namespace candela_plugins::gltf
