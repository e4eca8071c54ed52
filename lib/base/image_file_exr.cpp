#include <candela/error.h>
#include <candela/image_file.h>

#include <candela/threads.h>
#include <candela/whole_file.h>

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfRationalAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <half.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <variant>
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

    std::vector<std::byte> takeBytes() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

Imath::V2f toImath(const glm::dvec2& xy) {
    return Imath::V2f(float(xy.x), float(xy.y));
}

Imf::Compression toImf(ExrCompression compression) {
    switch (compression) {
        case ExrCompression::none:
            return Imf::NO_COMPRESSION;
        case ExrCompression::piz:
            return Imf::PIZ_COMPRESSION;
        case ExrCompression::dwaa:
            return Imf::DWAA_COMPRESSION;
        default:
            return Imf::ZIP_COMPRESSION;
    }
}

Imf::PixelType toImf(ExrPixelType type) {
    return type == ExrPixelType::half ? Imf::HALF : Imf::FLOAT;
}

/// Inserts an attribute of the type of the file format that the value has.
struct AttributeInsertion {
    Imf::Header& header;
    const std::string& name;

    void operator()(const std::string& text) const { header.insert(name, Imf::StringAttribute(text)); }
    void operator()(std::int32_t number) const { header.insert(name, Imf::IntAttribute(number)); }
    void operator()(float number) const { header.insert(name, Imf::FloatAttribute(number)); }
    void operator()(const ExrRational& fraction) const {
        header.insert(name, Imf::RationalAttribute(Imf::Rational(fraction.numerator, fraction.denominator)));
    }
    void operator()(const glm::mat4& matrix) const {
        Imath::M44f rows;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) rows[i][j] = matrix[i][j];
        header.insert(name, Imf::M44fAttribute(rows));
    }
};

/// Deflate's lowest level: of noise, which rendered pictures are full of, higher ones take longer and save a
/// hundredth.
constexpr int zipLevel = 1;

Imf::Header makeHeader(int width, int height, std::span<const ExrChannel> channels,
                       const Chromaticities& chromaticities, std::span<const ExrAttribute> attributes,
                       ExrCompression compression) {
    Imf::Header header(width, height);
    header.compression() = toImf(compression);
    header.zipCompressionLevel() = zipLevel;
    Imf::addChromaticities(header,
                           Imf::Chromaticities(toImath(chromaticities.red), toImath(chromaticities.green),
                                               toImath(chromaticities.blue), toImath(chromaticities.white)));
    for (const ExrChannel& channel : channels)
        header.channels().insert(channel.name, Imf::Channel(toImf(channel.type)));
    for (const ExrAttribute& attribute : attributes)
        std::visit(AttributeInsertion{header, attribute.name}, attribute.value);
    return header;
}

/// The largest finite half.
constexpr float maxHalf = 65504.0f;

/// The nearest half of each value; a finite one stays finite.
std::vector<half> toHalf(std::span<const float> values) {
    std::vector<half> halves;
    halves.reserve(values.size());
    for (const float value : values)
        halves.emplace_back(std::isfinite(value) ? std::clamp(value, -maxHalf, maxHalf) : value);
    return halves;
}

/// The values of channels as the file has them.
class PixelBuffers {
  public:
    PixelBuffers(std::uint32_t width, std::span<const ExrChannel> channels) {
        for (const ExrChannel& channel : channels) {
            if (channel.type == ExrPixelType::half) {
                halves_.push_back(toHalf(channel.values));
                insert(channel.name, Imf::HALF, halves_.back().data(), width);
            } else {
                insert(channel.name, Imf::FLOAT, channel.values.data(), width);
            }
        }
    }

    const Imf::FrameBuffer& frameBuffer() const { return buffer_; }

  private:
    template <typename Value>
    void insert(const std::string& name, Imf::PixelType type, const Value* values, std::uint32_t width) {
        // OpenEXR has one type for reading and writing; an output file only reads it.
        char* base = reinterpret_cast<char*>(const_cast<Value*>(values));
        buffer_.insert(name, Imf::Slice(type, base, sizeof(Value), sizeof(Value) * width));
    }

    std::vector<std::vector<half>> halves_;
    Imf::FrameBuffer buffer_;
};

/// The number of threads that OpenEXR takes for a file: 0 for the calling one alone.
int poolThreads(unsigned threads) {
    if (threads <= 1) return 0;
    const int wanted = static_cast<int>(threads);
    if (Imf::globalThreadCount() < wanted) Imf::setGlobalThreadCount(wanted);
    return wanted;
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

const char* toString(ExrCompression compression) {
    constexpr std::array names{"none", "zip", "piz", "dwaa"};
    return names[static_cast<std::size_t>(compression)];
}

std::vector<std::byte> encodeExr(const std::string& name, std::uint32_t width, std::uint32_t height,
                                 std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
                                 std::span<const ExrAttribute> attributes, const ExrOptions& options) {
    requireFits(name, width, height, channels);
    requireNames(attributes, "attribute", name);
    if (options.threads < 1 || options.threads > maxThreadCount)
        throw Error(ErrorKind::badInput, name,
                    "an EXR can not be encoded by " + std::to_string(options.threads) + " threads; 1 to " +
                        std::to_string(maxThreadCount) + " were expected");
    MemoryStream stream(name);
    try {
        const PixelBuffers buffers(width, channels);
        Imf::OutputFile file(
            stream,
            makeHeader(int(width), int(height), channels, chromaticities, attributes, options.compression),
            poolThreads(options.threads));
        file.setFrameBuffer(buffers.frameBuffer());
        file.writePixels(int(height));
    } catch (const std::exception& failure) {
        throw Error(ErrorKind::environment, name,
                    std::string("can not be encoded as EXR: ") + failure.what());
    }
    return stream.takeBytes();
}

void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
              std::span<const ExrAttribute> attributes, const ExrOptions& options) {
    writeWholeFile(path,
                   encodeExr(path.string(), width, height, channels, chromaticities, attributes, options));
}

}  // namespace candela
