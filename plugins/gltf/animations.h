#pragma once

#include <vector>

#include "../common/host.h"
#include "document.h"
#include "mesh_deformations.h"

namespace candela_plugins::gltf {

/// Adds the animations of drawn nodes' translation, rotation and scale, and of morph weights. Channels that
/// cannot be read are left out with a note. `nodes` are the host's indices of the file's nodes.
void addAnimations(const Document& document, const std::vector<std::int32_t>& nodes,
                   const MorphedNodes& morphed, const Host& host);

}  // namespace candela_plugins::gltf
