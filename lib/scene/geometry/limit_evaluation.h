#pragma once

#include <candela/refined_cage.h>

namespace candela {

class ThreadPool;

/// `evaluateLimit` in the threads of `pool`, which the call has to itself. Their number does not change a bit
/// of what is written.
void evaluateLimit(const RefinedCage& refined, std::span<const glm::vec3> cagePoints,
                   const LimitVertices& out, ThreadPool& pool);

}  // namespace candela
