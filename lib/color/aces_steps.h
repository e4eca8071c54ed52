#pragma once

#include "color/curve_table.h"
#include "color/ocio.h"

#include <string>

namespace candela {

// Steps of the ACES 1.0 output transforms, optimised: the same formulas as OpenColorIO's fixed
// functions of these names, without the arc tangent and the selection among four vectors of coefficients.

/// Whether `first` and `second` are the glow and the red modifier, which share most of their terms.
bool isGlowAndRed(const OCIO::ConstTransformRcPtr& first, const OCIO::ConstTransformRcPtr& second);
/// The GLSL function `vec3 candelaGlowAndRed(vec3 ap0)`.
std::string glowAndRedGlsl();

/// Whether `step` is the correction for a dim surround.
bool isDarkToDim(const OCIO::ConstTransformRcPtr& step);
/// The factor of a colour, as a function of its luminance.
CurveTable darkToDimFactor();
/// The GLSL function `vec3 candelaDarkToDim(vec3 ap1, int factor)`, `factor` being the first texel of
/// `darkToDimFactor`. Needs `CurveTable::glsl`.
std::string darkToDimGlsl();

}  // namespace candela
