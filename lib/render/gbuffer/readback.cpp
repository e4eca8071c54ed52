#include "render/gbuffer/readback.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace candela {

namespace {

struct PixelFormat {
    GLenum format, type;
    std::size_t bytes;  ///< A pixel.
};

constexpr PixelFormat depthFormat{GL_DEPTH_COMPONENT, GL_FLOAT, 4};
constexpr PixelFormat colorFormat{GL_RGBA, GL_FLOAT, 16};
constexpr PixelFormat byteFormat{GL_RGBA, GL_UNSIGNED_BYTE, 4};

PixelFormat wordFormat(const GBufferWordTexture& texture) {
    return {texture.readFormat, texture.readType, texture.bytes};
}

/// `into` has rows of `width` pixels.
void read(const gl::Texture& texture, const gl::PixelRectangle& from, int width, const PixelFormat& pixel,
          void* into) {
    if (from.width == 0 || from.height == 0) return;
    // OpenGL takes the size as an int: targets of 2 GiB and more are read in bands.
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, width);
    const std::size_t rowBytes = static_cast<std::size_t>(width) * pixel.bytes;
    const std::size_t left = static_cast<std::size_t>(from.x) * pixel.bytes,
                      partBytes = static_cast<std::size_t>(from.width) * pixel.bytes;
    const int rows = static_cast<int>(std::max<std::size_t>(1, (std::size_t{1} << 30) / rowBytes));
    for (int y = from.y; y < from.y + from.height; y += rows) {
        const int count = std::min(rows, from.y + from.height - y);
        glGetTextureSubImage(texture.name(), 0, from.x, y, 0, from.width, count, 1, pixel.format, pixel.type,
                             static_cast<GLsizei>(rowBytes * static_cast<std::size_t>(count - 1) + partBytes),
                             static_cast<std::byte*>(into) + rowBytes * static_cast<std::size_t>(y) + left);
    }
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

void read(const gl::Texture& texture, int width, int height, const PixelFormat& pixel, void* into) {
    read(texture, {0, 0, width, height}, width, pixel, into);
}

template <typename T>
T readPixel(const gl::Texture& texture, int x, int y, const PixelFormat& pixel) {
    T value{};
    assert(sizeof value == pixel.bytes);
    glGetTextureSubImage(texture.name(), 0, x, y, 0, 1, 1, 1, pixel.format, pixel.type,
                         static_cast<GLsizei>(pixel.bytes), &value);
    return value;
}

std::size_t pixelCount(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

static_assert(sizeof(GBufferTexel) == surfaceTexture.bytes);

}  // namespace

gl::PixelRectangle wholeOf(const GBufferTargets& targets) {
    return {0, 0, targets.width, targets.height};
}

void readWords(const GBufferTargets& targets, const gl::PixelRectangle& from, int output,
               std::span<std::uint32_t> into) {
    const std::size_t index = targets.indexOf(output);
    assert(into.size_bytes() == targets.layout[index].bytes * pixelCount(targets.width, targets.height));
    read(targets.words[index], from, targets.width, wordFormat(targets.layout[index]), into.data());
}

void readOcclusion(const GBufferTargets& targets, const gl::PixelRectangle& from,
                   std::span<std::uint8_t> into) {
    const std::size_t index = targets.indexOf(layout::OCCLUSION_OUTPUT);
    assert(into.size() == pixelCount(targets.width, targets.height));
    read(targets.words[index], from, targets.width, wordFormat(targets.layout[index]), into.data());
}

void readDepth(const GBufferTargets& targets, const gl::PixelRectangle& from, std::span<float> into) {
    assert(into.size() == pixelCount(targets.width, targets.height));
    read(targets.depth, from, targets.width, depthFormat, into.data());
}

void readRadiance(const GBufferTargets& targets, const gl::PixelRectangle& from, std::span<float> into) {
    assert(into.size() == 4 * pixelCount(targets.width, targets.height));
    read(targets.radiance, from, targets.width, colorFormat, into.data());
}

std::vector<GBufferTexel> readSurfaces(const GBufferTargets& targets) {
    std::vector<GBufferTexel> texels(pixelCount(targets.width, targets.height));
    read(targets.words[0], targets.width, targets.height, wordFormat(targets.layout[0]), texels.data());
    return texels;
}

std::vector<float> readDepth(const GBufferTargets& targets) {
    std::vector<float> depth(pixelCount(targets.width, targets.height));
    readDepth(targets, wholeOf(targets), depth);
    return depth;
}

std::vector<float> readColor(const gl::Texture& texture, int width, int height) {
    std::vector<float> rgba(4 * pixelCount(width, height));
    read(texture, width, height, colorFormat, rgba.data());
    return rgba;
}

std::vector<std::uint8_t> readBytes(const gl::Texture& texture, int width, int height) {
    std::vector<std::uint8_t> rgba(4 * pixelCount(width, height));
    read(texture, width, height, byteFormat, rgba.data());
    return rgba;
}

std::uint64_t countLitSurfaces(const GBufferTargets& targets) {
    const auto surfaces = readSurfaces(targets);
    return static_cast<std::uint64_t>(
        std::ranges::count_if(surfaces, [](const GBufferTexel& texel) { return texel.y != 0; }));
}

GBufferTexel readSurfaceAt(const GBufferTargets& targets, int x, int y) {
    return readPixel<GBufferTexel>(targets.words[0], x, y, wordFormat(targets.layout[0]));
}

float readDepthAt(const GBufferTargets& targets, int x, int y) {
    return readPixel<float>(targets.depth, x, y, depthFormat);
}

glm::vec3 readColorAt(const gl::Texture& texture, int x, int y) {
    return glm::vec3(readPixel<glm::vec4>(texture, x, y, colorFormat));
}

}  // namespace candela
