#include "measure.h"

#include <algorithm>
#include <map>

namespace {

using Clock = std::chrono::steady_clock;

constexpr double mostSeconds = 10.0;
constexpr std::size_t leastFrames = 3;

double median(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

Result measure(Program& program, const BenchScene& scene, const BenchOptions& options,
               const std::string& technique) {
    program.draw();
    std::vector<double> frames;
    std::map<std::string, std::vector<double>> passes;
    const Clock::time_point start = Clock::now();
    while (frames.size() < static_cast<std::size_t>(options.frames)) {
        if (frames.size() >= leastFrames && millisecondsSince(start) > 1000.0 * mostSeconds) break;
        const Clock::time_point frameStart = Clock::now();
        const std::vector<candela::PassTime> times = program.draw();
        frames.push_back(millisecondsSince(frameStart));
        for (const candela::PassTime& pass : times) passes[pass.name].push_back(pass.milliseconds);
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
    program.count(result);
    return result;
}
