#pragma once

#include <vector>

#include "failure.h"

namespace candela_importers {

enum class SampleSize : std::size_t { bits8 = 1, bits16 = 2 };

/// A decoded picture: RGBA, rows from the top, tightly packed; 16-bit samples in the machine's byte order.
struct Picture {
    std::uint32_t width = 0, height = 0;
    SampleSize sampleSize = SampleSize::bits8;
    std::vector<std::uint8_t> pixels;
};

// The largest width and height the host takes.
inline constexpr std::uint32_t maxSide = 32768;

// tinygltf's own decoder, stb_image, is not used: Debian's build stops the process by an assertion on some
// damaged JPEG files, and it reads damaged PNG files without a word.

bool isPng(const Bytes& file);
bool isJpeg(const Bytes& file);

/// Decodes a PNG file; 16-bit samples are kept, all others become 8 bits. Colour profiles and gamma are
/// ignored, as glTF 2.0, 3.8.3 asks. Throws `Failure` for `element` when the file is damaged or cut off.
Picture decodePng(const Bytes& file, const std::string& element);

/// Decodes a JPEG file of grey or colour. Throws `Failure` for `element` when the file is damaged or cut off.
Picture decodeJpeg(const Bytes& file, const std::string& element);

}  // namespace candela_importers
