#include "panels/panel.h"

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

void addError(ViewModel& model, const char* text) {
    // A value that is dragged fails in every frame.
    if (!model.messages.empty() && model.messages.back().text == text) return;
    model.messages.push_back({Message::Kind::error, text});
}

std::uint64_t sceneNumber(const ViewModel& model) {
    static const Document* last = nullptr;
    static std::uint64_t number = 0;
    // The next document is created while the last one lives, so that their addresses differ.
    if (model.document.get() != last || number == 0) {
        last = model.document.get();
        ++number;
    }
    return number;
}
