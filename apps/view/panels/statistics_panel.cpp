#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace {

constexpr float graphLines = 4.0f;
constexpr std::size_t maxBars = 240;
/// The time of a frame outside of its passes.
constexpr ImU32 restColor = IM_COL32(90, 90, 90, 255);

ImU32 drawColor(const glm::vec3& color) {
    return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1.0f});
}

/// The colour of pass `index` of a `FrameSummary`: display code values.
glm::vec3 passColor(std::size_t index) {
    // Hues a golden angle apart: neighbours differ, however many there are.
    constexpr float step = 0.618034f;
    const float hue = 0.58f + step * static_cast<float>(index);
    glm::vec3 color;
    ImGui::ColorConvertHSVtoRGB(hue - static_cast<float>(static_cast<int>(hue)), 0.65f, 0.9f, color.r,
                                color.g, color.b);
    return color;
}

/// The rectangle of the graph, and its pixels per millisecond.
struct Area {
    ImVec2 min, max;
    float scale;
};

std::size_t indexOf(const FrameSummary& summary, const std::string& pass) {
    const auto found = std::ranges::find(summary.passes, pass, &PassSummary::name);
    return static_cast<std::size_t>(found - summary.passes.begin());
}

void drawBar(const FrameRecord& frame, const FrameSummary& summary, const Area& area, float x, float width) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float y = area.max.y;
    const auto stack = [&](double milliseconds, ImU32 color) {
        const float top = std::max(y - static_cast<float>(milliseconds) * area.scale, area.min.y);
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
    list.AddText(area.min, ImGui::GetColorU32(ImGuiCol_Text), text.data());
    list.AddRect(area.min, area.max, ImGui::GetColorU32(ImGuiCol_Border));
}

/// A bar for each stored frame, the latest at the right, with its passes stacked.
void drawFrameGraph(const std::deque<FrameRecord>& frames, const FrameSummary& summary) {
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0f),
                      graphLines * ImGui::GetTextLineHeight());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size);
    const double full = roundedUp(std::max(summary.max, 0.01));
    const Area area{corner, {corner.x + size.x, corner.y + size.y}, size.y / static_cast<float>(full)};
    const float width = size.x / static_cast<float>(maxBars);
    float x = area.max.x;
    for (auto frame = frames.rbegin(); frame != frames.rend() && x > area.min.x; ++frame) {
        x -= width;
        drawBar(*frame, summary, area, x, width);
    }
    drawScale(area, full);
}

std::string milliseconds(double value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

void showPass(const std::string& name, const std::string& last, const std::string& median) {
    showText(name);
    ImGui::TableNextColumn();
    showText(last);
    ImGui::TableNextColumn();
    showText(median);
}

void showPasses(const FrameSummary& summary) {
    if (!ImGui::BeginTable("passes", 3)) return;
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("median", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableHeadersRow();
    for (std::size_t i = 0; i < summary.passes.size(); ++i) {
        const PassSummary& pass = summary.passes[i];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(i));
        codePatch("color", passColor(i));
        ImGui::PopID();
        ImGui::SameLine();
        showPass(pass.name, pass.last ? milliseconds(*pass.last) : "-", milliseconds(pass.median));
    }
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    showPass("the frame", milliseconds(summary.last), milliseconds(summary.median));
    ImGui::EndTable();
}

void showPairs(const ViewModel& model, const candela::PairCounts& pairs) {
    showRow("lights in view", groupedText(pairs.lightsVisible));
    showRow("pairs lit", groupedText(pairs.pairsLit));
    showRow("pairs evaluated", groupedText(pairs.pairsEvaluated));
    const auto pixels =
        static_cast<std::uint64_t>(model.options.width) * static_cast<std::uint64_t>(model.options.height);
    showRow("evaluated a pixel",
            milliseconds(static_cast<double>(pairs.pairsEvaluated) / static_cast<double>(pixels)));
    showRow("lights dropped", groupedText(pairs.lightsDropped));
    showRow("light lists", bytesText(pairs.lightListBytes));
}

void showCounters(ViewModel& model) {
    const candela::GpuScene& scene = model.document->gpuScene();
    const candela::CageReport cages = scene.cageReport();
    if (ImGui::BeginTable("counters", 2, ImGuiTableFlags_SizingFixedFit)) {
        showRow("lights", groupedText(model.document->lights().size()));
        showRow("triangles", groupedText(scene.triangleCount()));
        const std::uint64_t lines = scene.elementCount(candela::Topology::lines);
        const std::uint64_t points = scene.elementCount(candela::Topology::points);
        if (lines > 0) showRow("lines", groupedText(lines));
        if (points > 0) showRow("points", groupedText(points));
        if (cages.cages > 0) showRow("of cages", groupedText(cages.triangles));
        showRow("nodes", groupedText(model.document->scene().nodes.size()));
        showRow("materials", groupedText(scene.materialCount()));
        if (model.pairs) showPairs(model, *model.pairs);
        ImGui::EndTable();
    }
    if (ImGui::Button("Count pairs")) model.requests.countPairs = true;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("counts the pairs of one pixel with one light in a drawing of its own");
}

}  // namespace

void drawStatisticsPanel(ViewModel& model) {
    const PanelWindow window(model, Panel::statistics, "Statistics");
    if (!window) return;
    const std::optional<FrameSummary> summary = summarise(model.frames);
    if (!summary) return showDimText("No frame is drawn yet.");
    if (!ImGui::BeginTable("halves", 2, ImGuiTableFlags_SizingStretchSame)) return;
    ImGui::TableNextColumn();
    drawFrameGraph(model.frames, *summary);
    showPasses(*summary);
    ImGui::TableNextColumn();
    if (model.document) showCounters(model);
    ImGui::EndTable();
    showWrappedText(model.renderer);
}
