#include "panels/light_values.h"

#include "panels/split_color.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// The narrowest cone for which lumen are computed, in radians: those of a narrower one say nothing.
constexpr float narrowestCone = 1.0e-3f;

float candelaOfOneLumen(const candela::WorldLight& light) {
    if (light.type == candela::LightType::spot)
        return candela::candelaFromLumen(1.0f, std::max(light.outerConeAngle, narrowestCone));
    return candela::candelaFromLumen(1.0f);
}

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
    // Just less than the outer angle is a hard edge.
    constexpr float hardest = 0.999f;
    light.innerConeAngle = std::clamp(light.innerConeAngle, 0.0f, hardest * light.outerConeAngle);
}

ScatterOptions spelledOut(ScatterOptions choice, const candela::WorldLight& sample) {
    const bool sayCandela = choice.candela || choice.seed != ScatterOptions().seed;
    if (sayCandela && !choice.range) choice.range = sample.range;
    // Scattered colours have a greatest channel of 1.
    if (sayCandela && !choice.candela) choice.candela = splitColor(sample.intensity).strength;
    return choice;
}
