#pragma once

#include <candela/export.h>
#include <candela/image.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace candela {

/// The CIE 1931 xy coordinates of an RGB space's primaries and white.
struct Chromaticities {
    glm::dvec2 red{0.64, 0.33}, green{0.30, 0.60}, blue{0.15, 0.06},
        white{0.3127, 0.3290};  ///< Default: Rec.709.
};

/// How a display encodes code values, for the tags of a PNG.
struct DisplayEncoding {
    enum class Transfer { srgb, gamma, unknown };
    Transfer transfer = Transfer::srgb;
    double gamma = 2.2;  ///< Of Transfer::gamma: display light is code value to this power.
    std::optional<Chromaticities> chromaticities = {};  ///< None when unknown.
};

/// How a PNG is compressed. Of every level the pixels are the same.
struct PngOptions {
    /// 0 (not compressed) to 9 (smallest). Levels 1 to 3 predict a pixel from the one on its left, those
    /// above choose a predictor row by row. Level 1 takes an eighth of the time of level 6, for files that
    /// are a fifth larger.
    int level = 1;
};

/// The type of the values of a channel in the file.
enum class ExrPixelType {
    half,     ///< 16 bits: 11 bits of precision; values beyond ±65504 become that, infinity stays.
    float32,  ///< 32 bits: as they are.
};

/// One channel of an EXR file: width × height floats, rows from the top.
struct ExrChannel {
    std::string name = {};
    std::span<const float> values = {};
    ExrPixelType type = ExrPixelType::float32;
};

enum class ExrCompression {
    none,
    zip,   ///< Deflate of 16 rows, without loss.
    piz,   ///< Wavelets of 32 rows, without loss; the fastest one for half.
    dwaa,  ///< Cosine transforms of 32 rows; loses what is hardly seen, in R, G, B and channels named after.
};

/// "none", "zip", "piz", "dwaa".
CANDELA_API const char* toString(ExrCompression compression);

struct ExrOptions {
    ExrCompression compression = ExrCompression::zip;
    /// Threads that compress beside each other, 1 to `maxThreadCount`; the file is the same. More than one
    /// enlarges OpenEXR's global pool of threads where it is smaller, which must not happen while another
    /// thread uses OpenEXR.
    unsigned threads = 1;
};

/// A fraction, such as 24000/1001.
struct ExrRational {
    std::int32_t numerator = 0;
    std::uint32_t denominator = 1;  ///< 1 or more.
};

/// Of a matrix, row i of the file's is column i of this: OpenEXR multiplies row vectors by it.
using ExrValue = std::variant<std::string, std::int32_t, float, ExrRational, glm::mat4>;

/// An attribute in the header of an EXR file.
struct ExrAttribute {
    /// 1 to 255 bytes; of those that the file format itself defines only screenWindowWidth.
    std::string name = {};
    ExrValue value = {};
};

/// Encodes 8-bit RGBA, rows from the top, straight (not premultiplied) alpha, as PNG, tagged with `encoding`.
/// A picture that is opaque everywhere is written without alpha. `name` is what errors name. Throws `Error`
/// (badInput) when a side is not 1 to 2^31 - 1, `rgba` does not have 4 bytes per pixel or an option is not in
/// the range that it states; and (environment) when memory is not enough.
CANDELA_API std::vector<std::byte> encodePng(const std::string& name, std::uint32_t width,
                                             std::uint32_t height, std::span<const std::uint8_t> rgba,
                                             const DisplayEncoding& encoding, const PngOptions& options = {});

/// Encodes channels as one single-part scan-line EXR file, with the chromaticities of its colour channels and
/// `attributes`. Throws as `encodePng`; badInput also when there is no channel, two channels or attributes
/// have the same name, a name is not 1 to 255 bytes long, or a channel does not have one value per pixel.
CANDELA_API std::vector<std::byte> encodeExr(const std::string& name, std::uint32_t width,
                                             std::uint32_t height, std::span<const ExrChannel> channels,
                                             const Chromaticities& chromaticities,
                                             std::span<const ExrAttribute> attributes = {},
                                             const ExrOptions& options = {});

/// Writes what `encodePng` makes, atomically (`writeWholeFile`). Throws as both: (environment) naming the
/// file when the folder is missing, the disk full, and so on; (badInput) before a file is touched.
CANDELA_API void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                          std::span<const std::uint8_t> rgba, const DisplayEncoding& encoding,
                          const PngOptions& options = {});

/// Writes what `encodeExr` makes; likewise.
CANDELA_API void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                          std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
                          std::span<const ExrAttribute> attributes = {}, const ExrOptions& options = {});

/// A picture of linear light, and what was repaired in it.
struct HdrFile {
    /// `PixelFormat::rgba32f`, linear Rec.709, 0 to 1e20; alpha is 1. Its name is the file's.
    Image image = {};
    std::vector<std::string> notes = {};  ///< A line each, which begins with the path.
};

/// Reads a Radiance picture (.hdr: run-length coded or not, RGB or XYZ, any orientation; exposure and colour
/// correction are undone) or an OpenEXR file (.exr: channels R, G and B, or Y, of the first part, of any
/// type; what lies outside of its data window is black). What a file is, its first bytes say. Colours are
/// converted from the primaries that the file states. Values that are no light are replaced, with a note:
/// those below 0 or that are no number by 0, those that are infinite or over 1e20 by the largest of the
/// others. Throws `Error` that names the file: environment when it can not be read; badInput when it is
/// neither, cut off or damaged, has other channels, a side of more than 32768 or more than 2^27 pixels;
/// unsupported for deep data; limit when memory does not hold it.
CANDELA_API HdrFile readHdrFile(const std::filesystem::path& path);

}  // namespace candela
