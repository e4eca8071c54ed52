// A thread that draws, with a context that shares objects with the window's: the window shows the last
// texture that is finished, whatever a frame takes. Run as `embed_thread [SCENE [FRAMES [PICTURE.png]]]`.

#include <candela/candela.h>

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace {

constexpr int width = 480, height = 270;

/// A texture on its way from the thread that draws to the one that shows.
struct Shown {
    GLuint texture = 0;
    GLsync written = nullptr;
};

/// Three textures: one is shown, one is finished, one is drawn into.
class Exchange {
  public:
    /// Hands over a texture and returns one to draw into next.
    GLuint publish(Shown finished) {
        const std::lock_guard lock(mutex_);
        const GLuint next = finished_.texture != 0 ? finished_.texture : spare_;
        if (finished_.written != nullptr) glDeleteSync(finished_.written);
        finished_ = finished;
        return next;
    }
    /// The last finished texture in place of `shown`, which is drawn into later.
    bool take(Shown& shown) {
        const std::lock_guard lock(mutex_);
        if (finished_.texture == 0) return false;
        if (shown.written != nullptr) glDeleteSync(shown.written);
        spare_ = shown.texture;
        shown = finished_;
        finished_ = {};
        return true;
    }
    void setSpare(GLuint texture) { spare_ = texture; }

  private:
    std::mutex mutex_;
    Shown finished_;
    GLuint spare_ = 0;
};

/// The thread that draws: everything of candela belongs to its context.
void draw(GLFWwindow* window, const char* sceneName, int frames, Exchange& exchange, GLuint texture,
          std::atomic<bool>& ended, std::atomic<bool>& failed) {
    glfwMakeContextCurrent(window);
    try {
        const candela::Context context = candela::Context::adoptCurrent();
        const candela::Scene scene = candela::importScene(candela::PluginRegistry(), sceneName).scene;
        const candela::ColorConfig color = candela::ColorConfig::builtIn();
        const candela::DisplayTransform display = color.displayTransform({});
        candela::GpuScene gpuScene(context, scene, {.workingFromRec709 = color.workingFromRec709()});
        candela::Renderer renderer(context);
        const candela::CameraView view = candela::cameraView(scene, 0, candela::worldTransforms(scene));
        for (int i = 0; (frames == 0 || i < frames) && !ended; ++i) {
            const candela::Frame frame = renderer.render(gpuScene, view, {.width = width, .height = height});
            const candela::FrameTexture shown = frame.displayTexture(display);
            glCopyImageSubData(shown.texture, GL_TEXTURE_2D, 0, 0, 0, 0, texture, GL_TEXTURE_2D, 0, 0, 0, 0,
                               width, height, 1);
            const GLsync written = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
            glFlush();  // The other context waits for the fence.
            texture = exchange.publish({texture, written});
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "embed_thread: %s\n", error.what());
        failed = true;
    }
    glfwMakeContextCurrent(nullptr);
    ended = true;
}

void savePicture(const char* path) {
    std::vector<std::uint8_t> rgba(std::size_t{4} * width * height), turned;
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    for (std::ptrdiff_t y = height; y-- > 0;)
        turned.insert(turned.end(), rgba.begin() + y * 4 * width, rgba.begin() + (y + 1) * 4 * width);
    candela::writePng(path, width, height, turned, {});
}

void showTexture(const Shown& shown, GLuint framebuffer) {
    glWaitSync(shown.written, 0, GL_TIMEOUT_IGNORED);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, shown.texture, 0);
    glBlitNamedFramebuffer(framebuffer, 0, 0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
}

}  // namespace

int main(int argc, char** argv) {
    if (glfwInit() != GLFW_TRUE) return EXIT_FAILURE;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(width, height, "candela on a thread", nullptr, nullptr);
    if (window == nullptr) return EXIT_FAILURE;
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* drawing = glfwCreateWindow(1, 1, "", nullptr, window);  // shares the window's objects
    if (drawing == nullptr) return EXIT_FAILURE;
    glfwMakeContextCurrent(window);

    std::array<GLuint, 3> textures{};
    glCreateTextures(GL_TEXTURE_2D, 3, textures.data());
    for (const GLuint texture : textures) glTextureStorage2D(texture, 1, GL_RGBA8, width, height);
    GLuint framebuffer = 0;
    glCreateFramebuffers(1, &framebuffer);
    glFinish();  // The other context uses the textures.

    Exchange exchange;
    exchange.setSpare(textures[1]);
    std::atomic<bool> ended = false, failed = false;
    std::thread thread(draw, drawing, argc > 1 ? argv[1] : "plaza:4096", argc > 2 ? std::atoi(argv[2]) : 0,
                       std::ref(exchange), textures[0], std::ref(ended), std::ref(failed));
    Shown shown{textures[2], nullptr};
    while (!ended && glfwWindowShouldClose(window) == GLFW_FALSE) {
        glfwWaitEventsTimeout(0.01);
        if (!exchange.take(shown)) continue;
        showTexture(shown, framebuffer);
        glfwSwapBuffers(window);
    }
    ended = true;
    thread.join();
    exchange.take(shown);
    if (shown.written != nullptr) showTexture(shown, framebuffer);
    if (argc > 3) savePicture(argv[3]);
    glfwTerminate();
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
