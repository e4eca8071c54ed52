#include "panels/color_values.h"
#include "panels/light_editor.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

namespace {

/// Of the list while a light is edited under it.
constexpr float listLines = 5.0f;
/// Width of the field for a light's number, which has room for millions.
constexpr float numberLetters = 9.0f;
/// A new light gives its target as much as one of 1 cd at 1 m does when it stands this share of the camera's
/// distance away.
constexpr float newLightShare = 0.5f;
/// A drag over this many pixels crosses the distance to the camera's target.
constexpr float pixelsToTarget = 500.0f;

struct Kept {
    LightEditing editing;
    std::optional<std::uint32_t> edited, scrolledTo;
};

std::string rowText(std::size_t index, const candela::WorldLight& light) {
    const char* unit = light.type == candela::LightType::directional ? "lx" : "cd";
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%zu  %s  %.4g %s", index, nameOf(light.type),
                  static_cast<double>(splitColor(light.intensity).strength), unit);
    return text.data();
}

void drawList(ViewModel& model, Kept& kept) {
    const auto& lights = model.document->lights();
    const float rowHeight = ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("list", {0.0f, model.pickedLight ? listLines * rowHeight : 0.0f}, true);
    if (model.pickedLight != kept.scrolledTo && model.pickedLight)
        ImGui::SetScrollY(rowHeight * (static_cast<float>(*model.pickedLight) - 0.5f * listLines));
    kept.scrolledTo = model.pickedLight;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lights.size()), rowHeight);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            ImGui::PushID(i);
            colorPatch("color", splitColor(lights[index].intensity).hue);
            ImGui::SameLine();
            const Row row = model.pickedLight == index ? Row::selected : Row::plain;
            if (listRow(index, row, rowText(index, lights[index]))) {
                // The list is longer while no light is picked: it is then scrolled anew.
                if (model.pickedLight) kept.scrolledTo = index;
                model.pickedLight = index;
            }
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

bool same(const candela::WorldLight& a, const candela::WorldLight& b) {
    return a.type == b.type && a.position == b.position && a.intensity == b.intensity && a.range == b.range;
}

void addLight(ViewModel& model) {
    candela::WorldLight light;
    light.position = model.camera.target();
    const float metres = newLightShare * glm::distance(model.camera.eye(), model.camera.target());
    light.intensity = glm::vec3(std::clamp(metres * metres, 1.0e-6f, 1.0e20f));
    tryTo(model, [&] {
        model.document->addLight(light);
        const auto& lights = model.document->lights();
        const auto found = std::ranges::find_if(lights, [&](const auto& one) { return same(one, light); });
        if (found != lights.end()) model.pickedLight = static_cast<std::uint32_t>(found - lights.begin());
    });
}

void drawButtons(ViewModel& model) {
    if (ImGui::Button("Add")) addLight(model);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("a point light where the camera looks");
    if (!model.pickedLight) return;
    ImGui::SameLine();
    if (!ImGui::Button("Remove")) return;
    tryTo(model, [&] {
        model.document->removeLight(*model.pickedLight);
        model.pickedLight.reset();
    });
}

/// To find one light among very many.
void drawIndex(ViewModel& model) {
    const auto last = static_cast<std::uint32_t>(model.document->lights().size() - 1);
    std::uint32_t index = model.pickedLight.value_or(0);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(std::min(numberLetters * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x));
    if (countInput("##number", index, last)) model.pickedLight = index;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("pick a light by its number");
}

void drawEditor(ViewModel& model, Kept& kept) {
    if (!model.pickedLight) return;
    if (model.document->lightMotion().moving)
        return showWrappedText("The lights move. Stop them to edit one.");
    if (kept.edited != model.pickedLight) kept.editing.hue = glm::vec3(1.0f);
    kept.edited = model.pickedLight;
    kept.editing.target = model.camera.target();
    kept.editing.metresAPixel = glm::distance(model.camera.eye(), model.camera.target()) / pixelsToTarget;
    candela::WorldLight light = model.document->lights()[*model.pickedLight];
    ImGui::PushID(static_cast<int>(*model.pickedLight));
    const bool changed = editLight(light, kept.editing);
    ImGui::PopID();
    if (changed) tryTo(model, [&] { model.document->setLight(*model.pickedLight, light); });
}

void chooseDefaultLights(ViewModel& model) {
    using enum DefaultLights;
    chooseOne("default lights", model.options.defaultLights, std::array{automatic, on, off},
              [](DefaultLights option) { return toString(option); });
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "three lights that move with the camera; auto: where the scene has neither light nor "
            "environment");
}

void drawLights(ViewModel& model) {
    auto& kept = keptOfScene<Kept>(model);
    chooseDefaultLights(model);
    drawButtons(model);
    const std::size_t count = model.document->lights().size();
    if (model.pickedLight && *model.pickedLight >= count) model.pickedLight.reset();
    if (count == 0) return showDimText("The scene has no lights.");
    drawIndex(model);
    drawList(model, kept);
    drawEditor(model, kept);
}

const char* nameOf(EnvironmentOption::Source source) {
    switch (source) {
        case EnvironmentOption::Source::none:
            return "none";
        case EnvironmentOption::Source::studio:
            return "studio";
        case EnvironmentOption::Source::sky:
            return "sky";
        case EnvironmentOption::Source::file:
            return "file";
        default:
            return "of the scene";
    }
}

void drawEnvironment(ViewModel& model) {
    using enum EnvironmentOption::Source;
    EnvironmentOption& option = model.options.environment;
    std::vector<EnvironmentOption::Source> sources{own, none, studio, sky};
    if (!option.file.empty()) sources.push_back(file);
    chooseOne("environment", option.source, sources,
              [](EnvironmentOption::Source source) { return nameOf(source); });
    if (option.source == file) showWrappedText(option.file);
    showDimText("Drop an .hdr or .exr on the window.");
    if (!model.background) return;
    slideNumber("rotation", option.degrees, -180.0, 180.0, "%.0f degrees");
    slideNumber("brightness", option.stops, -10.0, 10.0, "%+.2f stops");
    bool shown = *model.background;
    if (ImGui::Checkbox("background", &shown)) model.options.background = shown;
}

/// The command line takes more; this guards against typing errors that would exhaust memory.
constexpr std::uint32_t maxScattered = 10'000'000;

struct ScatterForm {
    candela::LightScatter options;
    float range = 2.0f, candela = 1.0f;  ///< Shown where the options give none.
    bool initialised = false;
};

/// A value that the user gives or leaves open. `given` keeps what was typed last.
void editOptional(const char* name, std::optional<float>& value, float& given, const NumberRange& range) {
    ImGui::PushID(name);
    bool own = value.has_value();
    if (ImGui::Checkbox("##own", &own)) value = own ? std::optional(given) : std::nullopt;
    ImGui::SameLine();
    if (value) {
        if (dragNumber(name, given, range)) value = given;
    } else {
        showDimText(std::string(name) + ": by their spacing");
    }
    ImGui::PopID();
}

void scatter(ViewModel& model, const candela::LightScatter& options) {
    tryTo(model, [&] {
        model.document->scatterLights(options);
        model.pickedLight.reset();
        const auto& lights = model.document->lights();
        if (options.count == 0) {
            model.options.scatter.reset();
        } else {
            model.options.scatter = completed(options, lights.back());
        }
    });
}

void drawScattering(ViewModel& model) {
    auto& form = keptOfScene<ScatterForm>(model);
    if (!form.initialised) {
        form.options =
            model.options.scatter.value_or(candela::LightScatter{.count = 1000, .range = {}, .candela = {}});
        form.range = form.options.range.value_or(form.range);
        form.candela = form.options.candela.value_or(form.candela);
        form.initialised = true;
    }
    countInput("number", form.options.count, maxScattered);
    countInput("seed", form.options.seed, std::numeric_limits<std::uint32_t>::max());
    editOptional("range", form.options.range, form.range,
                 {.min = 1.0e-3f, .max = 1.0e8f, .speed = 0.01f * form.range, .format = "%.4g m"});
    editOptional("candela", form.options.candela, form.candela,
                 {.min = 1.0e-6f, .max = 1.0e8f, .speed = 0.01f * form.candela, .format = "%.4g cd"});
    if (ImGui::Button("Scatter")) scatter(model, form.options);
    if (!model.options.scatter) return;
    ImGui::SameLine();
    if (ImGui::Button("Take them away")) scatter(model, {.count = 0, .range = {}, .candela = {}});
}

void drawMotion(ViewModel& model) {
    LightMotion motion = model.document->lightMotion();
    const bool toggled = ImGui::Checkbox("circle their places", &motion.moving);
    bool changed = toggled;
    changed =
        dragNumber("radius", motion.radius, {.max = 1.0e6f, .speed = 0.01f, .format = "%.3f m"}) || changed;
    changed = dragNumber("speed", motion.speed,
                         {.min = -10.0f, .max = 10.0f, .speed = 0.005f, .format = "%.3f rev/s"}) ||
              changed;
    if (changed) tryTo(model, [&] { model.document->setLightMotion(motion); });
    // The motion follows the scene time.
    if (toggled && motion.moving) model.playing = true;
    showWrappedText(model.playing ? "Time is playing." : "Time is paused: play it to see them move.");
    if (ImGui::Button(model.playing ? "Pause" : "Play")) model.playing = !model.playing;
}

}  // namespace

void drawLightPanel(ViewModel& model) {
    const PanelWindow window(model, Panel::lights, "Lights");
    if (!window || !model.document || !ImGui::BeginTabBar("tabs")) return;
    if (ImGui::BeginTabItem("List")) {
        drawLights(model);
        ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Environment")) {
        drawEnvironment(model);
        ImGui::EndTabItem();
    }
    if (ImGui::BeginTabItem("Scatter")) {
        drawScattering(model);
        ImGui::Separator();
        showText("move all lights");
        drawMotion(model);
        ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
}
