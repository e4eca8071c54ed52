#pragma once

#include "gltf_file.h"

namespace candela_test {

enum class PngColor { grey = 0, rgb = 2, rgba = 6 };

/// A PNG file of these samples (8 bits each, or 16 bits each, big-endian), uncompressed.
Bytes makePng(std::uint32_t width, std::uint32_t height, int bitDepth, PngColor color, const Bytes& samples);

/// An 8-bit RGBA file of one colour.
Bytes makePng(std::uint32_t width, std::uint32_t height, std::uint8_t r, std::uint8_t g, std::uint8_t b,
              std::uint8_t a);

/// A JPEG file of 8 × 8 texels, all of them the grey 192.
Bytes makeGreyJpeg();

}  // namespace candela_test
