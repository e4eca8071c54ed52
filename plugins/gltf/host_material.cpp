#include "host_material.h"

#include <algorithm>
#include <limits>
#include <string>

namespace candela_plugins::gltf {

candela_texture noTexture() {
    candela_texture texture{};
    texture.image = -1;
    texture.scale[0] = texture.scale[1] = 1.0f;
    return texture;
}

HostMaterial::HostMaterial() : base{} {
    base.struct_size = sizeof base;
    std::fill_n(base.base_color, 4, 1.0f);
    base.metallic = base.roughness = 1.0f;
    base.normal_scale = base.occlusion_strength = 1.0f;
    base.alpha_cutoff = 0.5f;
    base.base_color_texture = base.metallic_roughness_texture = base.normal_texture = base.occlusion_texture =
        base.emission_texture = noTexture();
    textures.fill(noTexture());
}

void HostMaterial::setUvSet(std::uint32_t set) {
    for (candela_texture* texture : {&base.base_color_texture, &base.metallic_roughness_texture,
                                     &base.normal_texture, &base.occlusion_texture, &base.emission_texture}) {
        texture->uv_set = set;
    }
    for (candela_texture& texture : textures) texture.uv_set = set;
}

namespace {

template <typename Lobe>
const Lobe* pointerTo(const std::optional<Lobe>& lobe) {
    return lobe ? &*lobe : nullptr;
}

/// Makes the lobes of a material point to its textures.
void linkTextures(HostMaterial& material) {
    const auto& textures = material.textures;
    if (auto& lobe = material.specular) {
        lobe->texture = &textures[specularTexture];
        lobe->color_texture = &textures[specularColorTexture];
    }
    if (auto& lobe = material.clearcoat) {
        lobe->texture = &textures[clearcoatTexture];
        lobe->roughness_texture = &textures[clearcoatRoughnessTexture];
        lobe->normal_texture = &textures[clearcoatNormalTexture];
    }
    if (auto& lobe = material.sheen) {
        lobe->color_texture = &textures[sheenColorTexture];
        lobe->roughness_texture = &textures[sheenRoughnessTexture];
    }
    if (auto& lobe = material.anisotropy) lobe->texture = &textures[anisotropyTexture];
    if (auto& lobe = material.iridescence) {
        lobe->texture = &textures[iridescenceTexture];
        lobe->thickness_texture = &textures[iridescenceThicknessTexture];
    }
    if (auto& lobe = material.transmission) lobe->texture = &textures[transmissionTexture];
    if (auto& lobe = material.volume) lobe->thickness_texture = &textures[thicknessTexture];
    if (auto& lobe = material.diffuseTransmission) {
        lobe->texture = &textures[diffuseTransmissionTexture];
        lobe->color_texture = &textures[diffuseTransmissionColorTexture];
    }
}

}  // namespace

std::int32_t HostMaterial::add(const Host& host) const {
    HostMaterial linked = *this;
    linkTextures(linked);
    linked.base.specular = pointerTo(linked.specular);
    linked.base.clearcoat = pointerTo(linked.clearcoat);
    linked.base.sheen = pointerTo(linked.sheen);
    linked.base.anisotropy = pointerTo(linked.anisotropy);
    linked.base.iridescence = pointerTo(linked.iridescence);
    linked.base.transmission = pointerTo(linked.transmission);
    linked.base.volume = pointerTo(linked.volume);
    linked.base.diffuse_transmission = pointerTo(linked.diffuseTransmission);
    linked.base.emission_strength = &linked.emissionStrength;
    if (!host.takesEmissionStrength()) {
        for (float& number : linked.base.emission) number *= emissionStrength;
    }
    return host.add(linked.base);
}

namespace {

using tinygltf::Value;

/// KHR_materials_ior: 0 stands for an infinite index.
float iorOf(const Value& values, const std::string& element, const Host& host) {
    const float ior = numberOr(values, "ior", 1.5f);
    if (ior == 0.0f) return std::numeric_limits<float>::infinity();
    if (ior >= 1.0f) return ior;
    host.note(CANDELA_NOTE_REPAIRED, element + ", KHR_materials_ior, ior",
              "neither 0 nor 1 or more: taken as 1");
    return 1.0f;
}

candela_specular specularOf(const Value& values) {
    candela_specular lobe{numberOr(values, "specularFactor", 1.0f), {1.0f, 1.0f, 1.0f}, nullptr, nullptr};
    readNumbers(values, "specularColorFactor", lobe.color);
    return lobe;
}

candela_clearcoat clearcoatOf(const Value& values) {
    const bool hasNormals = values.Has("clearcoatNormalTexture");
    return {numberOr(values, "clearcoatFactor", 0.0f),
            numberOr(values, "clearcoatRoughnessFactor", 0.0f),
            hasNormals ? numberOr(values.Get("clearcoatNormalTexture"), "scale", 1.0f) : 1.0f,
            nullptr,
            nullptr,
            nullptr};
}

candela_sheen sheenOf(const Value& values) {
    candela_sheen lobe{{}, numberOr(values, "sheenRoughnessFactor", 0.0f), nullptr, nullptr};
    readNumbers(values, "sheenColorFactor", lobe.color);
    return lobe;
}

candela_anisotropy anisotropyOf(const Value& values) {
    return {numberOr(values, "anisotropyStrength", 0.0f), numberOr(values, "anisotropyRotation", 0.0f),
            nullptr};
}

candela_iridescence iridescenceOf(const Value& values) {
    return {numberOr(values, "iridescenceFactor", 0.0f),
            numberOr(values, "iridescenceIor", 1.3f),
            numberOr(values, "iridescenceThicknessMinimum", 100.0f),
            numberOr(values, "iridescenceThicknessMaximum", 400.0f),
            nullptr,
            nullptr};
}

/// Of KHR_materials_volume and KHR_materials_dispersion, either of which may be null.
candela_volume volumeOf(const Value* values, const Value* dispersion) {
    candela_volume volume{0.0f, 0.0f, {1.0f, 1.0f, 1.0f}, 0.0f, nullptr};
    if (dispersion) volume.dispersion = numberOr(*dispersion, "dispersion", 0.0f);
    if (!values) return volume;
    volume.thickness = numberOr(*values, "thicknessFactor", 0.0f);
    volume.attenuation_distance = numberOr(*values, "attenuationDistance", 0.0f);
    readNumbers(*values, "attenuationColor", volume.attenuation_color);
    return volume;
}

candela_diffuse_transmission diffuseTransmissionOf(const Value& values) {
    candela_diffuse_transmission lobe{
        numberOr(values, "diffuseTransmissionFactor", 0.0f), {1.0f, 1.0f, 1.0f}, nullptr, nullptr};
    readNumbers(values, "diffuseTransmissionColorFactor", lobe.color);
    return lobe;
}

}  // namespace

void readLobes(const tinygltf::Material& source, const std::string& element, const Host& host,
               HostMaterial& material) {
    const auto find = [&](const char* name) { return findExtension(source.extensions, name); };
    if (const Value* values = find("KHR_materials_ior")) material.base.ior = iorOf(*values, element, host);
    if (const Value* values = find("KHR_materials_specular")) material.specular = specularOf(*values);
    if (const Value* values = find("KHR_materials_clearcoat")) material.clearcoat = clearcoatOf(*values);
    if (const Value* values = find("KHR_materials_sheen")) material.sheen = sheenOf(*values);
    if (const Value* values = find("KHR_materials_anisotropy")) material.anisotropy = anisotropyOf(*values);
    if (const Value* values = find("KHR_materials_iridescence"))
        material.iridescence = iridescenceOf(*values);
    if (const Value* values = find("KHR_materials_transmission"))
        material.transmission = candela_transmission{numberOr(*values, "transmissionFactor", 0.0f), nullptr};
    const Value *volume = find("KHR_materials_volume"), *dispersion = find("KHR_materials_dispersion");
    if (volume || dispersion) material.volume = volumeOf(volume, dispersion);
    if (const Value* values = find("KHR_materials_diffuse_transmission"))
        material.diffuseTransmission = diffuseTransmissionOf(*values);
}

}  // namespace candela_plugins::gltf
