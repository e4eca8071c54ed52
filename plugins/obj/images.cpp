#include "images.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace candela_plugins::obj {
namespace {

/// The source of a channel of a combined image: a channel of an image, or 1.
struct ChannelSource {
    const Image* image = nullptr;
    Channel channel = Channel::red;
};

constexpr std::uint32_t fullScale = 65535;

/// 0 to 65535.
std::uint32_t sampleAt(const Image& image, std::size_t texel, std::size_t channel) {
    const std::size_t index = texel * 4 + channel;
    if (image.sampleSize == SampleSize::bits8) return image.pixels[index] * 257u;
    std::uint16_t sample = 0;
    std::memcpy(&sample, &image.pixels[index * 2], sizeof sample);
    return sample;
}

std::uint32_t valueAt(const Image& image, std::size_t texel, Channel channel) {
    switch (channel) {
        case Channel::green:
            return sampleAt(image, texel, 1);
        case Channel::blue:
            return sampleAt(image, texel, 2);
        case Channel::matte:
            return sampleAt(image, texel, 3);
        case Channel::luminance:
            // Rec.709, of the encoded values; the weights add up to one, so that grey is unchanged.
            return (2126 * sampleAt(image, texel, 0) + 7152 * sampleAt(image, texel, 1) +
                    722 * sampleAt(image, texel, 2) + 5000) /
                   10000;
        default:
            return sampleAt(image, texel, 0);
    }
}

std::uint32_t valueOf(const ChannelSource& source, const Image& target, std::uint32_t x, std::uint32_t y) {
    if (!source.image) return fullScale;
    const Image& image = *source.image;
    const std::uint64_t column = std::uint64_t{x} * image.width / target.width;
    const std::uint64_t row = std::uint64_t{y} * image.height / target.height;
    return valueAt(image, row * image.width + column, source.channel);
}

void store(std::uint32_t value, std::size_t index, Image& image) {
    if (image.sampleSize == SampleSize::bits8) {
        image.pixels[index] = static_cast<std::uint8_t>((value + 128) / 257);
        return;
    }
    const auto sample = static_cast<std::uint16_t>(value);
    std::memcpy(&image.pixels[index * 2], &sample, sizeof sample);
}

/// Combines channels of several images in one of the size of the largest: others are scaled to it with the
/// nearest texel. It has 16 bits a sample where one of the images has.
Image combined(const std::array<ChannelSource, 4>& sources) {
    Image image;
    for (const ChannelSource& source : sources) {
        if (!source.image) continue;
        image.width = std::max(image.width, source.image->width);
        image.height = std::max(image.height, source.image->height);
        image.sampleSize = std::max(image.sampleSize, source.image->sampleSize);
    }
    const std::size_t texelSize = 4 * static_cast<std::size_t>(image.sampleSize);
    image.pixels.resize(std::size_t{image.width} * image.height * texelSize);
    std::size_t index = 0;
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            for (const ChannelSource& source : sources) store(valueOf(source, image, x, y), index++, image);
        }
    }
    return image;
}

/// The channel of a mask where none is named: alpha, where the image is not opaque everywhere, else the
/// luminance.
Channel maskChannel(const Image& image) {
    const std::size_t texels = std::size_t{image.width} * image.height;
    for (std::size_t i = 0; i < texels; ++i)
        if (sampleAt(image, i, 3) != fullScale) return Channel::matte;
    return Channel::luminance;
}

Channel channelOr(Channel channel, Channel usual) {
    return channel == Channel::usual ? usual : channel;
}

Image combinedColorAndMask(const std::optional<Image>& color, const Image& mask, Channel channel) {
    const Image* const rgb = color ? &*color : nullptr;
    const Channel alpha = channelOr(channel, maskChannel(mask));
    return combined({{{rgb, Channel::red}, {rgb, Channel::green}, {rgb, Channel::blue}, {&mask, alpha}}});
}

/// Identifies a part of a combined image. No path holds a line break: a statement is one line.
std::string keyOf(const TextureInfo* texture) {
    if (!texture) return "\n";
    return texture->file + "\n" + std::to_string(static_cast<int>(texture->channel)) + "\n";
}

}  // namespace

std::optional<Images::File> Images::read(const TextureInfo* texture) {
    if (!texture || ignoredFiles_.contains(texture->file)) return std::nullopt;
    const Bytes bytes = host_.readFile(texture->file);
    const std::string element = texture->element + " '" + readable(texture->file) + "'";
    if (isPng(bytes) || isJpeg(bytes)) return File{bytes, element};
    host_.note(CANDELA_NOTE_MISSING, element, otherFormat(bytes) + ": left out");
    ignoredFiles_.insert(texture->file);
    return std::nullopt;
}

template <typename MakeJob>
Images::Request Images::request(const std::string& key, const MakeJob& makeJob) {
    const auto [found, isNew] = requests_.try_emplace(key, jobs_.size());
    if (isNew) jobs_.push_back(makeJob());
    return found->second;
}

Images::Request Images::whole(const TextureInfo* texture) {
    const std::optional<File> file = read(texture);
    if (!file) return std::nullopt;
    return request(texture->file, [&] {
        return ImageJob{texture->file, decodedSize(file->bytes),
                        [file = *file] { return decodeImage(file.bytes, file.element); }};
    });
}

Images::Request Images::colorAndMask(const TextureInfo* color, const TextureInfo* mask) {
    const std::optional<File> maskFile = read(mask);
    if (!maskFile) return whole(color);
    const std::optional<File> colorFile = read(color);
    return request("mask\n" + keyOf(color) + keyOf(mask), [&] {
        const std::uint64_t colorSize = colorFile ? decodedSize(colorFile->bytes) : 0;
        const std::uint64_t maskSize = decodedSize(maskFile->bytes);
        const auto make = [colorFile, maskFile = *maskFile, channel = mask->channel] {
            const Image decodedMask = decodeImage(maskFile.bytes, maskFile.element);
            std::optional<Image> decodedColor;
            if (colorFile) decodedColor = decodeImage(colorFile->bytes, colorFile->element);
            return combinedColorAndMask(decodedColor, decodedMask, channel);
        };
        return ImageJob{mask->file, colorSize + maskSize + std::max(colorSize, maskSize), make};
    });
}

Images::Request Images::roughnessAndMetallic(const TextureInfo* roughness, const TextureInfo* metallic) {
    const std::optional<File> roughFile = read(roughness), metalFile = read(metallic);
    if (!roughFile && !metalFile) return std::nullopt;
    return request("metallic\n" + keyOf(roughness) + keyOf(metallic), [&] {
        const std::uint64_t roughSize = roughFile ? decodedSize(roughFile->bytes) : 0;
        const std::uint64_t metalSize = metalFile ? decodedSize(metalFile->bytes) : 0;
        const auto make = [roughFile, metalFile,
                           roughChannel = roughness ? roughness->channel : Channel::usual,
                           metalChannel = metallic ? metallic->channel : Channel::usual] {
            std::optional<Image> rough, metal;
            if (roughFile) rough = decodeImage(roughFile->bytes, roughFile->element);
            if (metalFile) metal = decodeImage(metalFile->bytes, metalFile->element);
            std::array<ChannelSource, 4> sources;
            if (rough) sources[1] = {&*rough, channelOr(roughChannel, Channel::luminance)};
            if (metal) sources[2] = {&*metal, channelOr(metalChannel, Channel::luminance)};
            return combined(sources);
        };
        return ImageJob{(roughFile ? roughness : metallic)->file,
                        roughSize + metalSize + std::max(roughSize, metalSize), make};
    });
}

void Images::addRequested(double from, double to) {
    indices_ = addImages(jobs_, host_, from, to);
    jobs_.clear();
}

}  // namespace candela_plugins::obj
