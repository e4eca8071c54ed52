#pragma once

#include <candela/scene.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace candela::test {

// Scenes whose ambient occlusion is known. All surfaces are double-sided.

Material doubleSided(float grey);

glm::mat4 rotated(const glm::vec3& position, float degrees, const glm::vec3& axis);
/// A horizontal square that faces up.
glm::mat4 flatAt(const glm::vec3& position);

/// The floor y = 0 and the wall x = 0, which ends 5 m to all sides.
Scene floorAndWall(const Material& material);
/// The share of the hemisphere that is free at the distance `d` from a wall, where what is farther than
/// `distance` hides nothing. Directions are uniform in the unit disc below the hemisphere (Nusselt's analog).
/// A wall meets those whose coordinate towards it is over a = d / distance: a segment of the disc.
double freeBesideAWall(double d, double distance);

/// A cube from -1 to 1 m, seen from inside.
Scene closedRoom(const Material& material);

/// Rectangles that stand and float over a floor, and pass through it and each other.
Scene cardsOnAFloor(const Material& material);

}  // namespace candela::test
