#include "scene_options.h"

#include "parse.h"
#include "scene_environment.h"
#include "shadow_stats.h"

#include <CLI/CLI.hpp>

#include <array>
#include <limits>
#include <numbers>
#include <tuple>

namespace {

namespace help {

constexpr const char* scene =
    "A file that a plugin reads (.gltf, .glb, .obj), or a procedural scene such as\n"
    "plaza:4096, the benchmark scene with that many lights";
constexpr const char* lights =
    "Take the lights of FILE, which a plugin reads, in place of the scene's, and its\n"
    "cameras beside those of the scene (one of the same name replaces it): what\n"
    "candela-view saves by File > Save lights. Nothing else of FILE is used";
constexpr const char* scatterLights =
    "Scatter N more point lights over the scene's surfaces, on the side that their\n"
    "normals point to, the same in each run.\n"
    "RANGE in metres (default: twice the mean spacing), CANDELA each (default:\n"
    "RANGE x RANGE / 10). SEED selects another distribution (default: 1)";
constexpr const char* strict =
    "Take each note of something missing from the picture, or repaired, as an error";
constexpr const char* pluginPath = "Search this folder for plugins first. May be given several times";
constexpr const char* time = "Time of the picture, or of frame 0, in seconds. Default: 0";

constexpr const char* animation =
    "The animation that plays, by name or by number from 0; all or none of them.\n"
    "Default: the first one";
constexpr const char* loop = "Repeat the animations after their last key. Default: they hold their last pose";

constexpr const char* variant =
    "The variant of the scene that is drawn, by name or by number from 0.\n"
    "Default: the scene as it is without one";

constexpr const char* size = "Width and height in pixels, 1 to 65536 each. Default: 1280x720";
constexpr const char* show =
    "Show a debug view instead of the lit picture: normals, level (of subdivision),\n"
    "base_color, metallic, roughness, depth, emission, light_count or\n"
    "shadowed_count; and overlays: wireframe, cage. Separated by commas, such as\n"
    "level,wireframe";

constexpr const char* camera =
    "A camera of the scene, by the name of its node, its own name or its number in\n"
    "the file, from 0. Default: the first one; where there is none, one that frames\n"
    "what is drawn and its whole motion";
constexpr const char* eye = "Look from here instead, in metres, +Y up. Needs --target";
constexpr const char* target = "Look at this point. Needs --eye";
constexpr const char* fov =
    "Vertical field of view in degrees, between 0 and 180. Default: the camera's,\n"
    "or 45";

constexpr const char* ortho = "An orthographic view in which the picture is HEIGHT metres high";

constexpr const char* defaultLights =
    "Add a key, a fill and a rim light that move with the camera: auto (where the\n"
    "scene has neither light nor environment), on or off. Default: auto";
constexpr const char* environment =
    "What surrounds and lights the scene instead of its own environment: a picture\n"
    "in linear light, studio (soft boxes), sky (a clear day with its sun) or none.\n"
    "DEGREES turn it about +Y, STOPS brighten it. Default: the scene's own, or\n"
    "studio where the scene has no light";
constexpr const char* background =
    "Whether the environment is seen behind the scene: on or off. Default: on, but\n"
    "for studio";
constexpr const char* environmentRays =
    "Rays a pixel and sample, 1 to 4096, that find how much of the environment is\n"
    "hidden, where shadows are on. Default: 1";
constexpr const char* brdf =
    "Reflection model: course (GGX with Schlick-Smith), or gltf (height-correlated,\n"
    "energy-compensated). Default: course";
constexpr const char* technique =
    "How lights are applied to pixels: auto, tiles (binned to the screen), volumes\n"
    "(rasterised), or fullscreen (every light at every pixel, the reference). All\n"
    "give the same picture. Default: auto";

constexpr const char* tiles =
    "What runs the technique tiles: auto (by device), cpu or compute (a shader).\n"
    "Default: auto";

constexpr const char* shadows =
    "Whether every light casts shadows, traced by occlusion rays: on or off.\n"
    "Default: ";

constexpr const char* specularAntialiasing =
    "Whether roughness is widened where normals vary from pixel to pixel, so that\n"
    "highlights of small bumps do not sparkle: on or off. Default: on";

constexpr const char* layers = "Layers of transparent surfaces that are drawn, 0 to 64. Default: 8";

constexpr const char* rangeLoss =
    "What lights without a range may lose together at any point, as a share of\n"
    "their light there, between 0 and 1. Default: 0.01";

constexpr const char* subdivisionLevel =
    "Refine every subdivision cage to this level, 1 to 8. Default: the cage's own\n"
    "level if it states one, else a level that follows from its screen size";
constexpr const char* subdivisionEdge = "Target length in pixels of the edges of refined cages. Default: 8";
constexpr const char* subdivisionMaxLevel =
    "The highest level that --subdivision-edge selects, 1 to 8. Default: 5";

constexpr const char* vertexEvaluator =
    "What moves the vertices of refined cages, skins and morph targets: auto (by\n"
    "device), cpu or compute (a shader).\n"
    "Default: auto";
constexpr const char* threads =
    "Threads of all parallel work on the CPU, 0 to 1024. Default: 0, as many as the\n"
    "process may use (its affinity and control groups)";

constexpr const char* ocio = "OpenColorIO config file. Default: that of $OCIO, else a built-in config";
constexpr const char* display = "Display of the config that a .png is encoded for. Default: the config's";
constexpr const char* view = "View of that display. Default: the display's";
constexpr const char* look = "Look to apply. Default: none";
constexpr const char* exposure =
    "Brighten by this many stops (each doubles the light), between -64 and 64; or\n"
    "auto: the median of what is lit becomes mid-grey, the same for all frames.\n"
    "Default: 0. Like display, view and look it applies to .png only";

}  // namespace help

constexpr double maxStops = 64.0;
constexpr double maxEdgePixels = 1.0e6;
constexpr double maxOrthographicHeight = 1.0e9;

std::uint32_t parseLevel(const std::string& option, const std::string& text) {
    return static_cast<std::uint32_t>(parseInteger(option, text, 1, candela::maxSubdivisionLevel));
}

std::uint32_t parseLayers(const std::string& text) {
    return static_cast<std::uint32_t>(parseInteger("--layers", text, 0, candela::maxLayers));
}

/// Applies one word of --show that names an overlay. Returns false for other words.
bool parseOverlay(const std::string& word, candela::Overlays& overlays) {
    if (word == "wireframe") overlays.wireframe = true;
    if (word == "cage") overlays.cage = true;
    return word == "wireframe" || word == "cage";
}

}  // namespace

candela::LightScatter parseScatter(const std::string& text) {
    const std::string option = "--scatter-lights";
    const std::vector<std::string> parts = splitAtCommas(text);
    if (parts.size() > 4) throw UsageError(option + " \"" + text + "\": expected N[,RANGE[,CANDELA[,SEED]]]");
    candela::LightScatter parsed;
    parsed.count = static_cast<std::uint32_t>(
        parseInteger(option, parts[0], 0, std::numeric_limits<std::int32_t>::max()));
    if (parts.size() > 1) parsed.range = static_cast<float>(parseNumberBetween(option, parts[1], 0.0, 1.0e9));
    if (parts.size() > 2)
        parsed.candela = static_cast<float>(parseNumberBetween(option, parts[2], 0.0, 1.0e9));
    if (parts.size() > 3)
        parsed.seed = static_cast<std::uint32_t>(
            parseInteger(option, parts[3], 0, std::numeric_limits<std::uint32_t>::max()));
    return parsed;
}

std::vector<candela::DebugView> selectableViews() {
    std::vector<candela::DebugView> views{candela::DebugView::none};
    const auto debugViews = candela::debugViews();
    views.insert(views.end(), debugViews.begin(), debugViews.end());
    return views;
}

const char* toString(DefaultLights option) {
    switch (option) {
        case DefaultLights::on:
            return "on";
        case DefaultLights::off:
            return "off";
        default:
            return "auto";
    }
}

DefaultLights parseDefaultLights(const std::string& text) {
    using enum DefaultLights;
    return parseWord("--default-lights", text, std::array{automatic, on, off},
                     [](DefaultLights option) { return toString(option); });
}

DebugViewOptions parseDebugView(const std::string& text) {
    DebugViewOptions parsed;
    bool hasView = false;
    for (const std::string& word : splitAtCommas(text)) {
        if (parseOverlay(word, parsed.overlays)) continue;
        const candela::DebugView view = parseWord(
            "--show", word, selectableViews(),
            [](candela::DebugView value) { return candela::toString(value); }, "wireframe, cage");
        if (hasView)
            throw UsageError("--show \"" + text + "\": expected at most one debug view, and overlays");
        parsed.view = view;
        hasView = true;
    }
    return parsed;
}

SceneOptionReader::SceneOptionReader(CLI::App& app, SceneOptions& options, std::uint32_t defaultSamples)
    : app_(app), options_(options) {
    declareScene(app);
    declarePicture(app);
    declareCamera(app);
    declareSampling(app, options.sampling, defaultSamples);
    declareLighting(app);
    declareSubdivision(app);
    declareColor(app);
    declareThreads(app);
}

void SceneOptionReader::declareScene(CLI::App& app) {
    app.add_option("SCENE", options_.scene, help::scene)->type_name("")->group("Scene");
    app.add_option("--lights", options_.lights, help::lights)->type_name("FILE")->group("Scene");
    app.add_option_function<std::string>(
           "--scatter-lights", [this](const std::string& text) { options_.scatter = parseScatter(text); },
           help::scatterLights)
        ->type_name("N[,RANGE[,CANDELA[,SEED]]]")
        ->group("Scene");
    app.add_flag_callback(
           "--strict", [this] { options_.strictness = candela::Strictness::strict; }, help::strict)
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
    app.add_option("--animation", options_.animation, help::animation)
        ->type_name("NAME|INDEX|all|none")
        ->group("Scene");
    app.add_option("--variant", options_.variant, help::variant)->type_name("NAME|INDEX")->group("Scene");
    app.add_flag_callback(
           "--loop", [this] { options_.repeatAnimations = true; }, help::loop)
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
           "--show", [this](const std::string& text) { options_.debug = parseDebugView(text); }, help::show)
        ->type_name("LIST")
        ->group("Picture");
    declareElementSizes(app, options_.pointSize, options_.lineWidth);
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
    app.add_option_function<std::string>(
           "--ortho",
           [this](const std::string& text) {
               options_.orthographicHeight =
                   static_cast<float>(parseNumberBetween("--ortho", text, 0.0, maxOrthographicHeight));
           },
           help::ortho)
        ->type_name("HEIGHT")
        ->group("Camera");
}

void SceneOptionReader::declareLighting(CLI::App& app) {
    app.add_option_function<std::string>(
           "--default-lights",
           [this](const std::string& text) { options_.defaultLights = parseDefaultLights(text); },
           help::defaultLights)
        ->type_name("auto|on|off")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--environment",
           [this](const std::string& text) { options_.environment = parseEnvironment(text); },
           help::environment)
        ->type_name("FILE|studio|sky|none[,DEGREES[,STOPS]]")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--environment-rays",
           [this](const std::string& text) { options_.environmentRays = parseEnvironmentRays(text); },
           help::environmentRays)
        ->type_name("N")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--background",
           [this](const std::string& text) { options_.background = parseOnOff("--background", text); },
           help::background)
        ->type_name("on|off")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--brdf", [this](const std::string& text) { options_.brdf = parseBrdf(text); }, help::brdf)
        ->type_name("course|gltf")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--technique", [this](const std::string& text) { options_.technique = parseTechnique(text); },
           help::technique)
        ->type_name("auto|tiles|volumes|fullscreen")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--tiles", [this](const std::string& text) { options_.tileBackend = parseTileBackend(text); },
           help::tiles)
        ->type_name("auto|cpu|compute")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--shadows", [this](const std::string& text) { options_.shadows = parseShadows(text); },
           std::string(help::shadows) + candela::toString(drawnShadows(options_.shadows)))
        ->type_name("on|off")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--specular-aa",
           [this](const std::string& text) {
               options_.specularAntialiasing = parseOnOff("--specular-aa", text);
           },
           help::specularAntialiasing)
        ->type_name("on|off")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--layers", [this](const std::string& text) { options_.layers = parseLayers(text); }, help::layers)
        ->type_name("N")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--range-loss",
           [this](const std::string& text) {
               options_.rangeLoss = static_cast<float>(parseNumberBetween("--range-loss", text, 0.0, 1.0));
           },
           help::rangeLoss)
        ->type_name("SHARE")
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
                   static_cast<float>(parseNumberBetween("--subdivision-edge", text, 0.0, maxEdgePixels));
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
    app.add_option_function<std::string>(
           "--subdivision-evaluator",
           [this](const std::string& text) { options_.vertexEvaluator = parseVertexEvaluator(text); },
           help::vertexEvaluator)
        ->type_name("auto|cpu|compute")
        ->group("Subdivision");
}

void SceneOptionReader::declareThreads(CLI::App& app) {
    app.add_option_function<std::string>(
           "--threads", [this](const std::string& text) { options_.threads = parseThreads(text); },
           help::threads)
        ->type_name("N")
        ->group("Running");
}

void SceneOptionReader::declareColor(CLI::App& app) {
    app.add_option("--ocio", options_.ocio, help::ocio)->type_name("CONFIG")->group("Colour");
    app.add_option("--display", options_.display.display, help::display)->type_name("NAME")->group("Colour");
    app.add_option("--view", options_.display.view, help::view)->type_name("NAME")->group("Colour");
    app.add_option("--look", options_.display.look, help::look)->type_name("NAME")->group("Colour");
    app.add_option_function<std::string>(
           "--exposure",
           [this](const std::string& text) {
               options_.autoExposure = text == "auto";
               options_.display.exposure =
                   options_.autoExposure ? 0.0 : parseNumberBetween("--exposure", text, -maxStops, maxStops);
           },
           help::exposure)
        ->type_name("STOPS|auto")
        ->group("Colour");
}

void SceneOptionReader::finish() {
    if (eye_.has_value() != target_.has_value())
        throw UsageError(eye_ ? "--eye needs --target too" : "--target needs --eye too");
    if (options_.orthographicHeight && options_.verticalFov)
        throw UsageError("--ortho and --fov exclude each other");
    finishSampling(app_, options_.sampling);
    if (!eye_) return;
    options_.eye = EyeOptions{parsePoint("--eye", *eye_), parsePoint("--target", *target_)};
    if (options_.eye->eye == options_.eye->target)
        throw UsageError("--target \"" + *target_ + "\": expected another point than --eye");
}
