#include "materials.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "images.h"
#include "material_file.h"

namespace candela_obj {
namespace {

using MaterialsByName = std::unordered_map<std::string, const FileMaterial*>;

const TextureInfo* pointer(const std::optional<TextureInfo>& texture) {
    return texture ? &*texture : nullptr;
}

MaterialsByName byName(const std::vector<FileMaterial>& materials, const Host& host) {
    MaterialsByName found;
    for (const FileMaterial& material : materials) {
        if (!found.try_emplace(material.name, &material).second)
            host.note(material.element + " is defined before: left out");
    }
    return found;
}

std::vector<bool> materialsInUse(const Document& document) {
    std::vector<bool> used(document.materials.size());
    for (const FaceState& state : document.states)
        if (state.material != none) used[state.material] = true;
    return used;
}

candela_texture noTexture() {
    candela_texture texture{};
    texture.image = -1;
    texture.scale[0] = texture.scale[1] = 1.0f;
    return texture;
}

/// `use` says how `image` is sampled.
candela_texture textureOf(std::int32_t image, const TextureInfo* use) {
    candela_texture texture = noTexture();
    if (image < 0 || !use) return texture;
    texture.image = image;
    texture.mag_filter = CANDELA_FILTER_LINEAR;
    texture.wrap_s = texture.wrap_t = use->clamp ? CANDELA_WRAP_CLAMP_TO_EDGE : CANDELA_WRAP_REPEAT;
    std::copy_n(use->scale, 2, texture.scale);
    // Here v goes down: 1 - (offset + scale × (1 - v)).
    texture.offset[0] = use->offset[0];
    texture.offset[1] = 1.0f - use->offset[1] - use->scale[1];
    return texture;
}

bool readsUvs(const candela_material& material) {
    return material.base_color_texture.image >= 0 || material.metallic_roughness_texture.image >= 0 ||
           material.normal_texture.image >= 0 || material.emission_texture.image >= 0;
}

class MaterialPusher {
  public:
    explicit MaterialPusher(const Host& host) : host_(host), images_(host) {}

    PushedMaterial push(const FileMaterial& source) {
        candela_material material{};
        material.struct_size = sizeof material;
        material.name = source.name.c_str();
        material.normal_texture = material.occlusion_texture = noTexture();
        material.normal_scale = material.occlusion_strength = 1.0f;
        material.alpha_cutoff = 0.5f;
        material.double_sided = 1;
        takeBase(source, material);
        takeMetal(source, material);
        takeEmission(source, material);
        if (source.normalMap) {
            material.normal_texture = textureOf(images_.whole(pointer(source.normalMap)), &*source.normalMap);
            material.normal_scale = source.normalMap->multiplier;
        }
        return {host_.add(material), readsUvs(material)};
    }

  private:
    /// The texture whose options count for a picture made of both.
    const TextureInfo* samplingOf(const TextureInfo* first, const TextureInfo* second) const {
        if (first && second && !first->samplesLike(*second))
            host_.note(second->element + ": its options are not used, but those of " + first->element);
        return first ? first : second;
    }

    void takeBase(const FileMaterial& source, candela_material& material) {
        std::fill_n(material.base_color, 4, 1.0f);
        if (source.diffuse) std::copy(source.diffuse->begin(), source.diffuse->end(), material.base_color);
        material.base_color[3] = source.opacity.value_or(1.0f);
        const TextureInfo *color = pointer(source.diffuseMap), *mask = pointer(source.opacityMap);
        material.base_color_texture = textureOf(images_.colorAndMask(color, mask), samplingOf(color, mask));
        if (!mask && material.base_color[3] == 1.0f) return;
        material.alpha_mode = CANDELA_ALPHA_MASK;
        host_.note(source.element + ": its opacity is drawn as a mask with a cutoff of 0.5");
    }

    void takeMetal(const FileMaterial& source, candela_material& material) {
        const TextureInfo *rough = pointer(source.roughnessMap), *metal = pointer(source.metallicMap);
        const float exponent = source.exponent.value_or(0.0f);
        const float roughnessOfExponent = std::sqrt(std::sqrt(2.0f / (exponent + 2.0f)));
        material.roughness = source.roughness.value_or(rough ? 1.0f : roughnessOfExponent);
        material.metallic = source.metallic.value_or(metal ? 1.0f : 0.0f);
        material.metallic_roughness_texture =
            textureOf(images_.roughnessAndMetal(rough, metal), samplingOf(rough, metal));
    }

    void takeEmission(const FileMaterial& source, candela_material& material) {
        constexpr std::array black{0.0f, 0.0f, 0.0f}, white{1.0f, 1.0f, 1.0f};
        const TextureInfo* map = pointer(source.emissionMap);
        material.emission_texture = textureOf(images_.whole(map), map);
        std::array<float, 3> emission = source.emission.value_or(black);
        if (material.emission_texture.image >= 0 && emission == black) emission = white;
        std::copy(emission.begin(), emission.end(), material.emission);
    }

    const Host& host_;
    Images images_;
};

}  // namespace

std::vector<PushedMaterial> pushMaterials(const Document& document, const Host& host, double from,
                                          double to) {
    std::vector<FileMaterial> materials;
    for (const std::string& file : document.materialFiles) parseMaterialFile(file, host, materials);
    const MaterialsByName known = byName(materials, host);
    const std::vector<bool> used = materialsInUse(document);
    std::vector<PushedMaterial> pushed(used.size());
    MaterialPusher pusher(host);
    for (std::size_t i = 0; i < used.size(); ++i) {
        host.progress(from + (to - from) * static_cast<double>(i) / static_cast<double>(used.size()));
        if (!used[i]) continue;
        const auto found = known.find(document.materials[i]);
        if (found != known.end())
            pushed[i] = pusher.push(*found->second);
        else
            host.note("the material '" + readable(document.materials[i]) +
                      "' is in no material file: the default one is used");
    }
    return pushed;
}

PushedMaterial materialOf(const Document& document, const std::vector<PushedMaterial>& materials,
                          std::size_t face) {
    const std::uint32_t material = document.stateOf(face).material;
    return material == none ? PushedMaterial{} : materials[material];
}

}  // namespace candela_obj
