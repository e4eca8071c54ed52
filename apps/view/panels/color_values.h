#pragma once

#include <glm/vec3.hpp>

/// A colour split into hue and strength, for editing.
struct SplitColor {
    glm::vec3 hue{1.0f};    ///< Its maximum channel is 1.
    float strength = 0.0f;  ///< 0 or more; the colour is hue × strength.

    glm::vec3 joined() const { return hue * strength; }
};

/// `color` has channels of 0 or more. Black keeps `hueOfBlack`, so that a light that was dimmed to nothing
/// comes back in its colour.
SplitColor splitColor(const glm::vec3& color, const glm::vec3& hueOfBlack = glm::vec3(1.0f));

/// The sRGB code values (0 to 1) of linear Rec.709, clamped to 0 to 1. Source: IEC 61966-2-1, 5.2.
glm::vec3 srgbFromLinear(const glm::vec3& linear);

/// Linear Rec.709 from sRGB code values of 0 to 1.
glm::vec3 linearFromSrgb(const glm::vec3& codes);

/// The temperatures between which `colorOfTemperature` is defined, in kelvin.
constexpr float minTemperature = 1667.0f;
constexpr float maxTemperature = 25000.0f;

/// The colour of a black body: linear Rec.709, its maximum channel 1, a channel below 0 (the reddest black
/// bodies lie outside of Rec.709) set to 0. `kelvin` is clamped to the two temperatures above. Source of the
/// chromaticity: Kim et al., "Design of advanced color temperature control system for HDTV applications",
/// Journal of the Korean Physical Society 41, 2002, a cubic spline of the Planckian locus in CIE 1931 x, y.
glm::vec3 colorOfTemperature(float kelvin);

/// The temperature whose colour comes nearest to `color` (linear Rec.709, 0 or more, not black), whatever its
/// brightness.
float nearestTemperature(const glm::vec3& color);
