#include "import/abi_import.h"

#include <array>
#include <cmath>
#include <limits>

namespace candela {
namespace {

constexpr std::uint32_t maxSide = 32768;

std::uint32_t checkedSide(const AbiReader& element, const char* member, std::uint32_t value) {
    if (value < 1 || value > maxSide)
        element.refuse(joined(member, " is ", value, ", but 1 to ", maxSide, " was expected"));
    return value;
}

void requireFiniteTexels(const AbiReader& element, const Image& image) {
    if (image.format != PixelFormat::rgba32f) return;
    for (std::size_t offset = 0; offset < image.pixels.size(); offset += sizeof(float)) {
        float value = 0.0f;
        std::memcpy(&value, image.pixels.data() + offset, sizeof value);
        if (std::isfinite(value)) continue;
        const std::size_t texel = offset / texelSize(image.format);
        element.refuse(joined("the texel in row ", texel / image.width, ", column ", texel % image.width,
                              " holds ", value, ", but finite numbers were expected"));
    }
}

}  // namespace

Image imageFrom(const candela_image& pushed, const AbiReader& element) {
    constexpr std::array formats{PixelFormat::rgba8, PixelFormat::rgba16, PixelFormat::rgba32f};
    Image image;
    image.name = element.name();
    image.width = checkedSide(element, "width", pushed.width);
    image.height = checkedSide(element, "height", pushed.height);
    image.format = formats[element.enumerator("format", pushed.format, formats.size())];
    const std::uint64_t expected = std::uint64_t{image.width} * image.height * texelSize(image.format);
    if (pushed.pixels_size != expected)
        element.refuse(joined("pixels_size is ", pushed.pixels_size, ", but ", image.width, " × ",
                              image.height, " texels of ", texelSize(image.format), " bytes make ",
                              expected));
    if (!pushed.pixels) element.refuse("pixels is NULL");
    image.pixels.resize(expected);
    std::memcpy(image.pixels.data(), pushed.pixels, expected);
    requireFiniteTexels(element, image);
    return image;
}

}  // namespace candela
