#pragma once

#include "plugin_refinement.h"

#include <candela/cage.h>

#include <vector>

namespace candela {

/// The weights of all points of a cage, or of all its texture coordinates, at one location.
struct ReferenceStencil {
    std::vector<double> value, du, dv;  ///< Derivatives along parameters that run over a whole edge.
};

/// One stencil per grid vertex.
using ReferenceStencils = std::vector<ReferenceStencil>;

enum class Primvar { position, uv };

/// Evaluated by Far in double precision: adaptive refinement, a patch table, and a limit stencil table at the
/// ptex coordinates of the vertices. Smooth features are isolated to the level, semi-sharp ones until they
/// are smooth.
ReferenceStencils farReference(const Cage& cage, std::uint32_t level, const std::vector<GridVertex>& vertices,
                               Primvar primvar);

/// Evaluated by Bfr in double precision with the same isolation levels.
ReferenceStencils bfrReference(const Cage& cage, std::uint32_t level, const std::vector<GridVertex>& vertices,
                               Primvar primvar);

/// The levels until the last semi-sharp edge or vertex has become smooth.
int semiSharpLevels(const Cage& cage);

}  // namespace candela
