#pragma once

#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <cstddef>
#include <span>
#include <vector>

#include "stencil_list.h"

namespace candela_plugins::opensubdiv {

/// What a surface interpolates.
enum class Primvar { position, uv };

/// The stencils of single refinement steps: the points of each level as sums of points of the level before,
/// and of face points of their own level, which are sums of the level before alone. Points are counted
/// through all levels; those of level 0 are the vertices of the cage and have empty stencils.
class LevelStencils {
  public:
    LevelStencils(const OpenSubdiv::Far::TopologyRefiner& refined, Primvar primvar);

    std::size_t levelCount() const { return firsts_.size() - 1; }
    /// The first point of a level; for the level after the last the number of all points.
    std::size_t first(std::size_t level) const { return firsts_[level]; }
    std::span<const StencilList::Entry> of(std::size_t point) const { return stencils_[point]; }

  private:
    class Builder;

    std::vector<std::size_t> firsts_;
    StencilList stencils_;
};

/// All control points of a patch table as sums of the vertices of the cage: the vertices themselves, the
/// points of each level of refinement, and the local points of patches. Far makes such a table too, but
/// searches the stencil linearly for each index it adds, and multiplies long stencils by long stencils:
/// around a vertex of some hundred faces that takes minutes.
class PointStencils {
  public:
    PointStencils(const OpenSubdiv::Far::TopologyRefiner& refined, const OpenSubdiv::Far::PatchTable& patches,
                  Primvar primvar);

    std::span<const StencilList::Entry> of(int point) const {
        return stencils_[static_cast<std::size_t>(point)];
    }

  private:
    void addRefinedPoints(const LevelStencils& levels);
    void addRefinedPoint(const LevelStencils& levels, std::size_t point, StencilSum<double>& sum);
    void addPatchPoints(const LevelStencils& levels, const OpenSubdiv::Far::StencilTableReal<double>& points);

    StencilList stencils_;
};

}  // namespace candela_plugins::opensubdiv
