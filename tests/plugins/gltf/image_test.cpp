#include <candela/threads.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <iterator>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

/// A file whose material uses image 0.
GltfFile fileWithImage(const std::string& image) {
    GltfFile file;
    file.add("images", image);
    file.add("textures", R"({"source":0})");
    file.add("materials", R"({"emissiveTexture":{"index":0}})");
    return file;
}

GltfFile fileWithImage(const Bytes& image, const std::string& mimeType) {
    return fileWithImage(R"({"name":"picture","uri":"data:)" + mimeType + ";base64," + base64(image) + "\"}");
}

candela::Image imageOf(const GltfFile& file) {
    return load(file).scene.images.at(0);
}

std::vector<int> texels8(const candela::Image& image) {
    std::vector<int> values;
    for (const std::byte byte : image.pixels) values.push_back(std::to_integer<int>(byte));
    return values;
}

std::vector<int> texels16(const candela::Image& image) {
    std::vector<std::uint16_t> values(image.pixels.size() / 2);
    std::memcpy(values.data(), image.pixels.data(), image.pixels.size());
    return {values.begin(), values.end()};
}

TEST(Image, pngRowsStartAtTheTop) {
    const Bytes samples{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    const candela::Image image =
        imageOf(fileWithImage(makePng(2, 2, 8, PngColor::rgba, samples), "image/png"));
    EXPECT_EQ(image.name, "picture");
    EXPECT_EQ(image.width, 2u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_EQ(image.format, candela::PixelFormat::rgba8);
    EXPECT_EQ(texels8(image), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}));
}

TEST(Image, pngWithoutAlphaIsOpaque) {
    const Bytes samples{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(texels8(imageOf(fileWithImage(makePng(2, 1, 8, PngColor::rgb, samples), "image/png"))),
              (std::vector<int>{1, 2, 3, 255, 4, 5, 6, 255}));
    EXPECT_EQ(texels8(imageOf(fileWithImage(makePng(1, 1, 8, PngColor::grey, {9}), "image/png"))),
              (std::vector<int>{9, 9, 9, 255}));
}

TEST(Image, sixteenBitPngsStaySixteenBit) {
    const Bytes samples{0x12, 0x34, 0x00, 0x01, 0xFF, 0xFE, 0x80, 0x00};
    const candela::Image image =
        imageOf(fileWithImage(makePng(1, 1, 16, PngColor::rgba, samples), "image/png"));
    EXPECT_EQ(image.format, candela::PixelFormat::rgba16);
    EXPECT_EQ(texels16(image), (std::vector<int>{0x1234, 0x0001, 0xFFFE, 0x8000}));
}

TEST(Image, jpeg) {
    const candela::Image image = imageOf(fileWithImage(makeGreyJpeg(), "image/jpeg"));
    EXPECT_EQ(image.width, 8u);
    EXPECT_EQ(image.height, 8u);
    ASSERT_EQ(image.pixels.size(), 256u);
    // JPEG decoders may differ by one code value (ITU-T T.83).
    EXPECT_NEAR(texels8(image)[0], 192, 1);
    EXPECT_NEAR(texels8(image)[254], 192, 1);
    EXPECT_EQ(texels8(image)[3], 255);
}

TEST(Image, impossibleSizesAreRejectedBeforeAllocating) {
    const std::string error =
        complaintsOf(fileWithImage(makePng(32768, 32768, 16, PngColor::rgba, {}), "image/png"));
    EXPECT_NE(error.find("image 0 'picture': the PNG file is broken: it is too short"), std::string::npos)
        << error;
    Bytes jpeg = makeGreyJpeg();
    // The frame header's height and width follow the marker, a length and the sample size.
    const std::uint8_t marker[] = {0xFF, 0xC0};
    const auto frame = std::search(jpeg.begin(), jpeg.end(), std::begin(marker), std::end(marker));
    frame[5] = frame[7] = 0x7F;
    const std::string jpegError = complaintsOf(fileWithImage(jpeg, "image/jpeg"));
    EXPECT_NE(jpegError.find("image 0 'picture': the JPEG file is broken: it is too short"),
              std::string::npos)
        << jpegError;
    const std::string wide =
        complaintsOf(fileWithImage(makePng(40000, 1, 8, PngColor::grey, {}), "image/png"));
    EXPECT_NE(wide.find("image 0 'picture': the PNG file is wider or higher than 32768"), std::string::npos)
        << wide;
}

TEST(Image, fromABufferView) {
    GltfFile file = fileWithImage(R"({"bufferView":0,"mimeType":"image/png"})");
    file.addView(makePng(1, 1, 7, 8, 9, 10));
    EXPECT_EQ(texels8(imageOf(file)), (std::vector<int>{7, 8, 9, 10}));
    EXPECT_EQ(texels8(loadGlb(file.glb()).scene.images.at(0)), (std::vector<int>{7, 8, 9, 10}));
}

TEST(Image, fromAFileWithAnEscapedName) {
    const TemporaryFolder folder;
    folder.write("tex/my picture+1.png", makePng(1, 1, 7, 8, 9, 10));
    const GltfFile file = fileWithImage(R"({"uri":"tex/my%20picture+1.png"})");
    const candela::ImportedScene imported = loadPath(folder.write("scene.gltf", file.text()));
    EXPECT_EQ(texels8(imported.scene.images.at(0)), (std::vector<int>{7, 8, 9, 10}));
}

/// A file whose materials use `count` images of different colours; those of `broken` are cut off.
GltfFile fileWithImages(std::uint8_t count, const std::vector<std::uint8_t>& broken) {
    GltfFile file;
    for (std::uint8_t i = 0; i < count; ++i) {
        Bytes png = makePng(16, 16, i, 0, 0, 255);
        if (std::find(broken.begin(), broken.end(), i) != broken.end()) png.resize(png.size() / 2);
        file.add("images", R"({"uri":"data:image/png;base64,)" + base64(png) + "\"}");
        file.add("textures", R"({"source":)" + std::to_string(i) + "}");
        file.add("materials", R"({"emissiveTexture":{"index":)" + std::to_string(i) + "}}");
    }
    return file;
}

TEST(Image, theirOrderIsKept) {
    for (const unsigned threads : {1u, 4u}) {
        candela::setThreadCount(threads);
        const candela::ImportedScene imported = load(fileWithImages(60, {}));
        ASSERT_EQ(imported.scene.images.size(), 60u);
        for (std::size_t i = 0; i < 60; ++i)
            EXPECT_EQ(std::to_integer<std::size_t>(imported.scene.images[i].pixels[0]), i);
    }
    candela::setThreadCount(0);
}

TEST(Image, brokenOnesAreLeftOutAndTheOthersKeepTheirPlace) {
    for (const unsigned threads : {1u, 4u}) {
        candela::setThreadCount(threads);
        const candela::ImportedScene imported = load(fileWithImages(60, {57, 31, 44}));
        EXPECT_EQ(imported.scene.images.size(), 57u);
        EXPECT_TRUE(hasNote(imported, "image 31 and 2 more: the PNG file is broken"));
        EXPECT_FALSE(imported.scene.materials.at(31).emissionTexture);
        const auto& texture = imported.scene.materials.at(32).emissionTexture;
        EXPECT_EQ(std::to_integer<int>(imported.scene.images.at(texture.value().image).pixels[0]), 32);
    }
    candela::setThreadCount(0);
}

TEST(Image, unusedImagesAreNotRead) {
    GltfFile file;
    file.add("images", R"({"uri":"absent.png"})");
    EXPECT_TRUE(load(file).scene.images.empty());
}

/// The note of a file with this image, whose material keeps its factor.
std::string noteOf(const Bytes& image) {
    const candela::ImportedScene imported = load(fileWithImage(image, "image/png"));
    EXPECT_FALSE(imported.scene.materials.at(0).emissionTexture);
    EXPECT_EQ(imported.report.notes.size(), 1u);
    return imported.report.notes.at(0).line();
}

Bytes bytesOfText(const std::string& text) {
    return {text.begin(), text.end()};
}

TEST(Image, brokenImagesAreNamed) {
    Bytes cutPng = makePng(4, 4, 1, 2, 3, 4);
    cutPng.resize(cutPng.size() / 2);
    EXPECT_TRUE(noteOf(cutPng).starts_with("image 0 'picture': the PNG file is broken"));
    Bytes cutJpeg = makeGreyJpeg();
    cutJpeg.resize(cutJpeg.size() - 3);
    EXPECT_TRUE(noteOf(cutJpeg).starts_with("image 0 'picture': the JPEG file is broken: "));
    Bytes flippedPng = makePng(4, 4, 1, 2, 3, 4);
    flippedPng[flippedPng.size() / 2] ^= 1;
    EXPECT_TRUE(noteOf(flippedPng).starts_with("image 0 'picture': the PNG file is broken"));
}

TEST(Image, otherFormatsAreNamed) {
    const std::pair<std::string, const char*> formats[] = {
        {"GIF89a", "a GIF file"},
        {std::string("BM1234\0\0\0\0", 10), "a BMP file"},
        {"DDS |", "a DDS file"},
        {"#?RADIANCE\n", "a Radiance HDR file"},
        {std::string("\0\0\0\x1c"
                     "ftypavif",
                     12),
         "an AVIF file"},
        {std::string("II*\0", 4), "a TIFF file"},
        {"version https://git-lfs.github.com/spec/v1\n", "a Git LFS pointer"},
    };
    for (const auto& [content, name] : formats) {
        const std::string note = noteOf(bytesOfText(content));
        EXPECT_TRUE(note.starts_with("image 0 'picture': " + std::string(name))) << note;
        EXPECT_NE(note.find("expected PNG, JPEG, WebP or KTX2"), std::string::npos) << note;
    }
    EXPECT_EQ(noteOf(bytesOfText("who knows")),
              "image 0 'picture': of no known format, expected PNG, JPEG, WebP or KTX2: left out");
}

TEST(Image, aMissingFileIsNamed) {
    const candela::ImportedScene imported = load(fileWithImage(R"({"uri":"gone.png"})"));
    ASSERT_EQ(imported.report.notes.size(), 1u);
    EXPECT_EQ(imported.report.notes[0].line(),
              "image 0: file 'gone.png': No such file or directory: left out");
}

}  // namespace
}  // namespace candela_test
