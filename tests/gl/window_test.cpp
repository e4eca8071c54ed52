// A GLFW window whose context candela adopts and whose framebuffer it draws into.

#include "small_scene.h"
#include "support/techniques.h"
#include "virtual_display.h"

#include <candela/color.h>
#include <candela/context.h>

#include <gtest/gtest.h>

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <memory>

namespace candela::test {
namespace {

constexpr int width = 96, height = 64;

class WindowTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!display_.unavailableReason().empty()) GTEST_SKIP() << display_.unavailableReason();
        if (glfwInit() != GLFW_TRUE) GTEST_SKIP() << "GLFW does not start: " << reason();
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
        glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
        window_ = glfwCreateWindow(width, height, "candela", nullptr, nullptr);
        if (window_ == nullptr) GTEST_SKIP() << "GLFW makes no window with OpenGL 4.5: " << reason();
        glfwMakeContextCurrent(window_);
    }
    void TearDown() override {
        if (window_ != nullptr) glfwDestroyWindow(window_);
        glfwTerminate();
    }

    static std::string reason() {
        const char* text = nullptr;
        glfwGetError(&text);
        return text != nullptr ? text : "no reason given";
    }

    /// What the window's back buffer holds: RGBA, rows from the top.
    static std::vector<std::uint8_t> backBuffer() {
        std::vector<std::uint8_t> pixels(std::size_t{4} * width * height), flipped;
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        glReadBuffer(GL_BACK);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        constexpr std::ptrdiff_t row = std::ptrdiff_t{4} * width;
        for (std::ptrdiff_t y = height; y-- > 0;)
            flipped.insert(flipped.end(), pixels.begin() + y * row, pixels.begin() + (y + 1) * row);
        return flipped;
    }

    VirtualDisplay display_;
    GLFWwindow* window_ = nullptr;
};

TEST_F(WindowTest, isDisplayedInto) {
    const LitScene lit = smallScene();
    const DisplayTransform transform = ColorConfig::builtIn().displayTransform({});
    const Context context = Context::adoptCurrent();
    Renderer renderer(context);
    GpuScene scene(context, lit.scene);
    scene.setLights(lit.lights);
    for (const Technique technique : techniques) {
        glClearColor(1.0f, 0.0f, 1.0f, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        const Frame frame = render(renderer, scene, smallFrame(lit, technique, width, height));
        frame.display(transform, {});
        std::vector<std::uint8_t> seen = backBuffer(), expected = frame.displayPicture(transform);
        // A window may have no alpha.
        for (std::size_t i = 3; i < seen.size(); i += 4) seen[i] = expected[i] = 0;
        EXPECT_EQ(seen, expected);
        glfwSwapBuffers(window_);
        glfwPollEvents();
    }
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(WindowTest, coexistsWithAHeadlessContext) {
    const LitScene lit = smallScene();
    const Context adopted = Context::adoptCurrent();
    Renderer windowRenderer(adopted);
    GpuScene windowScene(adopted, lit.scene);
    const auto drawnInWindow = [&] {
        return render(windowRenderer, windowScene, smallFrame(lit, Technique::volumes)).radiance().rgba;
    };
    const std::vector<float> reference = drawnInWindow();
    // A thread has one current context: the window's has to go before EGL takes another.
    glfwMakeContextCurrent(nullptr);
    {
        const Context headless = Context::createHeadless();
        Renderer renderer(headless);
        GpuScene scene(headless, lit.scene);
        const std::vector<float> pixels =
            render(renderer, scene, smallFrame(lit, Technique::volumes)).radiance().rgba;
        if (adopted.renderer() == headless.renderer()) {
            EXPECT_EQ(pixels, reference);
        }
    }
    glfwMakeContextCurrent(window_);
    EXPECT_EQ(drawnInWindow(), reference);
}

}  // namespace
}  // namespace candela::test
