#pragma once

#include <candela/sampling.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace candela {

// The points of samples, mapped from `sampleCoordinate`. Sample 0 is (0, 0) and (0, 0, 0).

/// The offset from a pixel's centre, pixels to the right and up: -0.75 to 0.75, distributed as a
/// Blackman-Harris kernel of that width in each direction.
glm::dvec2 pixelOffset(std::uint32_t sample);

/// A point of the aperture, uniformly distributed: of the unit disc with 0 blades, else of the regular
/// polygon whose corners lie on the unit circle, one of them at (0, 1).
glm::dvec2 aperturePoint(std::uint32_t sample, std::uint32_t blades);

/// A point of the unit ball with the density 1 / sqrt(1 - r²), for the light of number `light`. From every
/// side its projection is uniformly distributed over the unit disc: docs/sampling.md.
glm::dvec3 lightPoint(std::uint32_t sample, std::uint32_t light);

}  // namespace candela
