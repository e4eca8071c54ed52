#include "window.h"

#include "style.h"

#include <candela/error.h>
#include <candela/image_file.h>

#include <epoxy/gl.h>
// After epoxy, which replaces the OpenGL headers that GLFW would include.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>

namespace {

constexpr const char* withoutDisplay = "; candela-render draws pictures without one";

std::string glfwReason() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "GLFW gives no reason";
}

[[noreturn]] void fail(const std::string& text) {
    throw candela::Error(candela::ErrorKind::environment, "", text);
}

}  // namespace

Window::Window(const glm::ivec2& size, const std::filesystem::path& layoutFile)
    : layoutFile_(layoutFile.string()) {
    if (!glfwInit())
        fail("no window can be opened, for there is no display (" + glfwReason() + ")" + withoutDisplay);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    // The picture has its own depth buffer.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_ = glfwCreateWindow(size.x, size.y, "candela", nullptr, nullptr);
    if (!window_) {
        const std::string reason = glfwReason();
        glfwTerminate();
        fail("no window with OpenGL 4.5 can be opened (" + reason + ")" + withoutDisplay);
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    listen();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = layoutFile_.empty() ? nullptr : layoutFile_.c_str();
    // Without its callbacks, which overwrite the state of a key before ImGui has seen it.
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

namespace {

/// The window that a callback of GLFW is for.
Window& windowOf(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

InputQueue::Press pressOf(int action) {
    return action == GLFW_RELEASE ? InputQueue::Press::up : InputQueue::Press::down;
}

/// Set by `Window::wake`, from any thread.
std::atomic<bool> woken{false};

}  // namespace

/// GLFW lets go of all keys and buttons itself when the window loses the focus.
void Window::listen() {
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        windowOf(window).active_ = true;
        windowOf(window).input_.movePointer({x, y});
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
        windowOf(window).active_ = true;
        if (!entered) return windowOf(window).input_.leave();
        // GLFW reports no move where the pointer comes back to the place at which it left.
        double x = 0.0, y = 0.0;
        glfwGetCursorPos(window, &x, &y);
        windowOf(window).input_.movePointer({x, y});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
        windowOf(window).active_ = true;
        windowOf(window).input_.pressButton(button, pressOf(action));
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
        windowOf(window).active_ = true;
        windowOf(window).input_.turnWheel({x, y});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
        windowOf(window).active_ = true;
        // ImGui repeats keys itself.
        if (action != GLFW_REPEAT) windowOf(window).input_.pressKey(key, pressOf(action));
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
        windowOf(window).active_ = true;
        windowOf(window).input_.type(character);
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** files) {
        windowOf(window).active_ = true;
        windowOf(window).dropped_.assign(files, files + count);
    });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* window, int, int) { windowOf(window).active_ = true; });
    glfwSetWindowContentScaleCallback(
        window_, [](GLFWwindow* window, float, float) { windowOf(window).active_ = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { windowOf(window).active_ = true; });
}

bool Window::takeActivity() {
    const bool wasWoken = woken.exchange(false);
    return std::exchange(active_, false) || wasWoken;
}

Window::~Window() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

bool Window::shouldClose() const {
    return glfwWindowShouldClose(window_);
}

void Window::close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

glm::ivec2 Window::framebufferSize() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

float Window::pixelRatio() const {
    int width = 0;
    glfwGetWindowSize(window_, &width, nullptr);
    return width > 0 ? static_cast<float>(framebufferSize().x) / static_cast<float>(width) : 1.0f;
}

void Window::copyToClipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}

void Window::handleEvents(Sleep sleep) {
    switch (sleep) {
        case Sleep::none:
            return glfwPollEvents();
        case Sleep::briefly:
            return glfwWaitEventsTimeout(1.0 / 6.0);
        case Sleep::untilEvent:
            return glfwWaitEvents();
    }
}

std::vector<std::string> Window::takeDropped() {
    return std::exchange(dropped_, {});
}

/// The density of pixels changes when the window is moved to another screen.
void Window::adaptStyle(float textScale) {
    float desktop = 1.0f;
    glfwGetWindowContentScale(window_, &desktop, nullptr);
    const float ratio = pixelRatio(), scale = textScale * desktop / ratio;
    if (scale == styleScale_ && ratio == styleRatio_) return;
    chooseStyle(scale, ratio);
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    styleScale_ = scale;
    styleRatio_ = ratio;
}

void Window::beginPanels(float textScale) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    adaptStyle(textScale);
    // While no text is typed, the key is a shortcut: see shortcuts.h.
    ImGuiIO& io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Tab] = io.WantTextInput ? GLFW_KEY_TAB : -1;
    input_.beginFrame(io);
    ImGui::NewFrame();
}

void Window::endPanels() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

void Window::wake() {
    woken = true;
    glfwPostEmptyEvent();
}

void writeWindowPicture(const std::filesystem::path& file, const glm::ivec2& size) {
    const auto row = static_cast<std::ptrdiff_t>(size.x) * 4;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(row) * static_cast<std::size_t>(size.y));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    for (std::ptrdiff_t y = 0; y < size.y / 2; ++y)
        std::swap_ranges(pixels.begin() + y * row, pixels.begin() + (y + 1) * row,
                         pixels.begin() + (size.y - 1 - y) * row);
    for (std::size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;
    candela::writePng(file, static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y), pixels,
                      candela::DisplayEncoding{});
}
