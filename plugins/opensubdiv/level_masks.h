#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <cstddef>
#include <vector>

#include "sparse_rows.h"

namespace candela_opensubdiv {

/// What a surface interpolates.
enum class Primvar { position, uv };

/// What one step of refinement does: the points of each level as sums of those of the level before, and of
/// such points of their own level that are sums of the level before alone: the middles of faces, which may
/// have many corners. Points are counted through all levels; those of level 0 are the cage's and have empty
/// rows.
class LevelMasks {
  public:
    LevelMasks(const OpenSubdiv::Far::TopologyRefiner& refined, Primvar primvar);

    std::size_t levelCount() const { return firsts_.size() - 1; }
    /// The first point of a level; that of the level after the last is the count of all points.
    std::size_t first(std::size_t level) const { return firsts_[level]; }
    std::span<const SparseRows::Entry> of(std::size_t point) const { return masks_[point]; }

  private:
    class Builder;

    std::vector<std::size_t> firsts_;
    SparseRows masks_;
};

}  // namespace candela_opensubdiv
