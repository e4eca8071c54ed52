#include <candela/error.h>
#include <candela/image_file.h>

#include <candela/whole_file.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>

#include <algorithm>
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
                       const Chromaticities& chromaticities, std::span<const ExrAttribute> attributes) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header,
                           Imf::Chromaticities(toImath(chromaticities.red), toImath(chromaticities.green),
                                               toImath(chromaticities.blue), toImath(chromaticities.white)));
    for (const ExrChannel& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    for (const ExrAttribute& attribute : attributes)
        header.insert(attribute.name, Imf::StringAttribute(attribute.value));
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
            std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
            std::span<const ExrAttribute> attributes) {
    Imf::OutputFile file(stream, makeHeader(int(width), int(height), channels, chromaticities, attributes));
    file.setFrameBuffer(makeFrameBuffer(width, channels));
    file.writePixels(int(height));
}

/// `kind` as messages name one of `parts`.
template <typename Part>
void requireNames(std::span<const Part> parts, const std::string& kind, const std::string& path) {
    std::vector<std::string> names;
    for (const Part& part : parts) {
        // OpenEXR keeps names as C strings of up to 255 bytes.
        if (part.name.empty() || part.name.size() > 255 || part.name.find('\0') != std::string::npos)
            throw Error(ErrorKind::badInput, path,
                        "an EXR " + kind + " has no name that a file can hold: 1 to 255 bytes were expected");
        names.push_back(part.name);
    }
    std::ranges::sort(names);
    const auto repeated = std::ranges::adjacent_find(names);
    if (repeated != names.end())
        throw Error(ErrorKind::badInput, path, "two EXR " + kind + "s have the name '" + *repeated + "'");
}

void requireFits(const std::string& path, std::uint32_t width, std::uint32_t height,
                 std::span<const ExrChannel> channels) {
    constexpr std::uint32_t maxSide = std::numeric_limits<int>::max();
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < 1 || height < 1 || width > maxSide || height > maxSide)
        throw Error(ErrorKind::badInput, path,
                    "an EXR can not have " + size + " pixels; 1 to 2147483647 along each side were expected");
    if (channels.empty()) throw Error(ErrorKind::badInput, path, "an EXR needs at least one channel");
    requireNames(channels, "channel", path);
    for (const ExrChannel& channel : channels) {
        if (channel.values.size() == std::uint64_t{width} * height) continue;
        throw Error(ErrorKind::badInput, path,
                    "EXR channel '" + channel.name + "' has " + std::to_string(channel.values.size()) +
                        " values for " + size + " pixels; one per pixel was expected");
    }
}

}  // namespace

void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
              std::span<const ExrAttribute> attributes) {
    requireFits(path.string(), width, height, channels);
    requireNames(attributes, "attribute", path.string());
    MemoryStream stream(path.string());
    try {
        encode(stream, width, height, channels, chromaticities, attributes);
    } catch (const std::exception& failure) {
        throw Error(ErrorKind::environment, path.string(),
                    std::string("can not be encoded as EXR: ") + failure.what());
    }
    writeWholeFile(path, stream.bytes());
}

}  // namespace candela
