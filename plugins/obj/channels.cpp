#include "channels.h"

#include <algorithm>
#include <cstring>

namespace candela_obj {
namespace {

using candela_importers::SampleSize;

constexpr std::uint32_t fullScale = 65535;

/// 0 to 65535.
std::uint32_t sampleAt(const Picture& picture, std::size_t texel, std::size_t channel) {
    const std::size_t index = texel * 4 + channel;
    if (picture.sampleSize == SampleSize::bits8) return picture.pixels[index] * 257u;
    std::uint16_t sample = 0;
    std::memcpy(&sample, &picture.pixels[index * 2], sizeof sample);
    return sample;
}

std::uint32_t valueAt(const Picture& picture, std::size_t texel, Channel channel) {
    switch (channel) {
        case Channel::green:
            return sampleAt(picture, texel, 1);
        case Channel::blue:
            return sampleAt(picture, texel, 2);
        case Channel::matte:
            return sampleAt(picture, texel, 3);
        case Channel::luminance:
            // Rec.709, of the encoded values; the weights add up to one, so that grey stays what it is.
            return (2126 * sampleAt(picture, texel, 0) + 7152 * sampleAt(picture, texel, 1) +
                    722 * sampleAt(picture, texel, 2) + 5000) /
                   10000;
        default:
            return sampleAt(picture, texel, 0);
    }
}

std::uint32_t valueOf(const ChannelSource& source, const Picture& target, std::uint32_t x, std::uint32_t y) {
    if (!source.picture) return static_cast<std::uint32_t>(source.constant * fullScale + 0.5f);
    const Picture& picture = *source.picture;
    const std::uint64_t column = std::uint64_t{x} * picture.width / target.width;
    const std::uint64_t row = std::uint64_t{y} * picture.height / target.height;
    return valueAt(picture, row * picture.width + column, source.channel);
}

void store(std::uint32_t value, std::size_t index, Picture& picture) {
    if (picture.sampleSize == SampleSize::bits8) {
        picture.pixels[index] = static_cast<std::uint8_t>((value + 128) / 257);
        return;
    }
    const auto sample = static_cast<std::uint16_t>(value);
    std::memcpy(&picture.pixels[index * 2], &sample, sizeof sample);
}

}  // namespace

Picture combined(const std::array<ChannelSource, 4>& sources) {
    Picture picture;
    for (const ChannelSource& source : sources) {
        if (!source.picture) continue;
        picture.width = std::max(picture.width, source.picture->width);
        picture.height = std::max(picture.height, source.picture->height);
        picture.sampleSize = std::max(picture.sampleSize, source.picture->sampleSize);
    }
    const std::size_t texelSize = 4 * static_cast<std::size_t>(picture.sampleSize);
    picture.pixels.resize(std::size_t{picture.width} * picture.height * texelSize);
    std::size_t index = 0;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            for (const ChannelSource& source : sources)
                store(valueOf(source, picture, x, y), index++, picture);
        }
    }
    return picture;
}

Channel maskChannel(const Picture& picture) {
    const std::size_t texels = std::size_t{picture.width} * picture.height;
    for (std::size_t i = 0; i < texels; ++i)
        if (sampleAt(picture, i, 3) != fullScale) return Channel::matte;
    return Channel::luminance;
}

}  // namespace candela_obj
