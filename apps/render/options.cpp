#include "options.h"

#include "common/parse.h"
#include "common/usage_error.h"
#include "help.h"

#include <candela/version.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>
#include <limits>
#include <numbers>
#include <tuple>

namespace {

constexpr int lastFrameNumber = 9'999'999;
constexpr double mostStops = 64.0;

ListKind parseListKind(const std::string& text) {
    using enum ListKind;
    return parseWord("--list", text, std::array{plugins, devices, displays, views}, [](ListKind kind) {
        constexpr std::array names{"plugins", "devices", "displays", "views"};
        return names[static_cast<std::size_t>(kind)];
    });
}

PictureFormat parseFormat(const std::filesystem::path& output) {
    std::string ending = output.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    if (ending == ".png") return PictureFormat::png;
    if (ending == ".exr") return PictureFormat::exr;
    throw UsageError("-o \"" + output.string() + "\": expected a file name that ends in .png or .exr");
}

ScatterChoice parseScatter(const std::string& text) {
    const std::string option = "--scatter-lights";
    const std::vector<std::string> parts = splitAtCommas(text);
    if (parts.size() > 3) throw UsageError(option + " \"" + text + "\": expected N[,RANGE[,CANDELA]]");
    ScatterChoice choice;
    choice.count = static_cast<std::uint32_t>(
        parseInteger(option, parts[0], 0, std::numeric_limits<std::int32_t>::max()));
    if (parts.size() > 1) choice.range = static_cast<float>(parseNumberBetween(option, parts[1], 0.0, 1.0e9));
    if (parts.size() > 2)
        choice.candela = static_cast<float>(parseNumberBetween(option, parts[2], 0.0, 1.0e9));
    return choice;
}

FrameRange parseFrames(const std::string& text) {
    const std::size_t dash = text.find('-');
    if (dash == text.npos) throw UsageError("--frames \"" + text + "\": expected FIRST-LAST, such as 0-47");
    FrameRange range;
    range.first = static_cast<int>(parseInteger("--frames", text.substr(0, dash), 0, lastFrameNumber));
    range.last =
        static_cast<int>(parseInteger("--frames", text.substr(dash + 1), range.first, lastFrameNumber));
    return range;
}

std::vector<std::string> parseAovs(const std::string& text) {
    const std::vector<std::string> known = candela::Renderer::aovNames();
    if (text == "all") return known;
    std::vector<std::string> names = splitAtCommas(text);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(known, names[i]) == known.end()) {
            std::string list = "all";
            for (const std::string& name : known) list += ", " + name;
            throw UsageError("--aov \"" + names[i] + "\": expected some of " + list);
        }
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
            names.begin() + static_cast<std::ptrdiff_t>(i))
            throw UsageError("--aov \"" + text + "\": " + names[i] + " stands there twice");
    }
    return names;
}

/// The texts of options whose meaning hangs on another option.
struct Pending {
    std::optional<std::string> eye, target, aovs;
};

void declareScene(CLI::App& app, Options& options) {
    app.add_option("SCENE", options.scene, help::scene)->type_name("")->group("Scene");
    app.add_option_function<std::string>(
           "--scatter-lights", [&](const std::string& text) { options.scatter = parseScatter(text); },
           help::scatterLights)
        ->type_name("N[,RANGE[,CANDELA]]")
        ->group("Scene");
    app.add_option("--plugin-path", options.pluginFolders, help::pluginPath)
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->group("Scene");
}

void declarePicture(CLI::App& app, Options& options, Pending& pending) {
    app.add_option("-o,--output", options.output, help::output)->type_name("FILE")->group("Picture");
    app.add_option_function<std::string>(
           "--size",
           [&](const std::string& text) { std::tie(options.width, options.height) = parseSize(text); },
           help::size)
        ->type_name("WxH")
        ->group("Picture");
    app.add_option("--aov", pending.aovs, help::aov)->type_name("all|LIST")->group("Picture");
    app.add_option_function<std::string>(
           "--frames", [&](const std::string& text) { options.frames = parseFrames(text); }, help::frames)
        ->type_name("A-B")
        ->group("Picture");
    app.add_option_function<std::string>(
           "--time", [&](const std::string& text) { options.time = parseNumber("--time", text); }, help::time)
        ->type_name("S")
        ->group("Picture");
}

void declareCamera(CLI::App& app, Options& options, Pending& pending) {
    app.add_option("--camera", options.camera, help::camera)->type_name("NAME|INDEX")->group("Camera");
    app.add_option("--eye", pending.eye, help::eye)->type_name("X,Y,Z")->group("Camera");
    app.add_option("--target", pending.target, help::target)->type_name("X,Y,Z")->group("Camera");
    app.add_option_function<std::string>(
           "--fov",
           [&](const std::string& text) {
               const double degrees = parseNumberBetween("--fov", text, 0.0, 180.0);
               options.verticalFov = static_cast<float>(degrees * std::numbers::pi / 180.0);
           },
           help::fov)
        ->type_name("DEG")
        ->group("Camera");
}

void declareLighting(CLI::App& app, Options& options) {
    app.add_option_function<std::string>(
           "--brdf", [&](const std::string& text) { options.brdf = parseBrdf(text); }, help::brdf)
        ->type_name("WORD")
        ->group("Lighting");
    app.add_option_function<std::string>(
           "--technique", [&](const std::string& text) { options.technique = parseTechnique(text); },
           help::technique)
        ->type_name("WORD")
        ->group("Lighting");
}

void declareColor(CLI::App& app, Options& options) {
    app.add_option("--ocio", options.ocio, help::ocio)->type_name("CONFIG")->group("Colour");
    app.add_option("--display", options.display.display, help::display)->type_name("NAME")->group("Colour");
    app.add_option("--view", options.display.view, help::view)->type_name("NAME")->group("Colour");
    app.add_option("--look", options.display.look, help::look)->type_name("NAME")->group("Colour");
    app.add_option_function<std::string>(
           "--exposure",
           [&](const std::string& text) {
               options.display.exposure = parseNumberBetween("--exposure", text, -mostStops, mostStops);
           },
           help::exposure)
        ->type_name("STOPS")
        ->group("Colour");
}

void declareRunning(CLI::App& app, Options& options) {
    app.add_option_function<std::string>(
           "--device", [&](const std::string& text) { options.device = parseDevice(text); }, help::device)
        ->type_name("N|software")
        ->group("Running");
    app.add_option("--stats", options.stats, help::stats)->type_name("FILE|-")->group("Running");
    app.add_flag("--quiet", options.quiet, help::quiet)->group("Running");
    app.add_option_function<std::string>(
           "--list", [&](const std::string& text) { options.list = parseListKind(text); }, help::list)
        ->type_name("KIND")
        ->group("Asking");
}

void resolveEye(const Pending& pending, Options& options) {
    if (pending.eye.has_value() != pending.target.has_value())
        throw UsageError(pending.eye ? "--eye needs --target too" : "--target needs --eye too");
    if (!pending.eye) return;
    options.eye = EyeChoice{parsePoint("--eye", *pending.eye), parsePoint("--target", *pending.target)};
    if (options.eye->eye == options.eye->target)
        throw UsageError("--target \"" + *pending.target + "\": expected another point than --eye");
}

void resolve(const Pending& pending, Options& options) {
    if (options.list) return;
    if (options.scene.empty())
        throw UsageError("SCENE is missing: name a file such as room.glb, or plaza:4096");
    resolveEye(pending, options);
    options.format = parseFormat(options.output);
    if (pending.aovs) options.aovs = parseAovs(*pending.aovs);
    if (pending.aovs && options.format != PictureFormat::exr)
        throw UsageError("--aov needs an .exr picture: name one with -o");
}

}  // namespace

std::optional<Options> parseOptions(int argc, const char* const* argv) {
    Options options;
    Pending pending;
    CLI::App app(help::description, "candela-render");
    app.get_formatter()->column_width(32);
    app.get_formatter()->label("OPTIONS", "OPTION...");
    app.set_help_flag("-h,--help", help::help)->group("Asking");
    app.set_version_flag("--version", "candela " CANDELA_VERSION, help::version)->group("Asking");
    app.footer(help::footer);
    declareScene(app, options);
    declarePicture(app, options, pending);
    declareCamera(app, options, pending);
    declareLighting(app, options);
    declareColor(app, options);
    declareRunning(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        app.exit(asked, std::cout, std::cerr);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    resolve(pending, options);
    return options;
}
