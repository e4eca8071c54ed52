#include "base/error_context.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace candela {

namespace {

constexpr std::uint32_t maxSide = 32768;

bool floatsAreFinite(const std::vector<std::byte>& bytes) {
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(float)) {
        float value = 0.0f;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        if (!std::isfinite(value)) return false;
    }
    return true;
}

bool isWrap(Wrap wrap) {
    return wrap == Wrap::repeat || wrap == Wrap::clampToEdge || wrap == Wrap::mirroredRepeat;
}

bool isMinFilter(Filter filter) {
    return filter >= Filter::linearMipmapLinear && filter <= Filter::nearestMipmapLinear;
}

void validateTexture(const std::optional<Texture>& texture, const char* use, const Scene& scene,
                     const ErrorContext& element) {
    if (!texture) return;
    const auto require = [&](bool holds, const char* rule) {
        if (!holds) element.refuse(use + (std::string(" texture: ") + rule));
    };
    element.requireIndex("image", texture->image, scene.images.size());
    require(texture->uvSet < maxUvSets, "the set of texture coordinates must be 0 to 17");
    require(isWrap(texture->wrapS) && isWrap(texture->wrapT), "a wrap mode is unknown");
    require(isMinFilter(texture->minFilter), "the minification filter is unknown");
    require(texture->magFilter == Filter::nearest || texture->magFilter == Filter::linear,
            "the magnification filter must be nearest or linear");
    require(allFinite(texture->offset) && std::isfinite(texture->rotation) && allFinite(texture->scale),
            "offset, rotation and scale must be finite numbers");
}

}  // namespace

void validateImage(const Image& image, const ErrorContext& element) {
    element.require(image.format == PixelFormat::rgba8 || image.format == PixelFormat::rgba16 ||
                        image.format == PixelFormat::rgba32f,
                    "its pixel format is unknown");
    element.require(
        image.width >= 1 && image.width <= maxSide && image.height >= 1 && image.height <= maxSide,
        "its width and height must lie between 1 and 32768");
    const std::size_t size = std::size_t{image.width} * image.height * texelSize(image.format);
    if (image.pixels.size() != size) {
        element.refuse("holds " + std::to_string(image.pixels.size()) +
                       " bytes of pixels, but its size requires " + std::to_string(size));
    }
    element.require(image.format != PixelFormat::rgba32f || floatsAreFinite(image.pixels),
                    "its pixels must be finite numbers");
}

namespace {

void requireColor(const char* what, const glm::vec3& color, const ErrorContext& element) {
    for (int i = 0; i < 3; ++i) element.requireWithin(what, color[i], 0.0f, 1.0f);
}

/// Of an index of refraction; `high` is included.
void requireIor(const char* what, float ior, float high, const ErrorContext& element) {
    if (!(ior >= 1.0f && ior <= high))
        element.refuse(what + (" is " + shortNumber(ior)) + ", but 1 or more was expected");
}

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float maxNumber = std::numeric_limits<float>::max();

/// The lobes that reflect.
void validateReflection(const Material& material, const ErrorContext& element) {
    requireIor("its index of refraction", material.ior, infinity, element);
    element.requireWithin("its specular factor", material.specular.factor, 0.0f, 1.0f);
    for (int i = 0; i < 3; ++i) element.requireNotNegative("its specular colour", material.specular.color[i]);
    const Clearcoat& coat = material.clearcoat;
    element.requireWithin("its clearcoat factor", coat.factor, 0.0f, 1.0f);
    element.requireWithin("its clearcoat roughness", coat.roughness, 0.0f, 1.0f);
    element.require(std::isfinite(coat.normalScale), "its clearcoat normal scale must be a finite number");
    requireColor("its sheen colour", material.sheen.color, element);
    element.requireWithin("its sheen roughness", material.sheen.roughness, 0.0f, 1.0f);
    element.requireWithin("its anisotropy strength", material.anisotropy.strength, 0.0f, 1.0f);
    element.require(std::isfinite(material.anisotropy.rotation),
                    "its anisotropy rotation must be a finite number");
    const Iridescence& film = material.iridescence;
    element.requireWithin("its iridescence factor", film.factor, 0.0f, 1.0f);
    requireIor("its iridescence index of refraction", film.ior, maxNumber, element);
    element.requireNotNegative("its least iridescence thickness", film.minThickness);
    element.requireNotNegative("its largest iridescence thickness", film.maxThickness);
}

/// The lobes and the medium that transmit.
void validateTransmission(const Material& material, const ErrorContext& element) {
    element.requireWithin("its transmission factor", material.transmission.factor, 0.0f, 1.0f);
    const Volume& volume = material.volume;
    element.requireNotNegative("its thickness", volume.thickness);
    element.require(volume.attenuationDistance > 0.0f, "its attenuation distance must be over 0 metres");
    requireColor("its attenuation colour", volume.attenuationColor, element);
    element.requireNotNegative("its dispersion", volume.dispersion);
    const DiffuseTransmission& diffuse = material.diffuseTransmission;
    element.requireWithin("its diffuse transmission factor", diffuse.factor, 0.0f, 1.0f);
    requireColor("its diffuse transmission colour", diffuse.color, element);
}

}  // namespace

void validateMaterial(const Material& material, const Scene& scene, const ErrorContext& element) {
    for (int i = 0; i < 4; ++i) element.requireWithin("its base colour", material.baseColor[i], 0.0f, 1.0f);
    element.requireWithin("its metallic factor", material.metallic, 0.0f, 1.0f);
    element.requireWithin("its roughness", material.roughness, 0.0f, 1.0f);
    for (int i = 0; i < 3; ++i) {
        element.requireWithin("its emission", material.emission[i], 0.0f, maxIntensity);
    }
    element.requireWithin("its emission strength", material.emissionStrength, 0.0f, maxIntensity);
    for (int i = 0; i < 3; ++i) {
        element.require(material.emission[i] * material.emissionStrength <= maxIntensity,
                        "its emission times its strength must be at most 1e20");
    }
    element.require(std::isfinite(material.normalScale), "its normal scale must be a finite number");
    element.requireWithin("its occlusion strength", material.occlusionStrength, 0.0f, 1.0f);
    element.require(material.alphaMode == AlphaMode::opaque || material.alphaMode == AlphaMode::mask ||
                        material.alphaMode == AlphaMode::blend,
                    "its alpha mode must be opaque, mask or blend");
    element.require(material.alphaCutoff >= 0.0f && std::isfinite(material.alphaCutoff),
                    "its alpha cutoff must be a finite number, 0 or more");
    validateReflection(material, element);
    validateTransmission(material, element);
    for (const MaterialTexture& texture : materialTextures())
        validateTexture(texture.of(material), texture.name, scene, element);
}

void requireUvs(UvSets sets, std::uint32_t material, const Scene& scene, const ErrorContext& element) {
    const Material& reader = scene.materials[material];
    for (const MaterialTexture& use : materialTextures()) {
        const std::optional<Texture>& texture = use.of(reader);
        if (!texture) continue;
        const std::uint32_t set = texture->uvSet;
        if (set < maxUvSets && (sets >> set & 1u) != 0) continue;
        element.refuse("has no texture coordinates " + std::to_string(set) + ", which a texture of " +
                       ErrorContext("material", material, reader.name).label() + " reads");
    }
}

}  // namespace candela
