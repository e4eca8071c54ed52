#pragma once

namespace candela {

/// The farthest from the world's origin, in metres along an axis, at which meshes, lights and cameras may
/// stand. Squared distances then fit a float with much to spare.
constexpr float farthestCoordinate = 1e9f;

/// The greatest intensity of a light (candela or lux, times colour) and the greatest emission.
constexpr float maxIntensity = 1e20f;

/// How far the length of a direction may be from 1: what 8-bit quantised directions need
/// (KHR_mesh_quantization), sqrt(4) × 0.5 / 127 for four numbers, and a little.
constexpr float unitTolerance = 0.01f;

/// How far the sum of a vertex's joint weights may be from 1: what four weights of 8 bits each need,
/// 4 × 0.5 / 255, and a little. `poseCage` divides by the sum.
constexpr float weightSumTolerance = 0.01f;

/// The greatest value of an animation, and of a morph weight.
constexpr float maxAnimated = 1e9f;

}  // namespace candela
