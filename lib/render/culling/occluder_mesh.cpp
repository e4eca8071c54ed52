#include "render/culling/occluder_mesh.h"

#include "render/culling/triangle_filter_kernel.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace candela {

namespace {

glm::vec3 positionOf(std::span<const float> vertices, std::uint32_t index) {
    const float* at = vertices.data() + std::size_t{index} * vertexFloats;
    return {at[0], at[1], at[2]};
}

/// The corners of all triangles; vertices of equal positions are one.
std::vector<std::uint32_t> mergeCorners(OccluderMesh& mesh, std::span<const float> vertices,
                                        std::span<const std::uint32_t> indices) {
    std::vector<std::uint32_t> order(vertices.size() / vertexFloats), cornerOf(order.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        const glm::vec3 p = positionOf(vertices, i);
        return std::tuple(p.x, p.y, p.z);
    };
    std::ranges::sort(order, {}, key);
    for (const std::uint32_t i : order) {
        const glm::vec3 position = positionOf(vertices, i);
        if (mesh.corners.empty() || mesh.corners.back() != position) mesh.corners.push_back(position);
        cornerOf[i] = static_cast<std::uint32_t>(mesh.corners.size() - 1);
    }
    std::vector<std::uint32_t> corners;
    corners.reserve(indices.size());
    for (const std::uint32_t index : indices) corners.push_back(cornerOf[index]);
    return corners;
}

/// Two triangles are neighbours where one has an edge in the other's opposite direction, and no third has it.
void findNeighbours(OccluderMesh& mesh) {
    struct Side {
        std::uint32_t low, high;
        bool isForward;
        std::uint32_t triangle, edge;
        auto ends() const { return std::pair(low, high); }
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& corners = mesh.triangles[i].corners;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), from < to, i, k});
        }
    }
    std::ranges::sort(sides, {}, &Side::ends);
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
        while (end < sides.size() && sides[end].ends() == sides[first].ends()) ++end;
        if (end - first != 2 || sides[first].isForward == sides[first + 1].isForward) continue;
        const Side &a = sides[first], &b = sides[first + 1];
        mesh.triangles[a.triangle].neighbours[a.edge] = b.triangle;
        mesh.triangles[b.triangle].neighbours[b.edge] = a.triangle;
    }
}

}  // namespace

OccluderMesh occluderMesh(std::span<const float> vertices, std::span<const std::uint32_t> indices) {
    OccluderMesh mesh;
    if (!boxOf(vertices)) return mesh;
    const std::vector<std::uint32_t> corners = mergeCorners(mesh, vertices, indices);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
        mesh.triangles.push_back({.corners = {corners[i], corners[i + 1], corners[i + 2]}});
    findNeighbours(mesh);
    return mesh;
}

std::optional<Bounds> boxOf(std::span<const float> vertices) {
    Bounds box;
    for (std::size_t i = 0; i < vertices.size() / vertexFloats; ++i) {
        const glm::vec3 position = positionOf(vertices, static_cast<std::uint32_t>(i));
        // A difference to itself is 0 only of a finite number.
        if (position - position != glm::vec3(0.0f)) return std::nullopt;
        box.add({position, position});
    }
    return box;
}

}  // namespace candela
