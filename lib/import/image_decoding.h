#pragma once

#include <candela/image.h>
#include <candela/plugin.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace candela {

/// A decoded file, or why there is none.
struct DecodedImage {
    std::optional<Image> image;
    std::string reason;  ///< One line; empty with an image.
};

/// Decodes a file of an image with the first of `decoders` that recognises it. `index` is that of the image,
/// for messages. Throws nothing but `std::bad_alloc`.
DecodedImage decodeImage(std::span<const candela_plugin* const> decoders, const candela_image_bytes& file,
                         std::size_t index);

}  // namespace candela
