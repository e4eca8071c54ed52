#pragma once

#include <candela/color.h>

#include "color/baked_transform.h"
#include "color/display_shader.h"
#include "color/ocio.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace candela {

struct DisplayTransform::State {
    std::string source;  ///< The config's, for messages.
    DisplayOptions options;
    DisplayEncoding encoding;
    OCIO::ConstProcessorRcPtr processor;
    OCIO::ConstCPUProcessorRcPtr cpu;
    mutable std::once_flag shaderOnce;
    mutable DisplayShader shader;
    mutable std::once_flag bakedOnce;
    mutable std::optional<DisplayShader> baked;
    mutable std::once_flag stepsOnce;
    mutable std::shared_ptr<const OwnedDisplaySteps> steps;
};

// The rule for numbers outside the range of colours, on the CPU and in GLSL: before the transform, NaN
// becomes 0 and everything else is clamped to ±65504, the largest half float, at which every transform has
// reached its limit; negative colours (outside the working space's gamut) are kept. After it, NaN becomes 0
// and everything else is clamped to 0..1.

inline constexpr float maxRadiance = 65504.0f;

inline float clampFinite(float value, float min, float max) {
    return std::isnan(value) ? 0.0f : std::clamp(value, min, max);
}

inline float sanitizedRadiance(float value) {
    return clampFinite(value, -maxRadiance, maxRadiance);
}
inline float sanitizedCode(float value) {
    return clampFinite(value, 0.0f, 1.0f);
}

/// The same rule as the GLSL functions `vec3 sanitizedRadiance(vec3)` and `vec3 sanitizedCode(vec3)`.
inline std::string sanitizeGlsl() {
    // A test of the bits: compilers may take `x != x` for false, and clamp() of NaN is undefined.
    return R"(vec3 candelaClamp(vec3 value, float low, float high) {
    bvec3 isNan = greaterThan(floatBitsToUint(value) & 0x7fffffffu, uvec3(0x7f800000u));
    return mix(clamp(value, low, high), vec3(0.0), isNan);
}
vec3 sanitizedRadiance(vec3 value) { return candelaClamp(value, -65504.0, 65504.0); }
vec3 sanitizedCode(vec3 value) { return candelaClamp(value, 0.0, 1.0); }
)";
}

}  // namespace candela
