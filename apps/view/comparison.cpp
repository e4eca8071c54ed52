#include "comparison.h"

#include "common/scene_environment.h"
#include "common/shadow_stats.h"
#include "view_options.h"

#include <array>
#include <cstdio>
#include <utility>

namespace {

std::string numberText(double number) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.4g", number);
    return text.data();
}

std::string onOff(bool on) {
    return on ? "on" : "off";
}

std::string environmentText(const SceneOptions& options) {
    return options.environment.source == EnvironmentOption::Source::own ? "of the scene"
                                                                        : toString(options.environment);
}

std::string backgroundText(const SceneOptions& options) {
    return options.background ? onOff(*options.background) : "as the environment has it";
}

std::string lensText(const SamplingOptions& sampling) {
    if (!sampling.fNumber) return "off";
    return "f/" + numberText(*sampling.fNumber) + " at " + numberText(*sampling.focusDistance) + " m" +
           (sampling.blades == 0 ? "" : ", " + std::to_string(sampling.blades) + " blades");
}

std::string shownText(const DebugViewOptions& debug) {
    return std::string(candela::toString(debug.view)) + (debug.overlays.wireframe ? ", wireframe" : "") +
           (debug.overlays.cage ? ", cages" : "");
}

std::string exposureText(const SceneOptions& options) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%+.2f stops", options.display.exposure);
    return text.data();
}

std::string nameOrDefault(const std::string& name) {
    return name.empty() ? "default" : name;
}

/// A setting as a caption names it, and as it shows what it is set to.
struct Setting {
    const char* name;
    std::string (*text)(const SceneOptions& options);
};

constexpr std::array settings{
    Setting{"reflection", [](const SceneOptions& o) { return std::string(candela::toString(o.brdf)); }},
    Setting{"technique", [](const SceneOptions& o) { return std::string(candela::toString(o.technique)); }},
    Setting{"tiles", [](const SceneOptions& o) { return std::string(candela::toString(o.tileBackend)); }},
    Setting{"shadows",
            [](const SceneOptions& o) { return std::string(candela::toString(drawnShadows(o.shadows))); }},
    Setting{"specular antialiasing", [](const SceneOptions& o) { return onOff(o.specularAntialiasing); }},
    Setting{"layers", [](const SceneOptions& o) { return std::to_string(o.layers); }},
    Setting{"point size", [](const SceneOptions& o) { return numberText(o.pointSize) + " px"; }},
    Setting{"line width", [](const SceneOptions& o) { return numberText(o.lineWidth) + " px"; }},
    Setting{"default lights", [](const SceneOptions& o) { return std::string(toString(o.defaultLights)); }},
    Setting{"environment", environmentText},
    Setting{"environment rays", [](const SceneOptions& o) { return std::to_string(o.environmentRays); }},
    Setting{"background", backgroundText},
    Setting{
        "samples",
        [](const SceneOptions& o) { return std::to_string(o.sampling.count.value_or(defaultViewSamples)); }},
    Setting{"depth of field", [](const SceneOptions& o) { return lensText(o.sampling); }},
    Setting{"shutter", [](const SceneOptions& o) { return numberText(o.sampling.shutter); }},
    Setting{"show", [](const SceneOptions& o) { return shownText(o.debug); }},
    Setting{"exposure", exposureText},
    Setting{"display", [](const SceneOptions& o) { return nameOrDefault(o.display.display); }},
    Setting{"view", [](const SceneOptions& o) { return nameOrDefault(o.display.view); }},
    Setting{"look", [](const SceneOptions& o) { return nameOrDefault(o.display.look); }},
};

}  // namespace

void takeComparedOptions(const SceneOptions& from, SceneOptions& to) {
    to.sampling = from.sampling;
    to.defaultLights = from.defaultLights;
    to.environment = from.environment;
    to.environmentRays = from.environmentRays;
    to.background = from.background;
    to.brdf = from.brdf;
    to.technique = from.technique;
    to.tileBackend = from.tileBackend;
    to.shadows = from.shadows;
    to.specularAntialiasing = from.specularAntialiasing;
    to.layers = from.layers;
    to.pointSize = from.pointSize;
    to.lineWidth = from.lineWidth;
    to.debug = from.debug;
    to.display = from.display;
    to.autoExposure = from.autoExposure;
}

ComparedTexts differences(const SceneOptions& left, const SceneOptions& right) {
    ComparedTexts texts;
    for (const Setting& setting : settings) {
        const std::string a = setting.text(left), b = setting.text(right);
        if (a == b) continue;
        texts.left.push_back(std::string(setting.name) + ": " + a);
        texts.right.push_back(std::string(setting.name) + ": " + b);
    }
    return texts;
}

SceneOptions leftOptions(const ViewModel& model) {
    SceneOptions options = model.options;
    takeComparedOptions(model.comparison.left, options);
    return options;
}

void toggleComparison(ViewModel& model) {
    Comparison& comparison = model.comparison;
    comparison.shown = !comparison.shown;
    comparison.dragged = false;
    if (comparison.shown) comparison.left = model.options;
}

void swapComparison(ViewModel& model) {
    const SceneOptions right = model.options;
    takeComparedOptions(model.comparison.left, model.options);
    model.comparison.left = right;
}
