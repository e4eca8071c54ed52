#pragma once

#include <candela/mesh.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace candela {

/// Indices of one triangle, line or point.
constexpr std::uint32_t cornersOf(Topology topology) {
    if (topology == Topology::triangles) return 3;
    return topology == Topology::lines ? 2 : 1;
}

inline bool isTriangles(const Submesh& submesh) {
    return submesh.topology == Topology::triangles;
}

/// Is nothing of the mesh lines or points?
inline bool hasOnlyTriangles(const Mesh& mesh) {
    return std::ranges::all_of(mesh.submeshes, isTriangles);
}

inline bool hasTriangles(const Mesh& mesh) {
    return mesh.submeshes.empty() || std::ranges::any_of(mesh.submeshes, isTriangles);
}

/// Calls `visit(first, count)` for the runs of indices that are triangles and drawn.
template <typename Visit>
void forEachTriangleRun(const Mesh& mesh, const Visit& visit) {
    if (mesh.submeshes.empty()) return visit(std::size_t{0}, mesh.indices.size());
    for (const Submesh& submesh : mesh.submeshes) {
        if (isTriangles(submesh)) visit(std::size_t{submesh.firstIndex}, std::size_t{submesh.indexCount});
    }
}

/// Calls `visit(first)` with the first index of each triangle. In a mesh of triangles alone those are all
/// triples of indices, drawn or not.
template <typename Visit>
void forEachTriangle(const Mesh& mesh, const Visit& visit) {
    const auto visitRun = [&](std::size_t first, std::size_t count) {
        for (std::size_t i = first; i < first + count; i += 3) visit(i);
    };
    if (hasOnlyTriangles(mesh)) return visitRun(0, mesh.indices.size());
    forEachTriangleRun(mesh, visitRun);
}

/// Are these lines or points without normals?
inline bool isUnlit(const Mesh& mesh, const Submesh& submesh) {
    return !isTriangles(submesh) && submesh.indexCount > 0 &&
           mesh.normals[mesh.indices[submesh.firstIndex]] == glm::vec3(0.0f);
}

}  // namespace candela
