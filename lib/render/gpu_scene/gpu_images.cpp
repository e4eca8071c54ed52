#include "render/gpu_scene/gpu_images.h"

#include "base/error_context.h"
#include "render/gbuffer/srgb.h"

#include <candela/error.h>

#include <glm/gtc/packing.hpp>

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
    std::size_t texelSize;  ///< Bytes of one texel as it is transferred.
    bool decoded;           ///< Colour is decoded before the transfer.
};

UploadFormat formatOf(PixelFormat format, TextureContent content, ColorDecoding decoding) {
    const bool color = content == TextureContent::color;
    switch (format) {
        case PixelFormat::rgba8:
            if (!color) return {GL_RGBA8, GL_UNSIGNED_BYTE, 4, false};
            if (decoding == ColorDecoding::device) return {GL_SRGB8_ALPHA8, GL_UNSIGNED_BYTE, 4, false};
            // Half floats hold what 8 bits decode to within 1/40 of a code.
            return {GL_RGBA16F, GL_HALF_FLOAT, 8, true};
        case PixelFormat::rgba16:
            // OpenGL has no sRGB format of 16 bits.
            if (color) return {GL_RGBA32F, GL_FLOAT, 16, true};
            return {GL_RGBA16, GL_UNSIGNED_SHORT, 8, false};
        default:
            return {GL_RGBA32F, GL_FLOAT, 16, false};
    }
}

constexpr std::size_t alphaChannel = 3;

/// For each code of a channel the half float that it is.
std::array<std::uint16_t, 256> halfTable(bool color) {
    std::array<std::uint16_t, 256> table;
    for (std::size_t code = 0; code < table.size(); ++code) {
        const float value = static_cast<float>(code) / 255.0f;
        table[code] = glm::packHalf1x16(color ? srgbDecode(value) : value);
    }
    return table;
}

void decodeColor8(std::span<const std::byte> pixels, std::span<std::byte> decoded) {
    static const std::array<std::uint16_t, 256> color = halfTable(true), alpha = halfTable(false);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint16_t half =
            (i % 4 == alphaChannel ? alpha : color)[std::to_integer<std::size_t>(pixels[i])];
        std::memcpy(decoded.data() + i * sizeof half, &half, sizeof half);
    }
}

void decodeColor16(std::span<const std::byte> pixels, std::span<std::byte> decoded) {
    for (std::size_t i = 0; i < pixels.size() / sizeof(std::uint16_t); ++i) {
        std::uint16_t code = 0;
        std::memcpy(&code, pixels.data() + i * sizeof code, sizeof code);
        const float value = static_cast<float>(code) / 65535.0f;
        const float linear = i % 4 == alphaChannel ? value : srgbDecode(value);
        std::memcpy(decoded.data() + i * sizeof linear, &linear, sizeof linear);
    }
}

void encodeColor8(std::span<const std::byte> decoded, std::span<std::byte> pixels) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        std::uint16_t half = 0;
        std::memcpy(&half, decoded.data() + i * sizeof half, sizeof half);
        const float linear = glm::unpackHalf1x16(half);
        const float value = i % 4 == alphaChannel ? linear : srgbEncode(linear);
        pixels[i] = static_cast<std::byte>(std::lround(255.0f * value));
    }
}

void encodeColor16(std::span<const std::byte> decoded, std::span<std::byte> pixels) {
    for (std::size_t i = 0; i < pixels.size() / sizeof(std::uint16_t); ++i) {
        float linear = 0.0f;
        std::memcpy(&linear, decoded.data() + i * sizeof linear, sizeof linear);
        const float value = i % 4 == alphaChannel ? linear : srgbEncode(linear);
        const auto code = static_cast<std::uint16_t>(std::lround(65535.0f * value));
        std::memcpy(pixels.data() + i * sizeof code, &code, sizeof code);
    }
}

/// The alpha of a texel as a code of 8 bits.
std::uint8_t alphaCode(PixelFormat format, const std::byte* texel) {
    if (format == PixelFormat::rgba8) return std::to_integer<std::uint8_t>(texel[alphaChannel]);
    if (format == PixelFormat::rgba16) {
        std::uint16_t code = 0;
        std::memcpy(&code, texel + alphaChannel * sizeof code, sizeof code);
        return static_cast<std::uint8_t>((code + 128u) / 257u);
    }
    float value = 0.0f;
    std::memcpy(&value, texel + alphaChannel * sizeof value, sizeof value);
    return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

/// A run of an image's rows.
struct Rows {
    GLint first;
    GLsizei count;
    std::size_t offset, size;  ///< In the pixels, bytes.
};

/// Calls `transfer` for runs of rows that together are the image.
template <typename Transfer>
void forEachRun(const Image& image, std::size_t maxBytes, const Transfer& transfer) {
    const std::size_t rowBytes = std::size_t{image.width} * texelSize(image.format);
    const std::size_t maxRows = std::max<std::size_t>(1, maxBytes / rowBytes);
    for (std::size_t first = 0; first < image.height; first += maxRows) {
        const std::size_t count = std::min(maxRows, image.height - first);
        transfer(
            Rows{static_cast<GLint>(first), static_cast<GLsizei>(count), first * rowBytes, count * rowBytes});
    }
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

[[noreturn]] void refuse(const Image& image, std::uint32_t index, const std::string& reason) {
    throw Error(ErrorKind::limit, "",
                ErrorContext("image", index, image.name).label() + " is " + std::to_string(image.width) +
                    "x" + std::to_string(image.height) + " pixels, but " + reason);
}

void requireSize(const Image& image, std::uint32_t index) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const auto max = static_cast<std::uint32_t>(largest);
    if (image.width <= max && image.height <= max) return;
    refuse(image, index, "this device holds " + std::to_string(max) + "x" + std::to_string(max) + " at most");
}

/// A texture with storage for the image and its mipmaps.
gl::Texture allocate(const Image& image, std::uint32_t index, GLenum format) {
    requireSize(image, index);
    gl::Texture texture(GL_TEXTURE_2D, image.name.empty() ? "image" : image.name.substr(0, 64).c_str());
    while (glGetError() != GL_NO_ERROR) {
    }
    glTextureStorage2D(texture.name(), std::bit_width(std::max(image.width, image.height)), format,
                       static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height));
    if (glGetError() == GL_OUT_OF_MEMORY) refuse(image, index, "the device has no memory for it");
    return texture;
}

gl::Texture whiteTexture() {
    gl::Texture white = gl::Texture::target2d(GL_RGBA8, 1, 1, "white");
    constexpr std::array<std::uint8_t, 4> texel{255, 255, 255, 255};
    glTextureSubImage2D(white.name(), 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    return white;
}

}  // namespace

GpuImages::GpuImages(std::span<const Image> images, ColorDecoding decoding, std::size_t maxTransferBytes)
    : decoding_(decoding), maxTransferBytes_(maxTransferBytes), images_(images), white_(whiteTexture()) {}

SampledTexture GpuImages::get(const std::optional<Texture>& texture, TextureContent content) {
    if (!texture) return {white_.name(), 0};
    return {upload(texture->image, content), sampler(*texture)};
}

void GpuImages::takeSources(std::span<Image> images) {
    for (Image& image : images)
        kept_.push_back({image.name, image.width, image.height, image.format, std::move(image.pixels)});
    images_ = kept_;
}

void GpuImages::releaseSources() {
    if (!kept_.empty()) return;
    for (std::uint32_t i = 0; i < images_.size(); ++i) {
        const Image& image = images_[i];
        const bool uploaded =
            textures_.contains({i, TextureContent::color}) || textures_.contains({i, TextureContent::data});
        kept_.push_back({image.name, image.width, image.height, image.format,
                         uploaded ? std::vector<std::byte>{} : image.pixels});
    }
    images_ = kept_;
}

std::vector<std::byte> GpuImages::readPixels(GLuint texture, TextureContent content,
                                             const Image& image) const {
    std::vector<std::byte> pixels(std::size_t{image.width} * image.height * texelSize(image.format));
    const UploadFormat format = formatOf(image.format, content, decoding_);
    forEachRun(image, maxTransferBytes_, [&](const Rows& rows) {
        const std::span<std::byte> part = std::span(pixels).subspan(rows.offset, rows.size);
        std::vector<std::byte> decoded(
            format.decoded ? part.size() / texelSize(image.format) * format.texelSize : 0);
        const std::span<std::byte> into = format.decoded ? std::span(decoded) : part;
        glGetTextureSubImage(texture, 0, 0, rows.first, 0, static_cast<GLsizei>(image.width), rows.count, 1,
                             GL_RGBA, format.type, static_cast<GLsizei>(into.size()), into.data());
        if (!format.decoded) return;
        image.format == PixelFormat::rgba8 ? encodeColor8(decoded, part) : encodeColor16(decoded, part);
    });
    return pixels;
}

void GpuImages::writePixels(GLuint texture, TextureContent content, const Image& image) const {
    forEachRun(image, maxTransferBytes_, [&](const Rows& rows) {
        const ImageRegion region{0, static_cast<std::uint32_t>(rows.first), image.width,
                                 static_cast<std::uint32_t>(rows.count)};
        writeRegion(texture, content, image.format, region,
                    std::span(image.pixels).subspan(rows.offset, rows.size));
    });
}

void GpuImages::writeRegion(GLuint texture, TextureContent content, PixelFormat pixelFormat,
                            const ImageRegion& region, std::span<const std::byte> pixels) const {
    const UploadFormat format = formatOf(pixelFormat, content, decoding_);
    std::vector<std::byte> decoded;
    if (format.decoded) {
        decoded.resize(pixels.size() / texelSize(pixelFormat) * format.texelSize);
        pixelFormat == PixelFormat::rgba8 ? decodeColor8(pixels, decoded) : decodeColor16(pixels, decoded);
        pixels = decoded;
    }
    glTextureSubImage2D(texture, 0, static_cast<GLint>(region.x), static_cast<GLint>(region.y),
                        static_cast<GLsizei>(region.width), static_cast<GLsizei>(region.height), GL_RGBA,
                        format.type, pixels.data());
}

std::optional<std::vector<std::byte>> GpuImages::uploadedPixels(std::uint32_t index) const {
    for (const TextureContent content : {TextureContent::color, TextureContent::data}) {
        const auto texture = textures_.find({index, content});
        if (texture != textures_.end()) return readPixels(texture->second.name(), content, images_[index]);
    }
    return std::nullopt;
}

void GpuImages::restorePixels(std::uint32_t index) {
    if (std::optional<std::vector<std::byte>> pixels = uploadedPixels(index))
        kept_[index].pixels = std::move(*pixels);
}

AlphaImage GpuImages::readAlpha(std::uint32_t index) const {
    const Image& image = images_[index];
    std::vector<std::byte> uploaded;
    if (image.pixels.empty()) uploaded = uploadedPixels(index).value_or(std::vector<std::byte>{});
    const std::span<const std::byte> pixels = image.pixels.empty() ? uploaded : image.pixels;
    AlphaImage alpha{image.width, image.height, {}};
    alpha.alpha.resize(std::size_t{image.width} * image.height);
    for (std::size_t i = 0; i < alpha.alpha.size(); ++i)
        alpha.alpha[i] = alphaCode(image.format, pixels.data() + i * texelSize(image.format));
    return alpha;
}

gl::Texture GpuImages::makeTexture(const Image& image, std::uint32_t index, TextureContent content) const {
    gl::Texture texture = allocate(image, index, formatOf(image.format, content, decoding_).internal);
    writePixels(texture.name(), content, image);
    glGenerateTextureMipmap(texture.name());
    return texture;
}

GLuint GpuImages::upload(std::uint32_t index, TextureContent content) {
    const auto known = textures_.find({index, content});
    if (known != textures_.end()) return known->second.name();
    if (images_[index].pixels.empty()) restorePixels(index);
    gl::Texture texture = makeTexture(images_[index], index, content);
    if (!kept_.empty()) kept_[index].pixels = std::vector<std::byte>();
    return textures_.emplace(Key(index, content), std::move(texture)).first->second.name();
}

void GpuImages::set(std::uint32_t index, const Image& image) {
    if (index >= kept_.size()) kept_.resize(index + 1);
    kept_[index] = image;
    images_ = kept_;
}

void GpuImages::replace(std::uint32_t index, const Image& image) {
    std::vector<std::pair<Key, gl::Texture>> made;
    for (const TextureContent content : {TextureContent::color, TextureContent::data}) {
        if (textures_.contains({index, content}))
            made.emplace_back(Key(index, content), makeTexture(image, index, content));
    }
    set(index, image);
    if (!made.empty()) kept_[index].pixels = std::vector<std::byte>();
    for (auto& [key, texture] : made) textures_[key] = std::move(texture);
}

void GpuImages::remove(std::uint32_t index) {
    kept_[index] = {};
    for (const TextureContent content : {TextureContent::color, TextureContent::data})
        textures_.erase({index, content});
}

void GpuImages::setPixels(std::uint32_t index, const ImageRegion& region, std::span<const std::byte> pixels) {
    const Image& image = images_[index];
    for (const TextureContent content : {TextureContent::color, TextureContent::data}) {
        const auto texture = textures_.find({index, content});
        if (texture == textures_.end()) continue;
        writeRegion(texture->second.name(), content, image.format, region, pixels);
        glGenerateTextureMipmap(texture->second.name());
    }
    if (image.pixels.empty()) return;
    const std::size_t texel = texelSize(image.format), rowBytes = region.width * texel;
    for (std::size_t row = 0; row < region.height; ++row) {
        const std::size_t to = ((region.y + row) * image.width + region.x) * texel;
        std::memcpy(kept_[index].pixels.data() + to, pixels.data() + row * rowBytes, rowBytes);
    }
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
