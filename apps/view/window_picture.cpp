#include "window_picture.h"

#include <candela/image_file.h>

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>
#include <vector>

void writeWindowPicture(const std::filesystem::path& file, const glm::ivec2& size) {
    const auto row = static_cast<std::ptrdiff_t>(size.x) * 4;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(row) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::ptrdiff_t y = 0; y < size.y / 2; ++y)
        std::swap_ranges(pixels.begin() + y * row, pixels.begin() + (y + 1) * row,
                         pixels.begin() + (size.y - 1 - y) * row);
    for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    candela::writePng(file, static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y), pixels,
                      candela::DisplayEncoding{});
}
