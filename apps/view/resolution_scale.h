#pragma once

#include "interaction.h"

#include <chrono>

/// How coarse the picture is drawn: on a slow device coarser while it moves, and sharp once it has rested.
class ResolutionScale {
  public:
    using Clock = std::chrono::steady_clock;

    /// What width and height of the next picture are to be divided by: 1, 2 or 4.
    int divisor(Motion motion, Clock::time_point now);
    /// The last picture, with the divisor asked for last, took this long.
    void tookMilliseconds(double milliseconds) { fullMilliseconds_ = milliseconds * divisor_ * divisor_; }
    /// Is the picture coarse, so that there is still something to do at rest?
    bool isReduced() const { return divisor_ > 1; }

  private:
    double fullMilliseconds_ = 0.0;  ///< About what a picture takes that is not coarse.
    int divisor_ = 1;
    Clock::time_point lastMotion_{};
};
