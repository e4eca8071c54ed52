#pragma once

#include "input_queue.h"

#include <glm/vec2.hpp>

#include <filesystem>
#include <string>
#include <vector>

struct GLFWwindow;

/// A window with an OpenGL 4.5 core context, current on this thread, and Dear ImGui on it.
class Window {
  public:
    /// `size` is of the framebuffer, in pixels. `layoutFile` keeps where the panels lie; empty: nowhere.
    /// Throws `candela::Error` (environment): where no display is, its text names candela-render.
    Window(const glm::ivec2& size, const std::filesystem::path& layoutFile);
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    bool shouldClose() const;
    /// `shouldClose` is true from now on.
    void close();
    void setTitle(const std::string& title);
    glm::ivec2 framebufferSize() const;
    /// Pixels of the framebuffer for a unit of ImGui.
    float pixelRatio() const;
    void copyToClipboard(const std::string& text);

    /// Handles what has happened, at once, or after sleeping until something does (`briefly`: for a sixth of
    /// a second at most).
    enum class Sleep { none, briefly, untilEvent };
    void handleEvents(Sleep sleep);
    /// Whether anything has happened since the last call: input, another size, `wake`, or a request of the
    /// desktop to draw the window again.
    bool takeActivity();
    /// Whether there are events that the last frame could not take with those before them.
    bool hasPendingInput() const { return !input_.empty(); }
    /// Files dropped since the last call.
    std::vector<std::string> takeDropped();

    /// `textScale` enlarges the panels, 1 as the desktop has it.
    void beginPanels(float textScale);
    /// Draws the panels over what the framebuffer holds.
    void endPanels();
    void swap();

    /// Wakes `handleEvents` from any thread.
    static void wake();

  private:
    void listen();
    void adaptStyle(float textScale);

    GLFWwindow* window_ = nullptr;
    std::vector<std::string> dropped_;
    InputQueue input_;
    float styleScale_ = 0.0f, styleRatio_ = 0.0f;  ///< That the style and the font were made for.
    bool active_ = true;                           ///< Something has happened; see `takeActivity`.
    std::string layoutFile_;
};

/// Writes the back buffer of the window, panels included, as a PNG. Call before the swap. `size` is that of
/// its framebuffer. Throws `candela::Error`.
void writeWindowPicture(const std::filesystem::path& file, const glm::ivec2& size);
