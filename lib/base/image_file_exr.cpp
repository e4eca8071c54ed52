#include <candela/error.h>
#include <candela/image_stream.h>

#include "base/image_rows.h"

#include <candela/threads.h>

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
#include <memory>
#include <optional>
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

/// The same of a file that is being written. It keeps the first failure: OpenEXR's destructor drops it.
class FileStream final : public Imf::OStream {
  public:
    explicit FileStream(WholeFile& file) : OStream(file.name().c_str()), file_(file), start_(file.size()) {}

    void write(const char data[], int size) override {
        try {
            file_.writeAt(start_ + position_, std::as_bytes(std::span(data, std::size_t(size))));
        } catch (...) {
            if (!failure_) failure_ = std::current_exception();
            throw;
        }
        position_ += std::uint64_t(size);
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    void requireNoFailure() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    WholeFile& file_;
    std::uint64_t start_ = 0, position_ = 0;
    std::exception_ptr failure_;
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

template <typename Channel>
Imf::Header makeHeader(int width, int height, std::span<const Channel> channels,
                       const Chromaticities& chromaticities, std::span<const ExrAttribute> attributes,
                       ExrCompression compression) {
    Imf::Header header(width, height);
    header.compression() = toImf(compression);
    header.zipCompressionLevel() = zipLevel;
    Imf::addChromaticities(header,
                           Imf::Chromaticities(toImath(chromaticities.red), toImath(chromaticities.green),
                                               toImath(chromaticities.blue), toImath(chromaticities.white)));
    for (const Channel& channel : channels)
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

/// The values of channels of rows from `firstRow` on, as the file has them.
class PixelBuffers {
  public:
    PixelBuffers(std::uint32_t width, std::uint32_t firstRow) : width_(width), firstRow_(firstRow) {}

    void add(const std::string& name, ExrPixelType type, std::span<const float> values) {
        if (type == ExrPixelType::half) {
            halves_.push_back(toHalf(values));
            insert(name, Imf::HALF, halves_.back().data());
        } else {
            insert(name, Imf::FLOAT, values.data());
        }
    }

    const Imf::FrameBuffer& frameBuffer() const { return buffer_; }

  private:
    template <typename Value>
    void insert(const std::string& name, Imf::PixelType type, const Value* values) {
        const std::size_t rowBytes = sizeof(Value) * width_;
        // OpenEXR has one type for reading and writing; an output file only reads it. It counts from row 0.
        const auto base = reinterpret_cast<std::uintptr_t>(values) - std::uintptr_t{firstRow_} * rowBytes;
        buffer_.insert(name, Imf::Slice(type, reinterpret_cast<char*>(base), sizeof(Value), rowBytes));
    }

    std::uint32_t width_, firstRow_;
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

template <typename Channel>
void requireHeader(const std::string& name, std::uint32_t width, std::uint32_t height,
                   std::span<const Channel> channels, std::span<const ExrAttribute> attributes,
                   const ExrOptions& options) {
    constexpr std::uint32_t maxSide = std::numeric_limits<int>::max();
    if (width < 1 || height < 1 || width > maxSide || height > maxSide)
        throw Error(ErrorKind::badInput, name,
                    "an EXR can not have " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels; 1 to 2147483647 along each side were expected");
    if (channels.empty()) throw Error(ErrorKind::badInput, name, "an EXR needs at least one channel");
    requireNames(channels, "channel", name);
    requireNames(attributes, "attribute", name);
    if (options.threads >= 1 && options.threads <= maxThreadCount) return;
    throw Error(ErrorKind::badInput, name,
                "an EXR can not be encoded by " + std::to_string(options.threads) + " threads; 1 to " +
                    std::to_string(maxThreadCount) + " were expected");
}

void requireValues(const std::string& name, std::uint32_t width, std::uint32_t height,
                   std::span<const ExrChannel> channels) {
    for (const ExrChannel& channel : channels) {
        if (channel.values.size() == std::uint64_t{width} * height) continue;
        throw Error(ErrorKind::badInput, name,
                    "EXR channel '" + channel.name + "' has " + std::to_string(channel.values.size()) +
                        " values for " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels; one per pixel was expected");
    }
}

/// Calls `body`, which calls OpenEXR. Its own errors name the file.
template <typename Body>
void encoding(const std::string& name, const Body& body) {
    try {
        body();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error(ErrorKind::environment, name,
                    std::string("can not be encoded as EXR: ") + failure.what());
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
    requireHeader(name, width, height, channels, attributes, options);
    requireValues(name, width, height, channels);
    MemoryStream stream(name);
    encoding(name, [&] {
        PixelBuffers buffers(width, 0);
        for (const ExrChannel& channel : channels) buffers.add(channel.name, channel.type, channel.values);
        Imf::OutputFile file(
            stream,
            makeHeader(int(width), int(height), channels, chromaticities, attributes, options.compression),
            poolThreads(options.threads));
        file.setFrameBuffer(buffers.frameBuffer());
        file.writePixels(int(height));
    });
    return stream.takeBytes();
}

void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
              std::span<const ExrAttribute> attributes, const ExrOptions& options) {
    writeWholeFile(path,
                   encodeExr(path.string(), width, height, channels, chromaticities, attributes, options));
}

struct ExrStream::State {
    State(WholeFile& into, const Imf::Header& header, int threads)
        : name(into.name()), stream(into), file(std::in_place, stream, header, threads) {}

    std::string name;
    std::vector<ExrChannelType> channels;
    std::uint32_t width = 0, height = 0;
    std::uint32_t rows = 0;  ///< Written.
    FileStream stream;
    std::optional<Imf::OutputFile> file;
};

ExrStream::ExrStream(WholeFile& file, std::uint32_t width, std::uint32_t height,
                     std::span<const ExrChannelType> channels, const Chromaticities& chromaticities,
                     std::span<const ExrAttribute> attributes, const ExrOptions& options) {
    requireHeader(file.name(), width, height, channels, attributes, options);
    encoding(file.name(), [&] {
        state_ = std::make_unique<State>(
            file,
            makeHeader(int(width), int(height), channels, chromaticities, attributes, options.compression),
            poolThreads(options.threads));
    });
    state_->channels.assign(channels.begin(), channels.end());
    state_->width = width;
    state_->height = height;
}

ExrStream::ExrStream(ExrStream&&) noexcept = default;
ExrStream& ExrStream::operator=(ExrStream&&) noexcept = default;
ExrStream::~ExrStream() = default;

ExrStream::State& ExrStream::state() const {
    return requireOpen(state_.get());
}

void ExrStream::write(std::span<const std::span<const float>> values) {
    State& open = state();
    if (values.size() != open.channels.size())
        throw Error(ErrorKind::badInput, open.name,
                    "rows of " + std::to_string(values.size()) + " channels are written into an EXR of " +
                        std::to_string(open.channels.size()));
    for (const std::span<const float> channel : values) {
        requireRows(open.name, channel.size(), open.width, open.height - open.rows);
        if (channel.size() == values.front().size()) continue;
        throw Error(ErrorKind::badInput, open.name, "the channels have different numbers of rows");
    }
    const auto count = static_cast<std::uint32_t>(values.front().size() / open.width);
    orEnd(state_, [&] {
        encoding(open.name, [&] {
            PixelBuffers buffers(open.width, open.rows);
            for (std::size_t i = 0; i < values.size(); ++i)
                buffers.add(open.channels[i].name, open.channels[i].type, values[i]);
            open.file->setFrameBuffer(buffers.frameBuffer());
            open.file->writePixels(static_cast<int>(count));
        });
    });
    open.rows += count;
}

void ExrStream::finish() {
    State& open = state();
    requireNoRowsLeft(open.name, open.height - open.rows);
    orEnd(state_, [&] {
        open.file.reset();  // Writes the table of lines.
        open.stream.requireNoFailure();
    });
    state_.reset();
}

}  // namespace candela
