#include "crowd_bench.h"

#include "common/timing.h"

#include <candela/error.h>
#include <candela/gpu_scene.h>
#include <candela/import.h>
#include <candela/renderer.h>
#include <candela/threads.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <barrier>
#include <cstring>
#include <iomanip>
#include <sstream>
#include <thread>
#include <vector>

namespace {

constexpr std::size_t floatsPerVertex = 6;  // position and normal

/// A copy of the vertices of the crowd in memory.
class VertexCopy {
  public:
    VertexCopy(std::uint64_t vertices, unsigned threads)
        : from_(vertices * floatsPerVertex, 1.0f), to_(from_.size()), threads_(threads) {}

    /// Returns the milliseconds from when all threads have started to when all have ended.
    double run() {
        std::barrier together(static_cast<std::ptrdiff_t>(threads_));
        std::vector<std::jthread> others;
        for (unsigned thread = 1; thread < threads_; ++thread) {
            others.emplace_back([&, thread] {
                together.arrive_and_wait();
                copyShare(thread);
                together.arrive_and_wait();
            });
        }
        together.arrive_and_wait();
        return measureMilliseconds([&] {
            copyShare(0);
            together.arrive_and_wait();
        });
    }

  private:
    void copyShare(unsigned thread) {
        const std::size_t first = from_.size() * thread / threads_;
        const std::size_t end = from_.size() * (thread + 1) / threads_;
        std::memcpy(to_.data() + first, from_.data() + first, (end - first) * sizeof(float));
    }

    std::vector<float> from_, to_;
    unsigned threads_;
};

/// The crowd on the device.
class Crowd {
  public:
    Crowd(const candela::Context& context, const candela::Scene& scene, const BenchOptions& options)
        : gpuScene_(context, scene, optionsOf(options)), renderer_(context) {
        settings_.width = settings_.height = 64;
        // Shadows would read the vertices back and build trees of them.
        settings_.shadows = candela::Shadows::off;
        const candela::Bounds bounds = worldBounds(scene, worldTransforms(scene));
        facing_ = frameBounds(bounds, 1.0f);
        away_ = facing_;
        // Turned by half a turn about its own y axis.
        away_.worldFromCamera[0] = -away_.worldFromCamera[0];
        away_.worldFromCamera[2] = -away_.worldFromCamera[2];
    }

    /// Poses the crowd without deforming it, out of view. Returns the milliseconds more that this takes than
    /// a frame in which nothing moves.
    double pose(double seconds) {
        const double still = measureMilliseconds([&] { draw(away_); });
        gpuScene_.setTime(seconds);
        return std::max(measureMilliseconds([&] { draw(away_); }) - still, 0.0);
    }

    /// Draws the posed crowd. Returns the milliseconds of the pass that deforms it.
    double deform() {
        const candela::Frame frame = draw(facing_);
        for (const candela::PassTime& pass : frame.passTimes())
            if (pass.name == "deform") return pass.milliseconds;
        throw candela::Error(candela::ErrorKind::environment, "crowd", "the frame has no pass that deforms");
    }

    candela::DeformationReport report() const { return gpuScene_.deformationReport(); }

  private:
    static candela::GpuSceneOptions optionsOf(const BenchOptions& options) {
        candela::GpuSceneOptions upload;
        upload.vertexEvaluator = options.vertexEvaluator;
        return upload;
    }
    candela::Frame draw(const candela::CameraView& view) {
        return renderer_.render(gpuScene_, view, settings_);
    }

    candela::GpuScene gpuScene_;
    candela::Renderer renderer_;
    candela::CameraView facing_, away_;
    candela::FrameSettings settings_;
};

std::uint64_t jointsOf(const candela::Scene& scene) {
    std::uint64_t joints = 0;
    for (const candela::Node& node : scene.nodes)
        if (node.mesh && node.skin) joints += scene.skins[*node.skin].joints.size();
    return joints;
}

}  // namespace

bool isCrowd(const std::string& scene) {
    return scene.starts_with("crowd:");
}

CrowdResult measureCrowd(const candela::PluginRegistry& plugins, const candela::Context& context,
                         const BenchOptions& options) {
    const candela::Scene scene = importScene(plugins, options.scene).scene;
    Crowd crowd(context, scene, options);
    CrowdResult result;
    result.scene = options.scene;
    result.characters = crowd.report().meshes;
    result.vertices = crowd.report().vertices;
    result.joints = jointsOf(scene);
    result.threads = candela::threadCount();
    if (result.vertices == 0)
        throw candela::Error(candela::ErrorKind::badInput, options.scene, "has no character to move");
    VertexCopy copy(result.vertices, result.threads);
    std::vector<double> poses, deforms, copies;
    for (int frame = 0; frame <= options.frames; ++frame) {
        const double pose = crowd.pose((frame + 1) / 60.0);
        const double deform = crowd.deform();
        const double copied = copy.run();
        if (frame == 0) continue;  // the first move allocates
        poses.push_back(pose);
        deforms.push_back(deform);
        copies.push_back(copied);
    }
    result.evaluator = crowd.report().evaluator;
    result.pose = median(poses);
    result.deform = median(deforms);
    result.copy = median(copies);
    return result;
}

std::string crowdResultJson(const std::string& renderer, const std::string& setup,
                            const CrowdResult& result) {
    using Json = nlohmann::ordered_json;
    const Json row{{"scene", result.scene},         {"characters", result.characters},
                   {"vertices", result.vertices},   {"joints", result.joints},
                   {"evaluator", result.evaluator}, {"threads", result.threads},
                   {"pose_ms", result.pose},        {"deform_ms", result.deform},
                   {"copy_ms", result.copy},        {"copies", result.ratio()}};
    const Json all{{"renderer", renderer}, {"setup", Json::parse(setup)}, {"results", Json::array({row})}};
    return all.dump(2) + "\n";
}

std::string crowdResultTable(const CrowdResult& result) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2) << result.characters << " characters: " << result.vertices
         << " vertices, " << result.joints << " joints\n"
         << "moving them: pose " << result.pose << " ms, deform (" << result.evaluator << ") "
         << result.deform << " ms\n"
         << "a copy of their vertices on " << result.threads << " threads: " << result.copy
         << " ms; a move is " << result.ratio() << " copies\n";
    return text.str();
}
