#include "window.h"

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

void chooseStyle(float scale) {
    ImGui::StyleColorsDark();
    ImGui::GetStyle().ScaleAllSizes(scale);
    ImGui::GetStyle().WindowRounding = 4.0f;
    ImFontConfig font;
    font.SizePixels = 13.0f * scale;
    ImGui::GetIO().Fonts->AddFontDefault(&font);
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
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** files) {
        auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
        self.dropped_.assign(files, files + count);
    });
    // ImGui calls it after its own.
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
        auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
        if (action == GLFW_PRESS && key >= 0) self.pressed_.push_back({key, modifiers});
    });
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = layoutFile_.empty() ? nullptr : layoutFile_.c_str();
    float scale = 1.0f;
    glfwGetWindowContentScale(window_, &scale, nullptr);
    chooseStyle(scale);
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
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

void Window::beginPanels() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    holdShortKeys();
    ImGui::NewFrame();
}

/// ImGui asks which keys are down in each frame. Where frames take long, a key is pressed and let go between
/// two of them: it is down in one frame then.
void Window::holdShortKeys() {
    ImGuiIO& io = ImGui::GetIO();
    const auto isDown = [&](int key) { return glfwGetKey(window_, key) == GLFW_PRESS; };
    for (const int key : std::exchange(held_, {})) io.KeysDown[key] = isDown(key);
    io.KeyShift = isDown(GLFW_KEY_LEFT_SHIFT) || isDown(GLFW_KEY_RIGHT_SHIFT);
    io.KeyCtrl = isDown(GLFW_KEY_LEFT_CONTROL) || isDown(GLFW_KEY_RIGHT_CONTROL);
    for (const Press& press : std::exchange(pressed_, {})) {
        if (io.KeysDown[press.key]) continue;
        io.KeysDown[press.key] = true;
        held_.push_back(press.key);
        io.KeyShift = io.KeyShift || (press.modifiers & GLFW_MOD_SHIFT) != 0;
        io.KeyCtrl = io.KeyCtrl || (press.modifiers & GLFW_MOD_CONTROL) != 0;
    }
}

void Window::endPanels() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

void Window::wake() {
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
