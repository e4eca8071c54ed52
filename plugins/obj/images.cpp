#include "images.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "references.h"

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

bool isOpaque(const Image& image) {
    return maskChannel(image) != Channel::matte;
}

Channel channelOr(Channel channel, Channel usual) {
    return channel == Channel::usual ? usual : channel;
}

/// Whether the colours are on average the vector +z as a tangent-space normal map encodes it, (0.5, 0.5, 1).
/// The limits let steep maps pass; heights are grey, so that their means are equal.
bool holdsNormals(const Image& image) {
    const std::size_t texels = std::size_t{image.width} * image.height;
    double sums[3] = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < texels; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel) sums[channel] += sampleAt(image, i, channel);
    const auto mean = [&](std::size_t channel) {
        return sums[channel] / (double{fullScale} * double(texels));
    };
    const auto isCentral = [](double value) { return value > 0.35 && value < 0.65; };
    return isCentral(mean(0)) && isCentral(mean(1)) && mean(2) > 0.7;
}

/// Identifies a part of a combined image. No path holds a line break: a statement is one line.
std::string keyOf(const std::string& path, const TextureInfo* texture) {
    if (!texture) return "\n";
    return path + "\n" + std::to_string(static_cast<int>(texture->channel)) + "\n";
}

}  // namespace

std::optional<Images::File> Images::find(const TextureInfo& texture) {
    std::string reason;
    for (const std::string& name : texture.names) {
        const std::string element = texture.element + " " + inQuotes(name);
        const ReferencedFile found = findReferenced(texture.owner, name, element, host_);
        if (found.bytes) {
            const File file{*found.bytes, found.path, element};
            if (isPng(file.bytes) || isJpeg(file.bytes)) return file;
            host_.noteLeftOut({element, otherFormat(file.bytes)});
            return std::nullopt;
        }
        if (reason.empty()) reason = found.reason;
    }
    host_.noteLeftOut({texture.element + " " + inQuotes(texture.names.front()), reason});
    return std::nullopt;
}

std::optional<Images::File> Images::read(const TextureInfo* texture) {
    if (!texture) return std::nullopt;
    const std::string key = texture->owner + "\n" + texture->names.front();
    const auto known = files_.find(key);
    return known != files_.end() ? known->second : files_[key] = find(*texture);
}

const TextureInfo* Images::usable(const std::optional<TextureInfo>& texture) const {
    if (!texture) return nullptr;
    const std::optional<File>& file = files_.at(texture->owner + "\n" + texture->names.front());
    return file && !unusablePaths_.contains(file->path) ? &*texture : nullptr;
}

Images::Request Images::request(const std::string& key, const Files& files,
                                std::function<Image(Decoded&, Outcome&)> make) {
    const auto [found, isNew] = requests_.try_emplace(key, jobs_.size());
    if (!isNew) return found->second;
    const auto outcome = outcomes_.emplace_back(std::make_shared<Outcome>());
    const auto makeUsable = [files, outcome, make = std::move(make)] {
        Decoded decoded;
        for (std::size_t i = 0; i < files.size(); ++i) {
            try {
                if (files[i]) decoded[i] = decodeImage(files[i]->bytes, files[i]->element);
            } catch (const Failure& failure) {
                outcome->faults.push_back({files[i]->path, failure});
            }
        }
        if (!decoded[0] && !decoded[1]) throw outcome->faults.front().failure;
        return make(decoded, *outcome);
    };
    std::uint64_t bytes = 0, largest = 0;
    for (const std::optional<File>& file : files) {
        const std::uint64_t size = file ? decodedSize(file->bytes) : 0;
        bytes += size;
        largest = std::max(largest, size);
    }
    const bool combines = files[0] && files[1];
    jobs_.push_back({(files[0] ? files[0] : files[1])->path, bytes + (combines ? largest : 0), makeUsable});
    return found->second;
}

Images::Request Images::whole(const TextureInfo* texture) {
    const std::optional<File> file = read(texture);
    if (!file) return std::nullopt;
    return request(file->path, {file, std::nullopt},
                   [](Decoded& decoded, Outcome&) { return std::move(*decoded[0]); });
}

Images::Request Images::bump(const TextureInfo* texture) {
    const std::optional<File> file = read(texture);
    if (!file) return std::nullopt;
    return request("bump\n" + file->path, {file, std::nullopt}, [file](Decoded& decoded, Outcome&) {
        if (!holdsNormals(*decoded[0])) throw Failure{file->element, "a height map, which is not drawn"};
        return std::move(*decoded[0]);
    });
}

Images::Request Images::colorAndMask(const TextureInfo* color, const TextureInfo* mask) {
    const std::optional<File> colorFile = read(color), maskFile = read(mask);
    if (!maskFile) return whole(color);
    const std::string colorPath = colorFile ? colorFile->path : "";
    // A map_d that is the map_Kd means its alpha channel, also where that is opaque.
    const bool isSame = colorPath == maskFile->path;
    const auto make = [isSame, channel = mask->channel](Decoded& decoded, Outcome& outcome) {
        if (!decoded[1]) return std::move(*decoded[0]);
        const Image* const rgb = decoded[0] ? &*decoded[0] : nullptr;
        const Channel usual = isSame ? Channel::matte : maskChannel(*decoded[1]);
        const ChannelSource alpha{&*decoded[1], channelOr(channel, usual)};
        Image image = combined({{{rgb, Channel::red}, {rgb, Channel::green}, {rgb, Channel::blue}, alpha}});
        outcome.hasHoles = !isOpaque(image);
        return image;
    };
    return request("mask\n" + keyOf(colorPath, color) + keyOf(maskFile->path, mask), {colorFile, maskFile},
                   make);
}

Images::Request Images::roughnessAndMetallic(const TextureInfo* roughness, const TextureInfo* metallic) {
    const std::optional<File> roughFile = read(roughness), metalFile = read(metallic);
    if (!roughFile && !metalFile) return std::nullopt;
    const Channel roughChannel =
        channelOr(roughness ? roughness->channel : Channel::usual, Channel::luminance);
    const Channel metalChannel = channelOr(metallic ? metallic->channel : Channel::usual, Channel::luminance);
    const auto make = [roughChannel, metalChannel](Decoded& decoded, Outcome&) {
        std::array<ChannelSource, 4> sources;
        if (decoded[0]) sources[1] = {&*decoded[0], roughChannel};
        if (decoded[1]) sources[2] = {&*decoded[1], metalChannel};
        return combined(sources);
    };
    const std::string key = keyOf(roughFile ? roughFile->path : "", roughness) +
                            keyOf(metalFile ? metalFile->path : "", metallic);
    return request("metallic\n" + key, {roughFile, metalFile}, make);
}

void Images::addRequested(double from, double to) {
    indices_ = addImages(jobs_, host_, from, to);
    jobs_.clear();
    for (const std::shared_ptr<Outcome>& outcome : outcomes_) {
        for (const Fault& fault : outcome->faults) {
            host_.noteLeftOut(fault.failure);
            unusablePaths_.insert(fault.path);
        }
    }
}

}  // namespace candela_plugins::obj
