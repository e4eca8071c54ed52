/// candela-bench: measures lighting, and compares techniques. See --help and docs/benchmarks.md.

#include "bare_baseline.h"
#include "bench_options.h"
#include "bench_scene.h"
#include "cages/cage_bench.h"
#include "candela_program.h"
#include "common/output_file.h"
#include "common/progress.h"
#include "common/run_program.h"
#include "comparison.h"
#include "measure.h"
#include "plot.h"
#include "setup.h"
#include "textbook_baseline.h"

#include <candela/error.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace {

/// Beyond so many pairs the reference technique takes minutes: it is left out of --technique all, and the
/// next one is the reference.
constexpr double maxReferencePairs = 2.0e10;

bool isAffordable(candela::Technique technique, const BenchScene& scene, const BenchOptions& options) {
    const double pairs =
        static_cast<double>(options.width) * options.height * static_cast<double>(scene.lights.size());
    return technique != candela::Technique::fullscreen || pairs <= maxReferencePairs;
}

std::vector<candela::Technique> techniquesFor(const BenchScene& scene, const BenchOptions& options) {
    std::vector<candela::Technique> techniques = options.techniques;
    if (options.compares)
        std::erase_if(techniques, [&](candela::Technique t) { return !isAffordable(t, scene, options); });
    return techniques;
}

/// The pairs that are lit are the scene's, whichever program draws it.
void copyLitPairs(Result& result, const Result& candelas) {
    result.pairsLit = candelas.pairsLit;
    result.lightsVisible = candelas.lightsVisible;
}

class Bench {
  public:
    Bench(const BenchOptions& options, const candela::Context& context)
        : options_(options),
          context_(context),
          progress_(options.quiet ? Verbosity::quiet : Verbosity::normal) {}

    void measureScene(const BenchScene& scene) {
        const std::vector<candela::Technique> techniques = techniquesFor(scene, options_);
        // The last technique is the reference of all: `fullscreen` where it is affordable.
        std::optional<Reference> reference;
        const std::size_t first = results_.size();
        for (auto technique = techniques.rbegin(); technique != techniques.rend(); ++technique) {
            const auto program = makeCandelaProgram(context_, scene, options_, *technique);
            const auto baseline = makeBaseline(scene, *technique);
            add(*program, baseline.get(), scene, toString(*technique), reference);
        }
        std::reverse(results_.begin() + static_cast<std::ptrdiff_t>(first), results_.end());
        if (options_.baseline == Baseline::with) measureBaseline(scene, results_[first], reference);
    }

    const std::vector<Result>& results() const { return results_; }
    void clearProgress() { progress_.clear(); }

  private:
    /// The program that draws the scene with its reference lights alone; none where none are named.
    std::unique_ptr<Program> makeBaseline(const BenchScene& scene, candela::Technique technique) const {
        if (!scene.referenceLights) return nullptr;
        BenchScene fewer = scene;
        fewer.lights.resize(*scene.referenceLights);
        return makeCandelaProgram(context_, fewer, options_, technique);
    }

    void add(Program& program, Program* baseline, const BenchScene& scene, const std::string& name,
             std::optional<Reference>& reference) {
        progress_.show("measuring " + scene.name + " with " + std::to_string(scene.lights.size()) +
                       " lights: " + name);
        Result result = measure(program, baseline, scene, options_, name);
        std::vector<float> picture = program.picture();
        if (!picture.empty() && reference)
            compare(result, picture, *reference, allowedDifference(result.technique, scene));
        if (!picture.empty() && !reference && (options_.compares || options_.baseline == Baseline::with)) {
            reference = Reference{result.technique, std::move(picture)};
        }
        results_.push_back(result);
    }

    void measureBaseline(const BenchScene& scene, const Result candelas,
                         std::optional<Reference>& reference) {
        const auto textbook = [&](TextbookLighting lighting, const char* name) {
            const auto program = makeTextbookBaseline(context_, scene, options_, lighting);
            add(*program, nullptr, scene, name, reference);
            copyLitPairs(results_.back(), candelas);
        };
        textbook(TextbookLighting::volumes, "textbook_volumes");
        if (fitsTextbookLoop(scene) && isAffordable(candela::Technique::fullscreen, scene, options_))
            textbook(TextbookLighting::fullscreen, "textbook_fullscreen");
        const auto bare = makeBareBaseline(context_, scene, options_);
        add(*bare, nullptr, scene, "bare", reference);
    }

    const BenchOptions& options_;
    const candela::Context& context_;
    Progress progress_;
    std::vector<Result> results_;
};

void runCageBench(const BenchOptions& options, const candela::PluginRegistry& plugins,
                  const candela::Context& context) {
    const CageResult result = measureCages(plugins, context, options);
    writeText(options.json, cageResultJson(context.renderer(), setupJson(options), result));
    if (!options.quiet) std::cout << context.renderer() << "\n" << cageResultTable(result);
}

void runBench(const BenchOptions& options) {
    checkWritable(options.json);
    if (options.plot) checkWritable(*options.plot);
    const candela::PluginRegistry plugins(options.pluginFolders);
    const candela::Context context = candela::Context::createHeadless(options.device);
    if (options.scene == cageScene) return runCageBench(options, plugins, context);
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
}

}  // namespace

int main(int argc, char** argv) {
    return runProgram("candela-bench", [&] {
        const std::optional<BenchOptions> options = parseBenchOptions(argc, argv);
        if (options) runBench(*options);
    });
}
