#pragma once

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <vector>

enum class Panel { scene, materials, lights, camera, color, drawing, statistics, probe, timeline };
constexpr std::size_t panelCount = 9;

/// Columns at both sides of the picture and a strip under it. Panels of a column lie one under another, those
/// of the strip side by side. The timeline is a row between picture and strip, of the height of its one line.
enum class Dock { left, right, bottom, row };
Dock dockOf(Panel panel);

/// Where the panels can lie, in units of ImGui.
struct PanelSpace {
    glm::vec2 display{1280.0f, 720.0f};
    float menuHeight = 19.0f;   ///< The menu bar takes this much at the top; 0 where it is hidden.
    float titleHeight = 19.0f;  ///< Of a panel of which only the title shows.
    float letter = 14.0f;       ///< Height of the letters.
};

struct PanelPlace {
    glm::vec2 position{0.0f};  ///< Of the upper left corner.
    glm::vec2 size{0.0f};
};

/// Which panels are there.
struct PanelStates {
    enum class State { closed, collapsed, open };
    std::array<State, panelCount> of{};
};

/// What a user changes of the layout.
struct DockSizes {
    float left = 17.0f, right = 17.0f, bottom = 13.0f;  ///< Widths and height, in heights of a letter.
    /// How the panels of a dock share it.
    std::array<float, panelCount> weights{1.0f, 1.2f, 1.4f, 1.1f, 1.0f, 1.3f, 1.8f, 1.0f, 1.0f};
};

/// A bar with which a size is changed.
struct Splitter {
    PanelPlace place;
    Dock dock = Dock::left;
    enum class Kind { dockSize, between } kind = Kind::dockSize;  ///< `between` two panels of the dock.
    Panel first = Panel::scene, second = Panel::scene;            ///< Those panels.
};

struct Layout {
    std::array<PanelPlace, panelCount> panels;  ///< Of those that are not closed.
    PanelPlace picture;                         ///< What is left; no panel and no splitter covers it.
    std::vector<Splitter> splitters;
};

/// Panels fill their docks; a dock without panels takes no room. A dock takes 0.3 of the window at most.
Layout layoutOf(const PanelSpace& space, const PanelStates& states, const DockSizes& sizes);

/// Moves a splitter of `layout` by so many units of ImGui, to the right or down. Sizes stay positive.
void moveSplitter(const Splitter& splitter, const glm::vec2& units, const Layout& layout,
                  const PanelSpace& space, DockSizes& sizes);
