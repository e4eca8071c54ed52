#pragma once

#include <candela/scene.h>

#include <glm/vec3.hpp>

#include <span>

namespace candela {

/// A point or spot light without a range.
struct RangelessLight {
    glm::vec3 position{0.0f};  ///< World, metres.
    float intensity = 0.0f;    ///< The largest channel, candela.
};

/// The irradiance, in lux, at which lights without a range may end: a light of I candela gets the range
/// sqrt(I / irradiance), and what all of them together then lose at any point of `region` is at most
/// `maxLoss` of the irradiance that they would give there (facing each of them). Within its range a light
/// loses what the window of KHR_lights_punctual takes. The result is the largest such irradiance by
/// bounds over `region`, rounded down to a quarter of a doubling; 0 without a light that gives any, or where
/// `region` is empty. `maxLoss` is over 0 and under 1.
double rangeIrradiance(std::span<const RangelessLight> lights, const Bounds& region, double maxLoss);

}  // namespace candela
