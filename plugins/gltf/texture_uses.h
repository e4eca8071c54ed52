#pragma once

#include <array>
#include <optional>
#include <vector>

#include "document.h"

namespace candela_plugins::gltf {

/// A texture of a material of the file.
struct TextureUse {
    const char* name = "";  ///< The member that holds it, for messages: "baseColorTexture".
    int texture = -1;       ///< -1: the material has none.
    int set = 0;            ///< Its texture coordinates: n of TEXCOORD_n.
    const tinygltf::Value* transform = nullptr;  ///< KHR_texture_transform.
};

/// The textures of lobes and media, in the order of `lobeTextureMembers`.
enum LobeTexture : std::size_t {
    specularTexture,
    specularColorTexture,
    clearcoatTexture,
    clearcoatRoughnessTexture,
    clearcoatNormalTexture,
    sheenColorTexture,
    sheenRoughnessTexture,
    anisotropyTexture,
    iridescenceTexture,
    iridescenceThicknessTexture,
    transmissionTexture,
    thicknessTexture,
    diffuseTransmissionTexture,
    diffuseTransmissionColorTexture,
    lobeTextureCount
};

/// The textures of a material. Where it has specular-glossiness values, base colour is their diffuse texture,
/// and `specularGlossiness` takes the place of `metallicRoughness`.
struct TextureUses {
    TextureUse baseColor, metallicRoughness, specularGlossiness, normal, emissive, occlusion;
    std::array<TextureUse, lobeTextureCount> lobes;

    /// All of them, those that matter most first.
    std::vector<TextureUse> all() const;
};

TextureUses textureUses(const tinygltf::Material& material);

/// An extension of a material; null where it has none of that name.
const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const char* name);

/// The number of a member of an extension; `fallback` where it has none.
float numberOr(const tinygltf::Value& object, const char* name, float fallback);

/// The numbers of an array member of an extension; unchanged where it has none.
template <std::size_t count>
void readNumbers(const tinygltf::Value& object, const char* name, float (&numbers)[count]) {
    if (!object.Has(name)) return;
    const tinygltf::Value& source = object.Get(name);
    for (std::size_t i = 0; i < count; ++i)
        numbers[i] = static_cast<float>(source.Get(static_cast<int>(i)).GetNumberAsDouble());
}

}  // namespace candela_plugins::gltf
