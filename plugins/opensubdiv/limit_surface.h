#pragma once

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTable.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/topologyRefiner.h>

#include <cstdint>
#include <memory>

#include "stencil_list.h"
#include "stencils.h"

namespace candela_plugins::opensubdiv {

/// A place on a face: a point of one of its patches. A face has one patch, or one for each corner where it is
/// cut into sub-faces. A patch is a ptex face of Far.
struct Place {
    std::uint32_t face, patch;
    double s, t;  ///< Parameters of the patch, 0 to 1.
};

/// The limit surface of a cage or of its texture coordinates, evaluated by Far in double precision. It may be
/// evaluated on several threads at once.
///
/// Far refines the cage adaptively near extraordinary and sharp features, and covers what is left there with
/// Gregory patches. Regular patches are exact; Gregory patches are so at their corners. Therefore
///  - features are isolated at least to the level of the tessellation: all points of that level are then
///    corners of patches, or lie on regular ones;
///  - a semi-sharp feature lasts as many levels as its sharpness, rounded up, and the patches ignore the
///    sharpness that is left when refinement ends: all features are isolated until none is left. Far could
///    stop earlier at smooth features, but then the faces around a vertex with Chaikin creases differ;
///  - infinitely sharp features are boundaries of patches, exact at each level.
///
/// OpenSubdiv's other evaluator, Bfr, evaluates one face with its neighbourhood at a time. In version 3.5 its
/// limits differ from uniform refinement, and between the two sides of an edge, for Chaikin
/// creases of unequal sharpness, and for texture coordinates where creases meet seams. Far agrees with
/// uniform refinement in all of these. (Where sheets of a cage meet in an edge of three faces, and a crease
/// of one sheet ends there, Far's patches of the other sheets ignore it.)
class LimitSurface {
  public:
    /// `base` is not refined, and has to live as long. Positions and texture coordinates are refined
    /// separately: Far isolates fewer features of the positions when it isolates for both.
    LimitSurface(const OpenSubdiv::Far::TopologyRefiner& base, std::uint32_t level, Primvar primvar);

    /// False for holes, and for faces at a boundary that is not interpolated.
    bool covers(std::uint32_t face) const;

    /// Sets `stencil` to the weights of the value at a covered place and of its derivatives, along parameters
    /// that run from 0 to 1 over an edge.
    void evaluate(const Place& place, LimitStencil& stencil) const;

  private:
    using PatchTable = OpenSubdiv::Far::PatchTable;

    const PatchTable::PatchHandle* find(const Place& place) const;

    Primvar primvar_;
    OpenSubdiv::Far::PtexIndices ptexFaces_;
    std::unique_ptr<const PatchTable> patches_;
    std::unique_ptr<const OpenSubdiv::Far::PatchMap> map_;
    std::unique_ptr<const PointStencils> stencils_;
};

}  // namespace candela_plugins::opensubdiv
