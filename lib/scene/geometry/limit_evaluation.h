#pragma once

#include <candela/refined_cage.h>

namespace candela {

/// Throws `Error` (badInput) unless the tables and indices of `refined` are whole, its stencils read a cage
/// of `cagePoints` points, and those of its texture coordinates a cage of `cageUvs`. Reads every index.
void validateRefinedCage(const RefinedCage& refined, std::size_t cagePoints, std::size_t cageUvs);

/// `evaluateLimit` of a refined cage that has passed `validateRefinedCage`: checks only the sizes, so that a
/// cage that moves each frame costs no more than its evaluation.
void evaluateValidatedLimit(const RefinedCage& refined, std::span<const glm::vec3> cagePoints,
                            const LimitVertices& out);

}  // namespace candela
