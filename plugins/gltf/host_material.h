#pragma once

#include <candela/plugin.h>

#include <array>
#include <cstdint>
#include <optional>

#include "../common/host.h"
#include "texture_uses.h"

namespace candela_plugins::gltf {

/// A use of no image.
candela_texture noTexture();

/// A material for the host, and the lobes that it points to when it is added.
struct HostMaterial {
    /// White, metallic and rough, without textures (glTF 2.0, 3.9.1 and 5.19).
    HostMaterial();

    /// Sets the host's set of texture coordinates of all textures.
    void setUvSet(std::uint32_t set);

    /// Returns the host's index.
    std::int32_t add(const Host& host) const;

    candela_material base;  ///< Its pointers are not read.
    float emissionStrength = 1.0f;
    // Their pointers to textures are not read.
    std::optional<candela_specular> specular;
    std::optional<candela_clearcoat> clearcoat;
    std::optional<candela_sheen> sheen;
    std::optional<candela_anisotropy> anisotropy;
    std::optional<candela_iridescence> iridescence;
    std::optional<candela_transmission> transmission;
    std::optional<candela_volume> volume;
    std::optional<candela_diffuse_transmission> diffuseTransmission;
    std::array<candela_texture, lobeTextureCount> textures;
};

/// Reads the extensions of `source` that give it lobes and media, but for their textures. `element` is named
/// in notes.
void readLobes(const tinygltf::Material& source, const std::string& element, const Host& host,
               HostMaterial& material);

}  // namespace candela_plugins::gltf
