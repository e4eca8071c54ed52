#include "materials.h"

#include <algorithm>
#include <cmath>

#include "images.h"
#include "material_file.h"
#include "material_library.h"

namespace candela_plugins::obj {
namespace {

/// Whether faces, lines or points use each material of the document.
std::vector<bool> materialsInUse(const Document& document) {
    std::vector<bool> isUsed(document.materials.size());
    const auto use = [&](std::uint32_t state) {
        const std::uint32_t material = document.states[state].material;
        if (material != none) isUsed[material] = true;
    };
    for (const Face& face : document.faces) use(face.state);
    for (const LooseElement& element : document.looseElements) use(element.state);
    return isUsed;
}

candela_texture noTexture() {
    candela_texture texture{};
    texture.image = -1;
    texture.scale[0] = texture.scale[1] = 1.0f;
    return texture;
}

/// `info` has the sampling parameters.
candela_texture textureOf(std::int32_t image, const TextureInfo* info) {
    candela_texture texture = noTexture();
    if (image < 0 || !info) return texture;
    texture.image = image;
    texture.mag_filter = CANDELA_FILTER_LINEAR;
    texture.wrap_s = texture.wrap_t = info->clamp ? CANDELA_WRAP_CLAMP_TO_EDGE : CANDELA_WRAP_REPEAT;
    std::copy_n(info->scale, 2, texture.scale);
    // Here v increases downwards: 1 - (offset + scale × (1 - v)).
    texture.offset[0] = info->offset[0];
    texture.offset[1] = 1.0f - info->offset[1] - info->scale[1];
    return texture;
}

bool readsUvs(const candela_material& material) {
    return material.base_color_texture.image >= 0 || material.metallic_roughness_texture.image >= 0 ||
           material.normal_texture.image >= 0 || material.emission_texture.image >= 0;
}

/// The images of a material.
struct MaterialImages {
    Images::Request base, metallicRoughness, emission, normal;
};

const TextureInfo* pointer(const std::optional<TextureInfo>& texture) {
    return texture ? &*texture : nullptr;
}

MaterialImages requestImages(const FileMaterial& source, Images& images) {
    return {
        images.colorAndMask(pointer(source.diffuseMap), pointer(source.opacityMap)),
        images.roughnessAndMetallic(pointer(source.roughnessMap), pointer(source.metallicMap)),
        images.whole(pointer(source.emissionMap)),
        source.normalMap ? images.whole(pointer(source.normalMap)) : images.bump(pointer(source.bumpMap))};
}

candela_material defaultMaterial(const std::string& name) {
    candela_material material{};
    material.struct_size = sizeof material;
    material.name = name.c_str();
    std::fill_n(material.base_color, 4, 1.0f);
    material.roughness = 1.0f;
    material.base_color_texture = material.metallic_roughness_texture = material.normal_texture =
        material.occlusion_texture = material.emission_texture = noTexture();
    material.normal_scale = material.occlusion_strength = 1.0f;
    material.alpha_cutoff = 0.5f;
    material.double_sided = 1;
    return material;
}

class MaterialImporter {
  public:
    MaterialImporter(const Host& host, const Images& images) : host_(host), images_(images) {}

    AddedMaterial add(const FileMaterial& source, const MaterialImages& images) {
        candela_material material = defaultMaterial(source.name);
        takeBase(source, images, material);
        takeMetallic(source, images, material);
        takeEmission(source, images, material);
        if (const TextureInfo* const map = pointer(source.normalMap ? source.normalMap : source.bumpMap)) {
            material.normal_texture = textureOf(images_.indexOf(images.normal), map);
            material.normal_scale = map->multiplier;
        }
        return {host_.add(material), readsUvs(material)};
    }

  private:
    void noteRepaired(const FileMaterial& source, const char* text) const {
        host_.note(CANDELA_NOTE_REPAIRED, source.element, text);
    }

    /// The texture whose sampling options apply to the image combined of both.
    const TextureInfo* samplingOf(const TextureInfo* first, const TextureInfo* second) const {
        if (first && second && !first->hasSameSampling(*second))
            host_.note(CANDELA_NOTE_MISSING, second->element,
                       "its options are not used, but those of " + first->element);
        return first ? first : second;
    }

    void takeBase(const FileMaterial& source, const MaterialImages& images, candela_material& material) {
        std::copy_n(baseColorOf(source).begin(), 3, material.base_color);
        material.base_color[3] = opacityOf(source);
        const TextureInfo *color = images_.usable(source.diffuseMap),
                          *mask = images_.usable(source.opacityMap);
        material.base_color_texture = textureOf(images_.indexOf(images.base), samplingOf(color, mask));
        if (!images_.hasHoles(images.base) && material.base_color[3] == 1.0f) return;
        material.alpha_mode = CANDELA_ALPHA_BLEND;
    }

    /// Programs that give a diffuse colour a map write a Kd of 0 beside it.
    std::array<float, 3> baseColorOf(const FileMaterial& source) const {
        constexpr std::array black{0.0f, 0.0f, 0.0f}, white{1.0f, 1.0f, 1.0f};
        const std::array<float, 3> color = source.diffuse.value_or(white);
        if (!source.hasDiffuseMap || color != black) return color;
        noteRepaired(source, "Kd is 0 beside map_Kd: taken as 1");
        return white;
    }

    /// d, which takes precedence, or 1 - Tr. Programs that mean opaque write a Tr of 1 (MeshLab until 2023),
    /// or a d of 0: nothing is drawn only where d and Tr agree on it.
    float opacityOf(const FileMaterial& source) const {
        const std::optional<float> opacity = source.opacity, transparency = source.transparency;
        if (opacity && *opacity > 0.0f) return *opacity;
        if (opacity && transparency == 1.0f && !source.opacityMap) return 0.0f;
        if (opacity)
            noteRepaired(source, source.opacityMap ? "d is 0 beside map_d: not used"
                                                   : "d is 0, which Tr does not confirm: not used");
        if (!transparency) return 1.0f;
        if (*transparency < 1.0f) return 1.0f - *transparency;
        if (!opacity) noteRepaired(source, "Tr is 1 without d: taken as opaque");
        return 1.0f;
    }

    void takeMetallic(const FileMaterial& source, const MaterialImages& images, candela_material& material) {
        const TextureInfo* const rough = images_.usable(source.roughnessMap);
        const TextureInfo* const metal = images_.usable(source.metallicMap);
        const float exponent = source.exponent.value_or(0.0f);
        const float roughnessOfExponent = std::sqrt(std::sqrt(2.0f / (exponent + 2.0f)));
        material.roughness = source.roughness.value_or(rough ? 1.0f : roughnessOfExponent);
        material.metallic = source.metallic.value_or(metal ? 1.0f : 0.0f);
        material.metallic_roughness_texture =
            textureOf(images_.indexOf(images.metallicRoughness), samplingOf(rough, metal));
    }

    /// A Ke of 0 beside a map counts as 1. Without its map, a surface would shine all over.
    void takeEmission(const FileMaterial& source, const MaterialImages& images, candela_material& material) {
        constexpr std::array black{0.0f, 0.0f, 0.0f}, white{1.0f, 1.0f, 1.0f};
        const TextureInfo* const map = images_.usable(source.emissionMap);
        material.emission_texture = textureOf(images_.indexOf(images.emission), map);
        std::array<float, 3> emission = source.emission.value_or(black);
        if (map && emission == black) emission = white;
        if (source.emissionMap && !map) emission = black;
        std::copy(emission.begin(), emission.end(), material.emission);
    }

    const Host& host_;
    const Images& images_;
};

/// Gives the faces without a material one that is white, rough and double-sided, and appends it to `added`.
void addDefault(const Document& document, const Host& host, std::vector<AddedMaterial>& added) {
    const auto lacksMaterial = [&](const auto& element) {
        const std::uint32_t material = document.states[element.state].material;
        return material == none || added[material].index < 0;
    };
    AddedMaterial material;
    if (std::any_of(document.faces.begin(), document.faces.end(), lacksMaterial) ||
        std::any_of(document.looseElements.begin(), document.looseElements.end(), lacksMaterial))
        material.index = host.add(defaultMaterial("default"));
    for (AddedMaterial& known : added)
        if (known.index < 0) known = material;
    added.push_back(material);
}

}  // namespace

std::vector<AddedMaterial> addMaterials(const Document& document, const std::string& sceneFile,
                                        const Host& host, double from, double to) {
    const MaterialLibrary library(document, sceneFile, host);
    const std::vector<bool> isUsed = materialsInUse(document);
    std::vector<const FileMaterial*> used(isUsed.size(), nullptr);
    Images images(host);
    std::vector<MaterialImages> requests(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        // "usemtl" without a name means none.
        if (isUsed[i] && !document.materials[i].empty()) used[i] = library.find(document.materials[i]);
        if (used[i]) requests[i] = requestImages(*used[i], images);
    }
    images.addRequested(from, to);

    std::vector<AddedMaterial> added(used.size());
    MaterialImporter importer(host, images);
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) added[i] = importer.add(*used[i], requests[i]);
    addDefault(document, host, added);
    return added;
}

AddedMaterial materialOf(const Document& document, const std::vector<AddedMaterial>& materials,
                         std::size_t face) {
    const std::uint32_t material = document.stateOf(face).material;
    return material == none ? materials.back() : materials[material];
}

}  // namespace candela_plugins::obj
