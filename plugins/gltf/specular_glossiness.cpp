#include "specular_glossiness.h"

#include <algorithm>
#include <limits>

namespace candela_plugins::gltf {
namespace {

const tinygltf::Value* extensionOf(const tinygltf::Material& material) {
    return findExtension(material.extensions, "KHR_materials_pbrSpecularGlossiness");
}

}  // namespace

bool hasSpecularGlossiness(const tinygltf::Material& material) {
    return extensionOf(material) != nullptr;
}

float glossinessFactor(const tinygltf::Material& material) {
    return numberOr(*extensionOf(material), "glossinessFactor", 1.0f);
}

void readSpecularGlossiness(const tinygltf::Material& source, const TextureUses& uses,
                            const TextureReader& textures, HostMaterial& material) {
    const tinygltf::Value& values = *extensionOf(source);
    const float glossiness = glossinessFactor(source);
    std::fill_n(material.base.base_color, 4, 1.0f);
    readNumbers(values, "diffuseFactor", material.base.base_color);
    material.base.metallic = 0.0f;
    material.base.ior = std::numeric_limits<float>::infinity();
    material.specular = candela_specular{1.0f, {1.0f, 1.0f, 1.0f}, nullptr, nullptr};
    readNumbers(values, "specularFactor", material.specular->color);
    material.textures[specularTexture] = noTexture();
    material.textures[specularColorTexture] = textures.read(uses.specularGlossiness);
    candela_texture& roughness = material.base.metallic_roughness_texture;
    roughness = textures.readRoughness(uses.specularGlossiness, glossiness);
    // The image holds the factor.
    material.base.roughness = roughness.image >= 0 ? 1.0f : 1.0f - glossiness;
}

}  // namespace candela_plugins::gltf
