// The guides of gizmo.h.

#include "gizmo.h"
#include "interaction.h"
#include "panels/color_values.h"

#include <imgui.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// More lights are not shown: their icons would hide the picture.
constexpr std::size_t maxIcons = 512;
constexpr float iconLetters = 0.45f, clickLetters = 0.8f;
/// Lines of the grid in each direction from its middle.
constexpr int gridLines = 10;

ScreenView screenOf(const ViewModel& model) {
    return {selectedView(model), model.layout.picture.position, model.layout.picture.size};
}

/// The lights that have an icon.
std::vector<std::uint32_t> shownLights(const ViewModel& model) {
    std::vector<std::uint32_t> shown;
    const auto& lights = model.document->lights();
    const auto has = [&](std::size_t i) { return lights[i].type != candela::LightType::directional; };
    if (model.guides.lights)
        for (std::size_t i = 0; i < std::min(lights.size(), maxIcons); ++i)
            if (has(i)) shown.push_back(static_cast<std::uint32_t>(i));
    const bool picked = model.pickedLight && *model.pickedLight < lights.size() && has(*model.pickedLight);
    if (picked && std::ranges::find(shown, *model.pickedLight) == shown.end())
        shown.push_back(*model.pickedLight);
    return shown;
}

/// A line of the world; cut where it comes behind the camera.
void drawLine(ImDrawList& list, const ScreenView& screen, const glm::vec3& from, const glm::vec3& to,
              ImU32 color) {
    constexpr int pieces = 16;
    for (int i = 0; i < pieces; ++i) {
        const auto a = screen.at(glm::mix(from, to, static_cast<float>(i) / pieces));
        const auto b = screen.at(glm::mix(from, to, static_cast<float>(i + 1) / pieces));
        if (a && b) list.AddLine({a->x, a->y}, {b->x, b->y}, color);
    }
}

/// On the ground about the camera's target, a power of ten metres apart.
void drawGrid(ImDrawList& list, const ScreenView& screen, const CameraControl& camera) {
    const float step = std::pow(10.0f, std::floor(std::log10(std::max(camera.heightAtTarget(), 1.0e-6f))));
    const glm::vec3 middle(std::round(camera.target().x / step) * step, 0.0f,
                           std::round(camera.target().z / step) * step);
    const float reach = step * gridLines;
    for (int i = -gridLines; i <= gridLines; ++i) {
        const glm::vec3 x(static_cast<float>(i) * step, 0.0f, 0.0f),
            z(0.0f, 0.0f, static_cast<float>(i) * step);
        const glm::vec3 alongX(reach, 0.0f, 0.0f), alongZ(0.0f, 0.0f, reach);
        drawLine(list, screen, middle + x - alongZ, middle + x + alongZ, IM_COL32(190, 190, 190, 70));
        drawLine(list, screen, middle + z - alongX, middle + z + alongX, IM_COL32(190, 190, 190, 70));
    }
    drawLine(list, screen, {0, 0, 0}, {step, 0, 0}, IM_COL32(226, 84, 84, 230));
    drawLine(list, screen, {0, 0, 0}, {0, step, 0}, IM_COL32(112, 192, 88, 230));
    drawLine(list, screen, {0, 0, 0}, {0, 0, step}, IM_COL32(88, 136, 232, 230));
}

void drawIcon(ImDrawList& list, const glm::vec2& place, const glm::vec3& hue, bool picked) {
    const float radius = iconLetters * ImGui::GetFontSize();
    const glm::vec3 codes = srgbFromLinear(hue);
    const ImU32 color = ImGui::ColorConvertFloat4ToU32({codes.r, codes.g, codes.b, 1.0f});
    list.AddCircleFilled({place.x, place.y}, radius, color);
    list.AddCircle({place.x, place.y}, radius + 1.0f,
                   picked ? IM_COL32(255, 255, 255, 255) : IM_COL32(20, 20, 20, 200), 0, 2.0f);
}

}  // namespace

void drawGuides(const ViewModel& model) {
    const std::vector<std::uint32_t> lights = shownLights(model);
    if (lights.empty() && !model.guides.grid) return;
    const ScreenView screen = screenOf(model);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    if (model.guides.grid) drawGrid(list, screen, model.camera);
    for (const std::uint32_t i : lights) {
        const candela::WorldLight& light = model.document->lights()[i];
        if (const auto place = screen.at(light.position))
            drawIcon(list, *place, splitColor(light.intensity).hue, model.pickedLight == i);
    }
}

std::optional<std::uint32_t> lightUnderPointer(const ViewModel& model) {
    const std::vector<std::uint32_t> lights = shownLights(model);
    if (lights.empty()) return std::nullopt;
    const ScreenView screen = screenOf(model);
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    float nearest = clickLetters * ImGui::GetFontSize();
    std::optional<std::uint32_t> found;
    for (const std::uint32_t i : lights) {
        const auto place = screen.at(model.document->lights()[i].position);
        const float distance = place ? glm::distance(*place, {pointer.x, pointer.y}) : nearest;
        if (distance >= nearest) continue;
        nearest = distance;
        found = i;
    }
    return found;
}
