#pragma once

#include <vector>

#include "document.h"
#include "hierarchy.h"
#include "host.h"

namespace candela_gltf {

/// Pushes a light for each drawn node that refers to one (KHR_lights_punctual). `nodes` are the host's
/// indices of the file's nodes.
void pushLights(const Document& document, const std::vector<DrawnNode>& drawn,
                const std::vector<std::int32_t>& nodes, const Host& host);

}  // namespace candela_gltf
