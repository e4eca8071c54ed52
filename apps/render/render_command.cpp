#include "commands.h"

#include "common/output_file.h"
#include "common/program.h"
#include "common/scene_environment.h"
#include "common/scene_lights.h"
#include "common/scene_selection.h"
#include "frame_writer.h"
#include "stats.h"

#include <candela/context.h>
#include <candela/error.h>
#include <candela/import.h>
#include <candela/plugin_registry.h>
#include <candela/threads.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>

namespace {

/// How often --stats draws and times a single frame.
constexpr int statsDrawings = 5;

using Clock = std::chrono::steady_clock;

struct Session {
    const Options& options;
    Progress progress;

    explicit Session(const Options& sessionOptions)
        : options(sessionOptions), progress(sessionOptions.quiet ? Verbosity::quiet : Verbosity::normal) {}

    void note(const std::string& text) {
        if (options.quiet) return;
        progress.clear();
        std::cerr << "note: " << text << "\n";
    }
    std::uint64_t frameCount() const { return options.frames ? options.frames->count() : 1; }
    int frame(std::uint64_t index) const { return options.frames ? (*options.frames)[index] : 0; }
    double timeOf(int frame) const { return options.time + frame / options.sampling.framesPerSecond; }
    std::filesystem::path pathOf(int frame) const {
        return options.frames ? framePath(options.output, frame) : options.output;
    }
};

void checkOutputs(const Session& session) {
    checkWritable(session.pathOf(session.frame(0)));
    if (session.options.stats && *session.options.stats != "-") checkWritable(*session.options.stats);
}

/// The way to the display for a PNG; the names are checked for an EXR too, which takes nothing of it.
std::optional<candela::DisplayTransform> chooseDisplay(Session& session, const candela::ColorConfig& color) {
    const candela::DisplayOptions& displayOptions = session.options.display;
    candela::DisplayTransform transform = color.displayTransform(displayOptions);
    if (session.options.format == PictureFormat::png) return transform;
    if (!displayOptions.display.empty() || !displayOptions.view.empty() || !displayOptions.look.empty() ||
        displayOptions.exposure != 0.0 || session.options.autoExposure)
        session.note(
            "an .exr holds scene-linear light: --display, --view, --look and --exposure do not change it");
    return std::nullopt;
}

/// `stats` gets what the scene holds.
candela::Scene readScene(Session& session, const candela::PluginRegistry& plugins, Stats& stats) {
    candela::ImportOptions options;
    options.strictness = session.options.strictness;
    options.progress = [&](double share) {
        session.progress.show("reading " + session.options.scene + ": " +
                              std::to_string(static_cast<int>(std::lround(share * 100.0))) + " %");
        return true;
    };
    candela::ImportedScene imported = candela::importScene(plugins, session.options.scene, options);
    for (const candela::ImportNote& note : imported.report.notes) session.note(note.line());
    if (const auto note = selectAnimations(imported.scene, session.options)) session.note(*note);
    selectVariant(imported.scene, session.options.variant, session.options.scene);
    stats.contents = contentCounts(imported.scene);
    stats.materialKinds = materialKinds(imported.scene);
    stats.notes = std::move(imported.report.notes);
    if (session.options.scatter)
        addScatteredLights(imported.scene, *session.options.scatter, session.options.scene);
    return std::move(imported.scene);
}

/// Gives the scene the environment of the options, and its sun. Returns its name.
std::string useEnvironment(Session& session, candela::Scene& scene) {
    EnvironmentLight light = placedEnvironment(loadEnvironment(scene, session.options), session.options);
    for (const std::string& note : light.notes) session.note(note);
    scene.environment = std::move(light.environment);
    if (light.sun) scene.lights.push_back(*light.sun);
    return light.name;
}

void noteLights(Session& session, const candela::LightReport& report) {
    if (report.rangesAssigned == 0) return;
    std::ostringstream text;
    const bool one = report.rangesAssigned == 1;
    text << report.rangesAssigned << (one ? " light" : " lights") << " without a range: drawn up to "
         << report.minRange;
    if (report.minRange < report.maxRange) text << " to " << report.maxRange;
    text << " m, which takes at most " << 100.0f * session.options.rangeLoss
         << " % of their light from any point (--range-loss)";
    session.note(text.str());
}

void noteMissingSubdivider(Session& session, const candela::CageReport& report) {
    if (report.cages == 0 || report.subdivided) return;
    session.note(
        "no plugin that refines subdivision cages was found (opensubdiv does): their polygons are drawn");
}

void noteLodClamped(Session& session, const candela::CageReport& report) {
    if (report.lodClamped == 0) return;
    session.note(std::to_string(report.lodClamped) +
                 " cages are coarser than --subdivision-edge asks for: --subdivision-max-level or the "
                 "maximum number of vertices of a cage limits their level");
}

/// What is wrong with the pictures of a run, told once for each kind.
class PictureNotes {
  public:
    void add(const candela::ExposureCounts& counts) {
        ++pictures_;
        if (const std::optional<std::string> note = pictureNote(counts)) ++counts_[*note];
    }
    void tell(Session& session) const {
        for (const auto& [note, count] : counts_) {
            const std::string share =
                "in " + std::to_string(count) + " of " + std::to_string(pictures_) + " pictures ";
            session.note((pictures_ == 1 ? "" : share) + note);
        }
    }

  private:
    int pictures_ = 0;
    std::map<std::string, int> counts_;
};

/// What the layers of transparent surfaces leave out, told once for a run.
class LayerNotes {
  public:
    void add(const candela::LayerCounts& counts) {
        ++pictures_;
        incomplete_ += counts.fragmentsBeyond > 0;
        most_ = std::max(most_, counts.fragmentsBeyond);
    }
    void tell(Session& session) const {
        if (incomplete_ == 0) return;
        const std::string share = pictures_ == 1 ? ""
                                                 : "in " + std::to_string(incomplete_) + " of " +
                                                       std::to_string(pictures_) + " pictures up to ";
        session.note(share + std::to_string(most_) +
                     " pixels of transparent surfaces are left out: they lie beyond the " +
                     std::to_string(session.options.layers) + " layers that are drawn (--layers)");
    }

  private:
    int pictures_ = 0, incomplete_ = 0;
    std::uint64_t most_ = 0;
};

/// What lights the pictures of a run.
class Lighting {
  public:
    /// All have to outlive it.
    Lighting(Session& session, const candela::Scene& scene, candela::GpuScene& gpuScene)
        : session_(session),
          scene_(scene),
          gpuScene_(gpuScene),
          added_(usesDefaultLights(scene, session.options.defaultLights)) {
        if (added_ && session.options.defaultLights == DefaultLights::automatic)
            session.note(defaultLightsNote);
    }

    /// Brings the scene on the device to a time and, with default lights, to a view.
    void pose(double time, const candela::CameraView& view) {
        if (!scene_.animations.empty()) gpuScene_.setTime(time);
        if (!added_) return;
        // An EXR takes no exposure.
        const bool exposed = session_.options.format == PictureFormat::png;
        gpuScene_.setLights(
            lightsWithDefaults(scene_, time, view, exposed ? session_.options.display.exposure : 0.0));
    }

  private:
    Session& session_;
    const candela::Scene& scene_;
    candela::GpuScene& gpuScene_;
    bool added_;
};

/// The samples of a picture.
class Samples {
  public:
    /// All have to outlive it. `time` is the picture's, before animations repeat.
    Samples(const Session& session, const candela::Scene& scene, Lighting& lighting,
            const CameraSelection& views, double time)
        : session_(session),
          scene_(scene),
          lighting_(lighting),
          views_(views),
          settings_(session.options.samplingSettings()),
          time_(time) {}

    /// Brings the scene to the time of a sample, and returns the view of the camera then.
    candela::CameraView view(std::uint32_t sample) {
        const double time = poseTime(scene_, session_.options, candela::sampleTime(time_, settings_, sample));
        if (!posed_ || *posed_ != time) {
            view_ = views_.at(time);
            lighting_.pose(time, view_);
            posed_ = time;
        }
        return view_;
    }
    bool moves() const { return settings_.shutter > 0.0 && !scene_.animations.empty(); }
    std::string progressOf(std::uint32_t sample) const {
        if (settings_.count == 1) return "";
        return ", sample " + std::to_string(sample + 1) + " of " + std::to_string(settings_.count);
    }

  private:
    const Session& session_;
    const candela::Scene& scene_;
    Lighting& lighting_;
    const CameraSelection& views_;
    candela::SamplingSettings settings_;
    double time_;
    std::optional<double> posed_;
    candela::CameraView view_;
};

/// The size of a picture that is only measured: at most this many pixels wide and high.
constexpr int measuredPixels = 256;

/// The exposure that --exposure auto asks for; 0 where nothing is lit.
double measureExposure(Session& session, candela::Renderer& renderer, candela::GpuScene& gpuScene,
                       Lighting& lighting, const CameraSelection& views, const std::vector<double>& times,
                       const glm::vec3& luminanceWeights) {
    session.progress.show("measuring the exposure");
    candela::FrameSettings settings = frameSettings(session.options);
    settings.debugView = candela::DebugView::none;
    settings.overlays = {};
    const int larger = std::max({settings.width, settings.height, measuredPixels});
    settings.width = std::max(1, settings.width * measuredPixels / larger);
    settings.height = std::max(1, settings.height * measuredPixels / larger);
    std::vector<candela::HdrImage> frames;
    for (const double time : times) {
        const candela::CameraView view = views.at(time);
        lighting.pose(time, view);
        frames.push_back(renderer.render(gpuScene, view, settings).radiance());
    }
    const std::optional<double> exposure = candela::autoExposure(frames, luminanceWeights);
    std::ostringstream text;
    text << "--exposure auto is " << exposure.value_or(0.0) << (exposure ? " stops" : ": nothing is lit");
    session.note(text.str());
    return exposure.value_or(0.0);
}

/// Draws frame after frame and writes each. Returns what the drawings took.
std::vector<FrameTiming> drawFrames(Session& session, const candela::Scene& scene, FrameWriter& frameWriter,
                                    Lighting& lighting, const CameraSelection& views, PictureNotes& notes,
                                    LayerNotes& layerNotes) {
    const std::uint64_t count = session.frameCount();
    std::vector<FrameTiming> timings;
    for (std::uint64_t i = 0; i < count; ++i) {
        const int frame = session.frame(i);
        const std::string name = session.pathOf(frame).string();
        const std::string drawing =
            "drawing " + name + " (" + std::to_string(i + 1) + " of " + std::to_string(count) + ")";
        Samples samples(session, scene, lighting, views, session.timeOf(frame));
        const SampleSource source{[&](std::uint32_t sample) {
                                      session.progress.show(drawing + samples.progressOf(sample));
                                      return samples.view(sample);
                                  },
                                  samples.moves()};
        if (session.options.stats && i == 0) frameWriter.draw(source);  // compiles and allocates
        const int drawings = session.options.stats && !session.options.frames ? statsDrawings : 1;
        for (int drawn = 0; drawn < drawings; ++drawn) timings.push_back(frameWriter.draw(source));
        layerNotes.add(frameWriter.frame().layerCounts());
        session.progress.show("writing " + name);
        frameWriter.write(session.pathOf(frame));
        if (!session.options.quiet && session.options.debug.view == candela::DebugView::none)
            notes.add(frameWriter.exposureCounts());
    }
    return timings;
}

void writeStats(Session& session, const Stats& stats) {
    const std::string text = statsJson(stats);
    if (*session.options.stats == "-")
        std::cout << text;
    else
        writeText(*session.options.stats, text);
}

std::string resultLine(const Session& session, const Stats& stats, double seconds) {
    const std::uint64_t count = session.frameCount();
    std::ostringstream text;
    text << "wrote " << session.pathOf(session.frame(0)).string();
    if (count > 1) text << " to " << session.pathOf(session.frame(count - 1)).filename().string();
    text << ": " << session.options.scene << ", " << stats.width << "x" << stats.height << ", "
         << stats.lights << (stats.lights == 1 ? " light" : " lights") << ", " << stats.samples
         << (stats.samples == 1 ? " sample" : " samples") << ", " << candela::toString(stats.technique)
         << " on " << stats.renderer << ", in " << std::fixed << std::setprecision(2) << seconds << " s";
    return text.str();
}

}  // namespace

void renderFrames(const Options& options) {
    const Clock::time_point start = Clock::now();
    Session session(options);
    checkOutputs(session);
    const candela::ColorConfig color = candela::ColorConfig::choose(options.ocio);
    for (const std::string& note : color.notes()) session.note(note);
    std::optional<candela::DisplayTransform> display = chooseDisplay(session, color);

    const candela::PluginRegistry plugins(options.pluginFolders);
    Stats stats;
    candela::Scene scene = readScene(session, plugins, stats);
    const std::string environment = useEnvironment(session, scene);
    const CameraSelection views(scene, options, [&] { return framedBox(scene); });

    session.progress.show("preparing the scene for drawing");
    const candela::Context context = candela::Context::createHeadless(options.device);
    candela::GpuSceneOptions upload;
    upload.workingFromRec709 = color.workingFromRec709();
    upload.rangeLoss = options.rangeLoss;
    upload.subdivider = plugins.subdivider();
    upload.subdivision = options.subdivision;
    upload.vertexEvaluator = options.vertexEvaluator;
    candela::GpuScene gpuScene =
        uploading(options.scene, [&] { return candela::GpuScene::takingPixels(context, scene, upload); });
    noteLights(session, gpuScene.lightReport());
    noteMissingSubdivider(session, gpuScene.cageReport());
    candela::Renderer renderer(context);
    Lighting lighting(session, scene, gpuScene);
    if (display && options.autoExposure) {
        candela::DisplayOptions exposed = options.display;
        exposed.exposure = measureExposure(session, renderer, gpuScene, lighting, views,
                                           exposureTimes(scene, options.time), color.luminanceWeights());
        display = color.displayTransform(exposed);
    }
    FrameWriter frameWriter(context, renderer, gpuScene, color, display, options);

    PictureNotes pictureNotes;
    LayerNotes layerNotes;
    stats.timings = drawFrames(session, scene, frameWriter, lighting, views, pictureNotes, layerNotes);
    pictureNotes.tell(session);
    layerNotes.tell(session);
    noteLodClamped(session, gpuScene.cageReport());
    stats.renderer = context.renderer();
    stats.width = options.width;
    stats.height = options.height;
    stats.technique = frameWriter.frame().technique();
    if (const auto backend = frameWriter.frame().tileBackend())
        stats.tileBackend = candela::toString(*backend);
    stats.brdf = options.brdf;
    stats.threads = candela::threadCount();
    stats.samples = options.samplingSettings().count;
    stats.vertexEvaluator = gpuScene.cageReport().evaluator;
    stats.triangles = gpuScene.triangleCount() + gpuScene.cageReport().triangles;
    stats.lines = gpuScene.elementCount(candela::Topology::lines);
    stats.points = gpuScene.elementCount(candela::Topology::points);
    stats.materials = gpuScene.materialCount();
    stats.lights = gpuScene.lightReport().lights;
    stats.environment = environment;
    if (options.stats) {
        session.progress.show("counting pairs of pixel and light");
        // Debug views show no light.
        if (options.debug.view == candela::DebugView::none)
            stats.shadows = shadowStats(frameWriter.frame(), gpuScene, options.shadows);
        stats.pairs = frameWriter.frame().countPairs();
        writeStats(session, stats);
    }

    session.progress.clear();
    if (options.quiet) return;
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    (options.stats == "-" ? std::cerr : std::cout) << resultLine(session, stats, seconds) << "\n";
}
