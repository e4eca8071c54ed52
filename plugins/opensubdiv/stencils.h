#pragma once

#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <span>

#include "level_masks.h"
#include "sparse_rows.h"

namespace candela_opensubdiv {

/// All points of a patch table, as sums of the cage's points: those of the cage, those of each level of
/// refinement, and those that patches have for themselves. Far makes such a table too, but searches a row for
/// each column it adds, and multiplies long rows with long rows: around a vertex of some hundred faces that
/// takes minutes.
class Stencils {
  public:
    Stencils(const OpenSubdiv::Far::TopologyRefiner& refined, const OpenSubdiv::Far::PatchTable& patches,
             Primvar primvar);

    std::span<const SparseRows::Entry> of(int point) const { return rows_[static_cast<std::size_t>(point)]; }

  private:
    void addRefinedPoints(const LevelMasks& masks);
    void addRefinedPoint(const LevelMasks& masks, std::size_t point, SparseSum<double>& sum);
    void addPatchPoints(const LevelMasks& masks, const OpenSubdiv::Far::StencilTableReal<double>& points);

    SparseRows rows_;
};

}  // namespace candela_opensubdiv
