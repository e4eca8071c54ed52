#pragma once

#include "common/scene_options.h"

#include <candela/light.h>

#include <span>
#include <vector>

/// What a light of `candela` gives in lumen by `candela::candelaFromLumen`: over the whole sphere, or for a
/// spot light over its cone. Not for a directional light.
float lumenOf(const candela::WorldLight& light, float candela);
/// The inverse of `lumenOf`.
float candelaOf(const candela::WorldLight& light, float lumen);

/// A direction as degrees.
struct DirectionAngles {
    float heading = 0.0f;  ///< About +Y, -180 to 180: 0 is along -Z, 90 along +X.
    float height = 0.0f;   ///< Over the horizon, -90 to 90.
};
/// Of a direction of unit length.
DirectionAngles anglesOf(const glm::vec3& direction);
/// Unit length.
glm::vec3 directionOf(const DirectionAngles& angles);

/// Clamps the inner cone angle, so that 0 <= inner < outer <= pi / 2.
void orderCones(candela::WorldLight& light);

/// Completes `scatter` for the syntax of --scatter-lights, where an intensity needs a range before it and a
/// seed needs both. `sample` is one of the lights that were scattered.
candela::LightScatter completed(candela::LightScatter scatter, const candela::WorldLight& sample);

/// Every point and spot light circles its rest position, each with its own phase.
struct LightMotion {
    bool moving = false;
    float radius = 0.5f;  ///< Metres.
    float speed = 0.25f;  ///< Revolutions a second.
};

/// Writes the lights as of `seconds` to `moved`.
void moveLights(std::span<const candela::WorldLight> resting, const LightMotion& motion, double seconds,
                std::vector<candela::WorldLight>& moved);
