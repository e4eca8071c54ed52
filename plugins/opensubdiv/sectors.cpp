#include "sectors.h"

#include <algorithm>
#include <numeric>

namespace candela_opensubdiv {

Sectors::Sectors(const GivenCage& cage, const OpenSubdiv::Far::TopologyRefiner& topology)
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

std::vector<bool> Sectors::pointedVertices() const {
    std::vector<bool> pointed;
    pointed.reserve(static_cast<std::size_t>(base_.GetNumVertices()));
    for (int vertex = 0; vertex < base_.GetNumVertices(); ++vertex) {
        const auto edges = base_.GetVertexEdges(vertex);
        const auto sharpEdges = std::count_if(edges.begin(), edges.end(),
                                              [this](int edge) { return base_.IsEdgeInfSharp(edge); });
        pointed.push_back(base_.IsVertexInfSharp(vertex) || sharpEdges > 2);
    }
    return pointed;
}

void Sectors::joinCorners() {
    const std::vector<bool> pointed = pointedVertices();
    for (int edge = 0; edge < base_.GetNumEdges(); ++edge) {
        if (!joined(edge)) continue;
        const EdgeSide a = side(edge, 0);
        const EdgeSide b = side(edge, 1);
        for (int end = 0; end < 2; ++end) {
            if (pointed[static_cast<std::size_t>(base_.GetEdgeVertices(edge)[end])]) continue;
            const std::uint32_t rootA = root(a.corners[end]);
            const std::uint32_t rootB = root(b.corners[end]);
            parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
        }
    }
    // A parent comes before its children, so that its own root stands when they ask.
    for (std::uint32_t& parent : parents_) parent = parents_[parent];
}

std::uint32_t Sectors::root(std::uint32_t corner) {
    while (parents_[corner] != corner) {
        parents_[corner] = parents_[parents_[corner]];
        corner = parents_[corner];
    }
    return corner;
}

}  // namespace candela_opensubdiv
