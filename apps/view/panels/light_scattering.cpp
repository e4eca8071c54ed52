#include "panels/light_scattering.h"

#include "panels/light_values.h"
#include "panels/panel_work.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <limits>

namespace {

/// More can be asked for on the command line; this keeps a slip of the keys from filling the memory.
constexpr std::uint32_t maxStrewn = 10'000'000;

struct Form {
    ScatterOptions choice;
    float range = 2.0f, candela = 1.0f;  ///< Where the choice gives none.
    bool made = false;
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

void scatter(ViewModel& model, const ScatterOptions& choice) {
    tryTo(model, [&] {
        model.document->scatterLights(choice);
        model.pickedLight.reset();
        const auto& lights = model.document->lights();
        if (choice.count == 0) {
            model.options.scatter.reset();
        } else {
            model.options.scatter = spelledOut(choice, lights.back());
        }
    });
}

}  // namespace

void drawLightScattering(ViewModel& model) {
    auto& form = keptOfScene<Form>(model);
    if (!form.made) {
        form.choice =
            model.options.scatter.value_or(ScatterOptions{.count = 1000, .range = {}, .candela = {}});
        form.range = form.choice.range.value_or(form.range);
        form.candela = form.choice.candela.value_or(form.candela);
        form.made = true;
    }
    countInput("number", form.choice.count, maxStrewn);
    countInput("seed", form.choice.seed, std::numeric_limits<std::uint32_t>::max());
    editOptional("range", form.choice.range, form.range,
                 {.least = 1.0e-3f, .most = 1.0e8f, .speed = 0.01f * form.range, .format = "%.4g m"});
    editOptional("candela", form.choice.candela, form.candela,
                 {.least = 1.0e-6f, .most = 1.0e8f, .speed = 0.01f * form.candela, .format = "%.4g cd"});
    if (ImGui::Button("Scatter")) scatter(model, form.choice);
    if (!model.options.scatter) return;
    ImGui::SameLine();
    if (ImGui::Button("Take them away")) scatter(model, {.count = 0, .range = {}, .candela = {}});
}

void drawLightMotion(ViewModel& model) {
    LightMotion motion = model.document->lightMotion();
    const bool toggled = ImGui::Checkbox("circle their places", &motion.moving);
    bool changed = toggled;
    changed =
        dragNumber("radius", motion.radius, {.most = 1.0e6f, .speed = 0.01f, .format = "%.3f m"}) || changed;
    changed = dragNumber("speed", motion.speed,
                         {.least = -10.0f, .most = 10.0f, .speed = 0.005f, .format = "%.3f turns/s"}) ||
              changed;
    if (changed) tryTo(model, [&] { model.document->setLightMotion(motion); });
    // They move with the time.
    if (toggled && motion.moving) model.playing = true;
    showWrappedText(model.playing ? "The time goes on." : "The time stands still: play it to see them move.");
    if (ImGui::Button(model.playing ? "Pause" : "Play")) model.playing = !model.playing;
}
