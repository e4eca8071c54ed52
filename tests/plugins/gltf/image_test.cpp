#include <candela/threads.h>

#include <gtest/gtest.h>

#include <algorithm>
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
        errorOf(fileWithImage(makePng(32768, 32768, 16, PngColor::rgba, {}), "image/png"));
    EXPECT_NE(error.find("image 0 'picture': the PNG file is broken: it is too short"), std::string::npos)
        << error;
    Bytes jpeg = makeGreyJpeg();
    // The frame header's height and width follow the marker, a length and the sample size.
    const std::uint8_t marker[] = {0xFF, 0xC0};
    const auto frame = std::search(jpeg.begin(), jpeg.end(), std::begin(marker), std::end(marker));
    frame[5] = frame[7] = 0x7F;
    const std::string jpegError = errorOf(fileWithImage(jpeg, "image/jpeg"));
    EXPECT_NE(jpegError.find("image 0 'picture': the JPEG file is broken: it is too short"),
              std::string::npos)
        << jpegError;
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

TEST(Image, theFirstOfSeveralBrokenImagesIsNamed) {
    for (const unsigned threads : {1u, 4u}) {
        candela::setThreadCount(threads);
        for (int run = 0; run < 10; ++run) {
            const std::string error = errorOf(fileWithImages(60, {57, 31, 44}));
            EXPECT_NE(error.find("image 31: the PNG file is broken"), std::string::npos) << error;
        }
    }
    candela::setThreadCount(0);
}

TEST(Image, unusedImagesAreNotRead) {
    GltfFile file;
    file.add("images", R"({"uri":"absent.png"})");
    EXPECT_TRUE(load(file).scene.images.empty());
}

TEST(Image, brokenImagesAreNamed) {
    Bytes cutPng = makePng(4, 4, 1, 2, 3, 4);
    cutPng.resize(cutPng.size() / 2);
    EXPECT_NE(errorOf(fileWithImage(cutPng, "image/png")).find("image 0 'picture': the PNG file is broken"),
              std::string::npos);
    Bytes cutJpeg = makeGreyJpeg();
    cutJpeg.resize(cutJpeg.size() - 3);
    EXPECT_NE(
        errorOf(fileWithImage(cutJpeg, "image/jpeg")).find("image 0 'picture': the JPEG file is broken: "),
        std::string::npos);
    Bytes flippedPng = makePng(4, 4, 1, 2, 3, 4);
    flippedPng[flippedPng.size() / 2] ^= 1;
    EXPECT_NE(
        errorOf(fileWithImage(flippedPng, "image/png")).find("image 0 'picture': the PNG file is broken"),
        std::string::npos);
    EXPECT_NE(errorOf(fileWithImage({'G', 'I', 'F', '8'}, "image/gif"))
                  .find("image 0 'picture': is neither a PNG nor a JPEG file"),
              std::string::npos);
}

}  // namespace
}  // namespace candela_test
