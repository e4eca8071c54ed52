#include "color/aces_steps.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

bool isForward(const OCIO::ConstTransformRcPtr& step, OCIO::FixedFunctionStyle style) {
    const auto fixed = OCIO_DYNAMIC_POINTER_CAST<const OCIO::FixedFunctionTransform>(step);
    return fixed && fixed->getStyle() == style && fixed->getDirection() == OCIO::TRANSFORM_DIR_FORWARD;
}

}  // namespace

bool isGlowAndRed(const OCIO::ConstTransformRcPtr& first, const OCIO::ConstTransformRcPtr& second) {
    return isForward(first, OCIO::FIXED_FUNCTION_ACES_GLOW_10) &&
           isForward(second, OCIO::FIXED_FUNCTION_ACES_RED_MOD_10);
}

std::string glowAndRedGlsl() {
    // Source: Academy Color Encoding System, RRT.ctl and RRT_common.ctl, version 1.0. Notes on the form:
    // - The chroma is written as a sum of squares, which no rounding makes negative.
    // - The hue's weight is a cubic B-spline over ±67.5 degrees about red. (a, b) has the length 2 × chroma,
    //   so that b / (a + 2 chroma) is the tangent of half the hue. The polynomial maps it to the hue in units
    //   of 33.75 degrees, to 3e-5.
    return R"(vec3 candelaGlowAndRed(vec3 ap0) {
    vec3 apart = ap0.gbr - ap0;
    float chroma = sqrt(0.5 * dot(apart, apart));
    float maximum = max(ap0.r, max(ap0.g, ap0.b));
    float range = max(maximum, 1e-10) - max(min(ap0.r, min(ap0.g, ap0.b)), 1e-10);

    float x = 5.0 * (range / max(maximum, 1e-2)) - 2.0;
    float t = max(1.0 - 0.5 * abs(x), 0.0);
    float shape = x < 0.0 ? 0.5 * t * t : 1.0 - 0.5 * t * t;
    float brightness = (ap0.r + ap0.g + ap0.b + 1.75 * chroma) * (1.0 / 3.0);
    float glow = 1.0 + 0.05 * shape * max(0.08 / max(brightness, 0.16 / 3.0) - 0.5, 0.0);

    float a = 2.0 * ap0.r - ap0.g - ap0.b;
    float b = 1.7320508 * (ap0.g - ap0.b);
    float h = a > 0.0 ? min(abs(b) / (a + 2.0 * chroma), 0.66817864) : 0.66817864;
    float u = h * h;
    float hue = h * (3.3952436 + u * (-1.1272871 + u * (0.62583859 + u * -0.26444672)));
    float outer = max(2.0 - hue, 0.0), inner = max(1.0 - hue, 0.0);
    float weight = 0.25 * outer * outer * outer - inner * inner * inner;

    vec3 glowing = ap0 * glow;
    float saturation = glow * range / max(maximum * glow, 1e-2);
    glowing.r += 0.18 * weight * saturation * (0.03 - glowing.r);
    return glowing;
}
)";
}

bool isDarkToDim(const OCIO::ConstTransformRcPtr& step) {
    return isForward(step, OCIO::FIXED_FUNCTION_ACES_DARK_TO_DIM_10);
}

CurveTable darkToDimFactor() {
    return CurveTable([](std::span<CurveTable::Values> numbers) {
        for (CurveTable::Values& number : numbers) {
            const float factor = std::pow(std::max(number.red, 1e-10f), 0.9811f - 1.0f);
            number = {factor, factor, factor};
        }
    });
}

std::string darkToDimGlsl() {
    // Source: ODT_Common.ctl; the weights are the luminances of AP1's primaries.
    return R"(vec3 candelaDarkToDim(vec3 ap1, int factor) {
    return ap1 * candelaCurve(factor, dot(ap1, vec3(0.27222872, 0.67408177, 0.05368952)));
}
)";
}

}  // namespace candela
