#include <candela/error.h>
#include <candela/image_file.h>

#include <candela/whole_file.h>

#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace candela {
namespace {

/// The gamma that stands for the sRGB curve in a gAMA chunk. Source: PNG specification, 11.3.2.
constexpr double gammaOfSrgb = 2.2;

/// The state of libpng's callbacks: the bytes written so far, and the reason of a failure.
struct PngOutput {
    std::vector<std::byte> bytes;
    std::array<char, 128> failure{};
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
        const auto* first = reinterpret_cast<const std::byte*>(data);
        output.bytes.insert(output.bytes.end(), first, first + size);
    } catch (const std::exception&) {
        enough = false;  // No exception may cross libpng, and no jump may leave a handler.
    }
    if (!enough) png_error(png, "out of memory");
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

struct PngPixels {
    std::uint32_t width, height;
    const std::uint8_t* rgba;
    int colorType;
};

/// Runs libpng. It leaves this function by longjmp when it fails, so nothing here has a destructor.
bool encode(const PngWriter& writer, PngOutput& output, const PngPixels& pixels,
            const DisplayEncoding& encoding, int level) {
    if (setjmp(png_jmpbuf(writer.png())) != 0) return false;
    png_set_write_fn(writer.png(), &output, onWrite, onFlush);
    png_set_user_limits(writer.png(), PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_benign_errors(writer.png(), 1);
    png_set_IHDR(writer.png(), writer.info(), pixels.width, pixels.height, 8, pixels.colorType,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(writer.png(), level);
    png_set_compression_buffer_size(writer.png(), pieceBytes);
    png_set_filter(writer.png(), PNG_FILTER_TYPE_BASE, filtersOf(level));
    tag(writer.png(), writer.info(), encoding);
    png_write_info(writer.png(), writer.info());
    if (pixels.colorType == PNG_COLOR_TYPE_RGB) png_set_filler(writer.png(), 0, PNG_FILLER_AFTER);
    for (std::uint32_t row = 0; row < pixels.height; ++row)
        png_write_row(writer.png(), pixels.rgba + std::size_t{row} * pixels.width * 4);
    png_write_end(writer.png(), writer.info());
    return true;
}

void requireFits(const std::string& name, std::uint32_t width, std::uint32_t height, std::size_t bytes) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height);
    if (width < 1 || height < 1 || width > PNG_UINT_31_MAX || height > PNG_UINT_31_MAX)
        throw Error(ErrorKind::badInput, name,
                    "a PNG can not have " + size + " pixels; 1 to 2147483647 along each side were expected");
    const std::uint64_t pixels = std::uint64_t{width} * height;
    if (bytes / 4 != pixels || bytes % 4 != 0)
        throw Error(ErrorKind::badInput, name,
                    "there are " + std::to_string(bytes) + " bytes for " + size +
                        " pixels of RGBA; 4 per pixel were expected");
}

}  // namespace

std::vector<std::byte> encodePng(const std::string& name, std::uint32_t width, std::uint32_t height,
                                 std::span<const std::uint8_t> rgba, const DisplayEncoding& encoding,
                                 const PngOptions& options) {
    requireFits(name, width, height, rgba.size());
    const bool hasGamma = encoding.transfer == DisplayEncoding::Transfer::gamma;
    if (hasGamma && !(encoding.gamma > 0.0 && std::isfinite(encoding.gamma)))
        throw Error(ErrorKind::badInput, name, "the gamma of a display must be finite and over 0");
    if (options.level < 0 || options.level > 9)
        throw Error(ErrorKind::badInput, name,
                    "a PNG can not have the compression level " + std::to_string(options.level) +
                        "; 0 to 9 was expected");
    PngOutput output;
    const PngWriter writer(output, onError, onWarning);
    const PngPixels pixels{width, height, rgba.data(),
                           isOpaque(rgba) ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA};
    if (!writer.isReady() || !encode(writer, output, pixels, encoding, options.level))
        throw Error(ErrorKind::environment, name,
                    "can not be encoded as PNG: " + std::string(output.failure.data()));
    return std::move(output.bytes);
}

void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
              std::span<const std::uint8_t> rgba, const DisplayEncoding& encoding,
              const PngOptions& options) {
    writeWholeFile(path, encodePng(path.string(), width, height, rgba, encoding, options));
}

}  // namespace candela
