#include "cage_bench.h"

#include "common/timing.h"
#include "opensubdiv_baselines.h"

#include <candela/error.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

namespace {

/// The level that cages are refined to.
constexpr std::uint32_t benchLevel = 3;

using Lattice = std::array<int, 3>;

constexpr Lattice quadsAlong{50, 50, 25};

/// The vertices of the box's surface; each is added once.
class LatticeVertices {
  public:
    explicit LatticeVertices(candela::Cage& cage) : cage_(cage) {}

    std::uint32_t at(const Lattice& place) {
        const auto [entry, isNew] =
            indices_.try_emplace(place, static_cast<std::uint32_t>(cage_.positions.size()));
        if (isNew) cage_.positions.push_back(onEllipsoid(place));
        return entry->second;
    }

  private:
    static glm::vec3 onEllipsoid(const Lattice& place) {
        glm::vec3 inBox;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            inBox[axis] = 2.0f * static_cast<float>(place[i]) / static_cast<float>(quadsAlong[i]) - 1.0f;
        }
        return glm::normalize(inBox) * glm::vec3(2.0f, 2.0f, 1.0f);
    }

    candela::Cage& cage_;
    std::map<Lattice, std::uint32_t> indices_;
};

enum class End { lower, upper };

/// The side of the box at one end of the axis `normal`; the other two axes follow it in turn.
void addSide(candela::Cage& cage, LatticeVertices& vertices, std::size_t normal, End end) {
    const std::size_t u = (normal + 1) % 3, v = (normal + 2) % 3;
    for (int i = 0; i < quadsAlong[u]; ++i) {
        for (int j = 0; j < quadsAlong[v]; ++j) {
            std::array<std::pair<int, int>, 4> ring{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
            if (end == End::lower) std::swap(ring[1], ring[3]);
            for (const auto& [a, b] : ring) {
                Lattice place{};
                place[normal] = end == End::upper ? quadsAlong[normal] : 0;
                place[u] = a;
                place[v] = b;
                cage.faceVertices.push_back(vertices.at(place));
            }
            cage.faceSizes.push_back(4);
        }
    }
}

/// A closed cage of 10,000 quads: the sides of a box, 50 × 50 × 25 quads, projected to an ellipsoid. The
/// box's eight corners have valence 3.
candela::Cage makeBenchCage() {
    candela::Cage cage;
    cage.name = "ellipsoid";
    LatticeVertices vertices(cage);
    for (std::size_t normal = 0; normal < 3; ++normal) {
        addSide(cage, vertices, normal, End::upper);
        addSide(cage, vertices, normal, End::lower);
    }
    return cage;
}

/// The cage's points moved by a wave, as of `seconds`.
std::vector<glm::vec3> waved(const candela::Cage& cage, double seconds) {
    std::vector<glm::vec3> points;
    points.reserve(cage.positions.size());
    for (const glm::vec3& p : cage.positions) {
        const auto wave = static_cast<float>(0.1 * std::sin(4.0 * p.x + 6.0 * seconds));
        points.push_back(p * (1.0f + wave));
    }
    return points;
}

/// A scene with the cage alone, at the origin.
candela::Scene makeCageScene() {
    candela::Scene scene;
    scene.cages.push_back(makeBenchCage());
    candela::Node node;
    node.name = "ellipsoid";
    node.cage = 0;
    scene.nodes.push_back(node);
    return scene;
}

/// A refinement takes about a second: it is measured this often at most.
constexpr int maxRefinements = 5;

/// candela with the cage on the device.
class CandelaMove {
  public:
    CandelaMove(const candela::Context& context, const candela::Subdivider& subdivider,
                candela::VertexEvaluator evaluator)
        : scene_(makeCageScene()),
          gpuScene_(context, scene_, optionsOf(subdivider, evaluator)),
          renderer_(context) {
        const std::vector<glm::mat4> world = worldTransforms(scene_);
        settings_.width = settings_.height = 64;
        // Shadows would read the vertices back and build trees of them.
        settings_.shadows = candela::Shadows::off;
        view_ = frameBounds(worldBounds(scene_, world), 1.0f);
    }

    /// Draws a small frame of the moved cage. Returns the milliseconds of the pass that moves it.
    double move(const std::vector<glm::vec3>& points) {
        gpuScene_.setCagePoints(0, points);
        const candela::Frame frame = renderer_.render(gpuScene_, view_, settings_);
        for (const candela::PassTime& pass : frame.passTimes())
            if (pass.name == "cages") return pass.milliseconds;
        throw candela::Error(candela::ErrorKind::environment, "", "no pass moved the cage");
    }

    std::string evaluator() const { return gpuScene_.cageReport().evaluator; }

  private:
    static candela::GpuSceneOptions optionsOf(const candela::Subdivider& subdivider,
                                              candela::VertexEvaluator evaluator) {
        candela::GpuSceneOptions options;
        options.subdivider = subdivider;
        options.subdivision.level = benchLevel;
        options.vertexEvaluator = evaluator;
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
                                 " differs from OpenSubdiv's evaluator: the times are not comparable");
    }
}

void measureRefinement(const candela::Subdivider& subdivider, const candela::Cage& cage,
                       const BenchOptions& options, CageResult& result) {
    std::vector<double> ownTimes, farTimes;
    for (int i = 0; i < std::min(options.frames, maxRefinements); ++i) {
        ownTimes.push_back(measureMilliseconds([&] { subdivider.refine(cage, benchLevel); }));
        farTimes.push_back(measureMilliseconds([&] { refineWithFar(cage, benchLevel); }));
    }
    result.refine = median(ownTimes);
    result.opensubdivRefine = median(farTimes);
}

void measureMoves(CandelaMove& own, OmpMove& baseline, const candela::Cage& cage, const BenchOptions& options,
                  CageResult& result) {
    std::vector<double> ownTimes, baselineTimes;
    for (int frame = 0; frame <= options.frames; ++frame) {
        const std::vector<glm::vec3> points = waved(cage, frame / 24.0);
        const double ownTime = own.move(points);
        const double baselineTime = measureMilliseconds([&] { baseline.move(points); });
        if (frame == 0) continue;  // the first move allocates
        ownTimes.push_back(ownTime);
        baselineTimes.push_back(baselineTime);
    }
    result.move = median(ownTimes);
    result.opensubdivMove = median(baselineTimes);
}

std::string ratioText(double ownTimes, double baselineTimes) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << ownTimes << " ms against " << baselineTimes
         << " ms: " << ownTimes / baselineTimes << " times";
    return text.str();
}

}  // namespace

CageResult measureCages(const candela::PluginRegistry& plugins, const candela::Context& context,
                        const BenchOptions& options) {
    const std::optional<candela::Subdivider> subdivider = plugins.subdivider();
    if (!subdivider)
        throw candela::Error(candela::ErrorKind::environment, "cages",
                             "needs a plugin that refines cages, such as opensubdiv; none was found");
    const candela::Cage cage = makeBenchCage();
    const candela::RefinedCage refined = subdivider->refine(cage, benchLevel);
    CageResult result;
    result.quads = cage.faceSizes.size();
    result.level = benchLevel;
    result.vertices = refined.vertexCount();
    result.entries = refined.positions.controlIndices.size();
    OmpMove baseline(refined);
    baseline.move(cage.positions);
    checkAgreement(refined, baseline, cage.positions);
    CandelaMove own(context, *subdivider, options.vertexEvaluator);
    measureMoves(own, baseline, cage, options, result);
    result.evaluator = own.evaluator();
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
