#pragma once

#include <optional>
#include <span>
#include <string>

/// What the user can do by a key or by a menu.
enum class Action {
    help,
    hidePanels,
    open,
    savePng,
    saveExr,
    saveLights,
    copyCommand,
    gizmoMove,
    gizmoTurn,
    gizmoScale,
    lightIcons,
    grid,
    compare,
    swapSides,
    undo,
    redo,
    quit,
    frameAll,
    framePicked,
    expose,
    play,
    largerText,
    smallerText,
};

/// A key that does something, alone or with modifiers.
struct Shortcut {
    Action action;
    int key;  ///< Of GLFW.
    enum class With { nothing, shift, control, controlAndShift } with;
    const char* keys;    ///< As menus show it, such as "Ctrl+S".
    const char* effect;  ///< Such as "save the picture".
};

/// All keys, in the order in which they are listed.
std::span<const Shortcut> shortcuts();
/// The keys of an action, such as "Ctrl+S".
const char* keysOf(Action action);

/// What the pointer does over the picture.
struct Gesture {
    const char* pointer;
    const char* effect;
};
std::span<const Gesture> gestures();

/// All gestures and keys as lines of text.
std::string controlsText();

/// The action whose keys were pressed in this ImGui frame. None while a dialog is open, text is typed or a
/// value is dragged.
std::optional<Action> pressedAction();
