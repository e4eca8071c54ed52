#pragma once

#include <candela/scene.h>

#include <cstdint>

/// The level that cages are measured at.
constexpr std::uint32_t benchLevel = 3;

/// A closed cage of 10,000 quads: the sides of a box, 50 × 50 × 25 quads, blown up to an ellipsoid, with the
/// box's eight corners as vertices of valence 3. Every vertex moves by a wave as time goes on.
candela::Cage makeBenchCage();

/// The points of the cage at `seconds`.
std::vector<glm::vec3> waved(const candela::Cage& cage, double seconds);

/// A scene with the cage alone, at the origin.
candela::Scene makeCageScene();
