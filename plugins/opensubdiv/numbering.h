#pragma once

#include <cstdint>
#include <vector>

#include "face_grid.h"
#include "limit_surface.h"
#include "sectors.h"

namespace candela_opensubdiv {

/// The numbers of all vertices to draw, and which face makes the rows of which. First come the points: a cage
/// vertex in use, those within an edge, and those inside a face are each one, whatever faces share them. They
/// are numbered in the order of the faces that own them: the first one that has them. The twins follow in
/// the same manner, each owned by the first face of its sector. So a row is made once, which makes all faces
/// agree on it bit for bit, and the rows that a face makes stand together.
class Numbering {
  public:
    /// `topology` and `sectors` are those of the cage.
    Numbering(const GivenCage& cage, const OpenSubdiv::Far::TopologyRefiner& topology, const Sectors& sectors,
              const LimitSurface& surface, const FaceGrids& grids);

    std::uint32_t pointCount() const { return pointCount_; }
    std::uint32_t vertexCount() const { return pointCount_ + static_cast<std::uint32_t>(seamPoints_.size()); }
    /// The point of each twin, which come after the points.
    const std::vector<std::uint32_t>& seamPoints() const { return seamPoints_; }
    /// The faces that have a surface, in order.
    const std::vector<std::uint32_t>& faces() const { return faces_; }

    /// The vertex of each slot of a face.
    void verticesOf(std::uint32_t face, std::vector<std::uint32_t>& vertices) const;

    /// The slots whose rows a face makes, in the order of their vertices.
    void ownPoints(std::uint32_t face, std::vector<std::uint32_t>& slots) const;
    void ownSeamVertices(std::uint32_t face, std::vector<std::uint32_t>& slots) const;

  private:
    enum class Role : std::uint8_t { borrows, ownsPoint, ownsSeamVertex };

    /// What a face has at a corner and within the edge that begins there.
    struct Corner {
        std::uint32_t vertex;
        std::uint32_t edgeVertices;  ///< The first one in the direction of the edge.
        Role vertexRole, edgeRole;
        bool edgeReversed;  ///< The face runs against that direction.
    };

    struct Inside {
        std::uint32_t points;  ///< The first one.
        std::uint32_t twins;   ///< The first one, of the slots that are no points.
    };

    class Assigner;

    void ownSlots(std::uint32_t face, Role role, std::vector<std::uint32_t>& slots) const;

    const GivenCage& cage_;
    const FaceGrids& grids_;
    std::uint32_t pointCount_ = 0;
    std::vector<std::uint32_t> seamPoints_;
    std::vector<std::uint32_t> faces_;
    std::vector<Corner> corners_;  ///< One a corner of the cage.
    std::vector<Inside> insides_;  ///< One a face of the cage.
};

}  // namespace candela_opensubdiv
