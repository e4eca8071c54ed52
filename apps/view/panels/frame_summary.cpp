#include "panels/frame_summary.h"

#include "common/timing.h"

#include <algorithm>
#include <cmath>

namespace {

std::vector<std::string> namesOfPasses(const std::deque<FrameRecord>& frames) {
    std::vector<std::string> names;
    for (const FrameRecord& frame : frames)
        for (const candela::PassTime& pass : frame.passes)
            if (std::ranges::find(names, pass.name) == names.end()) names.push_back(pass.name);
    return names;
}

/// A pass that ran more than once in a frame counts with all its times.
std::optional<double> timeOf(const FrameRecord& frame, const std::string& pass) {
    std::optional<double> sum;
    for (const candela::PassTime& one : frame.passes)
        if (one.name == pass) sum = sum.value_or(0.0) + one.milliseconds;
    return sum;
}

PassSummary summaryOf(const std::string& pass, const std::deque<FrameRecord>& frames) {
    std::vector<double> times;
    for (const FrameRecord& frame : frames)
        if (const auto time = timeOf(frame, pass)) times.push_back(*time);
    return {pass, timeOf(frames.back(), pass), median(times)};
}

}  // namespace

std::optional<FrameSummary> summarise(const std::deque<FrameRecord>& frames) {
    if (frames.empty()) return std::nullopt;
    FrameSummary summary;
    for (const std::string& pass : namesOfPasses(frames)) summary.passes.push_back(summaryOf(pass, frames));
    std::vector<double> times;
    for (const FrameRecord& frame : frames) times.push_back(frame.milliseconds);
    summary.last = times.back();
    summary.greatest = std::ranges::max(times);
    summary.median = median(std::move(times));
    return summary;
}

double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= value) return factor * power;
    return 10.0 * power;
}
