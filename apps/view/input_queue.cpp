#include "input_queue.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cstddef>

namespace {

constexpr int keyCount = 512;  ///< Of ImGuiIO::KeysDown.
static_assert(sizeof(ImGuiIO::KeysDown) == keyCount * sizeof(bool));

bool isModifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

/// Keys with which a text field does something, in an order that matters to what is typed.
bool edits(int key) {
    return key >= GLFW_KEY_ESCAPE && !isModifier(key);
}

}  // namespace

void InputQueue::leave() {
    const auto isPress = [](const Event& event) { return event.kind == Kind::button; };
    const auto last = std::find_if(events_.rbegin(), events_.rend(), isPress);
    const bool dragged = last != events_.rend() ? last->press == Press::down
                                                : std::ranges::find(buttons_, true) != buttons_.end();
    if (!dragged) movePointer(nowhere);
}

void InputQueue::pressButton(int button, Press press) {
    if (button < 0 || button >= static_cast<int>(buttons_.size())) return;
    add({.kind = Kind::button, .code = button, .press = press});
}

void InputQueue::pressKey(int key, Press press) {
    if (key < 0 || key >= keyCount) return;
    add({.kind = Kind::key, .code = key, .press = press});
}

/// Whether the state after `next` still tells all of what was taken.
bool InputQueue::fits(const std::vector<Event>& taken, const Event& next) {
    if (taken.empty()) return true;
    const bool typing = next.kind == Kind::key || next.kind == Kind::text;
    return std::ranges::all_of(taken, [&](const Event& before) {
        if (!typing) return before.kind == next.kind && next.kind != Kind::button;
        if (before.kind == Kind::text) return next.kind == Kind::text || !edits(next.code);
        if (before.kind != Kind::key) return false;
        if (next.kind == Kind::text) return before.press == Press::up || !edits(before.code);
        if (before.code == next.code) return false;
        // A combination is what was down when its last key was pressed.
        return !isModifier(next.code) || isModifier(before.code) || before.press == Press::up;
    });
}

void InputQueue::apply(const Event& event, ImGuiIO& io) {
    const bool down = event.press == Press::down;
    switch (event.kind) {
        case Kind::move:
            place_ = event.place;
            return;
        case Kind::button:
            buttons_[static_cast<std::size_t>(event.code)] = down;
            return;
        case Kind::wheel:
            io.MouseWheelH += event.place.x;
            io.MouseWheel += event.place.y;
            return;
        case Kind::key:
            io.KeysDown[event.code] = down;
            return;
        case Kind::text:
            io.AddInputCharacter(static_cast<unsigned>(event.code));
            return;
    }
}

void InputQueue::beginFrame(ImGuiIO& io) {
    std::vector<Event> taken;
    while (!events_.empty() && fits(taken, events_.front())) {
        taken.push_back(events_.front());
        events_.pop_front();
        apply(taken.back(), io);
    }
    io.MousePos = {place_.x, place_.y};
    for (std::size_t i = 0; i < buttons_.size(); ++i) io.MouseDown[i] = buttons_[i];
    const auto isDown = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
    io.KeyShift = isDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyCtrl = isDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyAlt = isDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = isDown(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}
