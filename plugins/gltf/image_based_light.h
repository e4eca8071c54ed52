#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "../common/host.h"

namespace candela_plugins::gltf {

struct Document;

/// A light of EXT_lights_image_based, of which the sharpest cube map is read: rougher ones and irradiance
/// follow from it.
struct ImageBasedLight {
    std::string element;  ///< As messages name it.
    std::string name;
    std::array<std::size_t, 6> faces{};         ///< Images: +X, -X, +Y, -Y, +Z, -Z.
    std::array<float, 4> rotation{0, 0, 0, 1};  ///< Unit quaternion x, y, z, w.
    float intensity = 1.0f;                     ///< 0 or more.
};

/// The light of the scene that is drawn. `document` need not be well-formed elsewhere. Notes what is repaired
/// or left out.
std::optional<ImageBasedLight> readImageBasedLight(const nlohmann::json& document, const Host& host);

/// Adds the light as an equirectangular picture. Notes a light that is left out. `storage` takes decoded data
/// URIs, as in buffers.h.
void addEnvironment(const Document& document, std::deque<std::vector<std::uint8_t>>& storage,
                    const Host& host);

}  // namespace candela_plugins::gltf
