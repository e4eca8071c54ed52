#pragma once

#include <candela/scene.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The triangles of a mesh, with their neighbours.
struct OccluderMesh {
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Triangle {
        std::array<std::uint32_t, 3> corners;  ///< Equal where positions are.
        /// Across the edge from corner k to the next one, or `none`.
        std::array<std::uint32_t, 3> neighbours{none, none, none};
    };

    std::vector<glm::vec3> corners;
    std::vector<Triangle> triangles;  ///< In the order of the indices; none where a position is not finite.
};

/// `vertices` are positions and normals, 6 floats each; `indices` are those of triangles.
OccluderMesh occluderMesh(std::span<const float> vertices, std::span<const std::uint32_t> indices);

/// None where a position is not finite.
std::optional<Bounds> boxOf(std::span<const float> vertices);

}  // namespace candela
