#include "render/subdivision/cage_edges.h"

#include <algorithm>
#include <span>

namespace candela {

namespace {

/// Appends the edges of a face whose corners are `vertices`.
void appendEdges(std::vector<CageEdge>& edges, std::span<const std::uint32_t> vertices) {
    std::uint32_t last = vertices.back();
    for (const std::uint32_t vertex : vertices) {
        edges.push_back({std::min(last, vertex), std::max(last, vertex)});
        last = vertex;
    }
}

std::vector<CageEdge> unique(std::vector<CageEdge> edges) {
    std::ranges::sort(edges);
    const auto repeated = std::ranges::unique(edges);
    edges.erase(repeated.begin(), repeated.end());
    return edges;
}

}  // namespace

std::vector<CageEdge> edgesOf(const Cage& cage) {
    std::vector<CageEdge> edges;
    edges.reserve(cage.faceVertices.size());
    const std::span<const std::uint32_t> corners(cage.faceVertices);
    std::size_t first = 0;
    for (const std::uint32_t size : cage.faceSizes) {
        appendEdges(edges, corners.subspan(first, size));
        first += size;
    }
    return unique(std::move(edges));
}

std::vector<CageEdge> edgesOf(const RefinedCage& refined) {
    std::vector<CageEdge> edges;
    edges.reserve(refined.faceVertices.size());
    std::vector<std::uint32_t> face(refined.faceSize);
    for (std::size_t first = 0; first < refined.faceVertices.size(); first += refined.faceSize) {
        for (std::uint32_t i = 0; i < refined.faceSize; ++i)
            face[i] = refined.pointOf(refined.faceVertices[first + i]);
        appendEdges(edges, face);
    }
    return unique(std::move(edges));
}

}  // namespace candela
