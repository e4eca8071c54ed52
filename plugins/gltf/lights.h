#pragma once

#include <map>
#include <vector>

#include "nodes.h"

namespace candela_plugins::gltf {

/// A light as it was added, but for its name.
struct AddedLight {
    std::int32_t index = -1;  ///< The host's.
    candela_light source;
};

/// By light of the file.
using AddedLights = std::multimap<std::size_t, AddedLight>;

/// Adds a light for each drawn node that refers to one (KHR_lights_punctual), and notes broken ones. `nodes`
/// are the host's indices of the file's nodes.
AddedLights addLights(const Document& document, const std::vector<DrawnNode>& drawn,
                      const std::vector<std::int32_t>& nodes, const Host& host);

}  // namespace candela_plugins::gltf
