#pragma once

#include <candela/export.h>
#include <candela/image.h>

#include <glm/vec2.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
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
    std::optional<Chromaticities> chromaticities;  ///< None when unknown.
};

/// One channel of an EXR file: width × height floats, rows from the top.
struct ExrChannel {
    std::string name;
    std::span<const float> values;
};

/// A text in the header of an EXR file.
struct ExrAttribute {
    std::string name;  ///< 1 to 255 bytes; not one of those that the file format itself defines.
    std::string value;
};

/// Writes 8-bit RGBA, rows from the top, straight (not premultiplied) alpha, as PNG, tagged with `encoding`.
/// The file is written atomically (`writeWholeFile`). Throws `Error` (environment)
/// naming the file when the folder is missing, the disk full, and so on; and (badInput), before a file is
/// touched, when a side is not 1 to 2^31 - 1 or `rgba` does not have 4 bytes per pixel.
CANDELA_API void writePng(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                          std::span<const std::uint8_t> rgba, const DisplayEncoding& encoding);

/// Writes 32-bit float channels as one single-part scan-line EXR file (ZIP), with the chromaticities of its
/// colour channels and `attributes`. Written atomically; throws as `writePng`; badInput also when there is no
/// channel, two channels or attributes have the same name, a name is not 1 to 255 bytes long, or a channel
/// does not have one value per pixel.
CANDELA_API void writeExr(const std::filesystem::path& path, std::uint32_t width, std::uint32_t height,
                          std::span<const ExrChannel> channels, const Chromaticities& chromaticities,
                          std::span<const ExrAttribute> attributes = {});

/// A picture of linear light, and what was repaired in it.
struct HdrFile {
    Image image;  ///< `PixelFormat::rgba32f`, linear Rec.709, 0 to 1e20; alpha is 1. Its name is the file's.
    std::vector<std::string> notes;  ///< A line each, which begins with the path.
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
