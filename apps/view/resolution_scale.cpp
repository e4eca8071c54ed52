#include "resolution_scale.h"

namespace {

/// A picture that takes longer than this is drawn at a lower resolution while the camera moves.
constexpr double fluentMilliseconds = 50.0;
constexpr int maxDivisor = 4;
/// A hand that moves the camera pauses for less than this.
constexpr std::chrono::milliseconds rest{150};

}  // namespace

int ResolutionScale::divisor(Motion motion, Clock::time_point now) {
    if (motion == Motion::rests) {
        if (now - lastMotion_ >= rest) divisor_ = 1;
        return divisor_;
    }
    lastMotion_ = now;
    divisor_ = 1;
    while (divisor_ < maxDivisor && fullMilliseconds_ / (divisor_ * divisor_) > fluentMilliseconds)
        divisor_ *= 2;
    return divisor_;
}
