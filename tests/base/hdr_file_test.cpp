// Reading pictures of linear light.

#include "base/primaries.h"
#include "hdr_samples.h"
#include "temporary_folder.h"

#include <candela/error.h>
#include <candela/image_file.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>

#include <cstring>
#include <limits>

namespace candela {
namespace {

constexpr std::uint32_t width = 20, height = 6;

glm::vec3 at(const Image& image, std::uint32_t x, std::uint32_t y) {
    glm::vec3 color;
    std::memcpy(&color, image.pixels.data() + (std::size_t{y} * image.width + x) * 16, sizeof color);
    return color;
}

class HdrFileTest : public testing::Test {
  protected:
    HdrFile read(const std::string& bytes) {
        const std::filesystem::path path = folder_.path() / "a.hdr";
        writeBytes(path, bytes);
        return readHdrFile(path);
    }
    std::string failure(const std::string& bytes) {
        try {
            read(bytes);
            return "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(error.path(), (folder_.path() / "a.hdr").string());
            return std::string(error.what()).substr(error.path().size() + 2);
        }
    }
    void expectTexels(const std::string& bytes, const std::vector<Rgbe>& texels) {
        const HdrFile file = read(bytes);
        ASSERT_EQ(file.image.width, width);
        ASSERT_EQ(file.image.height, height);
        EXPECT_TRUE(file.notes.empty());
        for (std::uint32_t i = 0; i < width * height; ++i) {
            const glm::vec3 color = at(file.image, i % width, i / width);
            for (std::size_t channel = 0; channel < 3; ++channel)
                ASSERT_EQ(color[static_cast<int>(channel)], static_cast<float>(valueOf(texels[i], channel)));
        }
    }

    TemporaryFolder folder_;
};

TEST_F(HdrFileTest, ReadsEveryCodingOfRadiance) {
    std::vector<Rgbe> texels = someTexels(width * height);
    for (std::uint32_t i = 2 * width; i < 3 * width; ++i) texels[i] = {9, 9, 9, 130};  // a run of a line
    texels[0] = {1, 2, 3, 0};                                                          // black
    const std::string header = radianceHeader("-Y 6 +X 20");
    expectTexels(header + uncoded(texels), texels);
    expectTexels(header + oldRuns(texels, width), texels);
    expectTexels(header + newRuns(texels, width), texels);
    EXPECT_EQ(read(header + uncoded(texels)).image.name, "a.hdr");
}

TEST_F(HdrFileTest, ReadsLongOldRuns) {
    const std::vector<Rgbe> texels(1000, {50, 60, 70, 128});
    const HdrFile file = read(radianceHeader("-Y 1 +X 1000") + oldRuns(texels, 1000));
    for (std::uint32_t x = 0; x < 1000; ++x) ASSERT_EQ(at(file.image, x, 0).g, 60.5f / 256.0f);
}

TEST_F(HdrFileTest, TurnsWhatAnOtherOrientationWasWrittenIn) {
    const std::vector<Rgbe> texels = someTexels(width * height);
    const auto texel = [&](std::uint32_t x, std::uint32_t y) { return texels[y * width + x]; };
    for (const bool fromBottom : {false, true}) {
        for (const bool fromRight : {false, true}) {
            std::vector<Rgbe> lines, columns;
            for (std::uint32_t i = 0; i < width * height; ++i) {
                const auto place = [&](std::uint32_t x, std::uint32_t y) {
                    return texel(fromRight ? width - 1 - x : x, fromBottom ? height - 1 - y : y);
                };
                lines.push_back(place(i % width, i / width));
                columns.push_back(place(i / height, i % height));
            }
            const std::string y = fromBottom ? "+Y 6" : "-Y 6", x = fromRight ? "-X 20" : "+X 20";
            expectTexels(radianceHeader(y + " " + x) + newRuns(lines, width), texels);
            expectTexels(radianceHeader(x + " " + y) + uncoded(columns), texels);
        }
    }
}

TEST_F(HdrFileTest, UndoesTheExposures) {
    const std::string bytes =
        radianceHeader("-Y 1 +X 1", "EXPOSURE=4\nSOFTWARE=x\nEXPOSURE= 0.5\n") + uncoded({{127, 63, 0, 129}});
    EXPECT_EQ(at(read(bytes).image, 0, 0), glm::vec3(127.5f, 63.5f, 0.5f) / 256.0f);
}

TEST_F(HdrFileTest, ConvertsXyzAndOtherPrimaries) {
    const Rgbe white{243, 255, 255, 128};
    const std::string xyz =
        "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + uncoded({{99, 99, 99, 128}});
    const glm::vec3 grey = at(read(xyz).image, 0, 0);  // XYZ's white is that of equal energy
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(grey[i], 99.5f / 256.0f, 1e-3f);
    const std::string wide =
        radianceHeader("-Y 1 +X 1", "PRIMARIES=0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290\n") +
        uncoded({white});
    const glm::dmat3 matrix = rgbFromRgb({}, knownPrimaries()[3].chromaticities);
    const glm::dvec3 expected = matrix * glm::dvec3(valueOf(white, 0), valueOf(white, 1), valueOf(white, 2));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(at(read(wide).image, 0, 0)[i], expected[i], 1e-6);
}

TEST_F(HdrFileTest, RefusesBrokenRadianceFiles) {
    const std::string size = "its header ends without its size: a line such as -Y 512 +X 1024 was expected";
    const std::string pixels = uncoded(someTexels(width * height));
    EXPECT_EQ(failure("P6 1 1 255"), "is neither a Radiance picture (.hdr) nor an OpenEXR file (.exr)");
    EXPECT_EQ(failure(""), "is neither a Radiance picture (.hdr) nor an OpenEXR file (.exr)");
    EXPECT_EQ(failure("#?RADIANCE\n"),
              "its header has no end: an empty line and a line such as -Y 512 +X 1024 were expected");
    for (const char* bad : {"", "-Y 6", "-Y 6 -Y 6", "Y 6 X 20", "-Y six +X 20", "-Y 6 +Z 20", "-X 6 +X 2"})
        EXPECT_EQ(failure(radianceHeader(bad) + pixels), size) << bad;
    EXPECT_EQ(failure("#?RGBE\nFORMAT=8-bit\n\n-Y 6 +X 20\n" + pixels),
              "its FORMAT is neither 32-bit_rle_rgbe nor 32-bit_rle_xyze");
    EXPECT_EQ(failure(radianceHeader("-Y 6 +X 20", "EXPOSURE=0\n") + pixels),
              "its EXPOSURE must be a number over 0");
    EXPECT_EQ(failure(radianceHeader("-Y 6 +X 20", "PRIMARIES=1 2 3\n") + pixels),
              "its PRIMARIES must be 8 numbers");
    EXPECT_EQ(failure(radianceHeader("-Y 6 +X 20", "PRIMARIES=0 0 0 0 0 0 0 0\n") + pixels),
              "its chromaticities are not those of three colours and white");
    EXPECT_EQ(failure(radianceHeader("-Y 6 +X 20") + pixels.substr(0, 100)), "ends within its pixels");
    EXPECT_EQ(failure(radianceHeader("-Y 1 +X 2") + uncoded({{1, 1, 1, 1}})),
              "a run of pixels leaves its line");
    EXPECT_EQ(failure(radianceHeader("-Y 1 +X 20") + std::string("\2\2\0\x15", 4)),
              "a line has a wrong length");
    EXPECT_EQ(failure(radianceHeader("-Y 1 +X 20") + std::string("\2\2\0\x14\xff\1", 6)),
              "a run of pixels leaves its line");
}

TEST_F(HdrFileTest, RefusesGiantsBeforeTheyTakeMemory) {
    EXPECT_EQ(failure(radianceHeader("-Y 32768 +X 32768")),
              "has 32768 x 32768 pixels; 1 to 32768 along each side and at most 134217728 were expected");
    EXPECT_EQ(failure(radianceHeader("-Y 1 +X 32769")),
              "has 32769 x 1 pixels; 1 to 32768 along each side and at most 134217728 were expected");
    EXPECT_EQ(failure(radianceHeader("-Y 0 +X 1")),
              "has 1 x 0 pixels; 1 to 32768 along each side and at most 134217728 were expected");
    // Within the limits, but the file is much too short for that.
    EXPECT_EQ(failure(radianceHeader("-Y 8192 +X 16384")), "ends within its pixels");
}

TEST_F(HdrFileTest, NamesWhatCanNotBeRead) {
    for (const std::filesystem::path& path : {folder_.path() / "missing.hdr", folder_.path()}) {
        try {
            readHdrFile(path);
            FAIL() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::environment);
            EXPECT_EQ(error.path(), path.string());
        }
    }
}

/// Exr files by OpenEXR itself.
class ExrFileTest : public HdrFileTest {
  protected:
    struct Channel {
        const char* name;
        Imf::PixelType type;
    };
    std::filesystem::path path() const { return folder_.path() / "a.exr"; }

    /// Channel i of the pixel (x, y) is `values[i] * (1 + x + 10 y)`.
    void write(Imf::Header header, const std::vector<Channel>& channels, const std::vector<float>& values) {
        for (const Channel& channel : channels) header.channels().insert(channel.name, channel.type);
        const Imath::Box2i window = header.dataWindow();
        const auto columns = std::size_t(window.max.x - window.min.x + 1);
        const auto rows = std::size_t(window.max.y - window.min.y + 1);
        std::vector<std::vector<char>> stores;
        Imf::FrameBuffer buffer;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const std::size_t size = channels[i].type == Imf::HALF ? 2 : 4;
            stores.emplace_back(columns * rows * size);
            for (std::size_t at = 0; at < columns * rows; ++at) {
                const float value = values[i] * float(1 + at % columns + 10 * (at / columns));
                const half small(value);
                const auto whole = static_cast<std::uint32_t>(value);
                const void* from = &value;
                if (channels[i].type == Imf::HALF) from = &small;
                if (channels[i].type == Imf::UINT) from = &whole;
                std::memcpy(stores.back().data() + at * size, from, size);
            }
            buffer.insert(channels[i].name,
                          Imf::Slice::Make(channels[i].type, stores.back().data(), window.min,
                                           std::int64_t(columns), std::int64_t(rows)));
        }
        if (header.hasTileDescription()) {
            Imf::TiledOutputFile file(path().c_str(), header);
            file.setFrameBuffer(buffer);
            file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
        } else {
            Imf::OutputFile file(path().c_str(), header);
            file.setFrameBuffer(buffer);
            file.writePixels(int(rows));
        }
    }
    std::string exrFailure() {
        try {
            readHdrFile(path());
            return "nothing was thrown";
        } catch (const Error& error) {
            return std::string(error.what()).substr(error.path().size() + 2);
        }
    }
};

TEST_F(ExrFileTest, ReadsEveryTypeOfChannel) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
        write(Imf::Header(7, 5), {{"R", type}, {"G", type}, {"B", type}, {"A", type}}, {1, 2, 3, 0});
        const HdrFile file = readHdrFile(path());
        ASSERT_EQ(file.image.width, 7u);
        ASSERT_EQ(file.image.height, 5u);
        EXPECT_TRUE(file.notes.empty());
        EXPECT_EQ(at(file.image, 0, 0), glm::vec3(1, 2, 3));
        EXPECT_EQ(at(file.image, 6, 4), glm::vec3(47, 94, 141));
    }
}

TEST_F(ExrFileTest, ReadsTilesAndEveryCompression) {
    for (const Imf::Compression compression :
         {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIP_COMPRESSION, Imf::PIZ_COMPRESSION}) {
        Imf::Header header(40, 40);
        header.compression() = compression;
        const std::vector<Channel> channels{{"R", Imf::HALF}, {"G", Imf::HALF}, {"B", Imf::HALF}};
        write(header, channels, {1, 0.5f, 0.25f});
        const HdrFile lines = readHdrFile(path());
        header.setTileDescription(Imf::TileDescription(16, 16));
        write(header, channels, {1, 0.5f, 0.25f});
        EXPECT_EQ(readHdrFile(path()).image.pixels, lines.image.pixels);
        EXPECT_EQ(at(lines.image, 39, 39), glm::vec3(430, 215, 107.5f));
    }
}

TEST_F(ExrFileTest, ReadsLuminanceAsGrey) {
    write(Imf::Header(3, 2), {{"Y", Imf::HALF}}, {2});
    EXPECT_EQ(at(readHdrFile(path()).image, 2, 1), glm::vec3(26));
}

TEST_F(ExrFileTest, PutsTheDataWindowIntoTheDisplayWindow) {
    // A display of 4 x 3 from (10, 20); data that begin left of it and end above its bottom.
    const Imf::Header header(Imath::Box2i({10, 20}, {13, 22}), Imath::Box2i({9, 20}, {12, 21}));
    write(header, {{"R", Imf::FLOAT}, {"G", Imf::FLOAT}, {"B", Imf::FLOAT}}, {1, 1, 1});
    const HdrFile file = readHdrFile(path());
    ASSERT_EQ(file.image.width, 4u);
    ASSERT_EQ(file.image.height, 3u);
    EXPECT_EQ(at(file.image, 0, 0), glm::vec3(2));
    EXPECT_EQ(at(file.image, 2, 1), glm::vec3(14));
    EXPECT_EQ(at(file.image, 3, 0), glm::vec3(0));
    EXPECT_EQ(at(file.image, 0, 2), glm::vec3(0));
}

TEST_F(ExrFileTest, ConvertsFromTheFilesPrimaries) {
    const Chromaticities ap1 = knownPrimaries()[1].chromaticities;
    const std::vector<float> red{0.5f}, green{0.25f}, blue{0.75f};
    writeExr(path(), 1, 1, std::vector<ExrChannel>{{"R", red}, {"G", green}, {"B", blue}}, ap1);
    const glm::dvec3 expected = rgbFromRgb({}, ap1) * glm::dvec3(0.5, 0.25, 0.75);
    const glm::vec3 is = at(readHdrFile(path()).image, 0, 0);
    // The file has its chromaticities in single precision.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(is[i], expected[i], 1e-5);
    writeExr(path(), 1, 1, std::vector<ExrChannel>{{"R", red}, {"G", green}, {"B", blue}}, {});
    EXPECT_EQ(at(readHdrFile(path()).image, 0, 0), glm::vec3(0.5f, 0.25f, 0.75f));
}

TEST_F(ExrFileTest, ReplacesWhatIsNoLightWithANote) {
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> red{1, -1, nan, inf, 2}, green{1, 1, 1, 1, 3}, blue{1, 1, -inf, 1e21f, 1};
    writeExr(path(), 5, 1, std::vector<ExrChannel>{{"R", red}, {"G", green}, {"B", blue}}, {});
    const HdrFile file = readHdrFile(path());
    EXPECT_EQ(at(file.image, 0, 0), glm::vec3(1));
    EXPECT_EQ(at(file.image, 1, 0), glm::vec3(0, 1, 1));
    EXPECT_EQ(at(file.image, 2, 0), glm::vec3(0, 1, 0));
    EXPECT_EQ(at(file.image, 3, 0), glm::vec3(3, 1, 3));
    ASSERT_EQ(file.notes.size(), 2u);
    EXPECT_EQ(file.notes[0], path().string() +
                                 ": 2 of 5 pixels have values below 0 or that are no number, "
                                 "which are taken as 0");
    EXPECT_EQ(file.notes[1], path().string() +
                                 ": 1 of 5 pixels have values that are infinite or over 1e20, "
                                 "which are taken as the largest of the others");
}

TEST_F(ExrFileTest, RefusesOtherFiles) {
    write(Imf::Header(2, 2), {{"R", Imf::HALF}, {"G", Imf::HALF}, {"Z", Imf::FLOAT}}, {1, 1, 1});
    EXPECT_EQ(exrFailure(), "has no EXR channels R, G and B, nor Y, in its first part");
    writeBytes(path(), std::string("\x76\x2f\x31\x01\x02\0\0\0", 8));
    EXPECT_TRUE(exrFailure().starts_with("can not be read as EXR: ")) << exrFailure();
    Imf::Header wide(1, 1);
    wide.dataWindow() = Imath::Box2i({0, 0}, {0, 0});
    wide.displayWindow() = Imath::Box2i({0, 0}, {99999, 99999});
    write(wide, {{"Y", Imf::HALF}}, {1});
    EXPECT_EQ(exrFailure(),
              "has 100000 x 100000 pixels; 1 to 32768 along each side and at most 134217728 were expected");
}

}  // namespace
}  // namespace candela
