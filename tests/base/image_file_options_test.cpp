// What the options of PNG and EXR files change, and the attributes of EXR files.
#include "temporary_folder.h"

#include <candela/error.h>
#include <candela/image_file.h>

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfMatrixAttribute.h>
#include <ImfRationalAttribute.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace candela {
namespace {

using Bytes = std::vector<std::byte>;

/// A smooth ramp with a pattern, so that every predictor and level has something to do.
std::vector<std::uint8_t> rampOf(std::uint32_t width, std::uint32_t height, std::uint8_t alpha) {
    std::vector<std::uint8_t> rgba;
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            for (const std::uint32_t value : {x * 3, y * 5 + x % 2, x + y, std::uint32_t{alpha}})
                rgba.push_back(std::uint8_t(value));
    return rgba;
}

std::vector<std::uint8_t> decodedPng(const Bytes& bytes, png_uint_32 format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    EXPECT_EQ(image.format & PNG_FORMAT_FLAG_ALPHA, format & PNG_FORMAT_FLAG_ALPHA);
    image.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, rgba.data(), 0, nullptr), 0);
    return rgba;
}

TEST(PngOptions, EveryLevelKeepsThePixels) {
    const std::vector<std::uint8_t> rgba = rampOf(61, 43, 200);
    for (int level = 0; level <= 9; ++level)
        EXPECT_EQ(decodedPng(encodePng("a.png", 61, 43, rgba, {}, {.level = level}), PNG_FORMAT_RGBA), rgba)
            << level;
}

TEST(PngOptions, OpaquePicturesHaveNoAlpha) {
    const std::vector<std::uint8_t> rgba = rampOf(61, 43, 255);
    for (const int level : {0, 1, 6})
        EXPECT_EQ(decodedPng(encodePng("a.png", 61, 43, rgba, {}, {.level = level}), PNG_FORMAT_RGB), rgba)
            << level;
}

TEST(PngOptions, HigherLevelsAreSmaller) {
    const std::vector<std::uint8_t> rgba = rampOf(256, 256, 255);
    const std::size_t stored = encodePng("a.png", 256, 256, rgba, {}, {.level = 0}).size();
    const std::size_t quick = encodePng("a.png", 256, 256, rgba, {}).size();
    const std::size_t small = encodePng("a.png", 256, 256, rgba, {}, {.level = 9}).size();
    EXPECT_GT(stored, 3u * 256 * 256);
    EXPECT_LT(quick, stored / 2);
    EXPECT_LT(small, quick);
}

TEST(PngOptions, OtherLevelsAreRefused) {
    const std::vector<std::uint8_t> rgba(4);
    EXPECT_THROW(encodePng("a.png", 1, 1, rgba, {}, {.level = -1}), Error);
    EXPECT_THROW(encodePng("a.png", 1, 1, rgba, {}, {.level = 10}), Error);
}

constexpr int width = 40, height = 70;  // More than two blocks of 32 rows.

std::vector<float> waves() {
    std::vector<float> values;
    for (int i = 0; i < width * height; ++i)
        values.push_back(1.5f + std::sin(float(i % width) * 0.1f) * std::cos(float(i / width) * 0.07f));
    return values;
}

std::filesystem::path written(const TemporaryFolder& folder, const std::vector<ExrChannel>& channels,
                              const ExrOptions& options, const std::vector<ExrAttribute>& attributes = {}) {
    writeExr(folder.path() / "a.exr", width, height, channels, {}, attributes, options);
    return folder.path() / "a.exr";
}

std::vector<float> readChannel(const std::filesystem::path& path, const char* name) {
    Imf::InputFile file(path.c_str());
    std::vector<float> values(width * height);
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                   sizeof(float) * width));
    file.setFrameBuffer(buffer);
    file.readPixels(0, height - 1);
    return values;
}

TEST(ExrOptions, CompressionsWithoutLossKeepEveryBit) {
    const TemporaryFolder folder;
    const std::vector<float> values = waves();
    using enum ExrCompression;
    for (const auto& [compression, stored] :
         {std::pair{none, Imf::NO_COMPRESSION}, {zip, Imf::ZIP_COMPRESSION}, {piz, Imf::PIZ_COMPRESSION}}) {
        const auto path = written(folder, {{"R", values}}, {.compression = compression});
        EXPECT_EQ(Imf::InputFile(path.c_str()).header().compression(), stored) << toString(compression);
        EXPECT_EQ(readChannel(path, "R"), values) << toString(compression);
    }
}

TEST(ExrOptions, DwaaLosesLittle) {
    const TemporaryFolder folder;
    const std::vector<float> values = waves();
    const auto path =
        written(folder, {{"R", values}, {"G", values}, {"B", values}}, {.compression = ExrCompression::dwaa});
    EXPECT_EQ(Imf::InputFile(path.c_str()).header().compression(), Imf::DWAA_COMPRESSION);
    const std::vector<float> read = readChannel(path, "G");
    // Its default level, 45, stands for quantisation steps of 45e-5 of values on a perceptual scale, and it
    // keeps half floats: 1 % of values of 0.5 to 2.5 is more than both.
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(read[i], values[i], 0.01f * values[i]);
}

TEST(ExrOptions, HalfRoundsAndStaysFinite) {
    const TemporaryFolder folder;
    std::vector<float> values = waves(), depth = waves();
    values[0] = 1.0e9f;
    values[1] = -1.0e9f;
    values[2] = std::numeric_limits<float>::infinity();
    values[3] = std::numeric_limits<float>::quiet_NaN();
    values[4] = 65519.0f;
    const auto path = written(folder, {{"R", values, ExrPixelType::half}, {"Z", depth}}, {});
    const Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().channels()["R"].type, Imf::HALF);
    EXPECT_EQ(file.header().channels()["Z"].type, Imf::FLOAT);
    const std::vector<float> read = readChannel(path, "R");
    EXPECT_EQ(read[0], 65504.0f);
    EXPECT_EQ(read[1], -65504.0f);
    EXPECT_EQ(read[2], values[2]);
    EXPECT_TRUE(std::isnan(read[3]));
    EXPECT_EQ(read[4], 65504.0f);
    // Half has 11 bits of precision: rounding moves a value by at most 2^-12 of the next power of two.
    for (std::size_t i = 5; i < values.size(); ++i) EXPECT_NEAR(read[i], values[i], 4.0f / 4096.0f) << i;
    EXPECT_EQ(readChannel(path, "Z"), depth);
}

TEST(ExrOptions, ThreadsMakeTheSameFile) {
    const std::vector<float> values = waves();
    const std::vector<ExrChannel> channels{{"R", values}};
    for (const ExrCompression compression : {ExrCompression::none, ExrCompression::zip})
        EXPECT_EQ(encodeExr("a.exr", width, height, channels, {}, {}, {compression, 3}),
                  encodeExr("a.exr", width, height, channels, {}, {}, {compression, 1}));
    EXPECT_THROW(encodeExr("a.exr", width, height, channels, {}, {}, {.threads = 0}), Error);
    EXPECT_THROW(encodeExr("a.exr", width, height, channels, {}, {}, {.threads = 1025}), Error);
}

template <typename Attribute>
auto valueOf(const Imf::InputFile& file, const char* name) {
    return file.header().typedAttribute<Attribute>(name).value();
}

TEST(ExrAttributes, HaveTheTypeOfTheirValue) {
    const TemporaryFolder folder;
    const std::vector<float> values = waves();
    glm::mat4 matrix(1.0f);
    matrix[3] = {2.0f, 3.0f, 4.0f, 1.0f};  // A translation: the last row of a matrix for row vectors.
    const auto path = written(folder, {{"R", values}}, {},
                              {{"text", "a\nb"},
                               {"whole", 7},
                               {"number", 0.25f},
                               {"rate", ExrRational{24000, 1001}},
                               {"matrix", matrix}});
    const Imf::InputFile file(path.c_str());
    EXPECT_EQ(valueOf<Imf::StringAttribute>(file, "text"), "a\nb");
    EXPECT_EQ(valueOf<Imf::IntAttribute>(file, "whole"), 7);
    EXPECT_EQ(valueOf<Imf::FloatAttribute>(file, "number"), 0.25f);
    EXPECT_EQ(valueOf<Imf::RationalAttribute>(file, "rate").n, 24000);
    EXPECT_EQ(valueOf<Imf::RationalAttribute>(file, "rate").d, 1001u);
    const Imath::M44f read = valueOf<Imf::M44fAttribute>(file, "matrix");
    EXPECT_EQ(Imath::V3f(1.0f, 1.0f, 1.0f) * read, Imath::V3f(3.0f, 4.0f, 5.0f));
}

}  // namespace
}  // namespace candela
