#include "scene/model/light_range.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela {

namespace {

/// A light as seen from anywhere in the region.
struct LightDistances {
    double intensity;
    double min2,
        max2;  ///< Squared distances to the nearest and the farthest point of the region, square metres.
};

LightDistances distances(const RangelessLight& light, const Bounds& region) {
    const glm::dvec3 position(light.position), low(region.min), high(region.max);
    const glm::dvec3 nearest = glm::clamp(position, low, high) - position;
    const glm::dvec3 farthest = glm::max(glm::abs(position - low), glm::abs(position - high));
    return {light.intensity, glm::dot(nearest, nearest), glm::dot(farthest, farthest)};
}

/// The maximum that a light which ends at `irradiance` loses at a point of the region. At distance d that is
/// irradiance² d² / I within the range r, as the window takes (d / r)^4 of I / d², and I / d² beyond it: it
/// rises up to the range and falls from there on.
double maxLossOf(const LightDistances& light, double irradiance) {
    const double range2 = light.intensity / irradiance;
    if (range2 >= light.max2) return irradiance * irradiance * light.max2 / light.intensity;
    return range2 > light.min2 ? irradiance : light.intensity / light.min2;
}

double sumOfLosses(std::span<const LightDistances> lights, double irradiance) {
    double sum = 0.0;
    for (const LightDistances& light : lights) sum += maxLossOf(light, irradiance);
    return sum;
}

}  // namespace

double rangeIrradiance(std::span<const RangelessLight> lights, const Bounds& region, double maxLoss) {
    if (region.empty()) return 0.0;
    std::vector<LightDistances> seen;
    seen.reserve(lights.size());
    double minTotal = 0.0;  // A lower bound of what all lights give at any point.
    for (const RangelessLight& light : lights) {
        if (!(light.intensity > 0.0f)) continue;
        const LightDistances distance = distances(light, region);
        // A region that is the light's own point has no scale: any range loses nothing there.
        if (!(distance.max2 > 0.0)) continue;
        seen.push_back(distance);
        minTotal += distance.intensity / distance.max2;
    }
    if (seen.empty()) return 0.0;
    // Each light loses at most `irradiance`, so that the lower end always holds. At the upper end each light
    // loses at least what it gives at its farthest point, so that it never does.
    const double allowed = maxLoss * minTotal;
    double holds = std::log2(allowed / static_cast<double>(seen.size())), fails = std::log2(minTotal);
    constexpr double resolution = 1e-5;
    // Steps keep the ranges as they are while something moves a little.
    constexpr double stepsPerDoubling = 4.0;
    while (fails - holds > resolution) {
        const double middle = 0.5 * (holds + fails);
        (sumOfLosses(seen, std::exp2(middle)) <= allowed ? holds : fails) = middle;
    }
    return std::exp2(std::floor(holds * stepsPerDoubling) / stepsPerDoubling);
}

}  // namespace candela
