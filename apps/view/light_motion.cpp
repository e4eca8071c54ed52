#include "light_motion.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

/// Spreads phases evenly, however many lights there are: multiples of the golden ratio (Weyl, 1916).
constexpr double phaseStep = 0.6180339887498949;

}  // namespace

void moveLights(std::span<const candela::WorldLight> resting, const LightMotion& motion, double seconds,
                std::vector<candela::WorldLight>& moved) {
    moved.assign(resting.begin(), resting.end());
    if (!motion.moving) return;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (moved[i].type == candela::LightType::directional) continue;
        const double turns = seconds * motion.speed + static_cast<double>(i) * phaseStep;
        const double angle = 2.0 * std::numbers::pi * (turns - std::floor(turns));
        moved[i].position.x += motion.radius * static_cast<float>(std::cos(angle));
        moved[i].position.z += motion.radius * static_cast<float>(std::sin(angle));
    }
}
