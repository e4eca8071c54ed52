/// candela-bench: measures the lighting techniques and compares their radiance. See --help and
/// docs/benchmarks.md.

#include "bench_options.h"
#include "bench_scene.h"
#include "cage_bench.h"
#include "common/output_file.h"
#include "common/program.h"
#include "crowd_bench.h"
#include "measure.h"
#include "programs.h"
#include "results.h"

#include <candela/color.h>
#include <candela/error.h>
#include <candela/threads.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>

namespace {

/// With more pairs of pixel and light `fullscreen` takes minutes: --technique all leaves it out, and the next
/// technique is the reference.
constexpr double maxFullscreenPairs = 2.0e10;

bool isAffordable(candela::Technique technique, const BenchScene& scene, const BenchOptions& options) {
    const double pairs =
        static_cast<double>(options.width) * options.height * static_cast<double>(scene.lights.size());
    return technique != candela::Technique::fullscreen || pairs <= maxFullscreenPairs;
}

std::vector<candela::Technique> techniquesFor(const BenchScene& scene, const BenchOptions& options) {
    std::vector<candela::Technique> techniques = options.techniques;
    if (options.compares)
        std::erase_if(techniques, [&](candela::Technique t) { return !isAffordable(t, scene, options); });
    return techniques;
}

using ProgramMaker = std::function<std::unique_ptr<Program>()>;

class Bench {
  public:
    Bench(const BenchOptions& options, const candela::Context& context)
        : options_(options),
          context_(context),
          progress_(options.quiet ? Verbosity::quiet : Verbosity::normal) {}

    void measureScene(const BenchScene& scene) {
        const std::vector<candela::Technique> techniques = techniquesFor(scene, options_);
        // The last technique is the reference of all: `fullscreen` where it is affordable.
        reference_.reset();
        const std::size_t first = results_.size();
        for (auto technique = techniques.rbegin(); technique != techniques.rend(); ++technique)
            addCandela(scene, *technique);
        std::reverse(results_.begin() + static_cast<std::ptrdiff_t>(first), results_.end());
        if (options_.baseline == Baseline::with) addBaselines(scene, Result(results_[first]));
    }

    const std::vector<Result>& results() const { return results_; }
    void clearProgress() { progress_.clear(); }

  private:
    void addCandela(const BenchScene& scene, candela::Technique technique) {
        const ProgramMaker make = [&] { return makeCandelaProgram(context_, scene, options_, technique); };
        if (!scene.referenceLights) return add(scene, toString(technique), make);
        BenchScene fewer = scene;
        fewer.lights.resize(*scene.referenceLights);
        add(scene, toString(technique), make,
            [&] { return makeCandelaProgram(context_, fewer, options_, technique); });
    }

    void addBaselines(const BenchScene& scene, const Result& own) {
        const auto addTextbook = [&](TextbookLighting lighting, const char* name) {
            add(scene, name, [&] { return makeTextbookProgram(context_, scene, options_, lighting); });
            // Lit pairs are a property of the scene, whichever program draws it.
            results_.back().pairsLit = own.pairsLit;
            results_.back().lightsVisible = own.lightsVisible;
        };
        addTextbook(TextbookLighting::volumes, "textbook_volumes");
        if (isAffordable(candela::Technique::fullscreen, scene, options_))
            addTextbook(TextbookLighting::fullscreen, "textbook_fullscreen");
        add(scene, "bare", [&] { return makeBareProgram(context_, scene, options_); });
    }

    /// Measures one program. What it throws becomes the result's error, so that other results are kept.
    void add(const BenchScene& scene, const std::string& name, const ProgramMaker& make,
             const ProgramMaker& makeReference = {}) {
        progress_.show("measuring " + scene.name + " with " + std::to_string(scene.lights.size()) +
                       " lights: " + name);
        Result result;
        try {
            const std::unique_ptr<Program> program = make();
            const std::unique_ptr<Program> reference = makeReference ? makeReference() : nullptr;
            result = measure(*program, reference.get(), scene, options_, name);
            checkImage(result, program->radiance(), scene);
        } catch (const candela::Error& error) {
            result.scene = scene.name;
            result.lights = scene.lights.size();
            result.technique = name;
            result.width = options_.width;
            result.height = options_.height;
            result.error = error.what();
        }
        results_.push_back(result);
    }

    void checkImage(Result& result, std::vector<float> rgb, const BenchScene& scene) {
        if (rgb.empty()) return;
        if (reference_)
            return compareImages(result, rgb, *reference_, allowedDifference(result.technique, scene));
        if (options_.compares || options_.baseline == Baseline::with)
            reference_ = ReferenceImage{result.technique, std::move(rgb)};
    }

    const BenchOptions& options_;
    const candela::Context& context_;
    Progress progress_;
    std::optional<ReferenceImage> reference_;
    std::vector<Result> results_;
};

/// A baseline that fails is reported in its row only; where candela itself fails, the run fails.
void requireCandelaResults(const std::vector<Result>& results) {
    for (const Result& result : results) {
        if (!result.error || !isCandela(result)) continue;
        throw candela::Error(
            candela::ErrorKind::badInput, result.scene,
            result.technique + " with " + std::to_string(result.lights) + " lights: " + *result.error);
    }
}

void runCageBench(const BenchOptions& options, const candela::PluginRegistry& plugins,
                  const candela::Context& context) {
    const CageResult result = measureCages(plugins, context, options);
    writeText(options.json, cageResultJson(context.renderer(), setupJson(options), result));
    if (!options.quiet) std::cout << context.renderer() << "\n" << cageResultTable(result);
}

void runCrowdBench(const BenchOptions& options, const candela::PluginRegistry& plugins,
                   const candela::Context& context) {
    const CrowdResult result = measureCrowd(plugins, context, options);
    writeText(options.json, crowdResultJson(context.renderer(), setupJson(options), result));
    if (!options.quiet) std::cout << context.renderer() << "\n" << crowdResultTable(result);
}

/// Throws before anything is measured where the config has no such view.
void checkView(const BenchOptions& options) {
    candela::DisplayOptions display;
    display.view = options.view.value_or("");
    candela::ColorConfig::builtIn().displayTransform(display);
}

void runBench(const BenchOptions& options) {
    checkWritable(options.json);
    if (options.plot) checkWritable(*options.plot);
    checkView(options);
    const candela::PluginRegistry plugins(options.pluginFolders);
    const candela::Context context = candela::Context::createHeadless(options.device);
    if (options.scene == cageScene) return runCageBench(options, plugins, context);
    if (isCrowd(options.scene)) return runCrowdBench(options, plugins, context);
    Bench bench(options, context);
    std::vector<std::optional<std::uint64_t>> counts(options.lights.begin(), options.lights.end());
    if (counts.empty()) counts.emplace_back();
    for (const auto& count : counts) bench.measureScene(loadBenchScene(plugins, options, count));
    bench.clearProgress();
    writeText(options.json, resultsJson(context.renderer(), setupJson(options), bench.results()));
    if (options.plot) writeText(*options.plot, plotSvg(context.renderer(), bench.results()));
    if (!options.quiet)
        std::cout << context.renderer() << ", " << options.width << "x" << options.height << "\n"
                  << resultsTable(bench.results());
    requireCandelaResults(bench.results());
}

}  // namespace

int main(int argc, char** argv) {
    return runProgram("candela-bench", [&] {
        const std::optional<BenchOptions> options = parseBenchOptions(argc, argv);
        if (!options) return;
        candela::setThreadCount(options->threads);
        runBench(*options);
    });
}
