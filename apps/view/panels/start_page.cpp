#include "panels/panels.h"
#include "panels/widgets.h"
#include "shortcuts.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>

namespace {

constexpr float pictureLetters = 13.0f, pictureAspect = 16.0f / 9.0f;
constexpr int columns = 3;
constexpr float minPictureLetters = 4.0f;

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

void drawExample(ViewModel& model, const Example& example, const ImVec2& size) {
    ImGui::BeginGroup();
    ImGui::PushID(example.scene.c_str());
    const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(example.texture));
    const bool clicked = example.texture != 0 ? ImGui::ImageButton(texture, size, {0, 0}, {1, 1}, 1)
                                              : ImGui::Button("##picture", {size.x + 2.0f, size.y + 2.0f});
    ImGui::PopID();
    showDimText(example.scene);
    ImGui::EndGroup();
    if (clicked) model.requests.open = example.scene;
}

void drawExamples(ViewModel& model, float width) {
    if (model.examples.empty()) return;
    showText("Procedural scenes");
    const ImVec2 size(width, width / pictureAspect);
    for (std::size_t i = 0; i < model.examples.size(); ++i) {
        if (i % columns != 0) ImGui::SameLine();
        drawExample(model, model.examples[i], size);
    }
    ImGui::Spacing();
}

void drawRecent(ViewModel& model) {
    if (model.recent.empty()) return;
    showText("Opened last");
    for (std::size_t i = 0; i < model.recent.size(); ++i)
        if (listRow(i, Row::plain, model.recent[i])) model.requests.open = model.recent[i];
}

}  // namespace

void drawStartPage(ViewModel& model) {
    if (model.document || model.loading) return;
    const PanelPlace& place = model.layout.picture;
    const float letter = ImGui::GetFontSize();
    const float room = (0.92f * place.size.x - 2.0f * letter) / static_cast<float>(columns) - letter;
    const float width = std::clamp(room, minPictureLetters * letter, pictureLetters * letter);
    ImGui::SetNextWindowPos({place.position.x + 0.5f * place.size.x, place.position.y + 0.5f * place.size.y},
                            ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {place.size.x, place.size.y});
    ImGui::Begin("start", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::AlignTextToFramePadding();
    showText("Drop a scene here, or");
    ImGui::SameLine();
    if (ImGui::Button("Open...")) model.requests.browse = true;
    ImGui::SameLine();
    showDimText(keysOf(Action::open));
    showDimText(joined(model.sceneEndings) + "; an .hdr or .exr lights the scene");
    ImGui::Spacing();
    drawExamples(model, width);
    drawRecent(model);
    ImGui::End();
}
