#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <algorithm>

namespace {

constexpr float barLetters = 28.0f, barHeightLetters = 1.2f;
constexpr int barSteps = 64;
/// Numbers along the bar, those at its ends included.
constexpr std::uint32_t maxMarks = 5;

constexpr ImGuiWindowFlags windowFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                         ImGuiWindowFlags_NoFocusOnAppearing;

ImU32 drawColor(const glm::vec3& color) {
    return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1.0f});
}

void drawBar(const ImVec2& corner, const ImVec2& size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float step = size.x / barSteps;
    for (int i = 0; i < barSteps; ++i) {
        const float x = corner.x + step * static_cast<float>(i);
        const ImU32 from = drawColor(candela::heatColor(static_cast<float>(i) / barSteps));
        const ImU32 to = drawColor(candela::heatColor(static_cast<float>(i + 1) / barSteps));
        list.AddRectFilledMultiColor({x, corner.y}, {x + step, corner.y + size.y}, from, to, to, from);
    }
}

/// `share` of the way along a bar; the number stays within its ends.
void drawMark(const ImVec2& corner, const ImVec2& size, float share, std::uint32_t number) {
    const std::string text = groupedText(number);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    const float x = corner.x + share * size.x;
    const float left = std::clamp(x - 0.5f * width, corner.x, corner.x + size.x - width);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(ImGuiCol_Text);
    const float end = corner.y + size.y + 0.25f * ImGui::GetFontSize();
    list.AddLine({x, corner.y + size.y}, {x, end}, color);
    list.AddText({left, end}, color, text.c_str());
}

/// What the ends of the heat map mean.
struct CountTexts {
    const char *title, *none;
};

CountTexts textsOf(candela::DebugView show) {
    if (show == candela::DebugView::shadowedCount)
        return {"lights hidden from a pixel", "no light is hidden"};
    return {"lights at a pixel", "no light reaches the picture"};
}

void drawCounts(const CountTexts& texts, std::uint32_t maxCount) {
    showText(texts.title);
    if (maxCount == 0) return showText(texts.none);
    const ImVec2 size(barLetters * ImGui::GetFontSize(), barHeightLetters * ImGui::GetFontSize());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy({size.x, size.y + 1.5f * ImGui::GetFontSize()});
    drawBar(corner, size);
    // Whole numbers only, each at its place.
    const std::uint32_t steps = std::min(maxCount, maxMarks - 1);
    for (std::uint32_t i = 0; i <= steps; ++i) {
        const auto number = static_cast<std::uint32_t>(std::uint64_t{maxCount} * i / steps);
        drawMark(corner, size, static_cast<float>(number) / static_cast<float>(maxCount), number);
    }
}

void drawLevels() {
    showText("level of subdivision");
    for (std::uint32_t level = 0; level <= candela::maxSubdivisionLevel; ++level) {
        if (level > 0) ImGui::SameLine();
        codePatch(std::to_string(level).c_str(), candela::levelColor(level));
        ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
        showText(level == 0 ? "0 (polygons)" : std::to_string(level));
    }
}

}  // namespace

void drawHeatLegend(const ViewModel& model) {
    const candela::DebugView show = model.options.debug.view;
    const bool showsCounts =
        show == candela::DebugView::lightCount || show == candela::DebugView::shadowedCount;
    if (!model.document || (!showsCounts && show != candela::DebugView::level)) return;
    const PanelPlace& picture = model.layout.picture;
    ImGui::SetNextWindowPos({picture.position.x + 0.5f * picture.size.x,
                             picture.position.y + picture.size.y - ImGui::GetFontSize()},
                            ImGuiCond_Always, {0.5f, 1.0f});
    if (ImGui::Begin("legend", nullptr, windowFlags)) {
        if (showsCounts) {
            drawCounts(textsOf(show), model.maxLightCount);
        } else {
            drawLevels();
        }
    }
    ImGui::End();
}
