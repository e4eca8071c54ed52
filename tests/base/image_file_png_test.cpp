#include "temporary_folder.h"

#include <candela/error.h>
#include <candela/image_file.h>

#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

namespace candela {
namespace {

constexpr Chromaticities displayP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};

/// A PNG decoded by libpng.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
    bool isSrgb = false;
    std::optional<double> gamma;
    std::optional<Chromaticities> chromaticities;
};

Picture readPng(const std::filesystem::path& path) {
    Picture picture;
    std::FILE* file = std::fopen(path.c_str(), "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_RGB_ALPHA);
    EXPECT_EQ(png_get_bit_depth(png, info), 8);
    picture.width = png_get_image_width(png, info);
    picture.height = png_get_image_height(png, info);
    for (std::uint32_t row = 0; row < picture.height; ++row) {
        const png_bytep first = png_get_rows(png, info)[row];
        picture.rgba.insert(picture.rgba.end(), first, first + std::size_t{picture.width} * 4);
    }
    picture.isSrgb = png_get_valid(png, info, PNG_INFO_sRGB) != 0;
    double gamma = 0.0;
    if (png_get_gAMA(png, info, &gamma) != 0) picture.gamma = gamma;
    Chromaticities c;
    if (png_get_cHRM(png, info, &c.white.x, &c.white.y, &c.red.x, &c.red.y, &c.green.x, &c.green.y, &c.blue.x,
                     &c.blue.y) != 0)
        picture.chromaticities = c;
    png_destroy_read_struct(&png, &info, nullptr);
    std::fclose(file);
    return picture;
}

Picture writtenWith(const DisplayEncoding& encoding) {
    const TemporaryFolder folder;
    writePng(folder.path() / "a.png", 1, 1, std::vector<std::uint8_t>{1, 2, 3, 4}, encoding);
    return readPng(folder.path() / "a.png");
}

bool fileContains(const std::filesystem::path& path, const std::string& part) {
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    return text.find(part) != std::string::npos;
}

/// A cHRM chunk counts in 1/100000.
constexpr double chunkStep = 1.0e-5;

void expectNear(const Chromaticities& got, const Chromaticities& expected) {
    const glm::dvec2 differences[] = {got.red - expected.red, got.green - expected.green,
                                      got.blue - expected.blue, got.white - expected.white};
    for (const glm::dvec2& difference : differences) {
        EXPECT_NEAR(difference.x, 0.0, chunkStep);
        EXPECT_NEAR(difference.y, 0.0, chunkStep);
    }
}

TEST(ImageFilePng, keepsEveryValue) {
    const TemporaryFolder folder;
    constexpr std::uint32_t width = 37, height = 21;
    std::vector<std::uint8_t> rgba(width * height * 4);
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = std::uint8_t(i * 2654435761u >> 13);
    writePng(folder.path() / "a.png", width, height, rgba, {});
    const Picture picture = readPng(folder.path() / "a.png");
    EXPECT_EQ(picture.width, width);
    EXPECT_EQ(picture.height, height);
    EXPECT_EQ(picture.rgba, rgba);
    EXPECT_EQ(folder.entries(), 1);
}

TEST(ImageFilePng, tagsSrgb) {
    const Picture picture = writtenWith({.chromaticities = Chromaticities{}});
    EXPECT_TRUE(picture.isSrgb);
}

TEST(ImageFilePng, tagsTheSrgbCurveOverOtherPrimaries) {
    const Picture picture = writtenWith({.chromaticities = displayP3});
    EXPECT_FALSE(picture.isSrgb);
    ASSERT_TRUE(picture.gamma);
    EXPECT_NEAR(*picture.gamma, 1.0 / 2.2, chunkStep);
    ASSERT_TRUE(picture.chromaticities);
    expectNear(*picture.chromaticities, displayP3);
}

TEST(ImageFilePng, tagsTheSrgbCurveAloneWhenPrimariesAreUnknown) {
    const Picture picture = writtenWith({});
    EXPECT_FALSE(picture.isSrgb);
    EXPECT_TRUE(picture.gamma);
    EXPECT_FALSE(picture.chromaticities);
}

TEST(ImageFilePng, tagsGammaAndPrimaries) {
    const Picture picture = writtenWith(
        {.transfer = DisplayEncoding::Transfer::gamma, .gamma = 2.4, .chromaticities = Chromaticities{}});
    EXPECT_FALSE(picture.isSrgb);
    ASSERT_TRUE(picture.gamma);
    EXPECT_NEAR(*picture.gamma, 1.0 / 2.4, chunkStep);
    ASSERT_TRUE(picture.chromaticities);
    expectNear(*picture.chromaticities, Chromaticities{});
}

TEST(ImageFilePng, writesNoTagsForUnknownEncodings) {
    const TemporaryFolder folder;
    writePng(folder.path() / "a.png", 1, 1, std::vector<std::uint8_t>{1, 2, 3, 4},
             {.transfer = DisplayEncoding::Transfer::unknown, .chromaticities = {}});
    for (const char* chunk : {"sRGB", "gAMA", "cHRM", "iCCP"})
        EXPECT_FALSE(fileContains(folder.path() / "a.png", chunk)) << chunk;
}

TEST(ImageFilePng, leavesNoFileOnFailure) {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> rgba(4);
    EXPECT_THROW(writePng(folder.path() / "missing" / "a.png", 1, 1, rgba, {}), Error);
    EXPECT_THROW(writePng(folder.path(), 1, 1, rgba, {}), Error);
    EXPECT_THROW(writePng("/dev/full", 1, 1, rgba, {}), Error);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(ImageFilePng, rejectsInconsistentArgumentsBeforeWriting) {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> pixel(4);
    for (const auto& [width, height] : {std::pair{0u, 1u}, {1u, 0u}, {2u, 1u}, {0x80000000u, 1u}}) {
        try {
            writePng(folder.path() / "a.png", width, height, pixel, {});
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
        }
    }
    DisplayEncoding gamma;
    gamma.transfer = DisplayEncoding::Transfer::gamma;
    gamma.gamma = 0.0;
    EXPECT_THROW(writePng(folder.path() / "a.png", 1, 1, pixel, gamma), Error);
    EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace candela
