#include "render/display/display_target.h"

#include "render/gbuffer/readback.h"

#include <candela/error.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace candela {

namespace {

template <typename T>
void flip(std::vector<T>& pixels, int width, int height) {
    const auto row = static_cast<std::ptrdiff_t>(width) * 4;
    for (std::ptrdiff_t y = 0; y < height / 2; ++y) {
        std::swap_ranges(pixels.begin() + y * row, pixels.begin() + (y + 1) * row,
                         pixels.begin() + (height - 1 - y) * row);
    }
}

}  // namespace

DisplayTarget::DisplayTarget(int pixelsWide, int pixelsHigh)
    : width(pixelsWide),
      height(pixelsHigh),
      texture(gl::Texture::target2d(GL_RGBA8, width, height, "display")),
      framebuffer({&texture}, nullptr, "display") {}

std::vector<std::uint8_t> DisplayTarget::read() const {
    std::vector<std::uint8_t> pixels = readBytes(texture, width, height);
    flipRows(pixels, width, height);
    return pixels;
}

void requireTarget(const FrameTarget& target) {
    const bool exists = target.framebuffer == 0 || glIsFramebuffer(target.framebuffer) == GL_TRUE;
    if (exists &&
        glCheckNamedFramebufferStatus(target.framebuffer, GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        return;
    throw Error(ErrorKind::badInput, "",
                "framebuffer " + std::to_string(target.framebuffer) +
                    (exists ? " is incomplete; a frame is displayed in a complete one"
                            : " does not exist in the current context"));
}

HdrImage wholeRadiance(int width, int height, std::vector<float> rgba, std::span<const float> depth) {
    HdrImage image{width, height, std::move(rgba)};
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] > 0.0f) image.rgba[4 * i + 3] = 1.0f;
    }
    flipRows(image.rgba, width, height);
    return image;
}

void flipRows(std::vector<float>& rgba, int width, int height) {
    flip(rgba, width, height);
}

void flipRows(std::vector<std::uint8_t>& rgba, int width, int height) {
    flip(rgba, width, height);
}

}  // namespace candela
