#pragma once

#include <candela/cage.h>
#include <candela/refined_cage.h>

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// An edge's two vertices, the lesser first.
using CageEdge = std::array<std::uint32_t, 2>;

/// Every edge of the cage's faces once, in growing order.
std::vector<CageEdge> edgesOf(const Cage& cage);

/// Every edge of the refined faces once. Its ends are points, not twins: both sides of a seam share it.
std::vector<CageEdge> edgesOf(const RefinedCage& refined);

}  // namespace candela
