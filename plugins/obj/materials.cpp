#include "materials.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "images.h"
#include "material_file.h"

namespace candela_plugins::obj {
namespace {

using MaterialsByName = std::unordered_map<std::string, const FileMaterial*>;

const TextureInfo* pointer(const std::optional<TextureInfo>& texture) {
    return texture ? &*texture : nullptr;
}

MaterialsByName byName(const std::vector<FileMaterial>& materials, const Host& host) {
    MaterialsByName found;
    for (const FileMaterial& material : materials) {
        if (!found.try_emplace(material.name, &material).second)
            host.note(CANDELA_NOTE_REPAIRED, material.element, "defined before: left out");
    }
    return found;
}

/// The material of each name that the document uses; NULL where it is not used by a face, or in no file.
std::vector<const FileMaterial*> materialsInUse(const Document& document, const MaterialsByName& known,
                                                const Host& host) {
    std::vector<bool> isUsed(document.materials.size());
    for (const FaceState& state : document.states)
        if (state.material != none) isUsed[state.material] = true;
    std::vector<const FileMaterial*> used(isUsed.size(), nullptr);
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!isUsed[i]) continue;
        const auto found = known.find(document.materials[i]);
        if (found != known.end())
            used[i] = found->second;
        else
            host.note(CANDELA_NOTE_MISSING, "material '" + readable(document.materials[i]) + "'",
                      "in no material file: the default one is used");
    }
    return used;
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

MaterialImages requestImages(const FileMaterial& source, Images& images) {
    return {images.colorAndMask(pointer(source.diffuseMap), pointer(source.opacityMap)),
            images.roughnessAndMetallic(pointer(source.roughnessMap), pointer(source.metallicMap)),
            images.whole(pointer(source.emissionMap)), images.whole(pointer(source.normalMap))};
}

class MaterialImporter {
  public:
    MaterialImporter(const Host& host, const Images& images) : host_(host), images_(images) {}

    AddedMaterial add(const FileMaterial& source, const MaterialImages& images) {
        candela_material material{};
        material.struct_size = sizeof material;
        material.name = source.name.c_str();
        material.normal_texture = material.occlusion_texture = noTexture();
        material.normal_scale = material.occlusion_strength = 1.0f;
        material.alpha_cutoff = 0.5f;
        material.double_sided = 1;
        takeBase(source, images, material);
        takeMetallic(source, images, material);
        takeEmission(source, images, material);
        if (source.normalMap) {
            material.normal_texture = textureOf(images_.indexOf(images.normal), &*source.normalMap);
            material.normal_scale = source.normalMap->multiplier;
        }
        return {host_.add(material), readsUvs(material)};
    }

  private:
    /// The texture whose sampling options apply to the image combined of both.
    const TextureInfo* samplingOf(const TextureInfo* first, const TextureInfo* second) const {
        if (first && second && !first->hasSameSampling(*second))
            host_.note(CANDELA_NOTE_MISSING, second->element,
                       "its options are not used, but those of " + first->element);
        return first ? first : second;
    }

    void takeBase(const FileMaterial& source, const MaterialImages& images, candela_material& material) {
        std::fill_n(material.base_color, 4, 1.0f);
        if (source.diffuse) std::copy(source.diffuse->begin(), source.diffuse->end(), material.base_color);
        material.base_color[3] = source.opacity.value_or(1.0f);
        const TextureInfo *color = pointer(source.diffuseMap), *mask = pointer(source.opacityMap);
        material.base_color_texture = textureOf(images_.indexOf(images.base), samplingOf(color, mask));
        if (!mask && material.base_color[3] == 1.0f) return;
        material.alpha_mode = CANDELA_ALPHA_MASK;
        host_.note(CANDELA_NOTE_MISSING, source.element,
                   "its opacity is drawn as a mask with a cutoff of 0.5");
    }

    void takeMetallic(const FileMaterial& source, const MaterialImages& images, candela_material& material) {
        const TextureInfo *rough = pointer(source.roughnessMap), *metal = pointer(source.metallicMap);
        const float exponent = source.exponent.value_or(0.0f);
        const float roughnessOfExponent = std::sqrt(std::sqrt(2.0f / (exponent + 2.0f)));
        material.roughness = source.roughness.value_or(rough ? 1.0f : roughnessOfExponent);
        material.metallic = source.metallic.value_or(metal ? 1.0f : 0.0f);
        material.metallic_roughness_texture =
            textureOf(images_.indexOf(images.metallicRoughness), samplingOf(rough, metal));
    }

    void takeEmission(const FileMaterial& source, const MaterialImages& images, candela_material& material) {
        constexpr std::array black{0.0f, 0.0f, 0.0f}, white{1.0f, 1.0f, 1.0f};
        const TextureInfo* map = pointer(source.emissionMap);
        material.emission_texture = textureOf(images_.indexOf(images.emission), map);
        std::array<float, 3> emission = source.emission.value_or(black);
        if (material.emission_texture.image >= 0 && emission == black) emission = white;
        std::copy(emission.begin(), emission.end(), material.emission);
    }

    const Host& host_;
    const Images& images_;
};

}  // namespace

std::vector<AddedMaterial> addMaterials(const Document& document, const Host& host, double from, double to) {
    std::vector<FileMaterial> materials;
    for (const std::string& file : document.materialFiles) parseMaterialFile(file, host, materials);
    const MaterialsByName known = byName(materials, host);
    const std::vector<const FileMaterial*> used = materialsInUse(document, known, host);
    Images images(host);
    std::vector<MaterialImages> requests(used.size());
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) requests[i] = requestImages(*used[i], images);
    images.addRequested(from, to);

    std::vector<AddedMaterial> added(used.size());
    MaterialImporter importer(host, images);
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) added[i] = importer.add(*used[i], requests[i]);
    return added;
}

AddedMaterial materialOf(const Document& document, const std::vector<AddedMaterial>& materials,
                         std::size_t face) {
    const std::uint32_t material = document.stateOf(face).material;
    return material == none ? AddedMaterial{} : materials[material];
}

}  // namespace candela_plugins::obj
