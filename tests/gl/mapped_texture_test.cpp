// Textures in memory that the program reads in place.

#include "gl/mapped_texture.h"
#include "gl/framebuffer.h"

#include <candela/context.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

namespace candela::test {
namespace {

constexpr std::array formats{gl::TexelFormat{GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8},
                             gl::TexelFormat{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4},
                             gl::TexelFormat{GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16},
                             gl::TexelFormat{GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1},
                             gl::TexelFormat{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4}};

class MappedTextureTest : public testing::Test {
  protected:
    void SetUp() override {
        const std::optional<gl::DeviceUuids> uuids = gl::importingDevice();
        if (!uuids) GTEST_SKIP() << "this driver imports no memory";
        device_ = gl::ExternalMemoryDevice::find(*uuids);
        if (device_ == nullptr) GTEST_SKIP() << "no Vulkan device of this driver is a CPU";
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
    }
    const gl::ExternalMemoryDevice& device() const { return *device_; }

  private:
    Context context_ = Context::createHeadless();
    const gl::ExternalMemoryDevice* device_ = nullptr;
};

/// Clears parts of the texture to values of their own, as draws would.
void clearParts(const gl::MappedTexture& mapped, const gl::TexelFormat& format, int width, int height) {
    const bool isDepth = format.format == GL_DEPTH_COMPONENT;
    const gl::Framebuffer framebuffer = isDepth ? gl::Framebuffer({}, &mapped.texture, "test")
                                                : gl::Framebuffer({&mapped.texture}, nullptr, "test");
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 12; ++i) {
        glScissor(width * i / 16, height * i / 24, width - width * i / 12, height - height * i / 12);
        const auto number = static_cast<GLuint>(i);
        const std::array<GLuint, 4> words{number * 0x01234567u + 1, ~number, number, 77};
        const std::array<GLfloat, 4> values{static_cast<float>(i + 1) / 13.0f, 0.0f, 0.0f, 0.0f};
        if (isDepth) {
            glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, values.data());
        } else if (format.type == GL_UNSIGNED_INT) {
            glClearNamedFramebufferuiv(framebuffer.name(), GL_COLOR, 0, words.data());
        } else {
            glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, values.data());
        }
    }
    glDisable(GL_SCISSOR_TEST);
    glFinish();
}

TEST_F(MappedTextureTest, memoryHoldsWhatIsDrawn) {
    int mappedCount = 0;
    for (const gl::TexelFormat& format : formats) {
        for (const auto& [width, height] :
             {std::array{1280, 720}, {64, 1}, {128, 77}, {1, 1}, {333, 217}, {1000, 3}}) {
            const auto mapped = gl::mappedTarget2d(device(), format, width, height, "test");
            if (!mapped) continue;  // Its rows have gaps, as those of odd widths on llvmpipe.
            ++mappedCount;
            clearParts(*mapped, format, width, height);
            std::vector<std::byte> read(std::size_t(width) * std::size_t(height) * format.bytes);
            glGetTextureSubImage(mapped->texture.name(), 0, 0, 0, 0, width, height, 1, format.format,
                                 format.type, GLsizei(read.size()), read.data());
            EXPECT_EQ(std::memcmp(mapped->mapping.data(), read.data(), read.size()), 0)
                << width << " x " << height << " of " << format.bytes << " bytes a pixel";
            EXPECT_NE(read, std::vector<std::byte>(read.size()));
        }
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    RecordProperty("mapped", mappedCount);
}

TEST_F(MappedTextureTest, memoryOutlivesDrawsThatAreUnderWay) {
    for (int i = 0; i < 50; ++i) {
        const auto mapped = gl::mappedTarget2d(device(), formats[0], 512, 512, "test");
        if (!mapped) GTEST_SKIP() << "this driver's rows have gaps";
        const gl::Framebuffer framebuffer({&mapped->texture}, nullptr, "test");
        constexpr std::array<GLuint, 4> words{1, 2, 3, 4};
        glClearNamedFramebufferuiv(framebuffer.name(), GL_COLOR, 0, words.data());
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(MappedTextureTest, whatTheDriverCannotHoldIsRefused) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    EXPECT_FALSE(gl::mappedTarget2d(device(), formats[0], largest + 64, 1, "test"));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST(ExternalMemoryTest, unknownDevicesAreNotFound) {
    gl::DeviceUuids unknown;
    unknown.device.fill(0xee);
    EXPECT_EQ(gl::ExternalMemoryDevice::find(unknown), nullptr);
    EXPECT_EQ(gl::ExternalMemoryDevice::find(unknown), nullptr) << "the second time";
}

}  // namespace
}  // namespace candela::test
