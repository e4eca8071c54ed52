#include "common/shadow_stats.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"
#include "view_options.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace {

/// As --subdivision-edge has it.
constexpr float minEdge = 0.1f, longestEdge = 1000.0f;
/// The level that a click on "fixed" begins with.
constexpr std::uint32_t firstLevel = 2;

void chooseShadows(candela::Shadows& shadows) {
    using enum candela::Shadows;
    bool casts = drawnShadows(shadows) == on;
    ImGui::BeginDisabled(!candela::hasShadows());
    if (ImGui::Checkbox("shadows", &casts)) shadows = casts ? on : off;
    ImGui::EndDisabled();
}

void chooseLighting(ViewModel& model) {
    using enum candela::Technique;
    constexpr std::array techniques{automatic, volumes, tiles, fullscreen};
    constexpr std::array models{candela::BrdfModel::course, candela::BrdfModel::gltf};
    chooseOne("technique", model.options.technique, techniques, [&](candela::Technique technique) {
        const bool chose = technique == automatic && model.technique != automatic;
        return std::string(candela::toString(technique)) +
               (chose ? std::string(" (") + candela::toString(model.technique) + ")" : "");
    });
    chooseOne("reflection", model.options.brdf, models,
              [](candela::BrdfModel brdf) { return candela::toString(brdf); });
    chooseShadows(model.options.shadows);
    ImGui::Checkbox("specular antialiasing", &model.options.specularAntialiasing);
    slideLevel("layers", model.options.layers, 0, candela::maxLayers);
    if (model.layerCounts.fragmentsBeyond > 0)
        showWrappedText("beyond these layers: " + countText(model.layerCounts.fragmentsBeyond, "pixel") +
                        " of transparent surfaces");
}

void editSamples(SamplingOptions& sampling) {
    // Up to what a view that rests gets within minutes; the command line takes more.
    constexpr std::uint32_t most = 4096;
    std::uint32_t count = sampling.count.value_or(defaultViewSamples);
    if (slideLevel("samples at rest", count, 1, std::max(most, count))) sampling.count = count;
}

/// Shown where the scene has them.
void editElements(ViewModel& model) {
    constexpr NumberRange range{
        .min = 0.25f, .max = 64.0f, .format = "%.2f px", .scale = NumberRange::Scale::logarithmic};
    if (!model.document) return;
    const candela::GpuScene& scene = model.document->gpuScene();
    if (scene.elementCount(candela::Topology::points) > 0)
        slideNumber("point size", model.options.pointSize, range);
    if (scene.elementCount(candela::Topology::lines) > 0)
        slideNumber("line width", model.options.lineWidth, range);
}

void chooseDebugView(DebugViewOptions& options) {
    chooseOne("show", options.view, selectableViews(),
              [](candela::DebugView view) { return candela::toString(view); });
    ImGui::Checkbox("wireframe", &options.overlays.wireframe);
    ImGui::SameLine();
    ImGui::Checkbox("cages", &options.overlays.cage);
}

bool editSubdivision(candela::SubdivisionSettings& settings) {
    bool changed = false;
    if (ImGui::RadioButton("by size", !settings.level) && settings.level) {
        settings.level.reset();
        changed = true;
    }
    ImGui::SameLine();
    if (ImGui::RadioButton("fixed level", settings.level.has_value()) && !settings.level) {
        settings.level = firstLevel;
        changed = true;
    }
    const std::uint32_t maxLevel = candela::maxSubdivisionLevel;
    if (settings.level) return slideLevel("level", *settings.level, 1, maxLevel) || changed;
    changed = slideNumber("edges", settings.edgePixels,
                          {.min = minEdge,
                           .max = longestEdge,
                           .format = "%.1f px",
                           .scale = NumberRange::Scale::logarithmic}) ||
              changed;
    return slideLevel("up to level", settings.maxLevel, 1, maxLevel) || changed;
}

std::string levelsText(const candela::CageReport& report) {
    if (report.minLevel == report.maxLevel) return "level " + std::to_string(report.maxLevel);
    return "levels " + std::to_string(report.minLevel) + " to " + std::to_string(report.maxLevel);
}

void showReport(const candela::CageReport& report) {
    if (report.cages == 0) return showDimText("The scene has no cages.");
    showText(countText(report.cages, "cage") + ", " + countText(report.triangles, "triangle"));
    if (!report.subdivided)
        return showWrappedText("No plugin that refines cages is loaded: their polygons are drawn.");
    showText(levelsText(report) + ", tables of " + bytesText(report.tableBytes));
    if (report.lodClamped > 0)
        showWrappedText(countText(report.lodClamped, "node") + " clamped below what the size asks for");
    if (!report.evaluator.empty()) showText("points are moved by " + report.evaluator);
}

void drawSubdivision(ViewModel& model) {
    candela::SubdivisionSettings settings = model.options.subdivision;
    const bool changed = editSubdivision(settings);
    if (model.document) showReport(model.document->gpuScene().cageReport());
    if (!changed) return;
    tryTo(model, [&] {
        if (model.document) model.document->gpuScene().setSubdivision(settings);
        model.options.subdivision = settings;
    });
}

}  // namespace

void drawDrawingPanel(ViewModel& model) {
    const PanelWindow window(model, Panel::drawing, "Drawing");
    if (!window) return;
    chooseLighting(model);
    editSamples(model.options.sampling);
    editElements(model);
    chooseDebugView(model.options.debug);
    ImGui::Separator();
    showText("subdivision");
    drawSubdivision(model);
}
