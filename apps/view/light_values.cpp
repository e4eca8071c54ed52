#include "light_values.h"

#include "panels/color_values.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

/// The minimum cone angle that lumen are computed for, in radians.
constexpr float minConeAngle = 1.0e-3f;

float candelaOfOneLumen(const candela::WorldLight& light) {
    if (light.type == candela::LightType::spot)
        return candela::candelaFromLumen(1.0f, std::max(light.outerConeAngle, minConeAngle));
    return candela::candelaFromLumen(1.0f);
}

/// Multiples of the golden ratio are equidistributed modulo 1 (Weyl, 1916), for any number of lights.
constexpr double phaseStep = 0.6180339887498949;

}  // namespace

float lumenOf(const candela::WorldLight& light, float candela) {
    return candela / candelaOfOneLumen(light);
}

float candelaOf(const candela::WorldLight& light, float lumen) {
    return lumen * candelaOfOneLumen(light);
}

DirectionAngles anglesOf(const glm::vec3& direction) {
    const float level = std::hypot(direction.x, direction.z);
    return {glm::degrees(std::atan2(direction.x, -direction.z)),
            glm::degrees(std::atan2(direction.y, level))};
}

glm::vec3 directionOf(const DirectionAngles& angles) {
    const float heading = glm::radians(angles.heading), height = glm::radians(angles.height);
    return {std::cos(height) * std::sin(heading), std::sin(height), -std::cos(height) * std::cos(heading)};
}

void orderCones(candela::WorldLight& light) {
    // The maximum ratio: a hard edge.
    constexpr float maxRatio = 0.999f;
    light.innerConeAngle = std::clamp(light.innerConeAngle, 0.0f, maxRatio * light.outerConeAngle);
}

candela::LightScatter completed(candela::LightScatter scatter, const candela::WorldLight& sample) {
    const bool needsCandela = scatter.candela || scatter.seed != candela::LightScatter().seed;
    if (needsCandela && !scatter.range) scatter.range = sample.range;
    // Scattered colours have a maximum channel of 1.
    if (needsCandela && !scatter.candela) scatter.candela = splitColor(sample.intensity).strength;
    return scatter;
}

void moveLights(std::span<const candela::WorldLight> resting, const LightMotion& motion, double seconds,
                std::vector<candela::WorldLight>& moved) {
    moved.assign(resting.begin(), resting.end());
    if (!motion.moving) return;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (moved[i].type == candela::LightType::directional) continue;
        const double revolutions = seconds * motion.speed + static_cast<double>(i) * phaseStep;
        const double angle = 2.0 * std::numbers::pi * (revolutions - std::floor(revolutions));
        moved[i].position.x += motion.radius * static_cast<float>(std::cos(angle));
        moved[i].position.z += motion.radius * static_cast<float>(std::sin(angle));
    }
}
