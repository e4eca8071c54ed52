// The line of comparison.h over the picture.

#include "comparison.h"

#include <imgui.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// In heights of a letter: how near to the line the pointer takes it, the size of its handle, and the margin
/// of the captions.
constexpr float reachLetters = 0.5f, handleLetters = 0.8f, marginLetters = 0.5f;
constexpr float handleHeight = 0.8f;  ///< As a share of the picture, from its top.
constexpr ImU32 lineColor = IM_COL32(255, 255, 255, 220), edgeColor = IM_COL32(0, 0, 0, 160),
                captionColor = IM_COL32(16, 16, 16, 200), textColor = IM_COL32(235, 235, 235, 255);

enum class Side { left, right };

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

/// In the lower corner of its side, up to the line.
void drawCaption(const PanelPlace& picture, float line, Side side, const std::string& text) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float margin = marginLetters * ImGui::GetFontSize();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float left = picture.position.x, right = left + picture.size.x,
                bottom = picture.position.y + picture.size.y;
    const float x = side == Side::left ? left + 2.0f * margin : right - 2.0f * margin - size.x;
    const float y = bottom - 2.0f * margin - size.y;
    const ImVec2 from{side == Side::left ? left : line, picture.position.y},
        to{side == Side::left ? line : right, bottom};
    if (from.x >= to.x) return;
    list.PushClipRect(from, to, true);
    list.AddRectFilled({x - margin, y - margin}, {x + size.x + margin, y + size.y + margin}, captionColor,
                       margin);
    list.AddText({x, y}, textColor, text.c_str());
    list.PopClipRect();
}

void drawCaptions(const ViewModel& model, float line) {
    const PanelPlace& picture = model.layout.picture;
    const ComparedTexts texts = differences(leftOptions(model), model.options);
    if (texts.left.empty()) {
        drawCaption(picture, line, Side::left, "as set before");
        return drawCaption(picture, line, Side::right, "as set now: change a setting");
    }
    drawCaption(picture, line, Side::left, joined(texts.left));
    drawCaption(picture, line, Side::right, joined(texts.right));
}

void drawLine(const PanelPlace& picture, float x, bool isActive) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float top = picture.position.y, bottom = top + picture.size.y;
    // Gizmos are more often in the middle.
    const float middle = glm::mix(top, bottom, handleHeight);
    const float letter = ImGui::GetFontSize(), width = std::max(0.1f * letter, 1.0f);
    list.AddLine({x, top}, {x, bottom}, edgeColor, 3.0f * width);
    list.AddLine({x, top}, {x, bottom}, lineColor, isActive ? 2.0f * width : width);
    const float size = handleLetters * letter, gap = 0.35f * letter;
    for (const float way : {-1.0f, 1.0f}) {
        const ImVec2 tip(x + way * (gap + size), middle), above(x + way * gap, middle - 0.7f * size),
            below(x + way * gap, middle + 0.7f * size);
        list.AddTriangleFilled(tip, above, below, lineColor);
        list.AddTriangle(tip, above, below, edgeColor, width);
    }
}

}  // namespace

bool driveComparison(ViewModel& model) {
    Comparison& comparison = model.comparison;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsMouseClicked(0)) comparison.tookPress = false;
    if (!comparison.shown) return false;
    const PanelPlace& picture = model.layout.picture;
    const float width = std::max(picture.size.x, 1.0f);
    float x = picture.position.x + comparison.line * width;
    const bool isFree = !model.gizmo.hovered && !model.gizmo.dragged;
    const bool isNear = isFree && std::abs(io.MousePos.x - x) < reachLetters * ImGui::GetFontSize() &&
                        io.MousePos.y >= picture.position.y &&
                        io.MousePos.y < picture.position.y + picture.size.y;
    const bool isHovered = isNear && !io.WantCaptureMouse && (comparison.dragged || !io.MouseDown[0]);
    if (isNear && ImGui::IsMouseClicked(0) && !io.MouseDownOwned[0] && !io.KeyShift)
        comparison.dragged = comparison.tookPress = true;
    if (!io.MouseDown[0]) comparison.dragged = false;
    if (comparison.dragged) {
        comparison.line = std::clamp((io.MousePos.x - picture.position.x) / width, 0.0f, 1.0f);
        x = picture.position.x + comparison.line * width;
    }
    if (comparison.dragged || isHovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    drawCaptions(model, x);
    drawLine(picture, x, comparison.dragged || isHovered);
    return comparison.dragged;
}
