#pragma once

#include <candela/light.h>

#include <span>
#include <vector>

/// Every point and spot light circles its resting place, each at a phase of its own.
struct LightMotion {
    bool moving = false;
    float radius = 0.5f;  ///< Metres.
    float speed = 0.25f;  ///< Turns a second.
};

/// The lights as they stand at `seconds`.
void moveLights(std::span<const candela::WorldLight> resting, const LightMotion& motion, double seconds,
                std::vector<candela::WorldLight>& moved);
