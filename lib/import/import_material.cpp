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
    texture.uvSet = element.below(member("uv_set").c_str(), source.uv_set, maxUvSets);
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

/// Reads the lobes and media of a material, each of which may be absent.
class LobeReader {
  public:
    LobeReader(const candela_material& source, const AbiReader& element, const Scene& scene)
        : source_(source), element_(element), scene_(scene) {}

    void readReflection(Material& material) const;
    void readTransmission(Material& material) const;

  private:
    std::optional<Texture> texture(const candela_texture* source, const char* what) const {
        return source ? textureFrom(*source, what, element_, scene_) : std::nullopt;
    }
    float share(const char* member, float value) const { return element_.within(member, value, 0.0f, 1.0f); }
    glm::vec3 color(const char* member, const float (&from)[3]) const {
        return {share(member, from[0]), share(member, from[1]), share(member, from[2])};
    }
    float ior(const char* member, float value, float high) const {
        if (!(value >= 1.0f && value <= high))
            element_.refuse(joined(member, " is ", value, ", but 1 or more was expected"));
        return value;
    }

    void read(const candela_specular& from, Specular& to) const;
    void read(const candela_clearcoat& from, Clearcoat& to) const;
    void read(const candela_sheen& from, Sheen& to) const;
    void read(const candela_anisotropy& from, Anisotropy& to) const;
    void read(const candela_iridescence& from, Iridescence& to) const;
    void read(const candela_transmission& from, Transmission& to) const;
    void read(const candela_volume& from, Volume& to) const;
    void read(const candela_diffuse_transmission& from, DiffuseTransmission& to) const;

    const candela_material& source_;
    const AbiReader& element_;
    const Scene& scene_;
};

void LobeReader::readReflection(Material& material) const {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (source_.ior != 0.0f) material.ior = ior("ior", source_.ior, infinity);
    if (source_.specular) read(*source_.specular, material.specular);
    if (source_.clearcoat) read(*source_.clearcoat, material.clearcoat);
    if (source_.sheen) read(*source_.sheen, material.sheen);
    if (source_.anisotropy) read(*source_.anisotropy, material.anisotropy);
    if (source_.iridescence) read(*source_.iridescence, material.iridescence);
}

void LobeReader::readTransmission(Material& material) const {
    if (source_.transmission) read(*source_.transmission, material.transmission);
    if (source_.volume) read(*source_.volume, material.volume);
    if (source_.diffuse_transmission) read(*source_.diffuse_transmission, material.diffuseTransmission);
}

void LobeReader::read(const candela_specular& from, Specular& to) const {
    to.factor = share("specular.factor", from.factor);
    for (int i = 0; i < 3; ++i) to.color[i] = element_.zeroOrMore("specular.color", from.color[i]);
    to.texture = texture(from.texture, "specular.texture");
    to.colorTexture = texture(from.color_texture, "specular.color_texture");
}

void LobeReader::read(const candela_clearcoat& from, Clearcoat& to) const {
    to.factor = share("clearcoat.factor", from.factor);
    to.roughness = share("clearcoat.roughness", from.roughness);
    to.normalScale = element_.finite("clearcoat.normal_scale", from.normal_scale);
    to.texture = texture(from.texture, "clearcoat.texture");
    to.roughnessTexture = texture(from.roughness_texture, "clearcoat.roughness_texture");
    to.normalTexture = texture(from.normal_texture, "clearcoat.normal_texture");
}

void LobeReader::read(const candela_sheen& from, Sheen& to) const {
    to.color = color("sheen.color", from.color);
    to.roughness = share("sheen.roughness", from.roughness);
    to.colorTexture = texture(from.color_texture, "sheen.color_texture");
    to.roughnessTexture = texture(from.roughness_texture, "sheen.roughness_texture");
}

void LobeReader::read(const candela_anisotropy& from, Anisotropy& to) const {
    to.strength = share("anisotropy.strength", from.strength);
    to.rotation = element_.finite("anisotropy.rotation", from.rotation);
    to.texture = texture(from.texture, "anisotropy.texture");
}

void LobeReader::read(const candela_iridescence& from, Iridescence& to) const {
    to.factor = share("iridescence.factor", from.factor);
    to.ior = ior("iridescence.ior", from.ior, std::numeric_limits<float>::max());
    to.minThickness = element_.zeroOrMore("iridescence.min_thickness", from.min_thickness);
    to.maxThickness = element_.zeroOrMore("iridescence.max_thickness", from.max_thickness);
    to.texture = texture(from.texture, "iridescence.texture");
    to.thicknessTexture = texture(from.thickness_texture, "iridescence.thickness_texture");
}

void LobeReader::read(const candela_transmission& from, Transmission& to) const {
    to.factor = share("transmission.factor", from.factor);
    to.texture = texture(from.texture, "transmission.texture");
}

void LobeReader::read(const candela_volume& from, Volume& to) const {
    to.thickness = element_.zeroOrMore("volume.thickness", from.thickness);
    const float distance = from.attenuation_distance;
    if (!(distance >= 0.0f))
        element_.refuse(joined("volume.attenuation_distance is ", distance, ", but 0 or more was expected"));
    if (distance > 0.0f) to.attenuationDistance = distance;
    to.attenuationColor = color("volume.attenuation_color", from.attenuation_color);
    to.dispersion = element_.zeroOrMore("volume.dispersion", from.dispersion);
    to.thicknessTexture = texture(from.thickness_texture, "volume.thickness_texture");
}

void LobeReader::read(const candela_diffuse_transmission& from, DiffuseTransmission& to) const {
    to.factor = share("diffuse_transmission.factor", from.factor);
    to.color = color("diffuse_transmission.color", from.color);
    to.texture = texture(from.texture, "diffuse_transmission.texture");
    to.colorTexture = texture(from.color_texture, "diffuse_transmission.color_texture");
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
    if (source.emission_strength)
        material.emissionStrength = element.zeroOrMore("emission_strength", *source.emission_strength);
    takeTextures(source, element, scene, material);
    material.normalScale = element.finite("normal_scale", source.normal_scale);
    material.occlusionStrength = element.within("occlusion_strength", source.occlusion_strength, 0.0f, 1.0f);
    material.alphaMode = alphaModes[element.enumerator("alpha_mode", source.alpha_mode, alphaModes.size())];
    material.alphaCutoff = element.zeroOrMore("alpha_cutoff", source.alpha_cutoff);
    material.doubleSided = element.flag("double_sided", source.double_sided);
    material.unlit = element.flag("unlit", source.unlit);
    const LobeReader lobes(source, element, scene);
    lobes.readReflection(material);
    lobes.readTransmission(material);
    return material;
}

}  // namespace candela
