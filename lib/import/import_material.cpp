#include "import/abi_import.h"

#include <array>
#include <cmath>
#include <limits>

namespace candela {

namespace {

constexpr std::uint32_t maxSide = 32768;

std::uint32_t checkedSide(const AbiReader& element, const char* member, std::uint32_t value) {
    if (value < 1 || value > maxSide)
        element.refuse(joined(member, " is ", value, ", but 1 to ", maxSide, " was expected"));
    return value;
}

void requireFiniteTexels(const AbiReader& element, const Image& image) {
    if (image.format != PixelFormat::rgba32f) return;
    for (std::size_t offset = 0; offset < image.pixels.size(); offset += sizeof(float)) {
        float value = 0.0f;
        std::memcpy(&value, image.pixels.data() + offset, sizeof value);
        if (std::isfinite(value)) continue;
        const std::size_t texel = offset / texelSize(image.format);
        element.refuse(joined("the texel in row ", texel / image.width, ", column ", texel % image.width,
                              " holds ", value, ", but finite numbers were expected"));
    }
}

}  // namespace

Image imageFrom(const candela_image& source, const AbiReader& element) {
    constexpr std::array formats{PixelFormat::rgba8, PixelFormat::rgba16, PixelFormat::rgba32f};
    Image image;
    image.name = element.name();
    image.width = checkedSide(element, "width", source.width);
    image.height = checkedSide(element, "height", source.height);
    image.format = formats[element.enumerator("format", source.format, formats.size())];
    const std::uint64_t expected = std::uint64_t{image.width} * image.height * texelSize(image.format);
    if (source.pixels_size != expected)
        element.refuse(joined("pixels_size is ", source.pixels_size, ", but ", image.width, " × ",
                              image.height, " texels of ", texelSize(image.format), " bytes make ",
                              expected));
    if (!source.pixels) element.refuse("pixels is NULL");
    image.pixels.resize(expected);
    std::memcpy(image.pixels.data(), source.pixels, expected);
    requireFiniteTexels(element, image);
    return image;
}

namespace {

constexpr std::array wraps{Wrap::repeat, Wrap::clampToEdge, Wrap::mirroredRepeat};
constexpr std::array filters{Filter::linearMipmapLinear,
                             Filter::nearest,
                             Filter::linear,
                             Filter::nearestMipmapNearest,
                             Filter::linearMipmapNearest,
                             Filter::nearestMipmapLinear};
constexpr std::array magFilters{Filter::linear, Filter::nearest, Filter::linear};

std::optional<Texture> textureFrom(const candela_texture& source, const std::string& what,
                                   const AbiReader& element, const Scene& scene) {
    const auto member = [&](const char* name) { return what + "." + name; };
    const auto image = element.reference(member("image").c_str(), source.image, scene.images.size());
    if (!image) return std::nullopt;
    Texture texture;
    texture.image = *image;
    texture.uvSet = element.flag(member("uv_set").c_str(), source.uv_set) ? 1 : 0;
    texture.wrapS = wraps[element.enumerator(member("wrap_s").c_str(), source.wrap_s, wraps.size())];
    texture.wrapT = wraps[element.enumerator(member("wrap_t").c_str(), source.wrap_t, wraps.size())];
    texture.minFilter =
        filters[element.enumerator(member("min_filter").c_str(), source.min_filter, filters.size())];
    texture.magFilter =
        magFilters[element.enumerator(member("mag_filter").c_str(), source.mag_filter, magFilters.size())];
    for (int i = 0; i < 2; ++i) {
        texture.offset[i] = element.finite(member("offset").c_str(), source.offset[i]);
        texture.scale[i] = element.finite(member("scale").c_str(), source.scale[i]);
    }
    texture.rotation = element.finite(member("rotation").c_str(), source.rotation);
    return texture;
}

void takeTextures(const candela_material& source, const AbiReader& element, const Scene& scene,
                  Material& material) {
    const auto take = [&](const candela_texture& texture, const char* what) {
        return textureFrom(texture, what, element, scene);
    };
    material.baseColorTexture = take(source.base_color_texture, "base_color_texture");
    material.metallicRoughnessTexture = take(source.metallic_roughness_texture, "metallic_roughness_texture");
    material.normalTexture = take(source.normal_texture, "normal_texture");
    material.occlusionTexture = take(source.occlusion_texture, "occlusion_texture");
    material.emissionTexture = take(source.emission_texture, "emission_texture");
}

}  // namespace

Material materialFrom(const candela_material& source, const AbiReader& element, const Scene& scene) {
    constexpr std::array alphaModes{AlphaMode::opaque, AlphaMode::mask, AlphaMode::blend};
    Material material;
    material.name = element.name();
    for (int i = 0; i < 4; ++i)
        material.baseColor[i] = element.within("base_color", source.base_color[i], 0.0f, 1.0f);
    material.metallic = element.within("metallic", source.metallic, 0.0f, 1.0f);
    material.roughness = element.within("roughness", source.roughness, 0.0f, 1.0f);
    for (int i = 0; i < 3; ++i) material.emission[i] = element.zeroOrMore("emission", source.emission[i]);
    takeTextures(source, element, scene, material);
    material.normalScale = element.finite("normal_scale", source.normal_scale);
    material.occlusionStrength = element.within("occlusion_strength", source.occlusion_strength, 0.0f, 1.0f);
    material.alphaMode = alphaModes[element.enumerator("alpha_mode", source.alpha_mode, alphaModes.size())];
    material.alphaCutoff = element.zeroOrMore("alpha_cutoff", source.alpha_cutoff);
    material.doubleSided = element.flag("double_sided", source.double_sided);
    material.unlit = element.flag("unlit", source.unlit);
    return material;
}

}  // namespace candela
