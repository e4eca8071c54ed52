#include "texture_uses.h"

#include <initializer_list>

namespace candela_plugins::gltf {
namespace {

constexpr const char* transformName = "KHR_texture_transform";

/// The set of texture coordinates, which a transform may override.
int setOf(int texCoord, const tinygltf::Value* transform) {
    return transform && transform->Has("texCoord") ? transform->Get("texCoord").GetNumberAsInt() : texCoord;
}

/// The texture of a core member of a material.
template <typename TextureInfo>
TextureUse useOf(const TextureInfo& info, const char* name) {
    const tinygltf::Value* transform = findExtension(info.extensions, transformName);
    return {name, info.index, setOf(info.texCoord, transform), transform};
}

/// The texture of a member of an extension, which may be null or without the member.
TextureUse useOf(const tinygltf::Value* extension, const char* name) {
    if (!extension || !extension->Has(name)) return {name};
    const tinygltf::Value& info = extension->Get(name);
    const bool isTransformed = info.Has("extensions") && info.Get("extensions").Has(transformName);
    const tinygltf::Value* transform = isTransformed ? &info.Get("extensions").Get(transformName) : nullptr;
    const int texCoord = info.Has("texCoord") ? info.Get("texCoord").GetNumberAsInt() : 0;
    return {name, info.Get("index").GetNumberAsInt(), setOf(texCoord, transform), transform};
}

struct LobeTextureMember {
    const char *extension, *member;
};

constexpr std::array<LobeTextureMember, lobeTextureCount> lobeTextureMembers{
    {{"KHR_materials_specular", "specularTexture"},
     {"KHR_materials_specular", "specularColorTexture"},
     {"KHR_materials_clearcoat", "clearcoatTexture"},
     {"KHR_materials_clearcoat", "clearcoatRoughnessTexture"},
     {"KHR_materials_clearcoat", "clearcoatNormalTexture"},
     {"KHR_materials_sheen", "sheenColorTexture"},
     {"KHR_materials_sheen", "sheenRoughnessTexture"},
     {"KHR_materials_anisotropy", "anisotropyTexture"},
     {"KHR_materials_iridescence", "iridescenceTexture"},
     {"KHR_materials_iridescence", "iridescenceThicknessTexture"},
     {"KHR_materials_transmission", "transmissionTexture"},
     {"KHR_materials_volume", "thicknessTexture"},
     {"KHR_materials_diffuse_transmission", "diffuseTransmissionTexture"},
     {"KHR_materials_diffuse_transmission", "diffuseTransmissionColorTexture"}}};

}  // namespace

TextureUses textureUses(const tinygltf::Material& material) {
    TextureUses uses;
    const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
    if (const auto* specular = findExtension(material.extensions, "KHR_materials_pbrSpecularGlossiness")) {
        uses.baseColor = useOf(specular, "diffuseTexture");
        uses.specularGlossiness = useOf(specular, "specularGlossinessTexture");
    } else {
        uses.baseColor = useOf(pbr.baseColorTexture, "baseColorTexture");
        uses.metallicRoughness = useOf(pbr.metallicRoughnessTexture, "metallicRoughnessTexture");
    }
    uses.normal = useOf(material.normalTexture, "normalTexture");
    uses.emissive = useOf(material.emissiveTexture, "emissiveTexture");
    uses.occlusion = useOf(material.occlusionTexture, "occlusionTexture");
    for (std::size_t i = 0; i < lobeTextureCount; ++i) {
        const LobeTextureMember& member = lobeTextureMembers[i];
        uses.lobes[i] = useOf(findExtension(material.extensions, member.extension), member.member);
    }
    return uses;
}

std::vector<TextureUse> TextureUses::all() const {
    std::vector<TextureUse> uses;
    const auto add = [&](const TextureUse& use) {
        if (use.texture >= 0) uses.push_back(use);
    };
    for (const TextureUse* use :
         {&baseColor, &metallicRoughness, &specularGlossiness, &normal, &emissive, &occlusion}) {
        add(*use);
    }
    for (const TextureUse& use : lobes) add(use);
    return uses;
}

const tinygltf::Value* findExtension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

float numberOr(const tinygltf::Value& object, const char* name, float fallback) {
    return object.Has(name) ? static_cast<float>(object.Get(name).GetNumberAsDouble()) : fallback;
}

}  // namespace candela_plugins::gltf
