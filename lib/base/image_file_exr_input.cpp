#include <candela/error.h>

#include "base/hdr_decoders.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace candela {
namespace {

/// A file in memory.
class MemoryStream final : public Imf::IStream {
  public:
    MemoryStream(std::span<const std::byte> bytes, const std::string& name)
        : IStream(name.c_str()), bytes_(bytes) {}

    bool read(char data[], int size) override {
        const std::uint64_t count = size < 0 ? 0 : std::uint64_t(size);
        if (position_ > bytes_.size() || count > bytes_.size() - position_)
            throw std::runtime_error("it ends too early");
        std::memcpy(data, bytes_.data() + position_, count);
        position_ += count;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

  private:
    std::span<const std::byte> bytes_;
    std::uint64_t position_ = 0;
};

/// The channels that stand for red, green and blue: those, or the luminance for all three.
std::array<const char*, 3> colorChannels(const Imf::ChannelList& channels, const std::string& path) {
    for (const auto& names : {std::array{"R", "G", "B"}, std::array{"Y", "Y", "Y"}}) {
        const bool hasAll = std::ranges::all_of(
            names, [&](const char* name) { return channels.findChannel(name) != nullptr; });
        if (!hasAll) continue;
        for (const char* name : names) {
            const Imf::Channel& channel = *channels.findChannel(name);
            if (channel.xSampling == 1 && channel.ySampling == 1) continue;
            throw Error(
                ErrorKind::badInput, path,
                std::string("EXR channel '") + name + "' is subsampled; one value per pixel was expected");
        }
        return names;
    }
    throw Error(ErrorKind::badInput, path, "has no EXR channels R, G and B, nor Y, in its first part");
}

Imf::Chromaticities chromaticitiesOf(const Imf::Header& header) {
    return Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities();
}

glm::dvec2 fromImath(const Imath::V2f& xy) {
    return {xy.x, xy.y};
}

/// Reads the picture within the display window; what the data window leaves of it stays black.
Image readPixels(Imf::InputFile& file, const std::string& path) {
    const Imf::Header& header = file.header();
    const Imath::Box2i data = header.dataWindow(), shown = header.displayWindow();
    const auto side = [](int min, int max) {
        return std::uint64_t(std::max<std::int64_t>(std::int64_t{max} - min + 1, 0));
    };
    requireHdrSize(path, side(data.min.x, data.max.x), side(data.min.y, data.max.y));
    requireHdrSize(path, side(shown.min.x, shown.max.x), side(shown.min.y, shown.max.y));
    const std::array<const char*, 3> names = colorChannels(header.channels(), path);

    const std::size_t width = side(shown.min.x, shown.max.x), height = side(shown.min.y, shown.max.y);
    Image image{"", std::uint32_t(width), std::uint32_t(height), PixelFormat::rgba32f, {}};
    image.pixels.resize(width * height * texelSize(image.format));
    auto* const numbers = reinterpret_cast<float*>(image.pixels.data());
    for (std::size_t i = 3; i < 4 * width * height; i += 4) numbers[i] = 1.0f;

    // OpenEXR writes whole lines of the data window.
    const std::size_t lineLength = side(data.min.x, data.max.x);
    std::vector<float> line(3 * lineLength);
    const int first = std::max(data.min.x, shown.min.x), last = std::min(data.max.x, shown.max.x);
    for (int y = std::max(data.min.y, shown.min.y); y <= std::min(data.max.y, shown.max.y); ++y) {
        Imf::FrameBuffer buffer;
        for (std::size_t i = 0; i < 3; ++i) {
            if (i > 0 && names[i] == names[0]) continue;
            buffer.insert(names[i], Imf::Slice::Make(Imf::FLOAT, line.data() + i, {data.min.x, y}, lineLength,
                                                     1, 3 * sizeof(float), 3 * sizeof(float) * lineLength));
        }
        file.setFrameBuffer(buffer);
        file.readPixels(y);
        const bool isGrey = names[1] == names[0];
        for (int x = first; x <= last; ++x) {
            const float* from = line.data() + 3 * std::size_t(std::int64_t{x} - data.min.x);
            float* to = numbers + 4 * (std::size_t(std::int64_t{y} - shown.min.y) * width +
                                       std::size_t(std::int64_t{x} - shown.min.x));
            for (std::size_t i = 0; i < 3; ++i) to[i] = from[isGrey ? 0 : i];
        }
    }
    return image;
}

}  // namespace

Image decodeExr(std::span<const std::byte> bytes, const std::string& path) {
    MemoryStream stream(bytes, path);
    try {
        Imf::InputFile file(stream);
        const Imf::Header& header = file.header();
        if (header.hasType() && Imf::isDeepData(header.type()))
            throw Error(ErrorKind::unsupported, path, "is a deep EXR; one value per pixel was expected");
        Image image = readPixels(file, path);
        const Imf::Chromaticities from = chromaticitiesOf(header);
        convertToRec709(
            image, {fromImath(from.red), fromImath(from.green), fromImath(from.blue), fromImath(from.white)},
            path);
        return image;
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error(ErrorKind::badInput, path, std::string("can not be read as EXR: ") + failure.what());
    }
}

}  // namespace candela
