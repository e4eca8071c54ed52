#include "import/abi_import.h"

#include <array>

namespace candela {
namespace {

constexpr std::array wraps{Wrap::repeat, Wrap::clampToEdge, Wrap::mirroredRepeat};
constexpr std::array filters{Filter::linearMipmapLinear,
                             Filter::nearest,
                             Filter::linear,
                             Filter::nearestMipmapNearest,
                             Filter::linearMipmapNearest,
                             Filter::nearestMipmapLinear};
constexpr std::array magFilters{Filter::linear, Filter::nearest, Filter::linear};

std::optional<Texture> textureFrom(const candela_texture& pushed, const std::string& what,
                                   const AbiReader& element, const Scene& scene) {
    const auto member = [&](const char* name) { return what + "." + name; };
    const auto image = element.reference(member("image").c_str(), pushed.image, scene.images.size());
    if (!image) return std::nullopt;
    Texture texture;
    texture.image = *image;
    texture.uvSet = element.flag(member("uv_set").c_str(), pushed.uv_set) ? 1 : 0;
    texture.wrapS = wraps[element.enumerator(member("wrap_s").c_str(), pushed.wrap_s, wraps.size())];
    texture.wrapT = wraps[element.enumerator(member("wrap_t").c_str(), pushed.wrap_t, wraps.size())];
    texture.minFilter =
        filters[element.enumerator(member("min_filter").c_str(), pushed.min_filter, filters.size())];
    texture.magFilter =
        magFilters[element.enumerator(member("mag_filter").c_str(), pushed.mag_filter, magFilters.size())];
    for (int i = 0; i < 2; ++i) {
        texture.offset[i] = element.finite(member("offset").c_str(), pushed.offset[i]);
        texture.scale[i] = element.finite(member("scale").c_str(), pushed.scale[i]);
    }
    texture.rotation = element.finite(member("rotation").c_str(), pushed.rotation);
    return texture;
}

void takeTextures(const candela_material& pushed, const AbiReader& element, const Scene& scene,
                  Material& material) {
    const auto take = [&](const candela_texture& texture, const char* what) {
        return textureFrom(texture, what, element, scene);
    };
    material.baseColorTexture = take(pushed.base_color_texture, "base_color_texture");
    material.metallicRoughnessTexture = take(pushed.metallic_roughness_texture, "metallic_roughness_texture");
    material.normalTexture = take(pushed.normal_texture, "normal_texture");
    material.occlusionTexture = take(pushed.occlusion_texture, "occlusion_texture");
    material.emissionTexture = take(pushed.emission_texture, "emission_texture");
}

}  // namespace

Material materialFrom(const candela_material& pushed, const AbiReader& element, const Scene& scene) {
    constexpr std::array alphaModes{AlphaMode::opaque, AlphaMode::mask};
    Material material;
    material.name = element.name();
    for (int i = 0; i < 4; ++i)
        material.baseColor[i] = element.within("base_color", pushed.base_color[i], 0.0f, 1.0f);
    material.metallic = element.within("metallic", pushed.metallic, 0.0f, 1.0f);
    material.roughness = element.within("roughness", pushed.roughness, 0.0f, 1.0f);
    for (int i = 0; i < 3; ++i) material.emission[i] = element.zeroOrMore("emission", pushed.emission[i]);
    takeTextures(pushed, element, scene, material);
    material.normalScale = element.finite("normal_scale", pushed.normal_scale);
    material.occlusionStrength = element.within("occlusion_strength", pushed.occlusion_strength, 0.0f, 1.0f);
    material.alphaMode = alphaModes[element.enumerator("alpha_mode", pushed.alpha_mode, alphaModes.size())];
    material.alphaCutoff = element.zeroOrMore("alpha_cutoff", pushed.alpha_cutoff);
    material.doubleSided = element.flag("double_sided", pushed.double_sided);
    material.unlit = element.flag("unlit", pushed.unlit);
    return material;
}

}  // namespace candela
