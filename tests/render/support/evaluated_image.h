#pragma once

#include "support/drawing_test.h"
#include "support/lobe_pixels.h"

#include <candela/brdf.h>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace candela::test {

/// The expected value of a pixel, and the tolerance of single precision.
struct ExpectedPixel {
    glm::dvec3 radiance{0.0};
    glm::dvec3 tolerance{0.0};
};

/// The image that the double-precision evaluator computes from a frame's AOVs, rows from the top.
///
/// Tolerance: single precision holds each input of the equation to a few units in its last place (2^-24
/// relative), so a pixel is right if it is right for inputs that are displaced by as much. The contribution
/// of each light may differ by the sum of
///  - its change when the surface moves by `positionUnits` units of its coordinates' size along each axis,
///  - its change when the normal rotates by `normalError`, which dominates in sharp highlights and close to
///    lights;
///  - `relativeError` of it, for about 60 roundings (6e-8 each) and for pow, which OpenGL requires to be
///    within 16 units in the last place;
///  - `windowError` of it before the range window, where 1 - (d / range)^4 cancels;
///  - the change of a spot's factor when the cosine moves by `cosineError`;
///  - `lobeError` of it on surfaces with further lobes: their sines, powers and albedos round more.
/// `lobes` is null where no material has further lobes.
std::vector<ExpectedPixel> evaluatedImage(BrdfModel model, const AovReader& aovs, int width, int height,
                                          const CameraView& view, std::span<const WorldLight> lights,
                                          const LobePixels* lobes = nullptr);

/// The lights, with the ranges that the renderer has assigned.
std::vector<WorldLight> withRanges(std::span<const WorldLight> lights, const LightReport& report);

}  // namespace candela::test
