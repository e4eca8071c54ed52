#pragma once

#include <candela/gpu_scene.h>

#include <cstdint>
#include <optional>

namespace candela {

/// How many vertices, edges and faces a cage has, and corners of its faces.
struct CageSize {
    std::uint64_t vertices = 0, edges = 0, faces = 0, corners = 0;
};

/// The distinct points that uniform refinement to `level` (1 or more) gives: each edge and, but for Loop's
/// scheme, each face adds one a level. Twins are not counted, and faces that holes and boundaries leave out
/// are.
std::uint64_t refinedPoints(SubdivisionScheme scheme, const CageSize& size, std::uint32_t level);

/// The greatest level that `settings` allow a cage whose level follows its size on the screen, 1 or more.
std::uint32_t maxLevel(SubdivisionScheme scheme, const CageSize& size, const SubdivisionSettings& settings);

/// The level at which edges of `longestEdge` pixels are no longer than `edgePixels`, as a real number.
float idealLevel(float longestEdge, float edgePixels);

/// The level that follows `current` (none at first) where `ideal` is asked for: `ideal` rounded up, from 1 to
/// `greatest`. A level is left only when `ideal` is a quarter beyond what it serves (level - 1 to level), so
/// that a small motion to and fro changes it once at most.
std::uint32_t nextLevel(std::optional<std::uint32_t> current, float ideal, std::uint32_t greatest);

/// Throws `Error` (badInput) naming the setting that is out of its range.
void checkSettings(const SubdivisionSettings& settings);

}  // namespace candela
