#pragma once

#include "interaction.h"

#include <chrono>

/// The divisor of the resolution: above 1 on a slow device while the camera moves, 1 once it rests.
class ResolutionScale {
  public:
    using Clock = std::chrono::steady_clock;

    /// What width and height of the next picture are to be divided by: 1, 2 or 4.
    int divisor(Motion motion, Clock::time_point now);
    /// The last picture, with the divisor asked for last, took this long.
    void tookMilliseconds(double milliseconds) { fullMilliseconds_ = milliseconds * divisor_ * divisor_; }
    /// Is the resolution reduced, so that another frame is due at rest?
    bool isReduced() const { return divisor_ > 1; }

  private:
    double fullMilliseconds_ = 0.0;  ///< Estimated time of a frame at full resolution.
    int divisor_ = 1;
    Clock::time_point lastMotion_{};
};
