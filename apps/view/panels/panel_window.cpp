#include "panels/panel_window.h"

#include <imgui.h>

namespace {

/// Room for the name of a value at its right, in letters.
constexpr float labelLetters = 8.5f;

bool arranging = false;

}  // namespace

PanelWindow::PanelWindow(Panel panel, const char* title, bool& open) {
    const PanelPlace place = firstPlace(panel, panelSpace());
    const ImGuiCond when = arranging ? ImGuiCond_Always : ImGuiCond_FirstUseEver;
    ImGui::SetNextWindowPos({place.position.x, place.position.y}, when);
    ImGui::SetNextWindowSize({place.size.x, place.size.y}, when);
    visible_ = ImGui::Begin(title, &open);
    ImGui::PushItemWidth(-labelLetters * ImGui::GetFontSize());
}

PanelWindow::~PanelWindow() {
    ImGui::PopItemWidth();
    ImGui::End();
}

PanelSpace panelSpace() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return {{display.x, display.y}, ImGui::GetFrameHeight(), ImGui::GetFontSize()};
}

void beginArrangement() {
    arranging = true;
}

void endArrangement() {
    arranging = false;
}
