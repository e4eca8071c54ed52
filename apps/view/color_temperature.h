#pragma once

#include <glm/vec3.hpp>

/// The temperatures between which `colorOfTemperature` is defined, in kelvin.
constexpr float minTemperature = 1667.0f;
constexpr float maxTemperature = 25000.0f;

/// The colour of a black body: linear Rec.709, its greatest channel 1, a channel below 0 (the reddest black
/// bodies lie outside of Rec.709) made 0. `kelvin` is held between the two temperatures above. Source of the
/// chromaticity: Kim et al., "Design of advanced color temperature control system for HDTV applications",
/// Journal of the Korean Physical Society 41, 2002, a cubic spline of the Planckian locus in CIE 1931 x, y.
glm::vec3 colorOfTemperature(float kelvin);

/// The temperature whose colour comes nearest to `color` (linear Rec.709, 0 or more, not black), whatever its
/// brightness.
float nearestTemperature(const glm::vec3& color);
