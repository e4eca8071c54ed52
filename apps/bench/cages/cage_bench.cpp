#include "cages/cage_bench.h"

#include "cages/bench_cage.h"
#include "cages/opensubdiv_baselines.h"
#include "common/median.h"

#include <candela/error.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <iomanip>
#include <sstream>

namespace {

/// Building a table takes long: it is measured this often at most.
constexpr int maxRefinements = 5;

template <typename Work>
double milliseconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// candela with the cage on the device, as a program that moves it has it.
class CandelaMove {
  public:
    CandelaMove(const candela::Context& context, const candela::Subdivider& subdivider)
        : scene_(makeCageScene()), gpuScene_(context, scene_, optionsOf(subdivider)), renderer_(context) {
        const std::vector<glm::mat4> world = worldTransforms(scene_);
        settings_.width = settings_.height = 64;
        view_ = frameBounds(worldBounds(scene_, world), 1.0f);
    }

    /// Draws a small frame of the moved cage; what the move took of it.
    double move(const std::vector<glm::vec3>& points) {
        gpuScene_.setCagePoints(0, points);
        const candela::Frame frame = renderer_.render(gpuScene_, view_, settings_);
        for (const candela::PassTime& pass : frame.passTimes())
            if (pass.name == "cages") return pass.milliseconds;
        throw candela::Error(candela::ErrorKind::environment, "", "no pass moved the cage");
    }

    std::string evaluator() const { return gpuScene_.cageReport().evaluator; }

  private:
    static candela::GpuSceneOptions optionsOf(const candela::Subdivider& subdivider) {
        candela::GpuSceneOptions options;
        options.subdivider = subdivider;
        options.subdivision.level = benchLevel;
        return options;
    }

    candela::Scene scene_;
    candela::GpuScene gpuScene_;
    candela::Renderer renderer_;
    candela::CameraView view_;
    candela::FrameSettings settings_;
};

/// A sum of n products in single precision is off by at most n roundings of the sum of their sizes; rows have
/// some tens of entries, whose weights add up to 1.
void checkAgreement(const candela::RefinedCage& refined, const OmpMove& baseline,
                    const std::vector<glm::vec3>& points) {
    std::vector<glm::vec3> positions(refined.vertexCount()), normals(refined.vertexCount());
    evaluateLimit(refined, points, {positions, normals, {}, {}});
    constexpr float allowed = 1.0e-5f;
    for (std::uint32_t i = 0; i < refined.pointCount; ++i) {
        if (glm::distance(positions[i], baseline.positions()[i]) <= allowed * glm::length(positions[i]))
            continue;
        throw candela::Error(candela::ErrorKind::badInput, "cages",
                             "vertex " + std::to_string(i) +
                                 " is not where OpenSubdiv's evaluator puts it: the times say nothing");
    }
}

void measureRefinement(const candela::Subdivider& subdivider, const candela::Cage& cage,
                       const BenchOptions& options, CageResult& result) {
    std::vector<double> ours, fars;
    for (int i = 0; i < std::min(options.frames, maxRefinements); ++i) {
        ours.push_back(milliseconds([&] { subdivider.refine(cage, benchLevel); }));
        fars.push_back(milliseconds([&] { refineWithFar(cage, benchLevel); }));
    }
    result.refine = median(ours);
    result.opensubdivRefine = median(fars);
}

void measureMoves(CandelaMove& candelas, OmpMove& baseline, const candela::Cage& cage,
                  const BenchOptions& options, CageResult& result) {
    std::vector<double> ours, theirs;
    for (int frame = 0; frame <= options.frames; ++frame) {
        const std::vector<glm::vec3> points = waved(cage, frame / 24.0);
        const double own = candelas.move(points);
        const double other = milliseconds([&] { baseline.move(points); });
        if (frame == 0) continue;  // allocates, and chooses the evaluator
        ours.push_back(own);
        theirs.push_back(other);
    }
    result.move = median(ours);
    result.opensubdivMove = median(theirs);
}

std::string ratioText(double ours, double theirs) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << ours << " ms against " << theirs << " ms: " << ours / theirs
         << " times";
    return text.str();
}

}  // namespace

CageResult measureCages(const candela::PluginRegistry& plugins, const candela::Context& context,
                        const BenchOptions& options) {
    const std::optional<candela::Subdivider> subdivider = plugins.subdivider();
    if (!subdivider)
        throw candela::Error(candela::ErrorKind::environment, "cages",
                             "no plugin that subdivides was found; the plugin opensubdiv does");
    const candela::Cage cage = makeBenchCage();
    const candela::RefinedCage refined = subdivider->refine(cage, benchLevel);
    CageResult result;
    result.quads = cage.faceSizes.size();
    result.level = benchLevel;
    result.vertices = refined.vertexCount();
    result.entries = refined.positions.columns.size();
    OmpMove baseline(refined);
    baseline.move(cage.positions);
    checkAgreement(refined, baseline, cage.positions);
    CandelaMove candelas(context, *subdivider);
    measureMoves(candelas, baseline, cage, options, result);
    result.evaluator = candelas.evaluator();
    measureRefinement(*subdivider, cage, options, result);
    return result;
}

std::string cageResultJson(const std::string& renderer, const std::string& setup, const CageResult& result) {
    using Json = nlohmann::ordered_json;
    const Json row{{"scene", "cages"},           {"quads", result.quads},
                   {"level", result.level},      {"vertices", result.vertices},
                   {"entries", result.entries},  {"evaluator", result.evaluator},
                   {"move_ms", result.move},     {"opensubdiv_move_ms", result.opensubdivMove},
                   {"refine_ms", result.refine}, {"opensubdiv_refine_ms", result.opensubdivRefine}};
    const Json all{{"renderer", renderer}, {"setup", Json::parse(setup)}, {"results", Json::array({row})}};
    return all.dump(2) + "\n";
}

std::string cageResultTable(const CageResult& result) {
    std::ostringstream text;
    text << "cage of " << result.quads << " quads at level " << result.level << ": " << result.vertices
         << " vertices, " << result.entries << " weights\n"
         << "moving it (" << result.evaluator
         << ") against Osd::OmpEvaluator: " << ratioText(result.move, result.opensubdivMove) << "\n"
         << "refining it against Far: " << ratioText(result.refine, result.opensubdivRefine) << "\n";
    return text.str();
}
