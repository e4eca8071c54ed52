#pragma once

#include <glm/vec2.hpp>

#include <filesystem>
#include <functional>
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
    void setTitle(const std::string& title);
    glm::ivec2 framebufferSize() const;
    /// Pixels of the framebuffer for a unit of ImGui.
    float pixelRatio() const;
    void copyToClipboard(const std::string& text);

    /// Handles what has happened, at once, or after sleeping until something does (`briefly`: for a sixth of
    /// a second at most).
    enum class Sleep { none, briefly, untilEvent };
    void handleEvents(Sleep sleep);
    /// Files dropped since the last call.
    std::vector<std::string> takeDropped();

    void beginPanels();
    /// Draws the panels over what the framebuffer holds.
    void endPanels();
    void swap();

    /// Wakes `handleEvents` from any thread.
    static void wake();

  private:
    struct Press {
        int key, modifiers;  ///< As given by GLFW.
    };
    void holdShortKeys();

    GLFWwindow* window_ = nullptr;
    std::vector<std::string> dropped_;
    std::vector<Press> pressed_;  ///< Since the last frame.
    std::vector<int> held_;       ///< Keys that are down for the last frame only.
    std::string layoutFile_;
};

/// Writes the back buffer of the window, panels included, as a PNG. Call before the swap. `size` is that of
/// its framebuffer. Throws `candela::Error`.
void writeWindowPicture(const std::filesystem::path& file, const glm::ivec2& size);
