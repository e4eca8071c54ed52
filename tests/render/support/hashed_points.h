#pragma once

#include "support/procedural_scene.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace candela::test {

// Numbers that depend on `seed` and `index` alone, as those of `hashed`.

inline float hashedBetween(float low, float high, std::uint32_t seed, std::uint32_t index) {
    return low + (high - low) * hashed(seed, index);
}

/// In a cube of 2 m around the origin; uses the numbers of `seed` to `seed + 2`.
inline glm::vec3 hashedPoint(std::uint32_t seed, std::uint32_t index) {
    return glm::vec3(hashed(seed, index), hashed(seed + 1, index), hashed(seed + 2, index)) * 2.0f - 1.0f;
}

}  // namespace candela::test
