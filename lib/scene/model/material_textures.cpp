#include "scene/model/material_textures.h"

#include <array>

namespace candela {

namespace {

using Reference = const std::optional<Texture>&;

template <std::optional<Texture> Material::*member>
Reference ofMaterial(const Material& material) {
    return material.*member;
}

/// A texture of a lobe or medium of the material.
template <auto lobe, auto member>
Reference ofLobe(const Material& material) {
    return material.*lobe.*member;
}

constexpr TextureContent color = TextureContent::color, data = TextureContent::data;

constexpr std::array textures{
    MaterialTexture{"base colour", color, ofMaterial<&Material::baseColorTexture>},
    MaterialTexture{"metallic-roughness", data, ofMaterial<&Material::metallicRoughnessTexture>},
    MaterialTexture{"normal", data, ofMaterial<&Material::normalTexture>},
    MaterialTexture{"emission", color, ofMaterial<&Material::emissionTexture>},
    MaterialTexture{"occlusion", data, ofMaterial<&Material::occlusionTexture>},
    MaterialTexture{"specular", data, ofLobe<&Material::specular, &Specular::texture>},
    MaterialTexture{"specular colour", color, ofLobe<&Material::specular, &Specular::colorTexture>},
    MaterialTexture{"clearcoat", data, ofLobe<&Material::clearcoat, &Clearcoat::texture>},
    MaterialTexture{"clearcoat roughness", data, ofLobe<&Material::clearcoat, &Clearcoat::roughnessTexture>},
    MaterialTexture{"clearcoat normal", data, ofLobe<&Material::clearcoat, &Clearcoat::normalTexture>},
    MaterialTexture{"sheen colour", color, ofLobe<&Material::sheen, &Sheen::colorTexture>},
    MaterialTexture{"sheen roughness", data, ofLobe<&Material::sheen, &Sheen::roughnessTexture>},
    MaterialTexture{"anisotropy", data, ofLobe<&Material::anisotropy, &Anisotropy::texture>},
    MaterialTexture{"iridescence", data, ofLobe<&Material::iridescence, &Iridescence::texture>},
    MaterialTexture{"iridescence thickness", data,
                    ofLobe<&Material::iridescence, &Iridescence::thicknessTexture>},
    MaterialTexture{"transmission", data, ofLobe<&Material::transmission, &Transmission::texture>},
    MaterialTexture{"thickness", data, ofLobe<&Material::volume, &Volume::thicknessTexture>},
    MaterialTexture{"diffuse transmission", data,
                    ofLobe<&Material::diffuseTransmission, &DiffuseTransmission::texture>},
    MaterialTexture{"diffuse transmission colour", color,
                    ofLobe<&Material::diffuseTransmission, &DiffuseTransmission::colorTexture>},
};

}  // namespace

static_assert(textures.size() == static_cast<std::size_t>(TextureSlot::diffuseTransmissionColor) + 1);

std::span<const MaterialTexture> materialTextures() {
    return textures;
}

std::optional<Texture>& textureOf(Material& material, TextureSlot slot) {
    const MaterialTexture& texture = textures[static_cast<std::size_t>(slot)];
    return const_cast<std::optional<Texture>&>(texture.of(material));
}

}  // namespace candela
