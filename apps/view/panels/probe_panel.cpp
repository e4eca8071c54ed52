#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace {

std::string numberText(float value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.4g", static_cast<double>(value));
    return text.data();
}

std::string vectorText(const glm::vec3& value) {
    return numberText(value.x) + " " + numberText(value.y) + " " + numberText(value.z);
}

/// A place in the space of the scene's file.
std::string placeText(const glm::dvec3& origin, const glm::vec3& position) {
    if (origin == glm::dvec3(0.0)) return vectorText(position);
    const glm::dvec3 place = origin + glm::dvec3(position);
    std::array<char, 128> text;
    std::snprintf(text.data(), text.size(), "%.3f %.3f %.3f", place.x, place.y, place.z);
    return text.data();
}

int codeValue(float share) {
    return static_cast<int>(std::lround(255.0f * share));
}

/// As a .png holds it.
std::string codesText(const glm::vec3& display) {
    const int red = codeValue(display.r), green = codeValue(display.g), blue = codeValue(display.b);
    std::array<char, 48> text;
    std::snprintf(text.data(), text.size(), "%d %d %d  #%02x%02x%02x", red, green, blue,
                  static_cast<unsigned>(red), static_cast<unsigned>(green), static_cast<unsigned>(blue));
    return text.data();
}

void showPatchRow(const char* name, const std::string& value, void (*patch)(const char*, const glm::vec3&),
                  const glm::vec3& color) {
    showRow(name, value);
    ImGui::SameLine();
    patch(name, color);
}

void showSurface(const candela::PixelProbe& probe, const candela::Scene& scene) {
    const std::string& name = scene.nodes[probe.node].name;
    showRow("node", std::to_string(probe.node) + (name.empty() ? "" : " " + name));
    showRow("depth", numberText(probe.z) + " m");
    showRow("position", placeText(scene.origin, probe.position));
    showRow("normal", vectorText(probe.normal));
    showPatchRow("base colour", vectorText(probe.baseColor), colorPatch, probe.baseColor);
    showRow("metallic", numberText(probe.metallic));
    showRow("roughness", numberText(probe.roughness));
    showPatchRow("emission", vectorText(probe.emission), colorPatch, probe.emission);
    showPatchRow("radiance", vectorText(probe.radiance), colorPatch, probe.radiance);
    showRow("lights", groupedText(probe.lightCount));
}

}  // namespace

void drawProbePanel(ViewModel& model) {
    const PanelWindow window(model, Panel::probe, "Probe");
    if (!window || !model.document) return;
    if (!model.pointer) return showWrappedText("Point at the picture.");
    if (!ImGui::BeginTable("values", 2, ImGuiTableFlags_SizingFixedFit)) return;
    showRow("pixel", std::to_string(model.pointer->x) + ", " + std::to_string(model.pointer->y));
    showPatchRow("display", codesText(model.probeDisplay), codePatch, model.probeDisplay);
    if (model.probe) {
        showSurface(*model.probe, model.document->scene());
    } else {
        showRow("node", "none: background");
    }
    ImGui::EndTable();
}
