#pragma once

#include "drawing_test.h"

#include <candela/brdf.h>

#include <glm/vec3.hpp>

#include <span>
#include <vector>

namespace candela::test {

/// What a pixel should be, and by how much single precision may miss it.
struct ExpectedPixel {
    glm::dvec3 radiance{0.0};
    glm::dvec3 tolerance{0.0};
};

/// The picture that the double-precision evaluator makes of a frame's AOVs, rows from the top.
///
/// Tolerance: single precision holds each input of the equation to a few units in its last place (2^-24
/// relative), and no more can be asked of a pixel than that it be right for inputs so displaced. The light at a
/// pixel therefore may err by
///  - what it changes by when the surface is moved by `positionUnits` units of the coordinates' size along each
///    axis, and its normal is turned by `normalError` each way; this is what counts for sharp highlights and
///    for lights very near;
///  - `relativeError` of it for some 60 roundings on the way (each 6e-8) and for pow, of which OpenGL asks no
///    more than 16 units in the last place;
///  - `windowError` of it before the range window, where 1 - (d / range)^4 cancels;
///  - the change of a spot's factor when the cosine moves by `cosineError`.
std::vector<ExpectedPixel> evaluatedPicture(BrdfModel model, const AovReader& aovs, int width, int height,
                                            const glm::vec3& eye, std::span<const PlacedLight> lights);

/// The lights with ranges as the renderer assigns them by its default threshold.
std::vector<PlacedLight> withRanges(std::span<const PlacedLight> lights);

}  // namespace candela::test
