#pragma once

#include <candela/image.h>
#include <candela/image_file.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace candela {

// Decoders of pictures of linear light. `path` is for messages. The result has the format rgba32f, linear
// Rec.709, rows from the top; values may be negative, infinite or no number. Each throws `Error` (badInput).

Image decodeRadiance(std::span<const std::byte> file, const std::string& path);
Image decodeExr(std::span<const std::byte> file, const std::string& path);

/// Refuses a picture whose sides are not 1 to 32768, or that has more than 2^27 pixels.
void requireHdrSize(const std::string& path, std::uint64_t width, std::uint64_t height);

/// Brings the colours of a picture to Rec.709 from other primaries.
void convertToRec709(Image& image, const Chromaticities& from, const std::string& path);

}  // namespace candela
