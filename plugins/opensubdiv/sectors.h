#pragma once

#include <opensubdiv/far/topologyRefiner.h>

#include <cstdint>
#include <vector>

#include "given_cage.h"

namespace candela_opensubdiv {

/// Where the surface and its texture coordinates run on smoothly from face to face, so that the faces can
/// share vertices: a sector is a group of faces around a cage vertex that do.
///
/// Faces are not joined across a boundary, an infinitely sharp edge, an edge of more than two faces, a
/// texture seam, and with the bilinear scheme across none. Semi-sharp edges and vertices are smooth in the
/// limit, with both crease methods. At an infinitely sharp vertex, and where three or more infinitely sharp
/// edges meet, each face has a tangent plane of its own. A sharp edge that ends in a smooth vertex (a dart)
/// separates the faces along it, but not at that vertex: they are joined the other way round. Holes join like
/// other faces: the surface around them is the same with and without them.
class Sectors {
  public:
    Sectors(const GivenCage& cage, const OpenSubdiv::Far::TopologyRefiner& topology);

    /// Whether the two faces of an edge share the vertices within it.
    bool joined(int edge) const { return joinedEdges_[static_cast<std::size_t>(edge)]; }

    /// The sector of a corner of a face: a number below the count of corners, of which each sector has one.
    std::uint32_t at(std::uint32_t corner) const { return parents_[corner]; }

  private:
    /// A face at an edge: its corners at both ends of it.
    struct EdgeSide {
        std::uint32_t corners[2];  ///< In the order of the edge's vertices.
    };

    EdgeSide side(int edge, int which) const;
    bool hasSharedUvs(const EdgeSide& a, const EdgeSide& b) const;
    bool isJoined(int edge) const;
    std::vector<bool> pointedVertices() const;
    void joinCorners();
    std::uint32_t root(std::uint32_t corner);

    const GivenCage& cage_;
    const OpenSubdiv::Far::TopologyLevel& base_;
    std::vector<bool> joinedEdges_;
    std::vector<std::uint32_t> parents_;  ///< A forest while sectors grow, then the root of each corner.
};

}  // namespace candela_opensubdiv
