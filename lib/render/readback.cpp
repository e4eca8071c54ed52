#include "render/readback.h"

#include <algorithm>

namespace candela {

namespace {

template <typename Texel>
std::vector<Texel> read(const gl::Texture& texture, int width, int height, GLenum format, GLenum type,
                        std::size_t perPixel = 1) {
    std::vector<Texel> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * perPixel);
    // glGetTextureImage takes its size as an int: pictures of 2 GiB and more are read in bands.
    const std::size_t rowBytes = static_cast<std::size_t>(width) * perPixel * sizeof(Texel);
    const int rows = static_cast<int>(std::max<std::size_t>(1, (std::size_t{1} << 30) / rowBytes));
    for (int y = 0; y < height; y += rows) {
        const int count = std::min(rows, height - y);
        glGetTextureSubImage(
            texture.name(), 0, 0, y, 0, width, count, 1, format, type,
            static_cast<GLsizei>(rowBytes * static_cast<std::size_t>(count)),
            texels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * perPixel);
    }
    return texels;
}

}  // namespace

std::vector<GBufferTexel> readSurfaces(const GBufferTargets& targets) {
    return read<GBufferTexel>(targets.surface, targets.width, targets.height, GL_RG_INTEGER, GL_UNSIGNED_INT);
}

std::vector<float> readDepth(const GBufferTargets& targets) {
    return read<float>(targets.depth, targets.width, targets.height, GL_DEPTH_COMPONENT, GL_FLOAT);
}

std::vector<float> readColor(const gl::Texture& texture, int width, int height) {
    return read<float>(texture, width, height, GL_RGBA, GL_FLOAT, 4);
}

std::vector<std::uint8_t> readBytes(const gl::Texture& texture, int width, int height) {
    return read<std::uint8_t>(texture, width, height, GL_RGBA, GL_UNSIGNED_BYTE, 4);
}

std::uint64_t countLitSurfaces(const GBufferTargets& targets) {
    const auto surfaces = readSurfaces(targets);
    return static_cast<std::uint64_t>(
        std::ranges::count_if(surfaces, [](const GBufferTexel& texel) { return texel.y != 0; }));
}

}  // namespace candela
