#include "panels/panel_window.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

namespace {

constexpr float barLetters = 30.0f;
/// Under the messages and above the legend.
constexpr float heightShare = 0.73f;

}  // namespace

void drawLoading(ViewModel& model) {
    if (!model.loading) return;
    const PanelPlace picture = freePicture(panelSpace());
    ImGui::SetNextWindowPos(
        {picture.position.x + 0.5f * picture.size.x, picture.position.y + heightShare * picture.size.y},
        ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    const float width = barLetters * ImGui::GetFontSize();
    ImGui::PushTextWrapPos(width);
    showText("reading " + model.loading->scene);
    ImGui::PopTextWrapPos();
    ImGui::ProgressBar(static_cast<float>(model.loading->share), {width, 0.0f});
    if (ImGui::Button("Cancel")) model.requests.cancelLoading = true;
    ImGui::End();
}
