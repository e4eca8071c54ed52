#include "view_session.h"

#include "command.h"
#include "own_display.h"
#include "sample_scene.h"

#include <epoxy/gl.h>
// After epoxy, which replaces the OpenGL headers that GLFW would include.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

namespace {

using namespace std::chrono_literals;

/// With one sample a pixel and without exposure, where the arguments say nothing of it: most tests are of
/// what is drawn at once, and candela-render does not expose by itself.
std::vector<std::string> completed(std::vector<std::string> arguments) {
    if (std::ranges::find(arguments, "--samples") == arguments.end())
        arguments.insert(arguments.end(), {"--samples", "1"});
    if (std::ranges::find(arguments, "--exposure") == arguments.end())
        arguments.insert(arguments.end(), {"--exposure", "0"});
    return arguments;
}

ViewOptions parsed(const std::vector<std::string>& arguments) {
    std::vector<const char*> words{"candela-view"};
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    return parseViewOptions(static_cast<int>(words.size()), words.data()).value();
}

/// Ignores messages of the shader compiler: a test may write an invalid shader.
void GLAPIENTRY report(GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
                       const void* count) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR) return;
    ADD_FAILURE() << "the driver reports: " << message;
    ++*static_cast<std::size_t*>(const_cast<void*>(count));
}

}  // namespace

ViewSession::ViewSession(const std::vector<std::string>& arguments)
    : application_(std::make_unique<Application>(parsed(completed(arguments)))),
      window_(glfwGetCurrentContext()) {
    model().panelsHidden = true;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(report, &glErrors_);
    // Moves the pointer away from where the last test left it.
    sendInput("mousemove 639 479");
    settle();
}

ViewSession::~ViewSession() {
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(glErrors_, 0u);
}

void ViewSession::step(int times) {
    for (int i = 0; i < times; ++i) {
        glfwPollEvents();
        application_->step();
        ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    }
}

bool ViewSession::stepUntil(const std::function<bool()>& reached) {
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!reached()) {
        if (std::chrono::steady_clock::now() > end) return false;
        step();
        std::this_thread::sleep_for(1ms);
    }
    return true;
}

void ViewSession::awaitScene() {
    step(2);  // the request is served, then shown
    ASSERT_TRUE(stepUntil([&] { return !model().loading && model().loadingEnvironment.empty(); }));
    step();
}

void ViewSession::settle() {
    // The X server delivers events within a few milliseconds; panels process them a frame later.
    for (int i = 0; i < 4; ++i) {
        std::this_thread::sleep_for(5ms);
        step();
    }
    stepUntil([&] { return !application_->hasPendingInput(); });
}

void ViewSession::stepUntilIdle() {
    ASSERT_TRUE(stepUntil([&] { return application_->isIdle(); }));
}

void ViewSession::sendFast(const std::string& arguments) {
    sendInput(arguments);
    // The display has sent the events, which this process is about to get.
    std::this_thread::sleep_for(2ms);
    step();
    stepUntilIdle();
}

std::size_t ViewSession::panelsHash() const {
    const ImDrawData& drawn = *ImGui::GetDrawData();
    std::size_t hash = 0;
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        const ImVector<ImDrawVert>& vertices = drawn.CmdLists[i]->VtxBuffer;
        const std::string_view bytes(reinterpret_cast<const char*>(vertices.Data),
                                     static_cast<std::size_t>(vertices.size_in_bytes()));
        hash = hash * 31 + std::hash<std::string_view>()(bytes);
    }
    return hash;
}

void ViewSession::drop(const std::string& file) {
    // Calls the drop callback as GLFW would.
    const GLFWdropfun dropped = glfwSetDropCallback(window_, nullptr);
    glfwSetDropCallback(window_, dropped);
    const char* files[] = {file.c_str()};
    dropped(window_, 1, files);
    awaitScene();
}

void ViewSession::resize(int width, int height) {
    glfwSetWindowSize(window_, width, height);
    ASSERT_TRUE(stepUntil([&] { return model().windowSize == glm::ivec2(width, height); }));
    step();
}

void ViewSession::pointTo(int x, int y) {
    int left = 0, top = 0;
    glfwGetWindowPos(window_, &left, &top);
    sendInput("mousemove " + std::to_string(left + x) + " " + std::to_string(top + y));
    settle();
}

void ViewSession::drag(int button, int fromX, int fromY, int toX, int toY) {
    pointTo(fromX, fromY);
    sendInput("mousedown " + std::to_string(button));
    settle();
    pointTo((fromX + toX) / 2, (fromY + toY) / 2);
    pointTo(toX, toY);
    sendInput("mouseup " + std::to_string(button));
    settle();
}

void ViewSession::click(int x, int y) {
    pointTo(x, y);
    sendInput("mousedown 1");
    settle();
    sendInput("mouseup 1");
    settle();
}

PngPicture ViewSession::picture() {
    const std::string file = pictures_ / "picture.png";
    std::filesystem::remove(file);
    model().requests.savePng = file;
    step();
    return readPng(file);
}

/// Of the back buffer, which the software rasteriser of Xvfb copies to the front.
PngPicture ViewSession::shown() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    const auto row = static_cast<std::ptrdiff_t>(4) * width;
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(row * height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    PngPicture shown{width, height, std::vector<std::uint8_t>(rows.size())};
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.begin() + row * (height - 1 - y), row, shown.rgba.begin() + row * y);
    return shown;
}

std::string ViewSession::copiedCommand() {
    model().requests.copyCommand = true;
    step();
    return glfwGetClipboardString(window_);
}

std::size_t ViewSession::messages(Message::Kind kind) {
    return static_cast<std::size_t>(std::ranges::count(model().messages, kind, &Message::kind));
}

ViewTest::ViewTest()
    : before_(std::filesystem::current_path()), config_("XDG_CONFIG_HOME", folder / "config") {
    std::filesystem::current_path(folder.path());
    folder.write("square.gltf", sampleScene());
}

ViewTest::~ViewTest() {
    std::filesystem::current_path(before_);
}

void ViewTest::SetUp() {
    if (!takeOwnDisplay().empty()) GTEST_SKIP() << takeOwnDisplay();
    if (std::system("command -v xdotool > /dev/null") != 0) GTEST_SKIP() << "xdotool is not installed";
}

PngPicture ViewTest::rendered(std::vector<std::string> arguments) const {
    arguments = completed(std::move(arguments));
    arguments.insert(arguments.end(), {"-o", "rendered.png", "--quiet"});
    expectSuccess(runCommand(arguments, {.folder = folder.path()}));
    return readPng(folder / "rendered.png");
}

PngPicture ViewTest::renderedBy(const std::string& command) const {
    const std::string programs = std::filesystem::path(CANDELA_COMMAND).parent_path().string();
    expectSuccess(runCommand({"-c", command}, {.folder = folder.path(),
                                               .environment = {"PATH=" + programs + ":/usr/bin:/bin"},
                                               .program = "/bin/sh"}));
    return readPng(folder / "candela.png");
}

int maxDifference(const PngPicture& a, const PngPicture& b) {
    if (a.width != b.width || a.height != b.height) return 256;
    int maxDifference = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        maxDifference = std::max(maxDifference, std::abs(int{a.rgba[i]} - int{b.rgba[i]}));
    return maxDifference;
}
