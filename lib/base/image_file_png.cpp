#include <candela/error.h>
#include <candela/image_stream.h>

#include "base/image_rows.h"

#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace candela {
namespace {

/// The gamma that stands for the sRGB curve in a gAMA chunk. Source: PNG specification, 11.3.2.
constexpr double gammaOfSrgb = 2.2;

/// Takes the bytes of a PNG. May throw.
using PngSink = std::function<void(std::span<const std::byte>)>;

/// The state of libpng's callbacks.
struct PngOutput {
    PngSink sink;
    std::array<char, 128> failure{};   ///< What libpng says.
    std::exception_ptr sinkFailure{};  ///< What the sink has thrown.
};

/// Owns libpng's two structures.
class PngWriter {
  public:
    PngWriter(PngOutput& output, png_error_ptr onError, png_error_ptr onWarning)
        : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &output, onError, onWarning)),
          info_(png_ != nullptr ? png_create_info_struct(png_) : nullptr) {}
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

    bool isReady() const { return info_ != nullptr; }
    png_structp png() const { return png_; }
    png_infop info() const { return info_; }

  private:
    png_structp png_;
    png_infop info_;
};

[[noreturn]] void onError(png_structp png, png_const_charp message) {
    auto& failure = static_cast<PngOutput*>(png_get_error_ptr(png))->failure;
    std::snprintf(failure.data(), failure.size(), "%s", message);
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void onWrite(png_structp png, png_bytep data, std::size_t size) {
    auto& output = *static_cast<PngOutput*>(png_get_io_ptr(png));
    bool enough = true;
    try {
        output.sink({reinterpret_cast<const std::byte*>(data), size});
    } catch (...) {
        output.sinkFailure = std::current_exception();
        enough = false;  // No exception may cross libpng, and no jump may leave a handler.
    }
    if (!enough) png_error(png, "the file can not be written");
}

void onFlush(png_structp) {}

bool isRec709(const Chromaticities& c) {
    const Chromaticities rec709;
    return c.red == rec709.red && c.green == rec709.green && c.blue == rec709.blue && c.white == rec709.white;
}

/// An sRGB chunk where it says all, else gamma and primaries as far as they are known.
void tag(png_structp png, png_infop info, const DisplayEncoding& encoding) {
    using Transfer = DisplayEncoding::Transfer;
    const Chromaticities* primaries = encoding.chromaticities ? &*encoding.chromaticities : nullptr;
    if (encoding.transfer == Transfer::srgb && primaries != nullptr && isRec709(*primaries)) {
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
        return;
    }
    if (encoding.transfer != Transfer::unknown)
        png_set_gAMA(png, info, 1.0 / (encoding.transfer == Transfer::srgb ? gammaOfSrgb : encoding.gamma));
    if (primaries != nullptr)
        png_set_cHRM(png, info, primaries->white.x, primaries->white.y, primaries->red.x, primaries->red.y,
                     primaries->green.x, primaries->green.y, primaries->blue.x, primaries->blue.y);
}

/// The levels whose rows are all predicted from the left.
constexpr int lastQuickLevel = 3;

/// zlib compresses in pieces of so many bytes, which are appended to the output.
constexpr std::size_t pieceBytes = 65536;

/// Sub is the quickest predictor that makes rendered pictures small: see docs/farm.md for sizes and times.
int filtersOf(int level) {
    if (level == 0) return PNG_FILTER_NONE;
    return level <= lastQuickLevel ? PNG_FILTER_SUB : PNG_ALL_FILTERS;
}

bool isOpaque(std::span<const std::uint8_t> rgba) {
    for (std::size_t i = 3; i < rgba.size(); i += 4)
        if (rgba[i] != 255) return false;
    return true;
}

struct PngFormat {
    std::uint32_t width, height;
    int colorType;
    int level;
};

// libpng leaves the following functions by longjmp when it fails, so that nothing in them has a destructor.

bool begin(png_structp png, png_infop info, PngOutput* output, const PngFormat& format,
           const DisplayEncoding& encoding) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, output, onWrite, onFlush);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_benign_errors(png, 1);
    png_set_IHDR(png, info, format.width, format.height, 8, format.colorType, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, format.level);
    png_set_compression_buffer_size(png, pieceBytes);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, filtersOf(format.level));
    tag(png, info, encoding);
    png_write_info(png, info);
    if (format.colorType == PNG_COLOR_TYPE_RGB) png_set_filler(png, 0, PNG_FILLER_AFTER);
    return true;
}

bool writeRows(png_structp png, const std::uint8_t* rgba, std::size_t rowBytes, std::size_t rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    for (std::size_t row = 0; row < rows; ++row) png_write_row(png, rgba + row * rowBytes);
    return true;
}

bool end(png_structp png, png_infop info) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_write_end(png, info);
    return true;
}

/// A PNG that is being written from the top.
class PngEncoding {
  public:
    PngEncoding(const std::string& name, const PngFormat& format, const DisplayEncoding& encoding,
                PngSink sink)
        : name_(name), format_(format), output_{std::move(sink)}, writer_(output_, onError, onWarning) {
        if (!writer_.isReady() || !begin(writer_.png(), writer_.info(), &output_, format, encoding)) fail();
    }

    const PngFormat& format() const { return format_; }
    void write(std::span<const std::uint8_t> rgba) {
        const std::size_t rowBytes = std::size_t{4} * format_.width;
        if (!writeRows(writer_.png(), rgba.data(), rowBytes, rgba.size() / rowBytes)) fail();
    }
    void finish() {
        if (!end(writer_.png(), writer_.info())) fail();
    }

  private:
    [[noreturn]] void fail() const {
        std::string reason(output_.failure.data());
        try {
            if (output_.sinkFailure) std::rethrow_exception(output_.sinkFailure);
        } catch (const std::bad_alloc&) {
            reason = "out of memory";
        }
        throw Error(ErrorKind::environment, name_, "can not be encoded as PNG: " + reason);
    }

    std::string name_;
    PngFormat format_;
    PngOutput output_;
    PngWriter writer_;
};

void requireSides(const std::string& name, std::uint32_t width, std::uint32_t height) {
    if (width >= 1 && height >= 1 && width <= PNG_UINT_31_MAX && height <= PNG_UINT_31_MAX) return;
    throw Error(ErrorKind::badInput, name,
                "a PNG can not have " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels; 1 to 2147483647 along each side were expected");
}

void requireOptions(const std::string& name, const DisplayEncoding& encoding, const PngOptions& options) {
    const bool hasGamma = encoding.transfer == DisplayEncoding::Transfer::gamma;
    if (hasGamma && !(encoding.gamma > 0.0 && std::isfinite(encoding.gamma)))
        throw Error(ErrorKind::badInput, name, "the gamma of a display must be finite and over 0");
    if (options.level < 0 || options.level > 9)
        throw Error(ErrorKind::badInput, name,
                    "a PNG can not have the compression level " + std::to_string(options.level) +
                        "; 0 to 9 was expected");
}

void requireFits(const std::string& name, std::uint32_t width, std::uint32_t height, std::size_t bytes) {
    requireSides(name, width, height);
    const std::uint64_t pixels = std::uint64_t{width} * height;
    if (bytes / 4 == pixels && bytes % 4 == 0) return;
    throw Error(ErrorKind::badInput, name,
                "there are " + std::to_string(bytes) + " bytes for " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels of RGBA; 4 per pixel were expected");
}

}  // namespace

std::vector<std::byte> encodePng(const std::string& name, std::uint32_t width, std::uint32_t height,
                                 std::span<const std::uint8_t> rgba, const DisplayEncoding& encoding,
                                 const PngOptions& options) {
    requireFits(name, width, height, rgba.size());
    requireOptions(name, encoding, options);
    const int colorType = isOpaque(rgba) ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
    std::vector<std::byte> bytes;
    PngEncoding png(
        name, {width, height, colorType, options.level}, encoding,
        [&](std::span<const std::byte> piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
    png.write(rgba);
    png.finish();
    return bytes;
}

void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const std::uint8_t> rgba, const DisplayEncoding& encoding,
              const PngOptions& options) {
    writeWholeFile(path, encodePng(path.string(), width, height, rgba, encoding, options));
}

struct PngStream::State {
    State(WholeFile& into, const PngFormat& format, const DisplayEncoding& encoding)
        : file(into),
          png(into.name(), format, encoding, [&](std::span<const std::byte> piece) { into.write(piece); }) {}

    WholeFile& file;
    PngEncoding png;
    std::uint64_t rowsLeft = png.format().height;
};

PngStream::PngStream(WholeFile& file, std::uint32_t width, std::uint32_t height,
                     const DisplayEncoding& encoding, PngAlpha alpha, const PngOptions& options) {
    requireSides(file.name(), width, height);
    requireOptions(file.name(), encoding, options);
    const int colorType = alpha == PngAlpha::none ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
    state_ = std::make_unique<State>(file, PngFormat{width, height, colorType, options.level}, encoding);
}

PngStream::PngStream(PngStream&&) noexcept = default;
PngStream& PngStream::operator=(PngStream&&) noexcept = default;
PngStream::~PngStream() = default;

PngStream::State& PngStream::state() const {
    return requireOpen(state_.get());
}

void PngStream::write(std::span<const std::uint8_t> rgba) {
    State& open = state();
    const std::size_t perRow = std::size_t{4} * open.png.format().width;
    requireRows(open.file.name(), rgba.size(), perRow, open.rowsLeft);
    orEnd(state_, [&] { open.png.write(rgba); });
    open.rowsLeft -= rgba.size() / perRow;
}

void PngStream::finish() {
    State& open = state();
    requireNoRowsLeft(open.file.name(), open.rowsLeft);
    orEnd(state_, [&] { open.png.finish(); });
    state_.reset();
}

}  // namespace candela
