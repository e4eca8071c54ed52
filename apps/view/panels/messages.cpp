#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <optional>

namespace {

constexpr std::size_t maxShown = 6;
constexpr float widestLetters = 50.0f;
constexpr float tallestShare = 0.62f;  ///< Of the picture.
/// At max, of a shader's error.
constexpr std::ptrdiff_t shaderLines = 10;

ImVec4 colorOf(Message::Kind kind) {
    return kind == Message::Kind::error ? ImVec4(1.0f, 0.45f, 0.4f, 1.0f)
                                        : ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

float textWidth(const PanelPlace& picture) {
    return std::min(0.9f * picture.size.x, widestLetters * ImGui::GetFontSize());
}

void showColored(const std::string& text, const ImVec4& color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    showWrappedText(text);
    ImGui::PopStyleColor();
}

/// Returns whether the user dismissed it.
bool showMessage(const Message& message, int id) {
    ImGui::PushID(id);
    const bool dismissed = ImGui::SmallButton("x");
    ImGui::SameLine();
    showColored(message.text, colorOf(message.kind));
    ImGui::PopID();
    return dismissed;
}

/// The latest; older ones follow when these are dismissed.
void showMessages(std::deque<Message>& messages) {
    const std::size_t first = messages.size() - std::min(messages.size(), maxShown);
    std::optional<std::size_t> dismissed;
    for (std::size_t i = first; i < messages.size(); ++i)
        if (showMessage(messages[i], static_cast<int>(i))) dismissed = i;
    if (first > 0) showDimText("and " + std::to_string(first) + " older");
    const bool all = messages.size() > 1 && ImGui::SmallButton("Dismiss all");
    if (dismissed) messages.erase(messages.begin() + static_cast<std::ptrdiff_t>(*dismissed));
    if (all) messages.clear();
}

void showShaderError(const std::string& text) {
    showColored("The shaders do not compile; the last good ones go on.", colorOf(Message::Kind::error));
    // One line more for its frame and one for a scroll bar.
    const auto lines = static_cast<float>(std::min(std::ranges::count(text, '\n') + 3, shaderLines));
    ImGui::BeginChild("shader error", {0.0f, lines * ImGui::GetTextLineHeight()}, true,
                      ImGuiWindowFlags_HorizontalScrollbar);
    showText(text);
    ImGui::EndChild();
}

constexpr float barLetters = 30.0f;
/// Position of the progress bar as a share of the free picture: below the messages and above the legend.
constexpr float loadingHeight = 0.73f;

}  // namespace

void drawMessages(ViewModel& model) {
    if (model.messages.empty() && model.shaderError.empty()) return;
    const PanelPlace& picture = model.layout.picture;
    const float margin = 0.5f * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({picture.position.x + 0.5f * picture.size.x, picture.position.y + margin},
                            ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowSizeConstraints({textWidth(picture), 0.0f},
                                        {textWidth(picture), tallestShare * picture.size.y});
    ImGui::Begin("messages", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    if (!model.shaderError.empty()) showShaderError(model.shaderError);
    if (!model.messages.empty()) showMessages(model.messages);
    ImGui::End();
}

void drawLoading(ViewModel& model) {
    if (!model.loading && model.loadingEnvironment.empty()) return;
    const PanelPlace& picture = model.layout.picture;
    ImGui::SetNextWindowPos(
        {picture.position.x + 0.5f * picture.size.x, picture.position.y + loadingHeight * picture.size.y},
        ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::Begin("loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    const float width = barLetters * ImGui::GetFontSize();
    ImGui::PushTextWrapPos(width);
    if (!model.loadingEnvironment.empty()) showText("reading " + model.loadingEnvironment);
    if (model.loading) showText("reading " + model.loading->scene);
    ImGui::PopTextWrapPos();
    if (model.loading) {
        ImGui::ProgressBar(static_cast<float>(model.loading->share), {width, 0.0f});
        if (ImGui::Button("Cancel")) model.requests.cancelLoading = true;
    }
    ImGui::End();
}
