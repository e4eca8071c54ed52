#include "texture_reader.h"

namespace candela_plugins::gltf {
namespace {

void noteSampler(const Host& host, const std::string& element, const char* member, int value) {
    host.note(CANDELA_NOTE_REPAIRED, element,
              std::string(member) + " " + std::to_string(value) + " does not exist: the default is used");
}

candela_wrap wrapOf(int value, const char* member, const std::string& element, const Host& host) {
    switch (value) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
            return CANDELA_WRAP_CLAMP_TO_EDGE;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
            return CANDELA_WRAP_MIRRORED_REPEAT;
        default:
            if (value != TINYGLTF_TEXTURE_WRAP_REPEAT) noteSampler(host, element, member, value);
            return CANDELA_WRAP_REPEAT;
    }
}

candela_filter minFilterOf(int value, const std::string& element, const Host& host) {
    constexpr int none = -1;
    switch (value) {
        case TINYGLTF_TEXTURE_FILTER_NEAREST:
            return CANDELA_FILTER_NEAREST;
        case TINYGLTF_TEXTURE_FILTER_LINEAR:
            return CANDELA_FILTER_LINEAR;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
            return CANDELA_FILTER_NEAREST_MIPMAP_NEAREST;
        case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
            return CANDELA_FILTER_LINEAR_MIPMAP_NEAREST;
        case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
            return CANDELA_FILTER_NEAREST_MIPMAP_LINEAR;
        default:
            if (value != none && value != TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR)
                noteSampler(host, element, "minFilter", value);
            return CANDELA_FILTER_LINEAR_MIPMAP_LINEAR;
    }
}

candela_filter magFilterOf(int value, const std::string& element, const Host& host) {
    constexpr int none = -1;
    if (value == TINYGLTF_TEXTURE_FILTER_NEAREST) return CANDELA_FILTER_NEAREST;
    if (value != none && value != TINYGLTF_TEXTURE_FILTER_LINEAR)
        noteSampler(host, element, "magFilter", value);
    return CANDELA_FILTER_LINEAR;
}

void applySampler(const Document& document, int index, const Host& host, candela_texture& texture) {
    if (index < 0) {
        texture.mag_filter = CANDELA_FILTER_LINEAR;
        return;
    }
    const tinygltf::Sampler& sampler = document.model.samplers.at(static_cast<std::size_t>(index));
    const std::string element = elementName("sampler", static_cast<std::size_t>(index), sampler.name);
    texture.wrap_s = wrapOf(sampler.wrapS, "wrapS", element, host);
    texture.wrap_t = wrapOf(sampler.wrapT, "wrapT", element, host);
    texture.min_filter = minFilterOf(sampler.minFilter, element, host);
    texture.mag_filter = magFilterOf(sampler.magFilter, element, host);
}

void applyTransform(const tinygltf::Value* transform, candela_texture& texture) {
    if (!transform) return;
    readNumbers(*transform, "offset", texture.offset);
    readNumbers(*transform, "scale", texture.scale);
    texture.rotation = numberOr(*transform, "rotation", 0.0f);
}

}  // namespace

const tinygltf::Texture& TextureReader::textureOf(const TextureUse& use) const {
    return document_.model.textures.at(static_cast<std::size_t>(use.texture));
}

void TextureReader::requireImage(const tinygltf::Texture& texture, std::size_t index) const {
    const std::string element = elementName("texture", index, texture.name);
    requireUsable(document_, element);
    if (texture.source >= 0) return;
    const std::string& extension = document_.imageExtensions.at(index);
    throw Failure{element, extension.empty() ? "no image"
                                             : "no PNG, JPEG, WebP or KTX2 image, but one of " + extension};
}

candela_texture TextureReader::read(const TextureUse& use) const {
    if (use.texture < 0) return noTexture();
    const tinygltf::Texture& source = textureOf(use);
    if (host_.leavesOut([&] { requireImage(source, static_cast<std::size_t>(use.texture)); }))
        return noTexture();
    return read(use, images_.indices.at(static_cast<std::size_t>(source.source)));
}

candela_texture TextureReader::readRoughness(const TextureUse& use, float glossinessFactor) const {
    if (use.texture < 0 || textureOf(use).source < 0) return noTexture();
    return read(use,
                images_.roughness.at({static_cast<std::size_t>(textureOf(use).source), glossinessFactor}));
}

candela_texture TextureReader::read(const TextureUse& use, std::int32_t image) const {
    candela_texture texture = noTexture();
    if (image < 0) return texture;  // It has a note of its own.
    const int slot = slots_.find(use.set);
    if (slot < 0) {
        host_.note(CANDELA_NOTE_MISSING, element_ + ", " + use.name,
                   "more sets of texture coordinates than a mesh may have, TEXCOORD_" +
                       std::to_string(use.set) + ": left out");
        return texture;
    }
    applySampler(document_, textureOf(use).sampler, host_, texture);
    applyTransform(use.transform, texture);
    texture.uv_set = static_cast<std::uint32_t>(slot);
    texture.image = image;
    return texture;
}

}  // namespace candela_plugins::gltf
