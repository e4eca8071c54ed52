#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace candela {

/// How the texels of an `Image` are stored; rows from the top, tightly packed.
enum class PixelFormat {
    rgba8,    ///< 4 × uint8_t, normalised. Whether colour is sRGB-encoded follows from the use (see
              ///< `Material`).
    rgba16,   ///< 4 × uint16_t, normalised, host byte order.
    rgba32f,  ///< 4 × float, linear.
};

/// Bytes of one texel.
constexpr std::size_t texelSize(PixelFormat format) {
    return format == PixelFormat::rgba8 ? 4 : format == PixelFormat::rgba16 ? 8 : 16;
}

/// A picture that materials refer to.
struct Image {
    std::string name = {};
    std::uint32_t width = 0, height = 0;  ///< 1 to 32768.
    PixelFormat format = PixelFormat::rgba8;
    std::vector<std::byte> pixels = {};  ///< width × height × texelSize(format) bytes.
};

}  // namespace candela
