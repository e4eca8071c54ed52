#include <webp/decode.h>

#include <cstring>

#include "image.h"

namespace candela_plugins {
namespace {

WebPBitstreamFeatures featuresOf(const Bytes& file, const std::string& element) {
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(file.data, file.size, &features) != VP8_STATUS_OK)
        throw Failure{element, "the WebP file is broken: its header cannot be read"};
    return features;
}

}  // namespace

bool isWebp(const Bytes& file) {
    constexpr std::uint64_t headerSize = 12;
    return file.size >= headerSize && std::memcmp(file.data, "RIFF", 4) == 0 &&
           std::memcmp(file.data + 8, "WEBP", 4) == 0;
}

std::uint64_t decodedWebpSize(const Bytes& file) {
    int width = 0, height = 0;
    if (WebPGetInfo(file.data, file.size, &width, &height) == 0) return 0;
    return std::uint64_t(width) * static_cast<std::uint64_t>(height) * 4;
}

Image decodeWebp(const Bytes& file, const std::string& element) {
    const WebPBitstreamFeatures features = featuresOf(file, element);
    if (features.has_animation != 0) throw Failure{element, "an animated WebP file, expected one picture"};
    // An image of one colour takes a few bytes whatever its size; a larger one is believed for its length.
    constexpr std::uint64_t maxTexels = std::uint64_t(4096) * 4096, maxTexelsPerByte = 65536;
    const auto width = static_cast<std::uint32_t>(features.width),
               height = static_cast<std::uint32_t>(features.height);
    const std::uint64_t texels = std::uint64_t(width) * height;
    if (texels > maxTexels && texels / maxTexelsPerByte > file.size)
        throw Failure{element, "the WebP file is broken: it is too short for its width and height"};
    Image image{width, height, SampleSize::bits8, {}};
    image.pixels.resize(texels * 4);
    if (!WebPDecodeRGBAInto(file.data, file.size, image.pixels.data(), image.pixels.size(),
                            features.width * 4))
        throw Failure{element, "the WebP file is broken or cut off"};
    return image;
}

}  // namespace candela_plugins
