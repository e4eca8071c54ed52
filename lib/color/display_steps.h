#pragma once

#include <candela/color.h>

#include <cstddef>
#include <span>

namespace candela {

/// One step of a display transform on the CPU. Plain numbers only: vector code of every instruction set reads
/// it.
struct DisplayStep {
    enum class Kind {
        matrix,
        clamp,
        curves,      ///< Of each channel: a `CurveTable`.
        glowAndRed,  ///< Two steps of the ACES 1.0 output transforms; see aces_steps.h.
        darkToDim,
        other,  ///< OpenColorIO's.
    };
    Kind kind;
    float matrix[3][4] = {};       ///< Applied to (red, green, blue, 1).
    float low = 0.0f, high = 0.0f;  ///< Of `clamp`. NaN becomes `low`.
    const float* curves[3] = {};  ///< Segments of each channel: value and slope. `darkToDim` has one.
    const void* processor = nullptr;
    /// Replaces `count` colours.
    void (*apply)(const void* processor, float* red, float* green, float* blue, std::size_t count) = nullptr;
};

/// The steps that take exposed, sanitised radiance to code values, which are to be sanitised again. Curves are
/// tables where the whole is off by at most a quarter of an 8-bit code; where it is not, OpenColorIO's CPU
/// processor is the only step. Created once per transform, on the first call, from any thread; they live as
/// long as the transform.
std::span<const DisplayStep> displaySteps(const DisplayTransform& transform);

}  // namespace candela
