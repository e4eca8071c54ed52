#pragma once

#include <glm/vec2.hpp>

enum class Panel { scene, materials, lights, camera, color, drawing, statistics, probe };

/// Where the panels can lie, in units of ImGui.
struct PanelSpace {
    glm::vec2 display{1280.0f, 720.0f};
    float menuHeight = 19.0f;  ///< The menu bar takes this much at the top.
    float letter = 13.0f;      ///< Height of the letters.
};

struct PanelPlace {
    glm::vec2 position{0.0f};  ///< Of the upper left corner.
    glm::vec2 size{0.0f};
};

/// Where a panel lies before anyone moves it: in a column left or right of the picture, or under it. No two
/// overlap, and the middle of the picture stays free.
PanelPlace firstPlace(Panel panel, const PanelSpace& space);

/// What the panels leave free of the picture when all are open.
PanelPlace freePicture(const PanelSpace& space);
