#include "render/gbuffer/readback.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace candela {

namespace {

struct Layout {
    GLenum format, type;
    std::size_t bytes;  ///< A pixel.
};

void read(const gl::Texture& texture, int width, int height, const Layout& layout, void* into) {
    // OpenGL takes the size as an int: pictures of 2 GiB and more are read in bands.
    const std::size_t rowBytes = static_cast<std::size_t>(width) * layout.bytes;
    const int rows = static_cast<int>(std::max<std::size_t>(1, (std::size_t{1} << 30) / rowBytes));
    for (int y = 0; y < height; y += rows) {
        const int count = std::min(rows, height - y);
        glGetTextureSubImage(texture.name(), 0, 0, y, 0, width, count, 1, layout.format, layout.type,
                             static_cast<GLsizei>(rowBytes * static_cast<std::size_t>(count)),
                             static_cast<std::byte*>(into) + rowBytes * static_cast<std::size_t>(y));
    }
}

std::size_t pixelCount(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

void readSurfaces(const GBufferTargets& targets, std::span<std::uint32_t> into) {
    assert(into.size() == 2 * pixelCount(targets.width, targets.height));
    read(targets.surface, targets.width, targets.height, {GL_RG_INTEGER, GL_UNSIGNED_INT, 8}, into.data());
}

void readDepth(const GBufferTargets& targets, std::span<float> into) {
    assert(into.size() == pixelCount(targets.width, targets.height));
    read(targets.depth, targets.width, targets.height, {GL_DEPTH_COMPONENT, GL_FLOAT, 4}, into.data());
}

void readColor(const gl::Texture& texture, int width, int height, std::span<float> into) {
    assert(into.size() == 4 * pixelCount(width, height));
    read(texture, width, height, {GL_RGBA, GL_FLOAT, 16}, into.data());
}

std::vector<GBufferTexel> readSurfaces(const GBufferTargets& targets) {
    std::vector<GBufferTexel> texels(pixelCount(targets.width, targets.height));
    static_assert(sizeof(GBufferTexel) == 8);
    read(targets.surface, targets.width, targets.height, {GL_RG_INTEGER, GL_UNSIGNED_INT, 8}, texels.data());
    return texels;
}

std::vector<float> readDepth(const GBufferTargets& targets) {
    std::vector<float> depth(pixelCount(targets.width, targets.height));
    readDepth(targets, depth);
    return depth;
}

std::vector<float> readColor(const gl::Texture& texture, int width, int height) {
    std::vector<float> rgba(4 * pixelCount(width, height));
    readColor(texture, width, height, rgba);
    return rgba;
}

std::vector<std::uint8_t> readBytes(const gl::Texture& texture, int width, int height) {
    std::vector<std::uint8_t> rgba(4 * pixelCount(width, height));
    read(texture, width, height, {GL_RGBA, GL_UNSIGNED_BYTE, 4}, rgba.data());
    return rgba;
}

std::uint64_t countLitSurfaces(const GBufferTargets& targets) {
    const auto surfaces = readSurfaces(targets);
    return static_cast<std::uint64_t>(
        std::ranges::count_if(surfaces, [](const GBufferTexel& texel) { return texel.y != 0; }));
}

}  // namespace candela
