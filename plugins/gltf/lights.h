#pragma once

#include <vector>

#include "nodes.h"

namespace candela_plugins::gltf {

/// Adds a light for each drawn node that refers to one (KHR_lights_punctual), and notes broken ones. `nodes`
/// are the host's indices of the file's nodes.
void addLights(const Document& document, const std::vector<DrawnNode>& drawn,
               const std::vector<std::int32_t>& nodes, const Host& host);

}  // namespace candela_plugins::gltf
