#include "panels/widgets.h"

#include "panels/color_values.h"

#include <algorithm>
#include <cmath>

namespace {

/// Scenes lie within it; see `candela::validate`.
constexpr float farthestCoordinate = 1.0e9f;
/// What is left for the label of three numbers, in heights of a letter: they need the rest.
constexpr float pointLabelLetters = 4.2f;
/// Of the pictures in lists: their width in heights of a letter.
constexpr float pictureLetters = 8.0f, pictureAspect = 16.0f / 9.0f;

ImGuiSliderFlags flagsOf(const NumberRange& range) {
    const bool logarithmic = range.scale == NumberRange::Scale::logarithmic;
    return ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

/// Stores an edited number, clamped to the range. Typed numbers can overflow: those are ignored.
bool take(float& value, float edited, const NumberRange& range) {
    if (!std::isfinite(edited)) return false;
    const float clamped = std::clamp(edited, range.min, range.max);
    const bool changed = clamped != value;
    value = clamped;
    return changed;
}

}  // namespace

bool dragNumber(const char* label, float& value, const NumberRange& range) {
    float edited = value;
    return ImGui::DragFloat(label, &edited, range.speed, range.min, range.max, range.format,
                            flagsOf(range)) &&
           take(value, edited, range);
}

bool slideNumber(const char* label, float& value, const NumberRange& range) {
    float edited = value;
    return ImGui::SliderFloat(label, &edited, range.min, range.max, range.format, flagsOf(range)) &&
           take(value, edited, range);
}

bool slideNumber(const char* label, double& value, double min, double max, const char* format) {
    double edited = value;
    if (!ImGui::SliderScalar(label, ImGuiDataType_Double, &edited, &min, &max, format,
                             ImGuiSliderFlags_AlwaysClamp) ||
        !std::isfinite(edited))
        return false;
    value = edited;
    return true;
}

bool slideLevel(const char* label, std::uint32_t& value, std::uint32_t min, std::uint32_t max) {
    return ImGui::SliderScalar(label, ImGuiDataType_U32, &value, &min, &max, "%u",
                               ImGuiSliderFlags_AlwaysClamp);
}

bool countInput(const char* label, std::uint32_t& value, std::uint32_t max) {
    const std::uint32_t one = 1, many = 100;
    std::uint32_t edited = value;
    if (!ImGui::InputScalar(label, ImGuiDataType_U32, &edited, &one, &many)) return false;
    edited = std::min(edited, max);
    const bool changed = edited != value;
    value = edited;
    return changed;
}

bool dragPoint(const char* label, glm::vec3& value, float speed) {
    glm::vec3 edited = value;
    ImGui::SetNextItemWidth(-pointLabelLetters * ImGui::GetFontSize());
    if (!ImGui::DragFloat3(label, &edited.x, speed, -farthestCoordinate, farthestCoordinate, "%.4g",
                           ImGuiSliderFlags_AlwaysClamp))
        return false;
    const NumberRange range{.min = -farthestCoordinate, .max = farthestCoordinate};
    bool changed = false;
    for (int axis = 0; axis < 3; ++axis) changed = take(value[axis], edited[axis], range) || changed;
    return changed;
}

bool editColor(const char* label, glm::vec3& linear) {
    glm::vec3 codes = srgbFromLinear(linear);
    if (!ImGui::ColorEdit3(label, &codes.x, ImGuiColorEditFlags_PickerHueWheel)) return false;
    const glm::vec3 edited = linearFromSrgb(codes);
    const NumberRange range;
    bool changed = false;
    for (int channel = 0; channel < 3; ++channel)
        changed = take(linear[channel], edited[channel], range) || changed;
    return changed;
}

void colorPatch(const char* id, const glm::vec3& linear) {
    codePatch(id, srgbFromLinear(linear));
}

void codePatch(const char* id, const glm::vec3& codes) {
    const float side = ImGui::GetTextLineHeight();
    ImGui::ColorButton(id, {codes.r, codes.g, codes.b, 1.0f},
                       ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, {side, side});
}

void showText(const std::string& text) {
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void showDimText(const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    showText(text);
    ImGui::PopStyleColor();
}

void showWrappedText(const std::string& text) {
    ImGui::PushTextWrapPos(0.0f);
    showText(text);
    ImGui::PopTextWrapPos();
}

void showRow(const char* name, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    showDimText(name);
    ImGui::TableNextColumn();
    showText(value);
}

bool listRow(std::uint64_t id, Row row, const std::string& text) {
    ImGui::PushID(reinterpret_cast<const void*>(static_cast<std::uintptr_t>(id)));
    const bool clicked = ImGui::Selectable("##row", row == Row::selected);
    ImGui::SameLine(0.0f, 0.0f);
    showText(text);
    ImGui::PopID();
    return clicked;
}

bool pictureRow(std::uint64_t id, Row row, unsigned texture, const std::string& text) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 picture(pictureLetters * ImGui::GetFontSize(),
                         pictureLetters * ImGui::GetFontSize() / pictureAspect);
    const ImVec2 corner = ImGui::GetCursorScreenPos(), letters = ImGui::CalcTextSize(text.c_str());
    ImGui::PushID(reinterpret_cast<const void*>(static_cast<std::uintptr_t>(id)));
    const float width =
        std::max(picture.x + style.ItemSpacing.x + letters.x, ImGui::GetContentRegionAvail().x);
    const bool clicked = ImGui::Selectable("##row", row == Row::selected, 0, {width, picture.y});
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(corner.x + picture.x, corner.y + picture.y);
    if (texture != 0) {
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture)), corner, end);
    } else {
        list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
    }
    list.AddText({end.x + style.ItemSpacing.x, corner.y + 0.5f * (picture.y - letters.y)},
                 ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    return clicked;
}
