#pragma once

#include <cstdint>

namespace candela {

// How the segments of a `CurveTable` lie: also for vector code, so plain numbers only.
//
// 128 segments per octave approximate a power function to a relative error of 1e-5; display curves are
// locally powers. That is more than 8 bits need, but a view's matrix subtracts channels from each other, and
// near black the display's curve amplifies the remaining error. On llvmpipe 32 segments per octave are no
// faster. `curveStart` is added to a number before its bits are taken, so that the segments below it have a
// constant length down to zero: 2^-31, over which the steepest of the displays' curves, gamma 2.6, rises by a
// fifteenth of a code.

constexpr float curveStart = 1.0f / 16777216.0f;
constexpr float curveEnd = 131072.0f;  ///< Twice the largest radiance.
constexpr int curveSegmentBits = 16;
constexpr std::int32_t curveStartBits = __builtin_bit_cast(std::int32_t, curveStart);  // Of a segment's start.
constexpr std::int32_t curveEndBits = __builtin_bit_cast(std::int32_t, curveEnd);
constexpr int curveSegments = (curveEndBits - curveStartBits) >> curveSegmentBits;
constexpr std::int32_t curveLastBits = curveStartBits + (curveSegments << curveSegmentBits) - 1;
constexpr std::int32_t curveSegmentMask = (1 << curveSegmentBits) - 1;

}  // namespace candela
