#pragma once

#include "common/scene_options.h"

#include <candela/light.h>

/// What a light of `candela` gives in lumen by `candela::candelaFromLumen`: over the whole sphere, or for a
/// spot light over its cone. Not for a directional light.
float lumenOf(const candela::WorldLight& light, float candela);
/// The other way.
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

/// Makes a spot light's cone angles keep 0 <= inner < outer <= pi / 2, by changing the inner one.
void orderCones(candela::WorldLight& light);

/// The same scattering as --scatter-lights can say it: an intensity needs a range before it, and another seed
/// needs both. `sample` is one of the lights that were scattered so.
ScatterOptions spelledOut(ScatterOptions choice, const candela::WorldLight& sample);
