#include "numbering.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace candela_plugins::opensubdiv {

Sectors::Sectors(const CheckedCage& cage, const OpenSubdiv::Far::TopologyRefiner& topology)
    : cage_(cage),
      base_(topology.GetLevel(0)),
      joinedEdges_(static_cast<std::size_t>(base_.GetNumEdges()), false),
      parents_(cage.faceVertices.size()) {
    std::iota(parents_.begin(), parents_.end(), 0u);
    if (cage.scheme == CANDELA_SCHEME_BILINEAR) return;
    for (int edge = 0; edge < base_.GetNumEdges(); ++edge) {
        joinedEdges_[static_cast<std::size_t>(edge)] = isJoined(edge);
    }
    joinCorners();
}

Sectors::EdgeSide Sectors::side(int edge, int which) const {
    const auto face = static_cast<std::uint32_t>(base_.GetEdgeFaces(edge)[which]);
    const std::uint32_t local = base_.GetEdgeFaceLocalIndices(edge)[which];
    const std::uint32_t start = cage_.faceStarts[face];
    const std::uint32_t here = start + local;
    const std::uint32_t next = start + (local + 1) % cage_.faceSizes[face];
    const auto first = static_cast<std::uint32_t>(base_.GetEdgeVertices(edge)[0]);
    return cage_.faceVertices[here] == first ? EdgeSide{{here, next}} : EdgeSide{{next, here}};
}

bool Sectors::hasSharedUvs(const EdgeSide& a, const EdgeSide& b) const {
    if (cage_.uvCount == 0) return true;
    return cage_.faceUvs[a.corners[0]] == cage_.faceUvs[b.corners[0]] &&
           cage_.faceUvs[a.corners[1]] == cage_.faceUvs[b.corners[1]];
}

bool Sectors::isJoined(int edge) const {
    if (base_.IsEdgeInfSharp(edge) || base_.IsEdgeNonManifold(edge)) return false;
    if (base_.GetEdgeFaces(edge).size() != 2) return false;
    return hasSharedUvs(side(edge, 0), side(edge, 1));
}

std::vector<bool> Sectors::cornerVertices() const {
    std::vector<bool> corner;
    corner.reserve(static_cast<std::size_t>(base_.GetNumVertices()));
    for (int vertex = 0; vertex < base_.GetNumVertices(); ++vertex) {
        const auto edges = base_.GetVertexEdges(vertex);
        const auto sharpEdges = std::count_if(edges.begin(), edges.end(),
                                              [this](int edge) { return base_.IsEdgeInfSharp(edge); });
        corner.push_back(base_.IsVertexInfSharp(vertex) || sharpEdges > 2);
    }
    return corner;
}

void Sectors::joinCorners() {
    const std::vector<bool> corner = cornerVertices();
    for (int edge = 0; edge < base_.GetNumEdges(); ++edge) {
        if (!joined(edge)) continue;
        const EdgeSide a = side(edge, 0);
        const EdgeSide b = side(edge, 1);
        for (int end = 0; end < 2; ++end) {
            if (corner[static_cast<std::size_t>(base_.GetEdgeVertices(edge)[end])]) continue;
            const std::uint32_t rootA = root(a.corners[end]);
            const std::uint32_t rootB = root(b.corners[end]);
            parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
        }
    }
    // A parent comes before its children, so its root is final when they read it.
    for (std::uint32_t& parent : parents_) parent = parents_[parent];
}

std::uint32_t Sectors::root(std::uint32_t corner) {
    while (parents_[corner] != corner) {
        parents_[corner] = parents_[parents_[corner]];
        corner = parents_[corner];
    }
    return corner;
}

namespace {

namespace Far = OpenSubdiv::Far;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

/// Assigns the indices, face by face.
class VertexNumbering::Assigner {
  public:
    Assigner(VertexNumbering& numbering, const Far::TopologyLevel& base, const Sectors& sectors)
        : numbering_(numbering),
          base_(base),
          sectors_(sectors),
          pointAt_(static_cast<std::size_t>(base.GetNumVertices()), none),
          pointsIn_(static_cast<std::size_t>(base.GetNumEdges()), none),
          sectorVertex_(numbering.corners_.size(), none) {}

    void addPoints(std::uint32_t face) {
        eachCorner(face, [this](Corner& corner, std::uint32_t sector, std::size_t vertex, int) {
            if (pointAt_[vertex] != none) return;
            pointAt_[vertex] = takePoints(1);
            sectorVertex_[sector] = pointAt_[vertex];
            corner.vertexRole = Role::ownsPoint;
        });
        eachCorner(face, [this, face](Corner& corner, std::uint32_t, std::size_t, int edge) {
            std::uint32_t& points = pointsIn_[static_cast<std::size_t>(edge)];
            if (points != none) return;
            points = takePoints(grid(face).edgeSlots());
            corner.edgeRole = Role::ownsPoint;
        });
        numbering_.insides_[face].points = takePoints(grid(face).innerPoints());
    }

    /// After all points have been added.
    void addSeamVertices(std::uint32_t face) {
        eachCorner(face, [this](Corner& corner, std::uint32_t sector, std::size_t vertex, int) {
            if (sectorVertex_[sector] == none) {
                sectorVertex_[sector] = addSeamVertex(pointAt_[vertex]);
                corner.vertexRole = Role::ownsSeamVertex;
            }
            corner.vertex = sectorVertex_[sector];
        });
        eachCorner(face, [this, face](Corner& corner, std::uint32_t, std::size_t vertex, int edge) {
            const std::uint32_t points = pointsIn_[static_cast<std::size_t>(edge)];
            corner.edgeReversed = static_cast<std::size_t>(base_.GetEdgeVertices(edge)[0]) != vertex;
            corner.edgeVertices = points;
            if (corner.edgeRole == Role::ownsPoint || sectors_.joined(edge)) return;
            corner.edgeVertices = numbering_.vertexCount();
            corner.edgeRole = Role::ownsSeamVertex;
            for (std::uint32_t i = 0; i < grid(face).edgeSlots(); ++i) addSeamVertex(points + i);
        });
        addExtraSlots(face);
    }

  private:
    const FaceGrid& grid(std::uint32_t face) const {
        return numbering_.grids_.of(numbering_.cage_.faceSizes[face]);
    }

    /// Calls `function` with the corners of a face, their sectors, vertices, and the edges that begin there.
    template <typename Function>
    void eachCorner(std::uint32_t face, Function function) {
        const auto vertices = base_.GetFaceVertices(static_cast<int>(face));
        const auto edges = base_.GetFaceEdges(static_cast<int>(face));
        const std::uint32_t start = numbering_.cage_.faceStarts[face];
        for (int i = 0; i < vertices.size(); ++i) {
            const std::uint32_t corner = start + static_cast<std::uint32_t>(i);
            function(numbering_.corners_[corner], sectors_.at(corner), static_cast<std::size_t>(vertices[i]),
                     edges[i]);
        }
    }

    std::uint32_t takePoints(std::uint32_t count) {
        const std::uint32_t first = numbering_.pointCount_;
        numbering_.pointCount_ += count;
        return first;
    }

    std::uint32_t addSeamVertex(std::uint32_t point) {
        numbering_.seamPoints_.push_back(point);
        return numbering_.vertexCount() - 1;
    }

    void addExtraSlots(std::uint32_t face) {
        const FaceGrid& faceGrid = grid(face);
        if (faceGrid.extraSlots() == 0) return;
        std::vector<std::uint32_t> vertices;
        numbering_.verticesOf(face, vertices);
        numbering_.insides_[face].seamVertices = numbering_.vertexCount();
        for (std::uint32_t slot = faceGrid.pointCount; slot < faceGrid.slots.size(); ++slot) {
            const std::uint32_t vertex = vertices[faceGrid.slots[slot].point];
            addSeamVertex(vertex < numbering_.pointCount_
                              ? vertex
                              : numbering_.seamPoints_[vertex - numbering_.pointCount_]);
        }
    }

    VertexNumbering& numbering_;
    const Far::TopologyLevel& base_;
    const Sectors& sectors_;
    std::vector<std::uint32_t> pointAt_;       ///< Of each cage vertex.
    std::vector<std::uint32_t> pointsIn_;      ///< Of each edge, the first one.
    std::vector<std::uint32_t> sectorVertex_;  ///< Of each sector.
};

VertexNumbering::VertexNumbering(const CheckedCage& cage, const Far::TopologyRefiner& topology,
                                 const Sectors& sectors, const LimitSurface& surface, const FaceGrids& grids)
    : cage_(cage), grids_(grids), corners_(cage.faceVertices.size()), insides_(cage.faceCount()) {
    for (std::uint32_t face = 0; face < cage.faceCount(); ++face) {
        if (surface.covers(face)) faces_.push_back(face);
    }
    Assigner assigner(*this, topology.GetLevel(0), sectors);
    for (const std::uint32_t face : faces_) assigner.addPoints(face);
    for (const std::uint32_t face : faces_) assigner.addSeamVertices(face);
}

void VertexNumbering::verticesOf(std::uint32_t face, std::vector<std::uint32_t>& vertices) const {
    const FaceGrid& grid = grids_.of(cage_.faceSizes[face]);
    const Corner* const corners = &corners_[cage_.faceStarts[face]];
    const std::uint32_t last = grid.edgeSlots() - 1;
    vertices.clear();
    for (std::uint32_t i = 0; i < grid.size; ++i) vertices.push_back(corners[i].vertex);
    for (std::uint32_t i = 0; i < grid.size; ++i) {
        for (std::uint32_t k = 0; k <= last; ++k) {
            vertices.push_back(corners[i].edgeVertices + (corners[i].edgeReversed ? last - k : k));
        }
    }
    for (std::uint32_t k = 0; k < grid.innerPoints(); ++k) vertices.push_back(insides_[face].points + k);
    for (std::uint32_t k = 0; k < grid.extraSlots(); ++k) vertices.push_back(insides_[face].seamVertices + k);
}

void VertexNumbering::ownPoints(std::uint32_t face, std::vector<std::uint32_t>& slots) const {
    const FaceGrid& grid = grids_.of(cage_.faceSizes[face]);
    ownSlots(face, Role::ownsPoint, slots);
    for (std::uint32_t k = 0; k < grid.innerPoints(); ++k) slots.push_back(grid.firstInnerSlot() + k);
}

void VertexNumbering::ownSeamVertices(std::uint32_t face, std::vector<std::uint32_t>& slots) const {
    const FaceGrid& grid = grids_.of(cage_.faceSizes[face]);
    ownSlots(face, Role::ownsSeamVertex, slots);
    for (std::uint32_t k = 0; k < grid.extraSlots(); ++k) slots.push_back(grid.pointCount + k);
}

void VertexNumbering::ownSlots(std::uint32_t face, Role role, std::vector<std::uint32_t>& slots) const {
    const FaceGrid& grid = grids_.of(cage_.faceSizes[face]);
    const Corner* const corners = &corners_[cage_.faceStarts[face]];
    const std::uint32_t last = grid.edgeSlots() - 1;
    slots.clear();
    for (std::uint32_t i = 0; i < grid.size; ++i) {
        if (corners[i].vertexRole == role) slots.push_back(i);
    }
    for (std::uint32_t i = 0; i < grid.size; ++i) {
        if (corners[i].edgeRole != role) continue;
        for (std::uint32_t k = 0; k <= last; ++k) {
            slots.push_back(grid.firstEdgeSlot(i) + (corners[i].edgeReversed ? last - k : k));
        }
    }
}

}  // namespace candela_plugins::opensubdiv
