#include "numbering.h"

#include <limits>

namespace candela_opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}  // namespace

/// Walks over the faces, and gives out numbers.
class Numbering::Assigner {
  public:
    Assigner(Numbering& numbering, const Far::TopologyLevel& base, const Sectors& sectors)
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
        numbering_.insides_[face].twins = numbering_.vertexCount();
        for (std::uint32_t slot = faceGrid.pointCount; slot < faceGrid.slots.size(); ++slot) {
            const std::uint32_t vertex = vertices[faceGrid.slots[slot].point];
            addSeamVertex(vertex < numbering_.pointCount_
                              ? vertex
                              : numbering_.seamPoints_[vertex - numbering_.pointCount_]);
        }
    }

    Numbering& numbering_;
    const Far::TopologyLevel& base_;
    const Sectors& sectors_;
    std::vector<std::uint32_t> pointAt_;       ///< Of each cage vertex.
    std::vector<std::uint32_t> pointsIn_;      ///< Of each edge, the first one.
    std::vector<std::uint32_t> sectorVertex_;  ///< Of each sector.
};

Numbering::Numbering(const GivenCage& cage, const Far::TopologyRefiner& topology, const Sectors& sectors,
                     const LimitSurface& surface, const FaceGrids& grids)
    : cage_(cage), grids_(grids), corners_(cage.faceVertices.size()), insides_(cage.faceCount()) {
    for (std::uint32_t face = 0; face < cage.faceCount(); ++face) {
        if (surface.covers(face)) faces_.push_back(face);
    }
    Assigner assigner(*this, topology.GetLevel(0), sectors);
    for (const std::uint32_t face : faces_) assigner.addPoints(face);
    for (const std::uint32_t face : faces_) assigner.addSeamVertices(face);
}

void Numbering::verticesOf(std::uint32_t face, std::vector<std::uint32_t>& vertices) const {
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
    for (std::uint32_t k = 0; k < grid.extraSlots(); ++k) vertices.push_back(insides_[face].twins + k);
}

void Numbering::ownPoints(std::uint32_t face, std::vector<std::uint32_t>& slots) const {
    const FaceGrid& grid = grids_.of(cage_.faceSizes[face]);
    ownSlots(face, Role::ownsPoint, slots);
    for (std::uint32_t k = 0; k < grid.innerPoints(); ++k) slots.push_back(grid.firstInnerSlot() + k);
}

void Numbering::ownSeamVertices(std::uint32_t face, std::vector<std::uint32_t>& slots) const {
    const FaceGrid& grid = grids_.of(cage_.faceSizes[face]);
    ownSlots(face, Role::ownsSeamVertex, slots);
    for (std::uint32_t k = 0; k < grid.extraSlots(); ++k) slots.push_back(grid.pointCount + k);
}

void Numbering::ownSlots(std::uint32_t face, Role role, std::vector<std::uint32_t>& slots) const {
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

}  // namespace candela_opensubdiv
