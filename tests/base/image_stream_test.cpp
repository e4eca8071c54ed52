#include <candela/image_stream.h>

#include "temporary_folder.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t width = 53, height = 97;  // More than three blocks of 32 rows.

std::vector<std::byte> bytesOf(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

/// Rows at a time: all, single ones, and numbers that divide neither the picture nor a block.
constexpr std::uint32_t bands[] = {height, 1, 7, 32, 40};

std::vector<std::uint8_t> ramp(std::uint8_t alpha) {
    std::vector<std::uint8_t> rgba;
    for (std::uint32_t i = 0; i < width * height; ++i)
        for (const std::uint32_t value : {i, i / width, 3 * i, std::uint32_t{alpha}})
            rgba.push_back(static_cast<std::uint8_t>(value));
    return rgba;
}

TEST(PngStream, WritesTheFileOfTheWholePicture) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.png";
    for (const PngAlpha alpha : {PngAlpha::none, PngAlpha::straight}) {
        const std::vector<std::uint8_t> rgba = ramp(alpha == PngAlpha::none ? 255 : 100);
        for (const int level : {0, 1, 6}) {
            const auto expected = encodePng("a.png", width, height, rgba, {}, {.level = level});
            for (const std::uint32_t rows : bands) {
                WholeFile file(path);
                PngStream png(file, width, height, {}, alpha, {.level = level});
                for (std::uint32_t row = 0; row < height; row += rows) {
                    const std::size_t count = std::min(rows, height - row);
                    png.write(std::span(rgba).subspan(4 * width * std::size_t{row}, 4 * width * count));
                }
                png.finish();
                file.finish();
                EXPECT_EQ(bytesOf(path), expected) << "level " << level << ", " << rows << " rows at a time";
            }
        }
    }
}

TEST(PngStream, AlphaThatIsNotThereIsNotRead) {
    const TemporaryFolder folder;
    WholeFile file(folder.path() / "a.png");
    PngStream png(file, width, height, {}, PngAlpha::none);
    png.write(ramp(17));
    png.finish();
    file.finish();
    EXPECT_EQ(bytesOf(folder.path() / "a.png"), encodePng("a.png", width, height, ramp(255), {}));
}

std::vector<float> waves(float frequency) {
    std::vector<float> values;
    for (std::uint32_t i = 0; i < width * height; ++i)
        values.push_back(1.5f + std::sin(float(i % width) * frequency) * std::cos(float(i / width) * 0.07f));
    return values;
}

TEST(ExrStream, WritesTheFileOfTheWholePicture) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.exr";
    const std::vector<float> r = waves(0.1f), g = waves(0.2f), b = waves(0.3f), z = waves(0.4f);
    const std::vector<ExrChannel> channels{
        {"R", r, ExrPixelType::half}, {"G", g, ExrPixelType::half}, {"B", b, ExrPixelType::half}, {"Z", z}};
    const std::vector<ExrChannelType> types{
        {"R", ExrPixelType::half}, {"G", ExrPixelType::half}, {"B", ExrPixelType::half}, {"Z"}};
    const std::vector<ExrAttribute> attributes{{"samples", "16"}, {"imageCounter", 7}};
    using enum ExrCompression;
    for (const ExrCompression compression : {none, zip, piz, dwaa}) {
        for (const unsigned threads : {1u, 3u}) {
            const ExrOptions options{compression, threads};
            const auto expected = encodeExr("a.exr", width, height, channels, {}, attributes, options);
            for (const std::uint32_t rows : bands) {
                WholeFile file(path);
                ExrStream exr(file, width, height, types, {}, attributes, options);
                for (std::uint32_t row = 0; row < height; row += rows) {
                    const std::size_t first = std::size_t{row} * width;
                    const std::size_t count = std::size_t{std::min(rows, height - row)} * width;
                    std::vector<std::span<const float>> band;
                    for (const ExrChannel& channel : channels)
                        band.push_back(channel.values.subspan(first, count));
                    exr.write(band);
                }
                exr.finish();
                file.finish();
                EXPECT_EQ(bytesOf(path), expected)
                    << toString(compression) << ", " << rows << " rows at a time, " << threads << " threads";
            }
        }
    }
}

TEST(ImageStream, LeavesNothingOfAPictureThatIsNotFinished) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.png";
    {
        WholeFile file(path);
        PngStream png(file, width, height, {}, PngAlpha::none);
        png.write(std::vector<std::uint8_t>(4 * width));
        EXPECT_THROW(png.finish(), Error) << "rows are missing";
        EXPECT_THROW(png.write(std::vector<std::uint8_t>(5)), Error) << "no whole row";
        EXPECT_THROW(png.write(std::vector<std::uint8_t>(4 * width * height)), Error) << "too many";
        WholeFile other(folder.path() / "a.exr");
        const std::vector<ExrChannelType> types{{"R"}, {"G"}};
        ExrStream exr(other, width, height, types, {});
        const std::vector<float> row(width), rows(2 * width);
        EXPECT_THROW(exr.write(std::vector<std::span<const float>>{row}), Error) << "a channel is missing";
        EXPECT_THROW(exr.write(std::vector<std::span<const float>>{row, rows}), Error);
        exr.write(std::vector<std::span<const float>>{row, row});
        EXPECT_THROW(exr.finish(), Error);
        EXPECT_EQ(folder.entries(), 0);
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(ImageStream, RefusesWhatEncodersRefuse) {
    const TemporaryFolder folder;
    WholeFile file(folder.path() / "a");
    EXPECT_THROW(PngStream(file, 0, 1, {}, PngAlpha::none), Error);
    EXPECT_THROW(PngStream(file, 1, 1, {}, PngAlpha::none, {.level = 10}), Error);
    const std::vector<ExrChannelType> twice{{"R"}, {"R"}}, one{{"R"}};
    EXPECT_THROW(ExrStream(file, 1, 1, {}, {}), Error);
    EXPECT_THROW(ExrStream(file, 1, 1, twice, {}), Error);
    EXPECT_THROW(ExrStream(file, 1, 1, one, {}, {}, {.threads = 0}), Error);
    PngStream png(file, 1, 1, {}, PngAlpha::none);
    png.write(std::vector<std::uint8_t>(4));
    png.finish();
    EXPECT_THROW(png.finish(), Error);
}

}  // namespace
}  // namespace candela
