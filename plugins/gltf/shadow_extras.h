#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <cstdint>
#include <map>

#include "../common/host.h"

namespace candela_plugins::gltf {

/// What the extras of nodes and of the lights of KHR_lights_punctual say of shadows, by the index of the node
/// or light (docs/shadows.md, "From glTF"). glTF has no other place for it.
struct ShadowExtras {
    std::map<std::size_t, bool> nodes;   ///< "castsShadow" of a node.
    std::map<std::size_t, bool> lights;  ///< "castsShadow" of a light.
    std::map<std::size_t, float> radii;  ///< "radius" of a light, metres, 0 or more.
};

/// `casts_no_shadow` of the ABI structs, of an element by its flags.
std::uint32_t castsNoShadow(const std::map<std::size_t, bool>& flags, std::size_t index);

/// `document` need not be well-formed elsewhere. A wrong value is left out, with a note that names element
/// and key.
ShadowExtras readShadowExtras(const nlohmann::json& document, const Host& host);

}  // namespace candela_plugins::gltf
