// The programs of docs/embedding.md run, and their windows show the scene and what the host has drawn.

#include "gl/virtual_display.h"

#include <gtest/gtest.h>

#include <png.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#ifndef EMBED_GLFW
#define EMBED_GLFW ""
#endif
#ifndef EMBED_THREAD
#define EMBED_THREAD ""
#endif
#ifndef EMBED_SDL2
#define EMBED_SDL2 ""
#endif
#ifndef EMBED_QT
#define EMBED_QT ""
#endif

namespace candela::test {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

std::vector<Pixel> readPng(const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
    image.format = PNG_FORMAT_RGBA;
    std::vector<Pixel> pixels(std::size_t{image.width} * image.height);
    png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
    return pixels;
}

class EmbeddingTest : public testing::Test {
  protected:
    /// Runs a program for three frames; the picture that it leaves. Skips where it was not built.
    void run(const std::string& program, const std::string& library, std::vector<Pixel>& pixels) {
        std::string reason = display_.unavailableReason();
        if (program.empty()) reason = library + " was not found when the tests were configured";
        if (!reason.empty()) {
            std::cout << "skipped: a program of docs/embedding.md: " << reason << "\n";
            GTEST_SKIP() << reason;
        }
        const std::filesystem::path folder(testing::TempDir());
        const std::filesystem::path picture =
            folder / (std::filesystem::path(program).filename().string() + ".png");
        const std::filesystem::path log = picture.string() + ".log";
        std::filesystem::remove(picture);
        const std::string command = "CANDELA_PLUGIN_PATH='" CANDELA_TEST_PLUGINS "' '" + program +
                                    "' plaza:4096 3 '" + picture.string() + "' > '" + log.string() + "' 2>&1";
        const int code = std::system(command.c_str());
        ASSERT_EQ(code, 0) << "see " << log;
        pixels = readPng(picture);
        ASSERT_EQ(pixels.size(), std::size_t{480} * 270);
        std::size_t lit = 0;
        for (const Pixel& pixel : pixels) lit += pixel[0] + pixel[1] + pixel[2] > 60;
        EXPECT_GT(lit, pixels.size() / 10) << "the scene";
        std::filesystem::remove(picture);
        std::filesystem::remove(log);
    }
    /// The host's colour, which the scene has at single pixels too.
    static bool isMagenta(const std::vector<Pixel>& pixels, int x, int y) {
        const Pixel& pixel = pixels[std::size_t(y * 480 + x)];
        return pixel[0] > 200 && pixel[1] < 60 && pixel[2] > 200;
    }

  private:
    VirtualDisplay display_;
};

TEST_F(EmbeddingTest, glfwShowsTheHostsTriangleAmongTheScene) {
    std::vector<Pixel> pixels;
    run(EMBED_GLFW, "GLFW", pixels);
    if (IsSkipped() || HasFatalFailure()) return;
    for (int x = 210; x < 270; ++x) EXPECT_TRUE(isMagenta(pixels, x, 150)) << x;
    EXPECT_FALSE(isMagenta(pixels, 240, 260)) << "under the floor";
}

TEST_F(EmbeddingTest, sdl2ShowsWhatTheHookHasDrawn) {
    std::vector<Pixel> pixels;
    run(EMBED_SDL2, "SDL2", pixels);
    if (IsSkipped() || HasFatalFailure()) return;
    for (int x = 122; x < 358; ++x) EXPECT_TRUE(isMagenta(pixels, x, 195)) << x;
}

TEST_F(EmbeddingTest, qtWidgetShowsTheScene) {
    std::vector<Pixel> pixels;
    run(EMBED_QT, "Qt 5 Widgets", pixels);
}

TEST_F(EmbeddingTest, aThreadDrawsForTheWindow) {
    std::vector<Pixel> pixels;
    run(EMBED_THREAD, "GLFW", pixels);
}

}  // namespace
}  // namespace candela::test
