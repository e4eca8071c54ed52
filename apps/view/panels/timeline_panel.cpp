#include "common/scene_selection.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace {

/// The end of the slider where no animation gives one, in seconds.
constexpr double standardEnd = 10.0;
/// Of the list of clips, in heights of a letter, and as a share of the row.
constexpr float clipLetters = 10.0f, minClipLetters = 4.0f, clipShare = 0.2f;

/// Narrower in a narrow window, which leaves room for the slider.
float clipWidth() {
    const float letter = ImGui::GetFontSize();
    return std::clamp(clipShare * ImGui::GetWindowWidth(), minClipLetters * letter, clipLetters * letter);
}

/// The animations that play, in words.
std::string playing(const ViewModel& model) {
    const candela::Scene& scene = model.document->scene();
    if (scene.animations.empty()) return scene.frameCallback ? "frame callback" : "no animation";
    return model.options.animation.value_or(animationLabel(scene, 0));
}

void chooseAnimation(ViewModel& model) {
    const candela::Scene& scene = model.document->scene();
    std::optional<std::string> chosen;
    ImGui::SetNextItemWidth(clipWidth());
    ImGui::BeginDisabled(scene.animations.empty());
    if (ImGui::BeginCombo("##clip", playing(model).c_str())) {
        for (const char* word : {"all", "none"})
            if (ImGui::Selectable(word)) chosen = word;
        for (std::uint32_t i = 0; i < scene.animations.size(); ++i)
            if (listRow(i, Row::plain, animationLabel(scene, i))) chosen = std::to_string(i);
        ImGui::EndCombo();
    }
    ImGui::EndDisabled();
    if (!chosen) return;
    tryTo(model, [&] {
        SceneOptions options = model.options;
        options.animation = chosen;
        model.document->playAnimations(selectedAnimations(scene, options));
        model.options.animation = chosen;
    });
}

/// What the controls at the right of the slider take.
float endWidth() {
    const ImGuiStyle& style = ImGui::GetStyle();
    return clipWidth() + ImGui::GetFrameHeight() + ImGui::CalcTextSize("loop").x +
           2.0f * style.ItemSpacing.x + style.ItemInnerSpacing.x;
}

}  // namespace

void drawTimelinePanel(ViewModel& model) {
    const PanelWindow window(model, Panel::timeline, "Timeline");
    if (!window || !model.document) return;
    if (ImGui::Button(model.playing ? "Pause" : "Play")) model.playing = !model.playing;
    ImGui::SameLine();
    if (ImGui::Button("Start")) model.options.time = 0.0;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to 0 s");
    ImGui::SameLine();
    const double lastKey = lastKeyTime(model.document->scene());
    ImGui::SetNextItemWidth(-endWidth());
    slideNumber("##time", model.options.time, 0.0, lastKey > 0.0 ? lastKey : standardEnd, "%.3f s");
    ImGui::SameLine();
    chooseAnimation(model);
    ImGui::SameLine();
    ImGui::Checkbox("loop", &model.options.repeatAnimations);
}
