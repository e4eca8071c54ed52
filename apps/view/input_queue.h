#pragma once

#include <glm/vec2.hpp>

#include <cstdint>
#include <deque>
#include <vector>

struct ImGuiIO;

/// Pointer and key events in the order in which they came. ImGui reads the state of pointer and keys once a
/// frame, so that each frame is given as many events as cannot hide one another: a key or a button that is
/// pressed and let go between two frames is down for one of them, and moves of the pointer before and after
/// a press are in other frames than the press.
class InputQueue {
  public:
    enum class Press { down, up };

    /// In units of ImGui, from the upper left corner of the window.
    void movePointer(const glm::vec2& place) { add({.kind = Kind::move, .place = place}); }
    /// The pointer is over another window. Ignored while a button is down.
    void leave();
    /// Of a button or a key that ImGui does not know, nothing is kept.
    void pressButton(int button, Press press);
    void turnWheel(const glm::vec2& steps) { add({.kind = Kind::wheel, .place = steps}); }
    /// `key` is a number of GLFW.
    void pressKey(int key, Press press);
    void type(std::uint32_t character) { add({.kind = Kind::text, .code = static_cast<int>(character)}); }

    bool empty() const { return events_.empty(); }
    /// Takes the events of the next frame and writes the state after them to `io`. To be called before
    /// ImGui::NewFrame, once a frame, also without events.
    void beginFrame(ImGuiIO& io);

  private:
    enum class Kind { move, button, wheel, key, text };
    struct Event {
        Kind kind = Kind::move;
        int code = 0;  ///< A key, a button or a character.
        Press press = Press::down;
        glm::vec2 place{0.0f};  ///< Of the pointer; of the wheel its steps.
    };

    void add(const Event& event) { events_.push_back(event); }
    static bool fits(const std::vector<Event>& taken, const Event& next);
    void apply(const Event& event, ImGuiIO& io);

    static constexpr glm::vec2 nowhere{-3.402823466e+38f};  ///< As ImGui has it.

    std::deque<Event> events_;
    glm::vec2 place_ = nowhere;
    std::vector<bool> buttons_ = std::vector<bool>(5, false);
};
