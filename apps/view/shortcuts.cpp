#include "shortcuts.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace {

using With = Shortcut::With;

constexpr std::array table{
    Shortcut{Action::help, GLFW_KEY_F1, With::nothing, "F1", "show all keys"},
    Shortcut{Action::hidePanels, GLFW_KEY_TAB, With::nothing, "Tab", "hide or show all panels"},
    Shortcut{Action::frameAll, GLFW_KEY_F, With::nothing, "F", "frame everything"},
    Shortcut{Action::framePicked, GLFW_KEY_F, With::shift, "Shift+F", "frame what is picked"},
    Shortcut{Action::expose, GLFW_KEY_X, With::nothing, "X", "expose what the picture shows"},
    Shortcut{Action::play, GLFW_KEY_SPACE, With::nothing, "Space", "play or pause time"},
    Shortcut{Action::gizmoMove, GLFW_KEY_W, With::nothing, "W", "move what is picked by its axes"},
    Shortcut{Action::gizmoTurn, GLFW_KEY_E, With::nothing, "E", "turn it"},
    Shortcut{Action::gizmoScale, GLFW_KEY_R, With::nothing, "R", "scale it"},
    Shortcut{Action::lightIcons, GLFW_KEY_L, With::nothing, "L", "show lights as icons, which a click picks"},
    Shortcut{Action::grid, GLFW_KEY_G, With::nothing, "G", "show grid and axes"},
    Shortcut{Action::compare, GLFW_KEY_C, With::nothing, "C",
             "compare settings: those of now left of a line, later ones right"},
    Shortcut{Action::swapSides, GLFW_KEY_C, With::shift, "Shift+C", "swap the two sides"},
    Shortcut{Action::undo, GLFW_KEY_Z, With::control, "Ctrl+Z", "undo the last edit"},
    Shortcut{Action::redo, GLFW_KEY_Z, With::controlAndShift, "Ctrl+Shift+Z", "redo it"},
    Shortcut{Action::open, GLFW_KEY_O, With::control, "Ctrl+O", "open a scene"},
    Shortcut{Action::savePng, GLFW_KEY_S, With::control, "Ctrl+S", "save the picture as PNG"},
    Shortcut{Action::saveExr, GLFW_KEY_S, With::controlAndShift, "Ctrl+Shift+S", "save all channels as EXR"},
    Shortcut{Action::saveLights, GLFW_KEY_L, With::control, "Ctrl+L", "save lights and cameras as glTF"},
    Shortcut{Action::copyCommand, GLFW_KEY_C, With::controlAndShift, "Ctrl+Shift+C",
             "copy the candela-render command"},
    Shortcut{Action::largerText, GLFW_KEY_EQUAL, With::control, "Ctrl+=", "larger text"},
    Shortcut{Action::smallerText, GLFW_KEY_MINUS, With::control, "Ctrl+-", "smaller text"},
    Shortcut{Action::quit, GLFW_KEY_Q, With::control, "Ctrl+Q", "quit"},
};

constexpr std::array pointerTable{
    Gesture{"Left button", "orbit the target; a click picks"},
    Gesture{"Middle button, Shift+left", "pan"},
    Gesture{"Wheel", "come nearer, go away"},
    Gesture{"Right button", "look around; W A S D fly, E Q up and down, with Shift faster"},
};

bool holds(With with, const ImGuiIO& io) {
    const bool shift = with == With::shift || with == With::controlAndShift;
    const bool control = with == With::control || with == With::controlAndShift;
    return io.KeyShift == shift && io.KeyCtrl == control && !io.KeyAlt && !io.KeySuper;
}

std::string row(const char* keys, const char* effect) {
    constexpr std::size_t width = 27;
    std::string text = "  " + std::string(keys);
    text.resize(std::max(width, text.size() + 1), ' ');
    return text + effect + "\n";
}

}  // namespace

std::span<const Shortcut> shortcuts() {
    return table;
}

std::span<const Gesture> gestures() {
    return pointerTable;
}

const char* keysOf(Action action) {
    const auto found = std::ranges::find(table, action, &Shortcut::action);
    return found == table.end() ? nullptr : found->keys;
}

std::string controlsText() {
    std::string text;
    for (const Gesture& gesture : pointerTable) text += row(gesture.pointer, gesture.effect);
    for (const Shortcut& shortcut : table) text += row(shortcut.keys, shortcut.effect);
    return text;
}

std::optional<Action> pressedAction() {
    const ImGuiIO& io = ImGui::GetIO();
    // With the right button, keys fly.
    if (io.WantCaptureKeyboard || io.MouseDown[1]) return std::nullopt;
    for (const Shortcut& shortcut : table)
        if (ImGui::IsKeyPressed(shortcut.key, false) && holds(shortcut.with, io)) return shortcut.action;
    return std::nullopt;
}
