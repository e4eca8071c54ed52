#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <cstdint>
#include <vector>

#include "cage.h"
#include "face_grid.h"
#include "limit_surface.h"

namespace candela_plugins::opensubdiv {

/// Where the surface and its texture coordinates are smooth across the edges between faces, so that the faces
/// can share vertices. A sector is a group of such faces around a vertex of the cage.
///
/// Faces are not joined across a boundary, an infinitely sharp edge, an edge of more than two faces or a
/// texture seam, and with the bilinear scheme across no edge. Semi-sharp edges and vertices are smooth in the
/// limit, with both crease methods. At an infinitely sharp vertex, and where three or more infinitely sharp
/// edges meet, each face has a separate tangent plane. A sharp edge that ends in a smooth vertex (a dart)
/// separates the faces along it, but not at that vertex, around which they are joined. Holes are joined like
/// other faces: they do not change the surface around them.
class Sectors {
  public:
    Sectors(const CheckedCage& cage, const OpenSubdiv::Far::TopologyRefiner& topology);

    /// Whether the two faces of an edge share the vertices within it.
    bool joined(int edge) const { return joinedEdges_[static_cast<std::size_t>(edge)]; }

    /// The sector of a corner of a face: a number below the number of corners, different for each sector.
    std::uint32_t at(std::uint32_t corner) const { return parents_[corner]; }

  private:
    /// A face at an edge: its corners at both ends of it.
    struct EdgeSide {
        std::uint32_t corners[2];  ///< In the order of the edge's vertices.
    };

    EdgeSide side(int edge, int which) const;
    bool hasSharedUvs(const EdgeSide& a, const EdgeSide& b) const;
    bool isJoined(int edge) const;
    std::vector<bool> cornerVertices() const;
    void joinCorners();
    std::uint32_t root(std::uint32_t corner);

    const CheckedCage& cage_;
    const OpenSubdiv::Far::TopologyLevel& base_;
    std::vector<bool> joinedEdges_;
    std::vector<std::uint32_t>
        parents_;  ///< Union-find: a forest while sectors are joined, then the root of each corner.
};

/// The indices of all vertices to draw, and the face that owns each of them. Points come first: at the
/// vertices of the cage in use, within its edges, and inside its faces, each once for all faces that share
/// it. They are in the order of the faces that own them: the first face that has them. Seam vertices follow
/// in the same order, each owned by the first face of its sector. A stencil is built once, by the owner: so
/// all faces share it bit for bit, and the stencils of a face are contiguous.
class VertexNumbering {
  public:
    /// `topology` and `sectors` are those of the cage.
    VertexNumbering(const CheckedCage& cage, const OpenSubdiv::Far::TopologyRefiner& topology,
                    const Sectors& sectors, const LimitSurface& surface, const FaceGrids& grids);

    std::uint32_t pointCount() const { return pointCount_; }
    std::uint32_t vertexCount() const { return pointCount_ + static_cast<std::uint32_t>(seamPoints_.size()); }
    /// The point of each seam vertex.
    const std::vector<std::uint32_t>& seamPoints() const { return seamPoints_; }
    /// The faces that have a surface, in order.
    const std::vector<std::uint32_t>& faces() const { return faces_; }

    /// The vertex of each slot of a face.
    void verticesOf(std::uint32_t face, std::vector<std::uint32_t>& vertices) const;

    /// The slots whose vertices a face owns, in the order of these vertices.
    void ownPoints(std::uint32_t face, std::vector<std::uint32_t>& slots) const;
    void ownSeamVertices(std::uint32_t face, std::vector<std::uint32_t>& slots) const;

  private:
    enum class Role : std::uint8_t { shares, ownsPoint, ownsSeamVertex };

    /// What a face has at a corner and within the edge that begins there.
    struct Corner {
        std::uint32_t vertex;
        std::uint32_t edgeVertices;  ///< The first one in the direction of the edge.
        Role vertexRole, edgeRole;
        bool edgeReversed;  ///< The face has the edge in the opposite direction.
    };

    struct Inside {
        std::uint32_t points;        ///< The first one.
        std::uint32_t seamVertices;  ///< The first one, of the slots behind the points.
    };

    class Assigner;

    void ownSlots(std::uint32_t face, Role role, std::vector<std::uint32_t>& slots) const;

    const CheckedCage& cage_;
    const FaceGrids& grids_;
    std::uint32_t pointCount_ = 0;
    std::vector<std::uint32_t> seamPoints_;
    std::vector<std::uint32_t> faces_;
    std::vector<Corner> corners_;  ///< One a corner of the cage.
    std::vector<Inside> insides_;  ///< One a face of the cage.
};

}  // namespace candela_plugins::opensubdiv
