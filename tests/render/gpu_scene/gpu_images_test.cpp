// Upload of images, and reading them back.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "gl/context_binding.h"
#include "gl/state_guard.h"
#include "render/gpu_scene/gpu_images.h"

#include <candela/error.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace candela::test {
namespace {

Image imageOf(PixelFormat format) {
    Image image{"pattern", 5, 7, format, {}};
    image.pixels.resize(std::size_t{5} * 7 * texelSize(format));
    if (format == PixelFormat::rgba32f) {
        for (std::size_t i = 0; i < image.pixels.size() / sizeof(float); ++i) {
            const float value = 0.01f * static_cast<float>(i);
            std::memcpy(image.pixels.data() + i * sizeof value, &value, sizeof value);
        }
        return image;
    }
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(37 * i % 251);
    return image;
}

std::vector<float> texelsOf(GLuint texture) {
    std::vector<float> texels(std::size_t{5} * 7 * 4);
    glGetTextureImage(texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(float)),
                      texels.data());
    return texels;
}

class GpuImagesTest : public DrawingTest {};

TEST_F(GpuImagesTest, TakenPixelsAreFreedOnceUploaded) {
    const std::vector<Image> source{imageOf(PixelFormat::rgba8), imageOf(PixelFormat::rgba16)};
    GpuImages copied(source, ColorDecoding::exact);
    std::vector<Image> given = source;
    GpuImages taken(given, ColorDecoding::exact);
    taken.takeSources(given);
    for (const Image& image : given) EXPECT_EQ(image.pixels.capacity(), 0u);
    // Both contents, the second one from what is read back; and one that is first read after the release.
    const Texture first{}, second{.image = 1};
    const auto expectSame = [&](const Texture& texture, TextureContent content) {
        EXPECT_EQ(texelsOf(taken.get(texture, content).texture),
                  texelsOf(copied.get(texture, content).texture));
    };
    expectSame(first, TextureContent::color);
    expectSame(first, TextureContent::data);
    taken.releaseSources();
    copied.releaseSources();
    expectSame(second, TextureContent::data);
    EXPECT_EQ(taken.readAlpha(0).alpha, copied.readAlpha(0).alpha);
}

TEST_F(GpuImagesTest, ASceneWhosePixelsAreTakenLooksTheSame) {
    Material material;
    material.unlit = true;
    material.baseColorTexture = Texture{};
    Scene scene = sceneOf(makeQuad(1.0f), material);
    scene.images = {imageOf(PixelFormat::rgba8)};
    const FrameRequest request{24, 24, lookAt({0, 0, 3}, {0, 0, 0}, 0.7f)};
    const HdrImage expected = drawn(upload(scene), request);
    GpuScene uploaded = GpuScene::takingPixels(context(), scene);
    EXPECT_EQ(drawn(uploaded, request).rgba, expected.rgba);
    EXPECT_TRUE(scene.images.at(0).pixels.empty());
    EXPECT_EQ(scene.meshes.at(0).positions.size(), 4u);
}

void expectBlocksGiveTheWholeImage(ColorDecoding decoding) {
    for (const PixelFormat format : {PixelFormat::rgba8, PixelFormat::rgba16, PixelFormat::rgba32f}) {
        const std::vector<Image> source{imageOf(format)};
        for (const TextureContent content : {TextureContent::color, TextureContent::data}) {
            GpuImages atOnce(source, decoding);
            const std::vector<float> expected = texelsOf(atOnce.get(Texture{}, content).texture);
            // Less than a row, two rows, and all but one.
            for (const std::size_t maxBytes : {std::size_t{1}, std::size_t{2} * 5 * texelSize(format),
                                               std::size_t{6} * 5 * texelSize(format)}) {
                GpuImages inBlocks(source, decoding, maxBytes);
                EXPECT_EQ(texelsOf(inBlocks.get(Texture{}, content).texture), expected);
                // The other content is uploaded from the read-back of this one.
                inBlocks.releaseSources();
                const auto other =
                    content == TextureContent::color ? TextureContent::data : TextureContent::color;
                EXPECT_EQ(texelsOf(inBlocks.get(Texture{}, other).texture),
                          texelsOf(atOnce.get(Texture{}, other).texture));
            }
        }
    }
}

TEST_F(GpuImagesTest, uploadInBlocksOfRowsGivesTheWholeImage) {
    const gl::StateGuard guard(*context().state().binding, "a test");
    for (const ColorDecoding decoding : {ColorDecoding::device, ColorDecoding::exact})
        expectBlocksGiveTheWholeImage(decoding);
}

TEST_F(GpuImagesTest, exactDecodingIsExactToAFractionOfACode) {
    const gl::StateGuard guard(*context().state().binding, "a test");
    const std::vector<Image> source{imageOf(PixelFormat::rgba8)};
    GpuImages images(source, ColorDecoding::exact);
    const std::vector<float> texels = texelsOf(images.get(Texture{}, TextureContent::color).texture);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const double code = std::to_integer<int>(source[0].pixels[i]) / 255.0;
        const double decoded = code < 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
        // Half floats have 11 bits.
        const double expected = i % 4 == 3 ? code : decoded;
        EXPECT_NEAR(texels[i], expected, expected * 0x1p-11) << i;
    }
}

TEST_F(GpuImagesTest, imageBeyondTheDeviceMemoryIsNamed) {
    if (!context().isSoftware()) GTEST_SKIP() << "the device may have enough memory";
    GLint side = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
    const auto size = static_cast<std::uint32_t>(side);
    // 16 bytes a texel: 4 GiB where the side is 16384, more than llvmpipe allocates for a texture.
    const std::vector<Image> source{{"panorama", size, size, PixelFormat::rgba32f, {}}};
    GpuImages images(source, ColorDecoding::device);
    try {
        images.get(Texture{}, TextureContent::data);
        FAIL() << "no error was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::limit);
        EXPECT_NE(std::string(error.what()).find("image 0 'panorama'"), std::string::npos) << error.what();
    }
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace candela::test
