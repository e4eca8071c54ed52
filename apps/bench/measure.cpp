#include "measure.h"

#include "common/median.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>

namespace {

using Clock = std::chrono::steady_clock;

// A frame of the textbook's loop over thousands of lights takes half a minute without a GPU.
constexpr double maxSeconds = 10.0, maxSecondsAtAll = 60.0;
constexpr std::size_t minFrames = 3;
constexpr int copies = 21;
volatile float lastCopied = 0.0f;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double lightingOf(const FrameTimes& times) {
    const auto found = std::ranges::find(times.passes, "lighting", &candela::PassTime::name);
    return found == times.passes.end() ? 0.0 : found->milliseconds;
}

bool isEnough(std::size_t frames, double seconds, const BenchOptions& options) {
    if (frames == static_cast<std::size_t>(options.frames)) return true;
    return frames > 0 && (seconds > maxSecondsAtAll || (seconds > maxSeconds && frames >= minFrames));
}

}  // namespace

double measureCopy(const std::vector<candela::WorldLight>& lights) {
    std::vector<candela::WorldLight> copy(lights.size());
    std::vector<double> times;
    for (int i = 0; i < copies; ++i) {
        const Clock::time_point start = Clock::now();
        std::memcpy(copy.data(), lights.data(), lights.size() * sizeof(candela::WorldLight));
        times.push_back(millisecondsSince(start));
        // Read by somebody, so that no compiler leaves the copy out.
        if (!copy.empty()) lastCopied = copy.back().range;
    }
    return median(times);
}

Result measure(Program& program, Program* baseline, const BenchScene& scene, const BenchOptions& options,
               const std::string& technique) {
    program.draw();
    if (baseline != nullptr) baseline->draw();
    std::vector<double> frames, baselineFrames;
    std::map<std::string, std::vector<double>> passes;
    const Clock::time_point start = Clock::now();
    while (!isEnough(frames.size(), 1.0e-3 * millisecondsSince(start), options)) {
        const FrameTimes times = program.draw();
        frames.push_back(times.frame);
        for (const candela::PassTime& pass : times.passes) passes[pass.name].push_back(pass.milliseconds);
        if (baseline != nullptr) baselineFrames.push_back(lightingOf(baseline->draw()));
    }
    Result result;
    result.scene = scene.name;
    result.lights = scene.lights.size();
    result.technique = technique;
    result.width = options.width;
    result.height = options.height;
    result.frames = static_cast<int>(frames.size());
    result.frame = median(frames);
    const auto pass = [&](const char* name) -> std::optional<double> {
        return passes.contains(name) ? std::optional(median(passes.at(name))) : std::nullopt;
    };
    result.geometry = pass("geometry");
    result.lighting = pass("lighting");
    result.display = pass("display");
    if (baseline != nullptr) {
        result.reference = ReferenceLights{scene.referenceLights.value_or(0), median(baselineFrames)};
        result.copy = measureCopy(scene.lights);
    }
    program.count(result);
    return result;
}
