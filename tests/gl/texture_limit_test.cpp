// The limits of textures.

#include "gl/texture.h"

#include <candela/context.h>
#include <candela/error.h>

#include <gtest/gtest.h>

#include <string>

namespace candela::test {
namespace {

TEST(BufferTextureTest, sizeIsCheckedInTexelsOfTheFormat) {
    const Context context = Context::createHeadless();
    GLint maxTexels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &maxTexels);
    struct Format {
        GLenum format;
        std::size_t bytes;
    };
    for (const auto& [format, bytes] :
         {Format{GL_R32UI, 4}, {GL_RG32F, 8}, {GL_RG32UI, 8}, {GL_RGBA32F, 16}, {GL_RGBA32UI, 16}}) {
        gl::BufferTexture texture(format, "test");
        const std::size_t texels = static_cast<std::size_t>(maxTexels) + 1;
        // Rejected before the data is read, so that one byte is enough.
        constexpr std::byte first{};
        try {
            texture.upload(std::span<const std::byte>(&first, texels * bytes));
            FAIL() << "no error was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::limit);
            EXPECT_NE(std::string(error.what()).find(std::to_string(texels) + " texels"), std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace candela::test
