#include "commands.h"

#include "common/count_text.h"
#include "common/light_file.h"
#include "common/output_file.h"
#include "common/program.h"
#include "common/scene_environment.h"
#include "common/scene_lights.h"
#include "common/scene_selection.h"
#include "frame_writer.h"
#include "picture_plan.h"
#include "posing.h"
#include "run_notes.h"
#include "run_report.h"
#include "sequence.h"
#include "stats.h"

#include <candela/context.h>
#include <candela/error.h>
#include <candela/import.h>
#include <candela/plugin_registry.h>
#include <candela/threads.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace {

/// Finds a folder that is missing before the scene is read, where names do not need the scene.
void checkOutputs(const Options& options) {
    if (options.stats && *options.stats != "-") checkWritable(*options.stats);
    if (options.output == "-" || options.mkdir || options.keepGoing) return;
    if (options.camera || cameraPath(options.output, "", false) != options.output) return;
    const int frame = options.frames ? options.frames->front() : 0;
    checkWritable(options.isSequence() ? framePath(options.output, frame) : options.output);
}

/// The way to the display for a PNG; the names are checked for an EXR too, which takes nothing of it.
std::optional<candela::DisplayTransform> chooseDisplay(RunReport& report, const Options& options,
                                                       const candela::ColorConfig& color) {
    const candela::DisplayOptions& display = options.display;
    candela::DisplayTransform transform = color.displayTransform(display);
    if (options.format != PictureFormat::exr) return transform;
    if (!display.display.empty() || !display.view.empty() || !display.look.empty() ||
        display.exposure != 0.0 || options.autoExposure)
        report.note(
            "an .exr holds scene-linear light: --display, --view, --look and --exposure do not change it");
    return std::nullopt;
}

/// `stats` gets what the scene holds.
candela::Scene readScene(RunReport& report, const Options& options, const candela::PluginRegistry& plugins,
                         Stats& stats) {
    candela::ImportOptions importing;
    importing.strictness = options.strictness;
    importing.progress = [&](double share) {
        report.work("reading " + options.scene + ": " +
                    std::to_string(static_cast<int>(std::lround(share * 100.0))) + " %");
        return true;
    };
    candela::ImportedScene imported = candela::importScene(plugins, options.scene, importing);
    for (const candela::ImportNote& note : imported.report.notes) report.note(note.line());
    for (candela::ImportNote& note : takeLightFile(imported.scene, plugins, options)) {
        report.note(note.line());
        imported.report.notes.push_back(std::move(note));
    }
    if (const auto note = selectAnimations(imported.scene, options)) report.note(*note);
    selectVariant(imported.scene, options.variant, options.scene);
    stats.contents = contentCounts(imported.scene);
    stats.materialKinds = materialKinds(imported.scene);
    stats.notes = std::move(imported.report.notes);
    if (options.scatter) addScatteredLights(imported.scene, *options.scatter, options.scene);
    return std::move(imported.scene);
}

/// Gives the scene the environment of the options, and its sun. Returns its name.
std::string useEnvironment(RunReport& report, const Options& options, candela::Scene& scene) {
    EnvironmentLight light = placedEnvironment(loadEnvironment(scene, options), options);
    for (const std::string& note : light.notes) report.note(note);
    scene.environment = std::move(light.environment);
    if (light.sun) scene.lights.push_back(*light.sun);
    return light.name;
}

candela::GpuSceneOptions uploadOptions(const Options& options, const candela::ColorConfig& color,
                                       const candela::PluginRegistry& plugins) {
    candela::GpuSceneOptions upload;
    upload.workingFromRec709 = color.workingFromRec709();
    upload.rangeLoss = options.rangeLoss;
    upload.subdivider = plugins.subdivider();
    upload.subdivision = options.subdivision;
    upload.vertexEvaluator = options.vertexEvaluator;
    return upload;
}

void addDevice(Stats& stats, const candela::Context& context) {
    stats.renderer = context.renderer();
    stats.driver = context.driver();
    if (!context.attempts().empty()) stats.device = context.attempts().back().way;
}

void addOptions(Stats& stats, const Options& options) {
    stats.file = options.scene;
    stats.width = options.width;
    stats.height = options.height;
    stats.brdf = options.brdf;
    stats.threads = candela::threadCount();
    stats.samples = options.samplingSettings().count;
}

void addScene(Stats& stats, const candela::GpuScene& scene) {
    stats.vertexEvaluator = scene.cageReport().evaluator;
    stats.triangles = scene.triangleCount() + scene.cageReport().triangles;
    stats.lines = scene.elementCount(candela::Topology::lines);
    stats.points = scene.elementCount(candela::Topology::points);
    stats.materials = scene.materialCount();
    stats.lights = scene.lightReport().lights;
}

/// What the last frame was drawn with.
void addFrame(Stats& stats, const candela::Frame& frame) {
    stats.technique = frame.technique();
    if (const auto backend = frame.tileBackend()) stats.tileBackend = candela::toString(*backend);
}

void writeStats(const Options& options, const Stats& stats) {
    const std::string text = statsJson(stats);
    if (*options.stats == "-")
        std::cout << text;
    else
        writeText(*options.stats, text);
}

std::string writtenNames(const std::vector<PictureResult>& results) {
    const std::filesystem::path &first = results.front().picture.path, &last = results.back().picture.path;
    if (first.empty()) return countText(results.size(), "picture") + " to standard output";
    const std::string name =
        last.parent_path() == first.parent_path() ? last.filename().string() : last.string();
    return first.string() + (results.size() > 1 ? " to " + name : "");
}

std::string resultLine(const RunReport& report, const Options& options, const Stats& stats) {
    const std::vector<PictureResult> results = report.results();
    std::ostringstream text;
    text << "wrote " << writtenNames(results) << ": " << options.scene << ", " << stats.width << "x"
         << stats.height << ", " << countText(stats.lights, "light") << ", "
         << countText(stats.samples, "sample") << ", " << candela::toString(stats.technique) << " on "
         << stats.renderer << ", in " << std::fixed << std::setprecision(2) << report.seconds() << " s";
    if (report.skippedCount() > 0) text << "; left out " << report.skippedCount();
    return text.str();
}

/// What is said where no picture was drawn.
std::string idleLine(const RunReport& report, const PicturePlan& plan) {
    if (plan.count() == 0) return "this shard has no picture";
    return "left out " + countText(report.skippedCount(), "picture") + ", wrote none";
}

void sayResult(RunReport& report, const Options& options, const std::string& line) {
    report.clear();
    if (options.quiet || options.jsonProgress) return;
    const bool occupied = options.stats == "-" || options.output == "-";
    (occupied ? std::cerr : std::cout) << line << "\n";
}

/// The first of the pictures that have to be drawn is found before anything is uploaded: a task of a farm
/// that is started again has often nothing left to do.
bool isAllThere(const Options& options, const PicturePlan& plan) {
    if (plan.count() > 0 && !options.skipExisting) return false;
    for (std::uint64_t i = 0; i < plan.count(); ++i)
        if (!isSkipped(options, plan[i])) return false;
    return true;
}

void reportAllThere(RunReport& report, const PicturePlan& plan) {
    report.begin(plan.count());
    for (std::uint64_t i = 0; i < plan.count(); ++i) report.skipped(plan[i], "it is there");
    report.end();
}

}  // namespace

int renderFrames(const Options& options) {
    RunReport report(options);
    checkOutputs(options);
    const candela::ColorConfig color = candela::ColorConfig::choose(options.ocio);
    for (const std::string& note : color.notes()) report.note(note);
    std::optional<candela::DisplayTransform> display = chooseDisplay(report, options, color);

    const candela::PluginRegistry plugins(options.pluginFolders);
    Stats stats;
    addOptions(stats, options);
    candela::Scene scene = readScene(report, options, plugins, stats);
    stats.environment = useEnvironment(report, options, scene);
    const PicturePlan plan(scene, options);
    if (isAllThere(options, plan)) {
        reportAllThere(report, plan);
        if (options.stats) writeStats(options, stats);
        sayResult(report, options, idleLine(report, plan));
        return 0;
    }

    report.work("preparing the scene for drawing");
    const candela::Context context = createContext(options.device, options.shardIndex());
    const candela::GpuSceneOptions upload = uploadOptions(options, color, plugins);
    candela::GpuScene gpuScene =
        uploading(options.scene, [&] { return candela::GpuScene::takingPixels(context, scene, upload); });
    noteLights(report, gpuScene.lightReport(), options.rangeLoss);
    noteMissingSubdivider(report, gpuScene.cageReport());
    candela::Renderer renderer(context);
    Lighting lighting(report, options, scene, gpuScene);
    if (display && options.autoExposure) {
        candela::DisplayOptions exposed = options.display;
        exposed.exposure = measureExposure(report, options, renderer, gpuScene, lighting, plan,
                                           exposureTimes(scene, options.time), color.luminanceWeights());
        display = color.displayTransform(exposed);
    }
    FrameWriter frameWriter(context, renderer, gpuScene, color, display, options);
    SequenceResult result = drawSequence({options, scene, color, plan, frameWriter, lighting, report});
    if (result.signal != 0) return result.signal;
    noteLodClamped(report, gpuScene.cageReport());
    stats.timings = std::move(result.timings);
    stats.pictures = report.results();
    addDevice(stats, context);
    addScene(stats, gpuScene);
    if (!stats.timings.empty()) addFrame(stats, frameWriter.frame());
    if (options.stats && !stats.timings.empty()) {
        report.work("counting pairs of pixel and light");
        const PictureCounters counters = frameWriter.counters();
        stats.pairs = counters.pairs;
        stats.shadows = counters.shadows;
    }
    if (options.stats) writeStats(options, stats);
    sayResult(report, options,
              stats.pictures.empty() ? idleLine(report, plan) : resultLine(report, options, stats));
    return 0;
}
