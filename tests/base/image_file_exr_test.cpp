#include "temporary_folder.h"

#include <candela/error.h>
#include <candela/image_file.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace candela {
namespace {

constexpr Chromaticities acesCg{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};

std::vector<float> readChannel(Imf::InputFile& file, const char* name) {
    const Imath::Box2i window = file.header().dataWindow();
    const std::size_t width = std::size_t(window.max.x + 1), height = std::size_t(window.max.y + 1);
    std::vector<float> values(width * height);
    Imf::FrameBuffer buffer;
    buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                   sizeof(float) * width));
    file.setFrameBuffer(buffer);
    file.readPixels(0, int(height) - 1);
    return values;
}

std::vector<std::uint32_t> bits(const std::vector<float>& values) {
    std::vector<std::uint32_t> result;
    for (float value : values) result.push_back(std::bit_cast<std::uint32_t>(value));
    return result;
}

std::vector<float> noise(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<float> values(count);
    for (float& value : values) value = float(random()) / 1000.0f - 1.0e6f;
    return values;
}

TEST(ImageFileExr, keepsEveryChannelBitForBit) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.exr").string();
    constexpr std::uint32_t width = 41, height = 35;  // Not whole ZIP blocks of 16 lines.
    std::vector<float> red = noise(width * height, 1), depth = noise(width * height, 2);
    red[0] = std::numeric_limits<float>::infinity();
    red[1] = std::numeric_limits<float>::quiet_NaN();
    red[2] = -0.0f;
    red[3] = std::numeric_limits<float>::denorm_min();
    writeExr(path, width, height, std::vector<ExrChannel>{{"R", red}, {"P.X", depth}}, acesCg);

    Imf::InputFile file(path.c_str());
    EXPECT_TRUE(file.isComplete());
    EXPECT_EQ(file.header().dataWindow(), Imath::Box2i({0, 0}, {int(width) - 1, int(height) - 1}));
    EXPECT_EQ(file.header().displayWindow(), file.header().dataWindow());
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_FALSE(file.header().hasTileDescription());
    EXPECT_EQ(bits(readChannel(file, "R")), bits(red));
    EXPECT_EQ(bits(readChannel(file, "P.X")), bits(depth));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(ImageFileExr, hasTheChannelsOfTheCallerAsFloats) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.exr").string();
    const std::vector<float> values(2);
    writeExr(path, 2, 1,
             std::vector<ExrChannel>{{"base_color.R", values}, {"Z", values}, {"light_count", values}}, {});
    const Imf::InputFile file(path.c_str());
    std::vector<std::string> names;
    for (auto channel = file.header().channels().begin(); channel != file.header().channels().end();
         ++channel) {
        names.push_back(channel.name());
        EXPECT_EQ(channel.channel().type, Imf::FLOAT);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"Z", "base_color.R", "light_count"}));  // OpenEXR sorts.
}

TEST(ImageFileExr, storesChromaticities) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.exr").string();
    const std::vector<float> values(1);
    writeExr(path, 1, 1, std::vector<ExrChannel>{{"R", values}}, acesCg);
    const Imf::InputFile file(path.c_str());
    ASSERT_TRUE(Imf::hasChromaticities(file.header()));
    const Imf::Chromaticities& read = Imf::chromaticities(file.header());
    EXPECT_EQ(read.red, Imath::V2f(0.713f, 0.293f));
    EXPECT_EQ(read.green, Imath::V2f(0.165f, 0.830f));
    EXPECT_EQ(read.blue, Imath::V2f(0.128f, 0.044f));
    EXPECT_EQ(read.white, Imath::V2f(0.32168f, 0.33767f));
}

TEST(ImageFileExr, leavesNoFileOnFailure) {
    const TemporaryFolder folder;
    const std::vector<float> values(1);
    const std::vector<ExrChannel> channels{{"R", values}};
    EXPECT_THROW(writeExr(folder.path() / "missing" / "a.exr", 1, 1, channels, {}), Error);
    EXPECT_THROW(writeExr(folder.path(), 1, 1, channels, {}), Error);
    EXPECT_THROW(writeExr("/dev/full", 1, 1, channels, {}), Error);
    EXPECT_EQ(folder.entries(), 0);
}

TEST(ImageFileExr, convertsOpenExrExceptionsToErrors) {
    const TemporaryFolder folder;
    const std::vector<float> values(1);
    // OpenEXR refuses a channel without a name.
    try {
        writeExr(folder.path() / "a.exr", 1, 1, std::vector<ExrChannel>{{"", values}}, {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.path(), (folder.path() / "a.exr").string());
    }
    EXPECT_EQ(folder.entries(), 0);
}

TEST(ImageFileExr, rejectsInconsistentArgumentsBeforeWriting) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.path() / "a.exr";
    const std::vector<float> two(2), three(3);
    const auto refuse = [&](std::uint32_t width, std::uint32_t height, std::vector<ExrChannel> channels) {
        try {
            writeExr(path, width, height, channels, {});
            ADD_FAILURE() << "no error";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(error.path(), path.string());
        }
    };
    refuse(2, 1, {});
    refuse(0, 1, {{"R", {}}});
    refuse(2, 0x80000000u, {{"R", two}});
    refuse(2, 1, {{"R", two}, {"G", three}});
    refuse(2, 1, {{"R", two}, {"G", two}, {"R", two}});
    EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace candela
