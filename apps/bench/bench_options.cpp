#include "bench_options.h"

#include "bench_scene.h"
#include "common/command_line.h"
#include "common/parse.h"
#include "common/scene_environment.h"
#include "common/shadow_stats.h"
#include "crowd_bench.h"

#include <candela/sampling.h>

#include <algorithm>
#include <array>

namespace {

constexpr const char* description =
    "Measures how fast candela lights a scene, and checks that its techniques draw the same picture.\n";

constexpr const char* footer =
    "Examples:\n"
    "  candela-bench --json r.json                                  the plaza with 4096 lights\n"
    "  candela-bench plaza:100 --json -                             with 100, onto standard output\n"
    "  candela-bench --lights 64,1024,16384 --technique all --json r.json --plot r.svg\n"
    "                                                               every technique, as a plot too\n"
    "  candela-bench --baseline --lights 4096 --json r.json         with textbook baselines\n"
    "  candela-bench --shadows on,off --json r.json                 what shadows cost\n"
    "\n"
    "The table's columns are explained in docs/benchmarks.md.\n"
    "\n"
    "Exit codes:\n"
    "  0  done\n"
    "  1  the scene, another file or this machine is at fault, or pictures of candela differ; one line says "
    "which, what and why\n"
    "  2  wrong usage";

std::vector<std::uint64_t> parseLights(const std::string& text) {
    std::vector<std::uint64_t> counts;
    for (const std::string& part : splitAtCommas(text)) {
        counts.push_back(static_cast<std::uint64_t>(parseInteger("--lights", part, 0, 16'000'000)));
    }
    return counts;
}

void parseTechniques(const std::string& text, BenchOptions& options) {
    options.compares = text == "all";
    if (options.compares) {
        using enum candela::Technique;
        options.techniques = {tiles, volumes, fullscreen};
        return;
    }
    options.techniques.clear();
    for (const std::string& part : splitAtCommas(text)) {
        const candela::Technique technique = parseTechnique(part);
        if (std::ranges::find(options.techniques, technique) != options.techniques.end())
            throw UsageError("--technique \"" + text + "\": " + part + " is given twice");
        options.techniques.push_back(technique);
    }
}

/// The baselines draw no shadows.
constexpr candela::Shadows defaultShadows = candela::Shadows::off;

std::vector<candela::Shadows> parseShadowList(const std::string& text) {
    std::vector<candela::Shadows> list;
    for (const std::string& part : splitAtCommas(text)) {
        const candela::Shadows shadows = parseShadows(part);
        if (std::ranges::find(list, shadows) != list.end())
            throw UsageError("--shadows \"" + text + "\": " + part + " is given twice");
        list.push_back(shadows);
    }
    return list;
}

std::vector<std::uint32_t> parseSamples(const std::string& text) {
    std::vector<std::uint32_t> counts;
    for (const std::string& part : splitAtCommas(text)) {
        const auto count =
            static_cast<std::uint32_t>(parseInteger("--samples", part, 1, candela::maxSamples));
        if (std::ranges::find(counts, count) != counts.end())
            throw UsageError("--samples \"" + text + "\": " + part + " is given twice");
        counts.push_back(count);
    }
    return counts;
}

std::vector<candela::TileBackend> parseTileBackends(const std::string& text) {
    std::vector<candela::TileBackend> backends;
    for (const std::string& part : splitAtCommas(text)) {
        const candela::TileBackend backend = parseTileBackend(part);
        if (std::ranges::find(backends, backend) != backends.end())
            throw UsageError("--tiles \"" + text + "\": " + part + " is given twice");
        backends.push_back(backend);
    }
    return backends;
}

bool hasEnvironment(const BenchOptions& options) {
    return options.environment.source != EnvironmentOption::Source::own;
}

/// plaza:100 is the scene plaza with --lights 100; likewise the other scenes that are made for the benchmark.
void takeLightsOfName(BenchOptions& options) {
    const std::size_t colon = options.scene.find(':');
    if (colon == options.scene.npos) return;
    const std::string name = options.scene.substr(0, colon), count = options.scene.substr(colon + 1);
    constexpr std::array scenes{"plaza", "cloud", "rooms", "outside", "hidden"};
    if (std::ranges::find(scenes, name) == scenes.end()) return;
    if (!options.lights.empty())
        throw UsageError("--scene " + options.scene + " and --lights exclude each other");
    options.scene = name;
    options.lights = parseLights(count);
}

void checkTogether(const BenchOptions& options) {
    if (options.json.empty()) throw UsageError("--json is missing: name the file to write the results to");
    if (options.scene.empty()) throw UsageError("--scene \"\": expected a name or a file");
    const bool measuresLights = !options.lights.empty() || options.compares || options.plot || options.view ||
                                options.baseline == Baseline::with || options.measuresCeiling ||
                                !options.shadows.empty() ||
                                options.samples != std::vector<std::uint32_t>{1} || hasEnvironment(options);
    if ((options.scene == cageScene || isCrowd(options.scene)) && measuresLights)
        throw UsageError("--scene " + options.scene +
                         " measures no lights: leave --lights, --technique all, --shadows, --samples, "
                         "--environment, --plot, "
                         "--view, --ceiling and --baseline out");
    if (isTriangles(options.scene) && options.scene.find(',') != options.scene.npos)
        throw UsageError("--scene " + options.scene + ": give the number of lights by --lights");
    if (options.baseline == Baseline::with && hasEnvironment(options))
        throw UsageError("--baseline draws no environment: leave --environment out");
    if (options.baseline == Baseline::with && options.brdf != candela::BrdfModel::course)
        throw UsageError("--baseline draws with the model course only: leave --brdf out");
}

void declare(CLI::App& app, BenchOptions& options, std::string& json, std::optional<DeviceOption>& device) {
    app.add_option("--scene", options.scene,
                   "plaza, cloud, rooms, outside (the plaza's lights, all behind the camera),\n"
                   "hidden (the plaza and as many lights again that reach no visible surface),\n"
                   "cages (moving and refining a subdivision cage, against OpenSubdiv),\n"
                   "triangles:N (N triangles, 1 to 50000000, from many pixels to less than one),\n"
                   "crowd:N (moving N skinned characters, against copies of their vertices), or a\n"
                   "file. Default: plaza")
        ->type_name("NAME|FILE");
    app.add_option("SCENE", options.scene, "The same as --scene; plaza:100 is plaza with 100 lights")
        ->type_name("");
    app.add_option("--variant", options.variant,
                   "The variant of a file that is drawn, by name or by number from 0. Default: none")
        ->type_name("NAME|INDEX");
    app.add_option_function<std::string>(
           "--lights", [&](const std::string& text) { options.lights = parseLights(text); },
           "Numbers of lights, separated by commas; a file gets them scattered over its\n"
           "surfaces. Default: 4096, a file's own")
        ->type_name("N,N,...");
    app.add_option_function<std::string>(
           "--technique", [&](const std::string& text) { parseTechniques(text, options); },
           "Some of auto, volumes, tiles, fullscreen, separated by commas; or all,\n"
           "which also compares their pictures. Default: auto")
        ->type_name("LIST|all");
    app.add_option_function<std::string>(
           "--tiles", [&](const std::string& text) { options.tileBackends = parseTileBackends(text); },
           "What runs the technique tiles: auto (by device), cpu or compute; of several,\n"
           "separated by commas, the last draws what pictures are compared with. Default:\nauto")
        ->type_name("LIST");
    app.add_option_function<std::string>(
           "--shadows", [&](const std::string& text) { options.shadows = parseShadowList(text); },
           std::string("on, off, or both, drawn alternately, so that their ratio is that of one run.\n"
                       "Default: ") +
               candela::toString(defaultShadows))
        ->type_name("LIST");
    app.add_option_function<std::string>(
           "--samples", [&](const std::string& text) { options.samples = parseSamples(text); },
           "Samples a pixel, 1 to 65536; several, separated by commas, are drawn alternately.\n"
           "Default: 1")
        ->type_name("LIST");
    app.add_option_function<std::string>(
           "--environment", [&](const std::string& text) { options.environment = parseEnvironment(text); },
           "What surrounds the scene, as in candela-render. Default: the scene's own")
        ->type_name("FILE|studio|sky|none[,DEGREES[,STOPS]]");
    app.add_option_function<std::string>(
           "--environment-rays",
           [&](const std::string& text) { options.environmentRays = parseEnvironmentRays(text); },
           "Rays a pixel and sample that find how much of the environment is hidden, with\nshadows. Default: "
           "1")
        ->type_name("N");
    app.add_option_function<std::string>(
           "--brdf", [&](const std::string& text) { options.brdf = parseBrdf(text); },
           "Reflection model: course or gltf. Default: course")
        ->type_name("course|gltf");
    app.add_flag_callback(
        "--baseline", [&] { options.baseline = Baseline::with; },
        "Also measure textbook deferred renderers (textbook_volumes,\n"
        "textbook_fullscreen), bare, which draws the geometry alone, and with --shadows\n"
        "on a cube shadow map a light, for at most a minute. One that cannot draw the\n"
        "scene is reported as failed");
    app.add_flag("--ceiling", options.measuresCeiling,
                 "Also measure how many pairs of pixel and light the device's compute shaders shade\n"
                 "at most, with everything in registers, and what share of it each technique reaches");
    app.add_flag_callback(
        "--markdown", [&] { options.table = TableFormat::markdown; }, "Print the table in Markdown");
    app.add_option_function<std::string>(
           "--size",
           [&](const std::string& text) { std::tie(options.width, options.height) = parseSize(text); },
           "Width and height in pixels. Default: 1280x720")
        ->type_name("WxH");
    app.add_option_function<std::string>(
           "--frames",
           [&](const std::string& text) {
               options.frames = static_cast<int>(parseInteger("--frames", text, 1, 10'000));
           },
           "Frames that each median is taken over; fewer where a frame takes seconds.\nDefault: 20")
        ->type_name("N");
    app.add_option("--view", options.view, "View of the built-in colour config. Default: the config's")
        ->type_name("NAME");
    app.add_option("--json", json,
                   "File to write the results to, as a table where its name ends in .csv; - is\n"
                   "standard output. Required")
        ->type_name("FILE|-");
    app.add_option("--plot", options.plot, "Also draw lighting time against the number of lights")
        ->type_name("FILE.svg");
    app.add_option("--plugin-path", options.pluginFolders, "Search this folder for plugins first")
        ->type_name("DIR")
        ->allow_extra_args(false);
    app.add_option_function<std::string>(
           "--device", [&](const std::string& text) { device = parseDevice("--device", text); },
           "A device of candela-render --list devices, the software rasteriser, or auto:\n"
           "processes take turns with the GPUs. Default: $CANDELA_DEVICE, else a GPU if\n"
           "there is one")
        ->type_name("N|software|auto");
    app.add_option_function<std::string>(
           "--subdivision-evaluator",
           [&](const std::string& text) { options.vertexEvaluator = parseVertexEvaluator(text); },
           "What moves the vertices of --scene cages and crowd:N: auto (by device), cpu or\ncompute. "
           "Default: auto")
        ->type_name("auto|cpu|compute");
    app.add_option_function<std::string>(
           "--threads", [&](const std::string& text) { options.threads = parseThreads(text); },
           "Threads of all parallel work on the CPU, 0 to 1024. Default: 0, as many as\nthe process may use")
        ->type_name("N");
    app.add_flag("--quiet", options.quiet, "Print no table");
}

}  // namespace

std::optional<BenchOptions> parseBenchOptions(int argc, const char* const* argv) {
    BenchOptions options;
    std::string json;
    CLI::App app(description, "candela-bench");
    prepareCommandLine(app);
    app.footer(footer);
    std::optional<DeviceOption> device;
    declare(app, options, json, device);
    if (!parseCommandLine(app, argc, argv)) return std::nullopt;
    options.json = json;
    options.device = chooseDevice(device);
    if (app.count("SCENE") > 0 && app.count("--scene") > 0)
        throw UsageError("--scene and \"" + options.scene + "\" exclude each other: name one scene");
    takeLightsOfName(options);
    checkTogether(options);
    if (options.shadows.empty()) options.shadows = {defaultShadows};
    return options;
}
