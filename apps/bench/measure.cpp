#include "measure.h"

#include "common/timing.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

namespace {

using Clock = std::chrono::steady_clock;

// A frame of the textbook's loop over thousands of lights takes half a minute without a GPU.
constexpr double maxSeconds = 10.0;
/// Limit where not even `minFrames` frames are drawn in `maxSeconds`.
constexpr double absoluteMaxSeconds = 60.0;
constexpr std::size_t minFrames = 3;
constexpr int copies = 21;
volatile float copiedValue = 0.0f;

double lightingOf(const FrameTimes& times) {
    const auto found = std::ranges::find(times.passes, "lighting", &candela::PassTime::name);
    return found == times.passes.end() ? 0.0 : found->milliseconds;
}

bool isEnough(std::size_t frames, double seconds, const BenchOptions& options) {
    if (frames == static_cast<std::size_t>(options.frames)) return true;
    return frames > 0 && (seconds > absoluteMaxSeconds || (seconds > maxSeconds && frames >= minFrames));
}

/// Milliseconds of a memcpy of the array of lights.
double measureCopy(const std::vector<candela::WorldLight>& lights) {
    std::vector<candela::WorldLight> copy(lights.size());
    std::vector<double> times;
    for (int i = 0; i < copies; ++i) {
        const Clock::time_point start = Clock::now();
        std::memcpy(copy.data(), lights.data(), lights.size() * sizeof(candela::WorldLight));
        times.push_back(millisecondsSince(start));
        // The volatile store keeps the compiler from removing the copy.
        if (!copy.empty()) copiedValue = copy.back().range;
    }
    return median(times);
}

/// Half a step of half floats at the farthest light's coordinates, metres.
double positionRounding(const BenchScene& scene) {
    float farthest = 1.0f;
    for (const candela::WorldLight& light : scene.lights)
        for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(light.position[axis]));
    return std::exp2(std::floor(std::log2(static_cast<double>(farthest))) - 11.0);
}

double shortestRange(const BenchScene& scene) {
    float shortest = 1.0e9f;
    for (const candela::WorldLight& light : scene.lights)
        if (light.range > 0.0f) shortest = std::min(shortest, light.range);
    return static_cast<double>(shortest);
}

/// Times of the frames of one subject, milliseconds.
struct Samples {
    std::vector<double> frames, reference;
    std::map<std::string, std::vector<double>> passes;

    /// Draws a frame.
    void add(const Subject& subject) {
        const FrameTimes times = subject.program->draw();
        frames.push_back(times.frame);
        for (const candela::PassTime& pass : times.passes) passes[pass.name].push_back(pass.milliseconds);
        if (subject.reference) reference.push_back(lightingOf(subject.reference->draw()));
    }
};

Result medians(const Samples& samples, const BenchScene& scene) {
    Result result;
    result.scene = scene.name;
    result.lights = scene.lights.size();
    result.frames = static_cast<int>(samples.frames.size());
    result.frame = median(samples.frames);
    const auto pass = [&](const char* name) -> std::optional<double> {
        const auto found = samples.passes.find(name);
        return found != samples.passes.end() ? std::optional(median(found->second)) : std::nullopt;
    };
    result.geometry = pass("geometry");
    result.lighting = pass("lighting");
    result.display = pass("display");
    result.ambientOcclusion = pass("ambient occlusion");
    result.environment = pass("environment");
    result.background = pass("background");
    if (!samples.reference.empty()) {
        result.reference = ReferenceLights{scene.referenceLights.value_or(0), median(samples.reference)};
        result.copy = measureCopy(scene.lights);
    }
    return result;
}

std::size_t nonFiniteCount(const std::vector<float>& values) {
    return static_cast<std::size_t>(std::ranges::count_if(values, [](float v) { return !std::isfinite(v); }));
}

}  // namespace

PassClock::PassClock(const candela::Context& context) : software_(context.isSoftware()) {}

PassClock::~PassClock() {
    glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void PassClock::start() {
    names_.clear();
    marks_ = 0;
    mark();
}

void PassClock::lap(const std::string& name) {
    names_.push_back(name);
    mark();
}

void PassClock::mark() {
    const std::size_t index = marks_++;
    if (software_) {
        glFinish();
        wallTimes_.resize(marks_);
        wallTimes_[index] = std::chrono::steady_clock::now();
        return;
    }
    if (queries_.size() < marks_) {
        queries_.push_back(0);
        glCreateQueries(GL_TIMESTAMP, 1, &queries_.back());
    }
    glQueryCounter(queries_[index], GL_TIMESTAMP);
}

double PassClock::at(std::size_t index) {
    if (software_) return std::chrono::duration<double>(wallTimes_[index].time_since_epoch()).count();
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(queries_[index], GL_QUERY_RESULT, &nanoseconds);
    return static_cast<double>(nanoseconds) * 1.0e-9;
}

FrameTimes PassClock::times() {
    FrameTimes times;
    for (std::size_t i = 0; i < names_.size(); ++i)
        times.passes.push_back({names_[i], 1000.0 * (at(i + 1) - at(i))});
    times.frame = 1000.0 * (at(names_.size()) - at(0));
    return times;
}

std::vector<Result> measure(const std::vector<Subject>& subjects, const BenchScene& scene,
                            const BenchOptions& options) {
    std::vector<Samples> samples(subjects.size());
    for (const Subject& subject : subjects) Samples().add(subject);
    const Clock::time_point start = Clock::now();
    while (!isEnough(samples.front().frames.size(), 1.0e-3 * millisecondsSince(start), options))
        for (std::size_t i = 0; i < subjects.size(); ++i) samples[i].add(subjects[i]);
    std::vector<Result> results;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        results.push_back(medians(samples[i], scene));
        Result& result = results.back();
        result.technique = subjects[i].technique;
        result.shadows = subjects[i].shadows;
        result.samples = subjects[i].samples;
        result.width = options.width;
        result.height = options.height;
        subjects[i].program->count(result);
    }
    return results;
}

double allowedDifference(const std::string& technique, const BenchScene& scene) {
    if (!technique.starts_with("textbook")) return 1.0e-5;
    return 0.02 + 4.0 * std::sqrt(3.0) * positionRounding(scene) / shortestRange(scene);
}

void compareImages(Result& result, const std::vector<float>& rgb, const ReferenceImage& reference,
                   double allowed) {
    double total = 0.0, max = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const double expected = static_cast<double>(reference.rgb[i]);
        const double difference = std::abs(static_cast<double>(rgb[i]) - expected);
        total += difference;
        max = std::max(max, difference);
        sum += expected;
    }
    std::ostringstream text;
    if (const std::size_t invalid = nonFiniteCount(rgb); invalid > 0) {
        text << "its picture has " << invalid << " of " << rgb.size()
             << " values that are infinite or not a number";
        result.error = text.str();
        return;
    }
    // A black reference has no mean to divide by: the difference is absolute then.
    const auto count = static_cast<double>(rgb.size());
    const double scale = sum > 0.0 ? count / sum : 1.0;
    result.difference = Difference{reference.technique, scale * max, scale * total / count};
    if (result.difference->mean <= allowed) return;
    text << "its picture differs from that of " << reference.technique << " by " << result.difference->mean
         << " of the mean, " << allowed << " is allowed";
    result.error = text.str();
}
