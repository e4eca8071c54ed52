#include "render/display/memory_display.h"

#include "../color/ramps.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"

#include <candela/color.h>
#include <candela/context.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace candela {
namespace {

// An odd width, of no multiple of any vector, and of more than a run of the kernel.
constexpr int width = 277;

const ColorConfig& luts() {
    static const ColorConfig config = ColorConfig::load(CANDELA_TEST_DATA "/../color/config/luts.ocio");
    return config;
}

DisplayTransform builtIn(const char* display, const char* view, double exposure = 0.0) {
    return ColorConfig::builtIn().displayTransform({display, view, "", exposure});
}

std::vector<float> wholeRows(std::vector<float> rgba) {
    const std::size_t row = std::size_t{width} * 4;
    rgba.resize((rgba.size() + row - 1) / row * row, 0.0f);
    return rgba;
}

std::vector<float> colors() {
    std::vector<float> rgba = test::Ramps::all(), scattered = test::Ramps().scattered(20000).rgba();
    rgba.insert(rgba.end(), scattered.begin(), scattered.end());
    return wholeRows(rgba);
}

MemoryPicture pictureOf(const std::vector<float>& rgba) {
    return {rgba, width, static_cast<int>(rgba.size() / 4 / width)};
}

/// The noise of shaders/display.frag, as share of a code.
double ditherAt(std::uint32_t x, std::uint32_t y) {
    std::uint32_t h = x * 1664525u + (y * 1664525u + 1013904223u) * 747796405u;
    h = (h ^ h >> 16) * 2246822519u;
    h = (h ^ h >> 13) * 3266489917u;
    return std::clamp(double((h ^ h >> 16) >> 8) / 16777216.0 - 0.5, -7.0 / 16.0, 7.0 / 16.0);
}

/// The largest distance of a code from the transform's exact value with dither, in codes. Half a code is that
/// of rounding.
double worstDistance(const DisplayKernel& kernel, const DisplayTransform& transform,
                     const std::vector<float>& rgba) {
    const MemoryPicture picture = pictureOf(rgba);
    const std::vector<std::uint8_t> codes = MemoryDisplay(kernel).codes(picture, transform);
    std::vector<float> exact = rgba;
    transform.apply(exact);
    double worst = 0.0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t from = 4 * (std::size_t(y) * width + std::size_t(x));
            const std::size_t to = 4 * (std::size_t(picture.height - 1 - y) * width + std::size_t(x));
            EXPECT_EQ(codes[to + 3], 255);
            for (std::size_t c = 0; c < 3; ++c) {
                const double value =
                    std::clamp(255.0 * double(exact[from + c]) + ditherAt(std::uint32_t(x), std::uint32_t(y)),
                               0.0, 255.0);
                worst = std::max(worst, std::abs(value - codes[to + c]));
            }
        }
    }
    return worst;
}

// Half a code of rounding; and an eighth of a code that differently rounded steps of ACES may make near
// black, as in display_test.cpp.
constexpr double exactTolerance = 0.5 + 0.125;
// Besides, the quarter of a code that `BakedTransform` allows its tables.
constexpr double bakedTolerance = exactTolerance + 0.25;

TEST(MemoryDisplay, agreesWithOpenColorIOOnEveryBuiltInView) {
    const std::vector<float> rgba = colors();
    const ColorConfig config = ColorConfig::builtIn();
    for (const DisplayKernel* kernel : displayKernels())
        for (const std::string& display : config.displays())
            for (const std::string& view : config.views(display))
                EXPECT_LE(worstDistance(*kernel, config.displayTransform({display, view, "", 0.0}), rgba),
                          view == "ACES 1.0 SDR" ? bakedTolerance : exactTolerance)
                    << kernel->name << ", " << display << ", " << view;
}

TEST(MemoryDisplay, agreesWithOpenColorIOOnTables) {
    const std::vector<float> rgba = colors();
    for (const DisplayKernel* kernel : displayKernels())
        for (const char* view :
             {"Mono", "RGB", "Tetrahedral", "Trilinear", "Graded", "Film and print", "Inverse"})
            EXPECT_LE(worstDistance(*kernel, luts().displayTransform({"Monitor", view, "", 0.0}), rgba),
                      bakedTolerance)
                << kernel->name << ", " << view;
}

TEST(MemoryDisplay, appliesExposure) {
    const std::vector<float> rgba = colors();
    for (const double exposure : {-3.5, 2.25, 60.0, -100.0})
        EXPECT_LE(worstDistance(*displayKernels().front(), builtIn("sRGB", "Un-tone-mapped", exposure), rgba),
                  exactTolerance)
            << exposure << " stops";
}

TEST(MemoryDisplay, blackAndWhiteHaveNoNoise) {
    for (const float level : {0.0f, 1.0f}) {
        const std::vector<float> rgba(std::size_t{width} * 16 * 4, level);
        const auto codes = MemoryDisplay().codes(pictureOf(rgba), builtIn("sRGB", "Un-tone-mapped"));
        for (std::size_t i = 0; i < codes.size(); ++i)
            ASSERT_EQ(codes[i], i % 4 == 3 ? 255 : level * 255) << i;
    }
}

/// A framebuffer that is larger than the picture.
struct Target {
    static constexpr int x = 5, y = 3;

    Target(GLenum format, const MemoryPicture& picture)
        : texture(gl::Texture::target2d(format, picture.width + 11, picture.height + 7, "test target")),
          framebuffer({&texture}, nullptr, "test target") {}

    FrameTarget frameTarget() const { return {framebuffer.name(), x, y}; }
    /// As `MemoryDisplay::codes` has them.
    std::vector<std::uint8_t> read(const MemoryPicture& picture) const {
        const std::size_t row = 4 * std::size_t(picture.width);
        std::vector<std::uint8_t> rows(row * std::size_t(picture.height)), result;
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureSubImage(texture.name(), 0, x, y, 0, picture.width, picture.height, 1, GL_RGBA,
                             GL_UNSIGNED_BYTE, GLsizei(rows.size()), rows.data());
        for (int i = picture.height - 1; i >= 0; --i)
            result.insert(result.end(), rows.begin() + long(row) * i, rows.begin() + long(row) * (i + 1));
        return result;
    }

    gl::Texture texture;
    gl::Framebuffer framebuffer;
};

TEST(MemoryDisplay, drawsItsCodesIntoAFramebuffer) {
    const Context context = Context::createHeadless();
    const std::vector<float> rgba = colors();
    const MemoryPicture picture = pictureOf(rgba);
    const Target target(GL_RGBA8, picture);
    const DisplayTransform transform = builtIn("sRGB", "ACES 1.0 SDR");
    MemoryDisplay display;
    ASSERT_TRUE(MemoryDisplay::suits(target.frameTarget()));
    display.render(picture, transform, target.frameTarget());
    EXPECT_EQ(target.read(picture), display.codes(picture, transform));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// The codes of a framebuffer, rows from the bottom.
std::vector<std::uint32_t> codesIn(GLuint framebuffer, int wide, int high) {
    std::vector<std::uint32_t> codes(std::size_t(wide) * std::size_t(high));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, wide, high, GL_RGBA, GL_UNSIGNED_BYTE, codes.data());
    return codes;
}

TEST(MemoryDisplay, drawsTheSameIntoTexturesAndRenderbuffers) {
    const Context context = Context::createHeadless();
    constexpr int wide = 64, high = 32;
    std::vector<float> rgba = test::Ramps().scattered(20 * 10).rgba();
    rgba.resize(4 * 20 * 10);
    const MemoryPicture picture{rgba, 20, 10};
    const DisplayTransform transform = builtIn("sRGB", "Un-tone-mapped");
    GLuint renderbuffer = 0, texture = 0;
    std::array<GLuint, 2> framebuffers{};
    glCreateRenderbuffers(1, &renderbuffer);
    glNamedRenderbufferStorage(renderbuffer, GL_RGBA8, wide, high);
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 3, GL_RGBA8, 2 * wide, 2 * high);
    glCreateFramebuffers(2, framebuffers.data());
    glNamedFramebufferRenderbuffer(framebuffers[0], GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    glNamedFramebufferTexture(framebuffers[1], GL_COLOR_ATTACHMENT0, texture, 1);
    constexpr std::array<GLfloat, 4> before{0.2f, 0.4f, 0.6f, 0.0f};
    MemoryDisplay display;
    // Inside, at the edges, and beyond each of them.
    for (const auto& [x, y] :
         {std::pair{7, 5}, {0, 0}, {wide - 20, high - 10}, {-3, 5}, {7, -2}, {50, 5}, {7, 25}}) {
        for (const GLuint framebuffer : framebuffers) {
            glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, before.data());
            display.render(picture, transform, {framebuffer, x, y});
        }
        const std::vector<std::uint32_t> expected = codesIn(framebuffers[0], wide, high);
        EXPECT_EQ(codesIn(framebuffers[1], wide, high), expected) << x << ", " << y;
        EXPECT_GT(std::ranges::count_if(expected, [](std::uint32_t code) { return code >> 24 == 255; }), 0);
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glDeleteFramebuffers(2, framebuffers.data());
    glDeleteTextures(1, &texture);
    glDeleteRenderbuffers(1, &renderbuffer);
}

TEST(MemoryDisplay, leavesOtherTargetsToTheShader) {
    const Context context = Context::createHeadless();
    const std::vector<float> rgba(std::size_t{width} * 4, 0.5f);
    const MemoryPicture picture = pictureOf(rgba);
    for (const GLenum format : {GL_RGB10_A2, GL_RGBA16, GL_RGBA16F, GL_RGBA32F})
        EXPECT_FALSE(MemoryDisplay::suits(Target(format, picture).frameTarget())) << format;
    EXPECT_TRUE(MemoryDisplay::suits(Target(GL_SRGB8_ALPHA8, picture).frameTarget()));
    const gl::Texture first = gl::Texture::target2d(GL_RGBA8, 8, 8, "first"),
                      second = gl::Texture::target2d(GL_RGBA8, 8, 8, "second");
    const gl::Framebuffer two({&first, &second}, nullptr, "two");
    EXPECT_FALSE(MemoryDisplay::suits({two.name(), 0, 0})) << "a copy would fill both";
    const GLenum firstAlone = GL_COLOR_ATTACHMENT0, secondAlone = GL_COLOR_ATTACHMENT1;
    for (const GLenum alone : {firstAlone, secondAlone}) {
        glNamedFramebufferDrawBuffers(two.name(), 1, &alone);
        EXPECT_TRUE(MemoryDisplay::suits({two.name(), 0, 0}));
    }
}

}  // namespace
}  // namespace candela
