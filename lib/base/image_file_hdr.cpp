#include <candela/error.h>
#include <candela/image_file.h>

#include "base/error_context.h"
#include "base/hdr_decoders.h"
#include "base/primaries.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <system_error>

namespace candela {
namespace {

/// The largest radiance that an environment takes: what is over it is no light but a fault.
constexpr float maxRadiance = 1e20f;

std::span<float> numbersOf(Image& image) {
    return {reinterpret_cast<float*>(image.pixels.data()), image.pixels.size() / sizeof(float)};
}

std::vector<std::byte> readWholeFile(const std::filesystem::path& path) {
    const auto fail = [&](const std::string& reason) {
        throw Error(ErrorKind::environment, path.string(), reason);
    };
    std::error_code failed;
    const auto status = std::filesystem::status(path, failed);
    if (!std::filesystem::exists(status)) fail("there is no such file");
    if (!std::filesystem::is_regular_file(status)) fail("is not a file");
    const std::uintmax_t size = std::filesystem::file_size(path, failed);
    constexpr std::uintmax_t maxSize = std::uintmax_t{4} << 30;
    if (!failed && size > maxSize)
        throw Error(ErrorKind::limit, path.string(),
                    "is larger than 4 GiB, the largest picture that is read");
    std::ifstream stream(path, std::ios::binary);
    std::vector<std::byte> bytes(failed ? 0 : size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (failed || !stream) fail("can not be read");
    return bytes;
}

bool beginsWith(std::span<const std::byte> file, std::string_view magic) {
    return file.size() >= magic.size() &&
           std::equal(magic.begin(), magic.end(), file.begin(),
                      [](char a, std::byte b) { return static_cast<std::byte>(a) == b; });
}

Image decode(std::span<const std::byte> file, const std::string& path) {
    if (beginsWith(file, "#?")) return decodeRadiance(file, path);
    if (beginsWith(file, "\x76\x2f\x31\x01")) return decodeExr(file, path);
    throw Error(ErrorKind::badInput, path, "is neither a Radiance picture (.hdr) nor an OpenEXR file (.exr)");
}

bool isRadiance(float value) {
    return value >= 0.0f && value <= maxRadiance;
}

/// Replaces values that are no radiance, and notes how many pixels had one.
void repair(HdrFile& file, const std::string& path) {
    const std::span<float> numbers = numbersOf(file.image);
    float largest = 0.0f;
    std::size_t dark = 0, bright = 0;
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        bool isDark = false, isBright = false;
        for (const float value : numbers.subspan(i, 3)) {
            if (isRadiance(value)) largest = std::max(largest, value);
            isBright |= value > maxRadiance;
            isDark |= !isRadiance(value) && !(value > maxRadiance);
        }
        dark += isDark;
        bright += isBright;
    }
    if (dark + bright == 0) return;
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        for (float& value : numbers.subspan(i, 3)) {
            if (!isRadiance(value)) value = value > maxRadiance ? largest : 0.0f;
        }
    }
    const auto note = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        file.notes.push_back(path + ": " + std::to_string(count) + " of " +
                             std::to_string(numbers.size() / 4) + " pixels have values " + what);
    };
    note(dark, "below 0 or that are no number, which are taken as 0");
    note(bright, "that are infinite or over 1e20, which are taken as the largest of the others");
}

}  // namespace

void requireHdrSize(const std::string& path, std::uint64_t width, std::uint64_t height) {
    constexpr std::uint64_t maxSide = 32768, maxPixels = std::uint64_t{1} << 27;
    if (width >= 1 && height >= 1 && width <= maxSide && height <= maxSide && width * height <= maxPixels)
        return;
    throw Error(ErrorKind::badInput, path,
                "has " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels; 1 to 32768 along each side and at most 134217728 were expected");
}

void convertToRec709(Image& image, const Chromaticities& from, const std::string& path) {
    constexpr double sameColor = 1e-4;
    const Chromaticities to = rec709Primaries();
    const auto same = [](const glm::dvec2& a, const glm::dvec2& b) {
        return glm::distance(a, b) < sameColor;
    };
    if (same(from.red, to.red) && same(from.green, to.green) && same(from.blue, to.blue) &&
        same(from.white, to.white))
        return;
    const glm::dmat3 matrix = rgbFromRgb(to, from);
    if (!allFinite(matrix))
        throw Error(ErrorKind::badInput, path, "its chromaticities are not those of three colours and white");
    const std::span<float> numbers = numbersOf(image);
    for (std::size_t i = 0; i < numbers.size(); i += 4) {
        const glm::dvec3 color = matrix * glm::dvec3(numbers[i], numbers[i + 1], numbers[i + 2]);
        for (int channel = 0; channel < 3; ++channel)
            numbers[i + static_cast<std::size_t>(channel)] = static_cast<float>(color[channel]);
    }
}

HdrFile readHdrFile(const std::filesystem::path& path) {
    HdrFile file;
    try {
        file.image = decode(readWholeFile(path), path.string());
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::limit, path.string(), "there is not enough memory for the picture");
    }
    file.image.name = path.filename().string();
    repair(file, path.string());
    return file;
}

}  // namespace candela
