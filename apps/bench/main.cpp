/// candela-bench: measures the lighting techniques and compares their radiance. See --help and
/// docs/benchmarks.md.

#include "arithmetic_ceiling.h"
#include "bench_options.h"
#include "bench_scene.h"
#include "cage_bench.h"
#include "common/output_file.h"
#include "common/program.h"
#include "crowd_bench.h"
#include "markdown_table.h"
#include "measure.h"
#include "programs.h"
#include "results.h"
#include "results_csv.h"

#include <candela/color.h>
#include <candela/error.h>
#include <candela/threads.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

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

/// A technique, and what runs it where it is `tiles`.
struct TechniqueRun {
    candela::Technique technique;
    candela::TileBackend backend;
};

bool isTiles(candela::Technique technique) {
    return technique == candela::Technique::tiles || technique == candela::Technique::automatic;
}

/// The techniques in order, `tiles` with the first of the backends; `tiles` with the others follows.
std::vector<TechniqueRun> runsOf(const std::vector<candela::Technique>& techniques,
                                 const std::vector<candela::TileBackend>& backends) {
    std::vector<TechniqueRun> runs;
    for (const candela::Technique technique : techniques) runs.push_back({technique, backends.front()});
    const auto tiles = std::ranges::find_if(techniques, isTiles);
    if (tiles == techniques.end()) return runs;
    for (std::size_t i = 1; i < backends.size(); ++i) runs.push_back({*tiles, backends[i]});
    return runs;
}

using ProgramMaker = std::function<std::unique_ptr<Program>()>;

/// A row of the report before it is measured.
struct Row {
    std::string technique;
    std::optional<candela::Shadows> shadows;
    ProgramMaker make, makeReference = {};  ///< The latter may be empty.
    std::uint32_t samples = 1;
};

Subject subjectOf(const Row& row) {
    return {row.technique, row.shadows, row.samples, row.make(),
            row.makeReference ? row.makeReference() : nullptr};
}

class Bench {
  public:
    Bench(const BenchOptions& options, const candela::Context& context)
        : options_(options),
          context_(context),
          progress_(options.quiet ? Verbosity::quiet : Verbosity::normal) {}

    void measureScene(const BenchScene& scene) {
        const std::vector<candela::Technique> techniques = techniquesFor(scene, options_);
        // The last one is the reference of all: `fullscreen` where it is affordable, or the last of several
        // backends of `tiles`.
        const std::vector<TechniqueRun> runs = runsOf(techniques, options_.tileBackends);
        references_.clear();
        const std::size_t first = results_.size();
        for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
            const std::vector<Result> rows = measureRows(scene, candelaRows(scene, *run));
            results_.insert(results_.begin() + static_cast<std::ptrdiff_t>(first), rows.begin(), rows.end());
        }
        if (options_.baseline == Baseline::with) addBaselines(scene, Result(results_[first]));
    }

    const std::vector<Result>& results() const { return results_; }
    void clearProgress() { progress_.clear(); }

  private:
    /// Of one technique, with shadows, without, or both, and with each number of samples.
    std::vector<Row> candelaRows(const BenchScene& scene, const TechniqueRun& run) const {
        std::vector<Row> rows;
        for (const candela::Shadows shadows : options_.shadows)
            for (const std::uint32_t samples : options_.samples)
                rows.push_back(candelaRow(scene, {run.technique, shadows, samples, run.backend}));
        return rows;
    }

    Row candelaRow(const BenchScene& scene, const CandelaDrawing& drawing) const {
        const auto make = [this, drawing](const BenchScene& lit) {
            return makeCandelaProgram(context_, lit, options_, drawing);
        };
        Row row{toString(drawing.technique), drawing.shadows, [make, &scene] { return make(scene); }, {}};
        row.samples = drawing.samples;
        if (scene.referenceLights) {
            row.makeReference = [make, &scene] {
                BenchScene fewer = scene;
                fewer.lights.resize(*scene.referenceLights);
                return make(fewer);
            };
        }
        return row;
    }

    void addBaselines(const BenchScene& scene, const Result& own) {
        const auto addBaseline = [&](const char* name, const ProgramMaker& make) {
            const std::vector<Result> rows = measureRows(scene, {{name, {}, make, {}}});
            results_.insert(results_.end(), rows.begin(), rows.end());
        };
        const auto addTextbook = [&](const char* name, TextbookLighting lighting) {
            addBaseline(name, [&] { return makeTextbookProgram(context_, scene, options_, lighting); });
            // Lit pairs are a property of the scene, whichever program draws it.
            results_.back().pairsLit = own.pairsLit;
            results_.back().lightsVisible = own.lightsVisible;
        };
        addTextbook("textbook_volumes", TextbookLighting::volumes);
        if (isAffordable(candela::Technique::fullscreen, scene, options_))
            addTextbook("textbook_fullscreen", TextbookLighting::fullscreen);
        addBaseline("bare", [&] { return makeBareProgram(context_, scene, options_); });
        if (std::ranges::find(options_.shadows, candela::Shadows::on) != options_.shadows.end())
            addShadowMaps(scene);
    }

    void addShadowMaps(const BenchScene& scene) {
        const char* name = "cube_shadow_maps";
        showProgress(scene, name);
        try {
            results_.push_back(measureShadowMaps(context_, scene, options_));
            results_.back().technique = name;
        } catch (const candela::Error& error) {
            results_.push_back(failedResult(scene, {name, {}, {}, {}}, error));
        }
    }

    /// Measures programs alternately. What one throws becomes the error of each, so that other results are
    /// kept.
    std::vector<Result> measureRows(const BenchScene& scene, const std::vector<Row>& rows) {
        showProgress(scene, rows.front().technique);
        try {
            std::vector<Subject> subjects;
            for (const Row& row : rows) subjects.push_back(subjectOf(row));
            std::vector<Result> results = measure(subjects, scene, options_);
            for (std::size_t i = 0; i < rows.size(); ++i) {
                results[i].backendShown = options_.tileBackends.size() > 1;
                checkImage(results[i], subjects[i].program->radiance(), scene);
            }
            return results;
        } catch (const candela::Error& error) {
            std::vector<Result> results;
            for (const Row& row : rows) results.push_back(failedResult(scene, row, error));
            return results;
        }
    }

    Result failedResult(const BenchScene& scene, const Row& row, const candela::Error& error) const {
        Result result;
        result.scene = scene.name;
        result.lights = scene.lights.size();
        result.technique = row.technique;
        result.shadows = row.shadows;
        result.samples = row.samples;
        result.width = options_.width;
        result.height = options_.height;
        result.error = error.what();
        return result;
    }

    /// Pictures with shadows and without, and each number of samples, have references of their own; the
    /// textbook programs draw none.
    void checkImage(Result& result, std::vector<float> rgb, const BenchScene& scene) {
        if (rgb.empty()) return;
        const candela::Shadows shadows = result.shadows.value_or(candela::Shadows::off);
        const auto key = std::pair(shadows, result.samples);
        const auto reference = references_.find(key);
        if (reference != references_.end())
            return compareImages(result, rgb, reference->second, allowedDifference(result.technique, scene));
        if (isCandela(result) &&
            (options_.compares || options_.baseline == Baseline::with || options_.tileBackends.size() > 1))
            references_[key] = ReferenceImage{result.technique, std::move(rgb)};
    }

    void showProgress(const BenchScene& scene, const std::string& name) {
        progress_.show("measuring " + scene.name + " with " + std::to_string(scene.lights.size()) +
                       " lights: " + name);
    }

    const BenchOptions& options_;
    const candela::Context& context_;
    Progress progress_;
    std::map<std::pair<candela::Shadows, std::uint32_t>, ReferenceImage> references_;
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

/// Where the table goes: not between the results.
std::ostream& tableStream(const BenchOptions& options) {
    return options.json == "-" ? std::cerr : std::cout;
}

/// `json` is their text; a file that ends in .csv gets a table of them.
void writeResults(const BenchOptions& options, const std::string& json) {
    const std::string text = options.json.extension() == ".csv" ? resultsCsv(json) : json;
    if (options.json == "-")
        std::cout << text;
    else
        writeText(options.json, text);
}

void runCageBench(const BenchOptions& options, const candela::PluginRegistry& plugins,
                  const candela::Context& context) {
    const CageResult result = measureCages(plugins, context, options);
    writeResults(options, cageResultJson(context.renderer(), setupJson(options), result));
    if (!options.quiet) tableStream(options) << context.renderer() << "\n" << cageResultTable(result);
}

void runCrowdBench(const BenchOptions& options, const candela::PluginRegistry& plugins,
                   const candela::Context& context) {
    const CrowdResult result = measureCrowd(plugins, context, options);
    writeResults(options, crowdResultJson(context.renderer(), setupJson(options), result));
    if (!options.quiet) tableStream(options) << context.renderer() << "\n" << crowdResultTable(result);
}

/// Throws before anything is measured where the config has no such view.
void checkView(const BenchOptions& options) {
    candela::DisplayOptions display;
    display.view = options.view.value_or("");
    candela::ColorConfig::builtIn().displayTransform(display);
}

void runBench(const BenchOptions& options) {
    if (options.json != "-") checkWritable(options.json);
    if (options.plot) checkWritable(*options.plot);
    checkView(options);
    const candela::PluginRegistry plugins(options.pluginFolders);
    const candela::Context context = createContext(options.device);
    if (options.scene == cageScene) return runCageBench(options, plugins, context);
    if (isCrowd(options.scene)) return runCrowdBench(options, plugins, context);
    Bench bench(options, context);
    std::vector<std::optional<std::uint64_t>> counts(options.lights.begin(), options.lights.end());
    if (counts.empty()) counts.emplace_back();
    for (const auto& count : counts) bench.measureScene(loadBenchScene(plugins, options, count));
    bench.clearProgress();
    std::optional<Ceiling> ceiling;
    if (options.measuresCeiling) ceiling = measureCeiling(context, options.brdf);
    writeResults(options, resultsJson(context.renderer(), setupJson(options), bench.results(), ceiling));
    if (options.plot) writeText(*options.plot, plotSvg(context.renderer(), bench.results()));
    if (!options.quiet) {
        tableStream(options) << context.renderer() << ", " << options.width << "x" << options.height << "\n"
                             << (options.table == TableFormat::markdown
                                     ? "\n" + markdownTable(bench.results(), ceiling)
                                     : resultsTable(bench.results()))
                             << (ceiling ? ceilingText(*ceiling) : "");
    }
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
