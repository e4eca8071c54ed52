#include "panels/frame_graph.h"
#include "panels/frame_summary.h"
#include "panels/panel_window.h"
#include "panels/panels.h"
#include "panels/texts.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <array>
#include <cstdio>

namespace {

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
    const PanelWindow window(Panel::statistics, "Statistics", model.panels.statistics);
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
