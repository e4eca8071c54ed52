#pragma once

#include <imgui.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

/// What a number may be, and how it is shown and dragged.
struct NumberRange {
    float min = 0.0f, max = 1.0f;
    float speed = 0.005f;  ///< Change for a pixel that the pointer is dragged.
    const char* format = "%.3f";
    enum class Scale { linear, logarithmic } scale = Scale::linear;
};

/// Each returns whether the user changed the value; a changed value is finite and within its range.
bool dragNumber(const char* label, float& value, const NumberRange& range);
bool slideNumber(const char* label, float& value, const NumberRange& range);
bool slideNumber(const char* label, double& value, double min, double max, const char* format);
bool slideLevel(const char* label, std::uint32_t& value, std::uint32_t min, std::uint32_t max);
/// A whole number with buttons for one less and one more.
bool countInput(const char* label, std::uint32_t& value, std::uint32_t max);
/// Metres, within those in which scenes lie.
bool dragPoint(const char* label, glm::vec3& value, float speed);
/// Linear Rec.709 of 0 to 1; shown, picked and typed as sRGB.
bool editColor(const char* label, glm::vec3& linear);

/// A patch of a colour of linear Rec.709; what is beyond 0 to 1 shows as its end.
void colorPatch(const char* id, const glm::vec3& linear);
/// A patch of display code values, 0 to 1.
void codePatch(const char* id, const glm::vec3& codes);

/// Text of a file or a user: nothing in it is a format or an identifier.
void showText(const std::string& text);
void showDimText(const std::string& text);
/// Broken into lines at the window's edge.
void showWrappedText(const std::string& text);

/// In a table of two columns: a name and a value.
void showRow(const char* name, const std::string& value);

/// A row of a list, with any text. Returns whether it was clicked.
enum class Row { plain, selected };
bool listRow(std::uint64_t id, Row row, const std::string& text);

/// The same with a small picture of 16:9 before the text: a GL texture, 0 for none yet.
bool pictureRow(std::uint64_t id, Row row, unsigned texture, const std::string& text);

/// A list to choose one of `values` from, by the names that `name` gives; `preview` shows while it is closed.
/// Returns whether the selection changed.
template <typename Value, typename Values, typename Name>
bool chooseOne(const char* label, const std::string& preview, Value& selected, const Values& values,
               Name&& name) {
    if (!ImGui::BeginCombo(label, preview.c_str())) return false;
    bool changed = false;
    std::uint64_t id = 0;
    for (const Value& value : values) {
        const bool same = value == selected;
        if (listRow(id++, same ? Row::selected : Row::plain, std::string(name(value))) && !same) {
            selected = value;
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

/// The same, with the name of what is selected as preview.
template <typename Value, typename Values, typename Name>
bool chooseOne(const char* label, Value& selected, const Values& values, Name&& name) {
    return chooseOne(label, std::string(name(selected)), selected, values, name);
}
