#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

namespace {

/// Within what --exposure takes.
constexpr double maxStops = 10.0;
/// Where no look is selected.
constexpr const char* none = "none";

/// An empty name means the default, which is shown by its name.
bool chooseName(const char* label, std::string& selected, std::vector<std::string> names,
                const std::string& defaultName) {
    names.insert(names.begin(), "");
    return chooseOne(label, selected.empty() ? defaultName : selected, selected, names,
                     [&](const std::string& name) {
                         if (!name.empty()) return name;
                         return defaultName == none ? defaultName : defaultName + " (default)";
                     });
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// Of a button in a row, with the gap before it.
float buttonWidth(const char* text) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::CalcTextSize(text).x + 2.0f * style.FramePadding.x + style.ItemSpacing.x;
}

void chooseConfig(ViewModel& model) {
    static std::string path;
    showWrappedText("config: " + model.color.source());
    ImGui::SetNextItemWidth(-(buttonWidth("Open") + buttonWidth("Default")));
    const bool entered =
        ImGui::InputTextWithHint("##config", "an .ocio file", &path, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    if ((ImGui::Button("Open") || entered) && !path.empty()) model.requests.ocioConfig = path;
    ImGui::SameLine();
    if (ImGui::Button("Default")) model.requests.ocioConfig = "";
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("the file that $OCIO names, else the built-in config");
}

/// A view that the new display does not have falls back to its default.
void chooseDisplay(ViewModel& model) {
    candela::DisplayOptions& options = model.options.display;
    const std::vector<std::string> displays = model.color.displays();
    const std::string standard = model.color.defaultDisplay();
    const bool changed = chooseName("display", options.display, displays, standard);
    const std::string& display = options.display.empty() ? standard : options.display;
    if (!has(displays, display)) return showWrappedText("The config has no such display.");
    const std::vector<std::string> views = model.color.views(display);
    if (changed && !has(views, options.view)) options.view.clear();
    chooseName("view", options.view, views, model.color.defaultView(display));
}

void editExposure(ViewModel& model) {
    double& exposure = model.options.display.exposure;
    if (slideNumber("exposure", exposure, -maxStops, maxStops, "%+.2f stops"))
        model.options.autoExposure = false;
    if (ImGui::Button("No exposure")) {
        exposure = 0.0;
        model.options.autoExposure = false;
    }
    ImGui::SameLine();
    if (ImGui::Button("Auto")) model.requests.measureExposure = true;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("the median of what is lit in this picture becomes mid-grey");
}

}  // namespace

void drawColorPanel(ViewModel& model) {
    const PanelWindow window(model, Panel::color, "Colour", 5.0f);
    if (!window) return;
    chooseConfig(model);
    ImGui::Separator();
    chooseDisplay(model);
    chooseName("look", model.options.display.look, model.color.looks(), none);
    editExposure(model);
    ImGui::Separator();
    showWrappedText("light is computed in " + model.color.workingSpace());
    for (const std::string& note : model.color.notes()) showWrappedText(note);
}
