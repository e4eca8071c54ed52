#include "panels/panels.h"
#include "panels/widgets.h"
#include "shortcuts.h"

#include <candela/version.h>

#include <imgui.h>

namespace {

constexpr ImGuiWindowFlags flags =
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;

void centre() {
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
    // In a small window it scrolls.
    constexpr float share = 0.9f;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {share * display.x, share * display.y});
}

void drawKeys(bool& open) {
    centre();
    if (ImGui::Begin("Keys", &open, flags) && ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const Gesture& gesture : gestures()) showRow(gesture.pointer, gesture.effect);
        for (const Shortcut& shortcut : shortcuts()) showRow(shortcut.keys, shortcut.effect);
        ImGui::EndTable();
    }
    ImGui::End();
}

void drawAbout(const ViewModel& model, bool& open) {
    centre();
    if (ImGui::Begin("About", &open, flags)) {
        showText("candela " CANDELA_VERSION);
        showText("scenes lit by very many lights, deferred, on OpenGL");
        showDimText("MIT licence");
        showDimText(model.renderer);
    }
    ImGui::End();
}

}  // namespace

void drawHelp(ViewModel& model) {
    if (model.helpShown && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) model.helpShown = false;
    if (model.helpShown) drawKeys(model.helpShown);
    if (model.aboutShown) drawAbout(model, model.aboutShown);
}

void drawHiddenHint(const ViewModel& model) {
    if (!model.panelsHidden) return;
    const std::string text = std::string(keysOf(Action::hidePanels)) + ": panels";
    const ImVec2 display = ImGui::GetIO().DisplaySize, size = ImGui::CalcTextSize(text.c_str());
    const float margin = 0.5f * ImGui::GetFontSize();
    ImGui::GetBackgroundDrawList()->AddText({display.x - size.x - margin, display.y - size.y - margin},
                                            IM_COL32(200, 200, 200, 110), text.c_str());
}
