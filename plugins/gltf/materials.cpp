#include "materials.h"

#include <algorithm>

#include "specular_glossiness.h"
#include "texture_reader.h"
#include "texture_uses.h"

namespace candela_plugins::gltf {
namespace {

void readAlpha(const tinygltf::Material& source, candela_material& material) {
    material.alpha_cutoff = 0.5f;
    if (source.alphaMode == "OPAQUE") return;
    if (source.alphaMode == "MASK") {
        material.alpha_mode = CANDELA_ALPHA_MASK;
        material.alpha_cutoff = static_cast<float>(source.alphaCutoff);
        return;
    }
    material.alpha_mode = CANDELA_ALPHA_BLEND;
}

void readMetallicRoughness(const tinygltf::PbrMetallicRoughness& source, candela_material& material) {
    std::transform(source.baseColorFactor.begin(), source.baseColorFactor.end(), material.base_color,
                   [](double v) { return static_cast<float>(v); });
    material.metallic = static_cast<float>(source.metallicFactor);
    material.roughness = static_cast<float>(source.roughnessFactor);
}

/// The host's limit of the product with the emission, whose largest number is 1.
constexpr float maxEmission = 1e20f;

void readFactors(const tinygltf::Material& source, HostMaterial& read) {
    candela_material& material = read.base;
    material.normal_scale = static_cast<float>(source.normalTexture.scale);
    material.occlusion_strength = static_cast<float>(source.occlusionTexture.strength);
    const tinygltf::Value* strength = findExtension(source.extensions, "KHR_materials_emissive_strength");
    if (strength)
        read.emissionStrength = std::min(numberOr(*strength, "emissiveStrength", 1.0f), maxEmission);
    std::transform(source.emissiveFactor.begin(), source.emissiveFactor.end(), material.emission,
                   [](double v) { return static_cast<float>(v); });
    material.double_sided = source.doubleSided ? 1 : 0;
    material.unlit = findExtension(source.extensions, "KHR_materials_unlit") ? 1 : 0;
}

void readTextures(const TextureUses& uses, const TextureReader& textures, HostMaterial& material) {
    material.base.base_color_texture = textures.read(uses.baseColor);
    material.base.metallic_roughness_texture = textures.read(uses.metallicRoughness);
    material.base.normal_texture = textures.read(uses.normal);
    material.base.occlusion_texture = textures.read(uses.occlusion);
    material.base.emission_texture = textures.read(uses.emissive);
    for (std::size_t i = 0; i < lobeTextureCount; ++i) material.textures[i] = textures.read(uses.lobes[i]);
}

HostMaterial readMaterial(const Document& document, std::size_t index, const AddedImages& images,
                          const UvSlots& slots, const Host& host) {
    const tinygltf::Material& source = document.model.materials[index];
    const std::string element = elementName("material", index, source.name);
    const TextureReader textures(document, images, slots, host, element);
    const TextureUses uses = textureUses(source);
    HostMaterial material;
    material.base.name = source.name.c_str();
    readMetallicRoughness(source.pbrMetallicRoughness, material.base);
    readFactors(source, material);
    readLobes(source, element, host, material);
    readTextures(uses, textures, material);
    if (hasSpecularGlossiness(source)) readSpecularGlossiness(source, uses, textures, material);
    readAlpha(source, material.base);
    return material;
}

bool needsDefaultMaterial(const tinygltf::Mesh& mesh) {
    return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                       [](const tinygltf::Primitive& primitive) { return primitive.material < 0; });
}

bool needsDefaultMaterial(const Document& document, const std::vector<bool>& usedMeshes) {
    for (std::size_t i = 0; i < usedMeshes.size(); ++i) {
        if (usedMeshes[i] && needsDefaultMaterial(document.model.meshes[i])) return true;
    }
    return false;
}

}  // namespace

AddedMaterials addMaterials(const Document& document, const AddedImages& images,
                            const std::vector<bool>& usedMeshes, const Host& host) {
    AddedMaterials materials;
    materials.uvSlots = uvSlotsOf(document, host.takesFurtherUvs() ? maxUvSlots : 2);
    for (std::size_t i = 0; i < document.model.materials.size(); ++i) {
        const HostMaterial material = readMaterial(document, i, images, materials.uvSlots[i], host);
        material.add(host);
        materials.added.push_back(material);
    }
    // The material of a primitive without one is metallic and rough (glTF 2.0, 3.9.1).
    if (needsDefaultMaterial(document, usedMeshes)) materials.defaultMaterial = HostMaterial().add(host);
    return materials;
}

}  // namespace candela_plugins::gltf
