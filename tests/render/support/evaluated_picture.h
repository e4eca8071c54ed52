#pragma once

#include "support/drawing_test.h"

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
/// relative), and no more can be asked of a pixel than that it be right for inputs so displaced. The light of
/// each lamp may therefore err by the sum of
///  - its change when the surface moves by `positionUnits` units of its coordinates' size along each axis,
///  and
///    when its normal turns by `normalError`: what counts for sharp highlights and for lights very near;
///  - `relativeError` of it, for some 60 roundings on the way (6e-8 each) and for pow, of which OpenGL asks
///  no
///    more than 16 units in the last place;
///  - `windowError` of it before the range window, where 1 - (d / range)^4 cancels;
///  - the change of a spot's factor when the cosine moves by `cosineError`.
std::vector<ExpectedPixel> evaluatedPicture(BrdfModel model, const AovReader& aovs, int width, int height,
                                            const glm::vec3& eye, std::span<const WorldLight> lights);

/// The lights with ranges as the renderer assigns them by its default threshold.
std::vector<WorldLight> withRanges(std::span<const WorldLight> lights);

}  // namespace candela::test
