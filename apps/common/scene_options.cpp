#include "scene_options.h"

#include "parse.h"
#include "scene_help.h"
#include "usage_error.h"

#include <CLI/CLI.hpp>

#include <array>
#include <limits>
#include <numbers>
#include <tuple>

namespace {

constexpr double maxStops = 64.0;
constexpr double longestEdge = 1.0e6;

std::uint32_t parseLevel(const std::string& option, const std::string& text) {
    return static_cast<std::uint32_t>(parseInteger(option, text, 1, candela::maxSubdivisionLevel));
}

/// Takes one word of --show. False when it is none of the overlays.
bool takeOverlay(const std::string& word, candela::Overlays& overlays) {
    if (word == "wireframe") overlays.wireframe = true;
    if (word == "cage") overlays.cage = true;
    return word == "wireframe" || word == "cage";
}

}  // namespace

ScatterOptions parseScatter(const std::string& text) {
    const std::string option = "--scatter-lights";
    const std::vector<std::string> parts = splitAtCommas(text);
    if (parts.size() > 4) throw UsageError(option + " \"" + text + "\": expected N[,RANGE[,CANDELA[,SEED]]]");
    ScatterOptions choice;
    choice.count = static_cast<std::uint32_t>(
        parseInteger(option, parts[0], 0, std::numeric_limits<std::int32_t>::max()));
    if (parts.size() > 1) choice.range = static_cast<float>(parseNumberBetween(option, parts[1], 0.0, 1.0e9));
    if (parts.size() > 2)
        choice.candela = static_cast<float>(parseNumberBetween(option, parts[2], 0.0, 1.0e9));
    if (parts.size() > 3)
        choice.seed = static_cast<std::uint32_t>(
            parseInteger(option, parts[3], 0, std::numeric_limits<std::uint32_t>::max()));
    return choice;
}

DebugViewOptions parseDebugView(const std::string& text) {
    using enum candela::DebugView;
    constexpr std::array all{none,      normals, level,    baseColor, metallic,
                             roughness, depth,   emission, lightCount};
    DebugViewOptions choice;
    bool chosen = false;
    for (const std::string& word : splitAtCommas(text)) {
        if (takeOverlay(word, choice.overlays)) continue;
        const candela::DebugView show = parseWord(
            "--show", word, all, [](candela::DebugView value) { return candela::toString(value); },
            "wireframe, cage");
        if (chosen) throw UsageError("--show \"" + text + "\": expected one picture, and lines over it");
        choice.show = show;
        chosen = true;
    }
    return choice;
}

SceneOptionReader::SceneOptionReader(CLI::App& app, SceneOptions& options) : options_(options) {
    declareScene(app);
    declarePicture(app);
    declareCamera(app);
    declareLighting(app);
    declareSubdivision(app);
    declareColor(app);
}

void SceneOptionReader::declareScene(CLI::App& app) {
    app.add_option("SCENE", options_.scene, help::scene)->type_name("")->group("Scene");
    app.add_option_function<std::string>(
           "--scatter-lights", [this](const std::string& text) { options_.scatter = parseScatter(text); },
           help::scatterLights)
        ->type_name("N[,RANGE[,CANDELA[,SEED]]]")
        ->group("Scene");
    app.add_option("--plugin-path", options_.pluginFolders, help::pluginPath)
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->group("Scene");
    app.add_option_function<std::string>(
           "--time", [this](const std::string& text) { options_.time = parseNumber("--time", text); },
           help::time)
        ->type_name("S")
        ->group("Scene");
}

void SceneOptionReader::declarePicture(CLI::App& app) {
    app.add_option_function<std::string>(
           "--size",
           [this](const std::string& text) { std::tie(options_.width, options_.height) = parseSize(text); },
           help::size)
        ->type_name("WxH")
        ->group("Picture");
    app.add_option_function<std::string>(
           "--show", [this](const std::string& text) { options_.show = parseDebugView(text); }, help::show)
        ->type_name("LIST")
        ->group("Picture");
}

void SceneOptionReader::declareCamera(CLI::App& app) {
    app.add_option("--camera", options_.camera, help::camera)->type_name("NAME|INDEX")->group("Camera");
    app.add_option("--eye", eye_, help::eye)->type_name("X,Y,Z")->group("Camera");
    app.add_option("--target", target_, help::target)->type_name("X,Y,Z")->group("Camera");
    app.add_option_function<std::string>(
           "--fov",
           [this](const std::string& text) {
               const double degrees = parseNumberBetween("--fov", text, 0.0, 180.0);
               options_.verticalFov = static_cast<float>(degrees * std::numbers::pi / 180.0);
           },
           help::fov)
        ->type_name("DEG")
        ->group("Camera");
}

void SceneOptionReader::declareLighting(CLI::App& app) {
    app.add_option_function<std::string>(
           "--brdf", [this](const std::string& text) { options_.brdf = parseBrdf(text); }, help::brdf)
        ->type_name("WORD")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--technique", [this](const std::string& text) { options_.technique = parseTechnique(text); },
           help::technique)
        ->type_name("WORD")
        ->group("Lighting");
}

void SceneOptionReader::declareSubdivision(CLI::App& app) {
    candela::SubdivisionSettings& settings = options_.subdivision;
    app.add_option_function<std::string>(
           "--subdivision-level",
           [&settings](const std::string& text) { settings.level = parseLevel("--subdivision-level", text); },
           help::subdivisionLevel)
        ->type_name("N")
        ->group("Subdivision");
    app.add_option_function<std::string>(
           "--subdivision-edge",
           [&settings](const std::string& text) {
               settings.edgePixels =
                   static_cast<float>(parseNumberBetween("--subdivision-edge", text, 0.0, longestEdge));
           },
           help::subdivisionEdge)
        ->type_name("PIXELS")
        ->group("Subdivision");
    app.add_option_function<std::string>(
           "--subdivision-max-level",
           [&settings](const std::string& text) {
               settings.maxLevel = parseLevel("--subdivision-max-level", text);
           },
           help::subdivisionMaxLevel)
        ->type_name("N")
        ->group("Subdivision");
}

void SceneOptionReader::declareColor(CLI::App& app) {
    app.add_option("--ocio", options_.ocio, help::ocio)->type_name("CONFIG")->group("Colour");
    app.add_option("--display", options_.display.display, help::display)->type_name("NAME")->group("Colour");
    app.add_option("--view", options_.display.view, help::view)->type_name("NAME")->group("Colour");
    app.add_option("--look", options_.display.look, help::look)->type_name("NAME")->group("Colour");
    app.add_option_function<std::string>(
           "--exposure",
           [this](const std::string& text) {
               options_.display.exposure = parseNumberBetween("--exposure", text, -maxStops, maxStops);
           },
           help::exposure)
        ->type_name("STOPS")
        ->group("Colour");
}

void SceneOptionReader::finish() {
    if (eye_.has_value() != target_.has_value())
        throw UsageError(eye_ ? "--eye needs --target too" : "--target needs --eye too");
    if (!eye_) return;
    options_.eye = EyeOptions{parsePoint("--eye", *eye_), parsePoint("--target", *target_)};
    if (options_.eye->eye == options_.eye->target)
        throw UsageError("--target \"" + *target_ + "\": expected another point than --eye");
}
