#include <candela/error.h>
#include <candela/image_file.h>

#include <candela/whole_file.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace candela {
namespace {

/// A file in memory: OpenEXR goes back to its start to fill in the table of lines.
class MemoryStream final : public Imf::OStream {
  public:
    explicit MemoryStream(const std::string& name) : OStream(name.c_str()) {}

    void write(const char data[], int size) override {
        const std::size_t end = position_ + std::size_t(size);
        if (end > bytes_.size()) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, data, std::size_t(size));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::span<const std::byte> bytes() const { return bytes_; }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

Imath::V2f toImath(const glm::dvec2& xy) {
    return Imath::V2f(float(xy.x), float(xy.y));
}

Imf::Header makeHeader(int width, int height, std::span<const ExrChannel> channels,
                       const Chromaticities& chromaticities) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header,
                           Imf::Chromaticities(toImath(chromaticities.red), toImath(chromaticities.green),
                                               toImath(chromaticities.blue), toImath(chromaticities.white)));
    for (const ExrChannel& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    return header;
}

Imf::FrameBuffer makeFrameBuffer(std::uint32_t width, std::span<const ExrChannel> channels) {
    Imf::FrameBuffer buffer;
    for (const ExrChannel& channel : channels) {
        // OpenEXR has one type for reading and writing; an output file only reads it.
        char* base = reinterpret_cast<char*>(const_cast<float*>(channel.values.data()));
        buffer.insert(channel.name, Imf::Slice(Imf::FLOAT, base, sizeof(float), sizeof(float) * width));
    }
    return buffer;
}

void encode(MemoryStream& stream, std::uint32_t width, std::uint32_t height,
            std::span<const ExrChannel> channels, const Chromaticities& chromaticities) {
    Imf::OutputFile file(stream, makeHeader(int(width), int(height), channels, chromaticities));
    file.setFrameBuffer(makeFrameBuffer(width, channels));
    file.writePixels(int(height));
}

[[maybe_unused]] bool namesDiffer(std::span<const ExrChannel> channels) {
    std::vector<std::string> names;
    for (const ExrChannel& channel : channels) names.push_back(channel.name);
    std::ranges::sort(names);
    return std::ranges::adjacent_find(names) == names.end();
}

}  // namespace

void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannel> channels, const Chromaticities& chromaticities) {
    assert(width > 0 && height > 0 && !channels.empty());
    assert(width <= std::uint32_t(std::numeric_limits<int>::max()));
    assert(height <= std::uint32_t(std::numeric_limits<int>::max()));
    assert(namesDiffer(channels));
    assert(std::ranges::all_of(channels, [&](const ExrChannel& channel) {
        return channel.values.size() == std::size_t{width} * height;
    }));
    MemoryStream stream(path.string());
    try {
        encode(stream, width, height, channels, chromaticities);
    } catch (const std::exception& failure) {
        throw Error(ErrorKind::environment, path.string(),
                    std::string("can not be encoded as EXR: ") + failure.what());
    }
    writeWholeFile(path, stream.bytes());
}

}  // namespace candela
