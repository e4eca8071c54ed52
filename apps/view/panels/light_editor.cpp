#include "panels/light_editor.h"

#include "light_values.h"
#include "panels/color_values.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

using candela::LightType;
using candela::WorldLight;

constexpr float brightest = 1.0e20f;
constexpr float farthest = 1.0e9f;
constexpr float minRange = 1.0e-3f;
/// Irradiance in lux at the range that a light is first given.
constexpr float rangeIrradiance = 0.005f;
/// Numbers of every size change by this share of themselves for a pixel.
constexpr float dragShare = 0.01f;

bool editType(WorldLight& light) {
    constexpr std::array types{LightType::point, LightType::spot, LightType::directional};
    if (!chooseOne("type", light.type, types, nameOf)) return false;
    // What the new kind reads may have been ignored so far.
    light.direction = directionOf(anglesOf(light.direction));
    orderCones(light);
    return true;
}

bool editPosition(WorldLight& light, const LightEditing& editing) {
    if (light.type == LightType::directional) return false;
    bool changed = dragPoint("position", light.position, editing.metresAPixel);
    if (ImGui::SmallButton("To the camera's target")) {
        light.position = editing.target;
        changed = true;
    }
    return changed;
}

bool editDirection(WorldLight& light, const LightEditing& editing) {
    if (light.type == LightType::point) return false;
    DirectionAngles angles = anglesOf(light.direction);
    bool changed =
        slideNumber("heading", angles.heading, {.min = -180.0f, .max = 180.0f, .format = "%.1f deg"});
    // Straight up and down have no heading.
    changed =
        slideNumber("height", angles.height, {.min = -89.9f, .max = 89.9f, .format = "%.1f deg"}) || changed;
    if (changed) light.direction = directionOf(angles);
    const glm::vec3 toTarget = editing.target - light.position;
    if (light.type == LightType::spot && ImGui::SmallButton("Aim at the camera's target") &&
        glm::length(toTarget) > 0.0f) {
        light.direction = glm::normalize(toTarget);
        changed = true;
    }
    return changed;
}

bool editCones(WorldLight& light) {
    if (light.type != LightType::spot) return false;
    float outer = glm::degrees(light.outerConeAngle), inner = glm::degrees(light.innerConeAngle);
    bool changed = false;
    if (slideNumber("outer cone", outer, {.min = 0.5f, .max = 90.0f, .format = "%.1f deg"})) {
        light.outerConeAngle = std::min(glm::radians(outer), glm::radians(90.0f));
        changed = true;
    }
    if (slideNumber("inner cone", inner, {.min = 0.0f, .max = 90.0f, .format = "%.1f deg"})) {
        light.innerConeAngle = glm::radians(inner);
        changed = true;
    }
    if (changed) orderCones(light);
    return changed;
}

bool editRange(WorldLight& light, float candela) {
    if (light.type == LightType::directional) return false;
    bool own = light.range > 0.0f;
    bool changed = ImGui::Checkbox("own range", &own);
    if (changed)
        light.range = own ? std::clamp(std::sqrt(candela / rangeIrradiance), minRange, farthest) : 0.0f;
    if (!own) return changed;
    const NumberRange range{
        .min = minRange, .max = farthest, .speed = dragShare * light.range, .format = "%.4g m"};
    return dragNumber("range", light.range, range) || changed;
}

bool editShadow(WorldLight& light) {
    const bool changed = ImGui::Checkbox("casts shadows", &light.castsShadow);
    if (light.type == LightType::directional) return changed;
    const NumberRange range{
        .max = farthest, .speed = dragShare * std::max(light.radius, 0.1f), .format = "%.4g m"};
    const bool resized = dragNumber("radius", light.radius, range);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("of the sphere that emits the light: softens its shadows");
    return resized || changed;
}

bool editHue(glm::vec3& hue, LightEditing& editing) {
    using enum LightEditing::ColorBy;
    if (ImGui::RadioButton("RGB", editing.colorBy == rgb)) editing.colorBy = rgb;
    ImGui::SameLine();
    if (ImGui::RadioButton("temperature", editing.colorBy == temperature)) editing.colorBy = temperature;
    if (editing.colorBy == rgb) {
        glm::vec3 edited = hue;
        if (!editColor("colour", edited)) return false;
        hue = splitColor(edited, hue).hue;
        return true;
    }
    colorPatch("shown", hue);
    ImGui::SameLine();
    float kelvin = nearestTemperature(hue);
    if (!slideNumber("kelvin", kelvin,
                     {.min = minTemperature,
                      .max = maxTemperature,
                      .format = "%.0f K",
                      .scale = NumberRange::Scale::logarithmic}))
        return false;
    hue = colorOfTemperature(kelvin);
    return true;
}

/// Of any size: an empty light can still be dragged up.
NumberRange strengthRange(float value, const char* format) {
    return {.max = brightest, .speed = dragShare * std::max(value, 0.1f), .format = format};
}

bool editStrength(const WorldLight& light, float& strength, LightEditing& editing) {
    using enum LightEditing::Unit;
    if (light.type == LightType::directional)
        return dragNumber("illuminance", strength, strengthRange(strength, "%.4g lx"));
    if (ImGui::RadioButton("candela", editing.unit == candela)) editing.unit = candela;
    ImGui::SameLine();
    if (ImGui::RadioButton("lumen", editing.unit == lumen)) editing.unit = lumen;
    if (editing.unit == candela) return dragNumber("intensity", strength, strengthRange(strength, "%.4g cd"));
    float flux = lumenOf(light, strength);
    if (!dragNumber("flux", flux, strengthRange(flux, "%.4g lm"))) return false;
    strength = std::min(candelaOf(light, flux), brightest);
    return true;
}

bool editIntensity(WorldLight& light, LightEditing& editing) {
    SplitColor split = splitColor(light.intensity, editing.hue);
    bool changed = editHue(split.hue, editing);
    changed = editStrength(light, split.strength, editing) || changed;
    editing.hue = split.hue;
    if (changed) light.intensity = split.joined();
    return changed;
}

}  // namespace

const char* nameOf(LightType type) {
    switch (type) {
        case LightType::point:
            return "point";
        case LightType::spot:
            return "spot";
        case LightType::directional:
            return "directional";
    }
    return "";
}

bool editLight(WorldLight& light, LightEditing& editing) {
    bool changed = editIntensity(light, editing);
    changed = editPosition(light, editing) || changed;
    changed = editRange(light, splitColor(light.intensity).strength) || changed;
    changed = editDirection(light, editing) || changed;
    changed = editCones(light) || changed;
    changed = editShadow(light) || changed;
    return editType(light) || changed;
}
