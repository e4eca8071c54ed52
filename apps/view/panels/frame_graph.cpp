#include "panels/frame_graph.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace {

constexpr float graphLines = 4.0f;
constexpr std::size_t maxBars = 240;
/// What a frame took beyond its passes.
constexpr ImU32 restColor = IM_COL32(90, 90, 90, 255);

ImU32 drawColor(const glm::vec3& color) {
    return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1.0f});
}

/// Where the graph lies, and how many pixels a millisecond is high.
struct Area {
    ImVec2 least, most;
    float scale;
};

std::size_t indexOf(const FrameSummary& summary, const std::string& pass) {
    const auto found = std::ranges::find(summary.passes, pass, &PassSummary::name);
    return static_cast<std::size_t>(found - summary.passes.begin());
}

void drawBar(const FrameRecord& frame, const FrameSummary& summary, const Area& area, float x, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float y = area.most.y;
    const auto stack = [&](double milliseconds, ImU32 color) {
        const float top = std::max(y - static_cast<float>(milliseconds) * area.scale, area.least.y);
        if (top < y) list.AddRectFilled({x, top}, {x + width, y}, color);
        y = top;
    };
    double sum = 0.0;
    for (const candela::PassTime& pass : frame.passes) {
        stack(pass.milliseconds, drawColor(passColor(indexOf(summary, pass.name))));
        sum += pass.milliseconds;
    }
    stack(std::max(frame.milliseconds - sum, 0.0), restColor);
}

void drawScale(const Area& area, double full) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%g ms", full);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(area.least, ImGui::GetColorU32(ImGuiCol_Text), text.data());
    list.AddRect(area.least, area.most, ImGui::GetColorU32(ImGuiCol_Border));
}

}  // namespace

glm::vec3 passColor(std::size_t index) {
    // Hues a golden angle apart: neighbours differ, however many there are.
    constexpr float step = 0.618034f;
    const float turns = 0.58f + step * static_cast<float>(index);
    glm::vec3 color;
    ImGui::ColorConvertHSVtoRGB(turns - static_cast<float>(static_cast<int>(turns)), 0.65f, 0.9f, color.r,
                                color.g, color.b);
    return color;
}

void drawFrameGraph(const std::deque<FrameRecord>& frames, const FrameSummary& summary) {
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0f),
                      graphLines * ImGui::GetTextLineHeight());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    const double full = roundedUp(std::max(summary.greatest, 0.01));
    const Area area{corner, {corner.x + size.x, corner.y + size.y}, size.y / static_cast<float>(full)};
    const float width = size.x / static_cast<float>(maxBars);
    float x = area.most.x;
    for (auto frame = frames.rbegin(); frame != frames.rend() && x > area.least.x; ++frame) {
        x -= width;
        drawBar(*frame, summary, area, x, width);
    }
    drawScale(area, full);
}
