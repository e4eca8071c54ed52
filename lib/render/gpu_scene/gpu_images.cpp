#include "render/gpu_scene/gpu_images.h"

#include "render/gbuffer/srgb.h"

#include <candela/error.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace candela {

namespace {

struct UploadFormat {
    GLenum internal, type;
};

UploadFormat formatOf(const Image& image, TextureInfo use) {
    switch (image.format) {
        case PixelFormat::rgba8:
            return {use == TextureInfo::color ? GLenum(GL_SRGB8_ALPHA8) : GLenum(GL_RGBA8), GL_UNSIGNED_BYTE};
        case PixelFormat::rgba16:
            return {GL_RGBA16, GL_UNSIGNED_SHORT};
        default:
            return {GL_RGBA32F, GL_FLOAT};
    }
}

/// OpenGL has no sRGB format of 16 bits: such colour is decoded to floats here.
std::vector<float> decodeColor16(const Image& image) {
    std::vector<std::uint16_t> codes(image.pixels.size() / sizeof(std::uint16_t));
    std::memcpy(codes.data(), image.pixels.data(), codes.size() * sizeof(std::uint16_t));
    std::vector<float> decoded(codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const float value = static_cast<float>(codes[i]) / 65535.0f;
        decoded[i] = i % 4 == 3 ? value : srgbDecode(value);
    }
    return decoded;
}

GLint wrapMode(Wrap wrap) {
    switch (wrap) {
        case Wrap::clampToEdge:
            return GL_CLAMP_TO_EDGE;
        case Wrap::mirroredRepeat:
            return GL_MIRRORED_REPEAT;
        default:
            return GL_REPEAT;
    }
}

GLint filterMode(Filter filter) {
    switch (filter) {
        case Filter::nearest:
            return GL_NEAREST;
        case Filter::linear:
            return GL_LINEAR;
        case Filter::nearestMipmapNearest:
            return GL_NEAREST_MIPMAP_NEAREST;
        case Filter::linearMipmapNearest:
            return GL_LINEAR_MIPMAP_NEAREST;
        case Filter::nearestMipmapLinear:
            return GL_NEAREST_MIPMAP_LINEAR;
        default:
            return GL_LINEAR_MIPMAP_LINEAR;
    }
}

/// The pixels of an image from which `texture` was made for `use`.
std::vector<std::byte> readPixels(GLuint texture, TextureInfo use, const Image& image) {
    std::vector<std::byte> pixels(std::size_t{image.width} * image.height * texelSize(image.format));
    if (use == TextureInfo::data || image.format != PixelFormat::rgba16) {
        glGetTextureImage(texture, 0, GL_RGBA, formatOf(image, use).type, static_cast<GLsizei>(pixels.size()),
                          pixels.data());
        return pixels;
    }
    std::vector<float> decoded(pixels.size() / sizeof(std::uint16_t));
    glGetTextureImage(texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(decoded.size() * sizeof(float)),
                      decoded.data());
    std::vector<std::uint16_t> codes(decoded.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const float value = i % 4 == 3 ? decoded[i] : srgbEncode(decoded[i]);
        codes[i] = static_cast<std::uint16_t>(std::lround(65535.0f * value));
    }
    std::memcpy(pixels.data(), codes.data(), pixels.size());
    return pixels;
}

void requireSize(const Image& image, std::uint32_t index) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(image.width, image.height) <= static_cast<std::uint32_t>(largest)) return;
    throw Error(ErrorKind::limit, "",
                "image " + std::to_string(index) + " '" + image.name + "' is " + std::to_string(image.width) +
                    "x" + std::to_string(image.height) + " pixels, but this device holds " +
                    std::to_string(largest) + "x" + std::to_string(largest) + " at most");
}

gl::Texture whiteTexture() {
    gl::Texture white = gl::Texture::target2d(GL_RGBA8, 1, 1, "white");
    constexpr std::array<std::uint8_t, 4> texel{255, 255, 255, 255};
    glTextureSubImage2D(white.name(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    return white;
}

}  // namespace

GpuImages::GpuImages(std::span<const Image> images) : images_(images), white_(whiteTexture()) {}

SampledTexture GpuImages::get(const std::optional<Texture>& texture, TextureInfo use) {
    if (!texture) return {white_.name(), 0};
    return {upload(texture->image, use), sampler(*texture)};
}

void GpuImages::forgetSources() {
    for (std::uint32_t i = 0; i < images_.size(); ++i) {
        const Image& image = images_[i];
        const bool uploaded =
            textures_.contains({i, TextureInfo::color}) || textures_.contains({i, TextureInfo::data});
        kept_.push_back({image.name, image.width, image.height, image.format,
                         uploaded ? std::vector<std::byte>{} : image.pixels});
    }
    images_ = kept_;
}

void GpuImages::restorePixels(std::uint32_t index) {
    for (const TextureInfo use : {TextureInfo::color, TextureInfo::data}) {
        const auto texture = textures_.find({index, use});
        if (texture == textures_.end()) continue;
        kept_[index].pixels = readPixels(texture->second.name(), use, kept_[index]);
        return;
    }
}

GLuint GpuImages::upload(std::uint32_t index, TextureInfo use) {
    const auto known = textures_.find({index, use});
    if (known != textures_.end()) return known->second.name();
    requireSize(images_[index], index);
    if (images_[index].pixels.empty()) restorePixels(index);
    const Image& image = images_[index];
    gl::Texture texture(GL_TEXTURE_2D, image.name.empty() ? "image" : image.name.substr(0, 64).c_str());
    const auto width = static_cast<GLsizei>(image.width), height = static_cast<GLsizei>(image.height);
    const auto levels = static_cast<GLsizei>(std::bit_width(std::max(image.width, image.height)));
    const bool decode = use == TextureInfo::color && image.format == PixelFormat::rgba16;
    const UploadFormat format = decode ? UploadFormat{GL_RGBA32F, GL_FLOAT} : formatOf(image, use);
    glTextureStorage2D(texture.name(), levels, format.internal, width, height);
    if (decode) {
        glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, format.type,
                            decodeColor16(image).data());
    } else {
        glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, format.type,
                            image.pixels.data());
    }
    glGenerateTextureMipmap(texture.name());
    if (!kept_.empty()) kept_[index].pixels.clear();
    return textures_.emplace(std::pair(index, use), std::move(texture)).first->second.name();
}

GLuint GpuImages::sampler(const Texture& texture) {
    const std::tuple key(texture.wrapS, texture.wrapT, texture.minFilter, texture.magFilter);
    const auto known = samplers_.find(key);
    if (known != samplers_.end()) return known->second.name();
    gl::Sampler sampler("material sampler");
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, wrapMode(texture.wrapS));
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, wrapMode(texture.wrapT));
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, filterMode(texture.minFilter));
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER,
                        texture.magFilter == Filter::nearest ? GL_NEAREST : GL_LINEAR);
    return samplers_.emplace(key, std::move(sampler)).first->second.name();
}

}  // namespace candela
