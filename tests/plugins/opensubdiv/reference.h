#pragma once

#include "refining.h"

#include <candela/cage.h>

#include <vector>

namespace candela {

/// The weights of all points of a cage, or all of its texture coordinates, for one place.
struct ReferenceRow {
    std::vector<double> value, du, dv;  ///< Derivatives along parameters that run over a whole edge.
};

/// A row a grid vertex.
using ReferenceRows = std::vector<ReferenceRow>;

enum class Primvar { position, uv };

/// By Far in double precision: adaptive refinement, a patch table, and a limit stencil table at the ptex
/// coordinates of the vertices. Smooth features are isolated to the level, semi-sharp ones as long as they
/// last.
ReferenceRows farReference(const Cage& cage, std::uint32_t level, const std::vector<GridVertex>& vertices,
                           Primvar primvar);

/// By Bfr in double precision with the same levels.
ReferenceRows bfrReference(const Cage& cage, std::uint32_t level, const std::vector<GridVertex>& vertices,
                           Primvar primvar);

/// The levels until the last semi-sharp edge or vertex has become smooth.
int semiSharpLevels(const Cage& cage);

}  // namespace candela
