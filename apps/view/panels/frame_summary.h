#pragma once

#include "view_model.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

/// What one pass took, in milliseconds.
struct PassSummary {
    std::string name;
    std::optional<double> last;  ///< None: the last frame did not have it.
    double median = 0.0;         ///< Of the frames that had it.
};

/// What the stored frames took, in milliseconds.
struct FrameSummary {
    std::vector<PassSummary> passes;  ///< In the order in which the frames had them first.
    double last = 0.0, median = 0.0, greatest = 0.0;
};

/// None without a frame.
std::optional<FrameSummary> summarise(const std::deque<FrameRecord>& frames);

/// A round number that is not less than `value` (over 0): 1, 2 or 5 times a power of ten.
double roundedUp(double value);
