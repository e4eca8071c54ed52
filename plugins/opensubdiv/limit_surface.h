#pragma once

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <cstdint>
#include <memory>

#include "stencil_table.h"
#include "stencils.h"

namespace candela_opensubdiv {

/// A place on a face: a point of one of its patches, of which a face has one, or, cut into sub-faces, one a
/// corner; those are Far's ptex faces.
struct Place {
    std::uint32_t face, patch;
    double s, t;  ///< Parameters of the patch, 0 to 1.
};

/// The limit surface of a cage or of its texture coordinates, evaluated by Far in double precision; several
/// threads may do so at once.
///
/// Far refines the cage as a whole, near extraordinary and sharp places only, and closes what is left there
/// with Gregory patches. Regular patches are exact; Gregory patches are so at their corners. Therefore
///  - features are isolated to the level that is tessellated at least: all points of that level are then
///    corners of patches, or lie on regular ones;
///  - a semi-sharp feature lasts as many levels as its sharpness, rounded up, and what is left of it when
///    refinement ends would be taken for smooth: all features are isolated until nothing is left of it. Far
///    could stop earlier at smooth ones, but then the faces around a vertex with Chaikin creases do not
///    agree;
///  - infinitely sharp features are boundaries of patches, exact at each level.
///
/// OpenSubdiv's other evaluator, Bfr, looks at the surroundings of one face at a time. In version 3.5 that
/// gives other limits than uniform refinement, and not the same ones on both sides of an edge, for Chaikin
/// creases of unequal sharpness, and for texture coordinates where creases meet seams. Far agrees with
/// uniform refinement in all of these. (Where pages of a cage meet in an edge of three faces, and a crease of
/// one page ends there, Far's patches of the other pages do not know of it.)
class LimitSurface {
  public:
    /// `base` is not refined, and has to live as long. Positions and texture coordinates are refined apart:
    /// Far isolates less of the positions where it isolates for both.
    LimitSurface(const OpenSubdiv::Far::TopologyRefiner& base, std::uint32_t level, Primvar primvar);

    /// False for holes, and for faces at a boundary that is not interpolated.
    bool covers(std::uint32_t face) const;

    /// Sets `row` to the weights of the value at a covered place, and to those of both derivatives, along
    /// parameters that run over a whole edge.
    void evaluate(const Place& place, RowSum& row) const;

  private:
    using PatchTable = OpenSubdiv::Far::PatchTable;

    const PatchTable::PatchHandle* find(const Place& place) const;

    Primvar primvar_;
    OpenSubdiv::Far::PtexIndices ptexFaces_;
    std::unique_ptr<const PatchTable> patches_;
    std::unique_ptr<const OpenSubdiv::Far::PatchMap> map_;
    std::unique_ptr<const Stencils> stencils_;
};

}  // namespace candela_opensubdiv
