/// check_picture FILE WIDTH HEIGHT: succeeds if FILE is a PNG of that size that shows something: many
/// colours, not all dark.

#include <png.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace {

// The plaza under 256 coloured lights shows thousands; a gradient or a clear colour far fewer.
constexpr std::size_t minColors = 500;
constexpr std::uint8_t minPeak = 64;

int fail(const std::string& text) {
    std::cerr << "check_picture: " << text << "\n";
    return 1;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return fail("usage: check_picture FILE WIDTH HEIGHT");
    const std::string path = argv[1];
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return fail(path + ": " + image.message);
    if (std::to_string(image.width) != argv[2] || std::to_string(image.height) != argv[3])
        return fail(path + ": is " + std::to_string(image.width) + "x" + std::to_string(image.height));
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr) == 0)
        return fail(path + ": " + image.message);

    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i < rgb.size(); i += 3)
        colors.insert(static_cast<std::uint32_t>(rgb[i] | rgb[i + 1] << 8 | rgb[i + 2] << 16));
    if (colors.size() < minColors)
        return fail(path + ": has only " + std::to_string(colors.size()) + " colours");
    if (*std::ranges::max_element(rgb) < minPeak) return fail(path + ": is dark all over");
    return 0;
}
