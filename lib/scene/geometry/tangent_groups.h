#pragma once

#include <candela/mesh.h>

#include <glm/vec2.hpp>

#include <cstdint>
#include <vector>

namespace candela {

constexpr std::uint32_t noCorner = 0xffffffffu;

/// How a triangle contributes to tangents.
enum class TriangleKind : std::uint8_t {
    whole,
    withoutUvArea,  ///< Has no tangent, and has the handedness of the group that reaches it.
    degenerate,     ///< Two of its positions coincide: no part of the surface.
};

/// Which triangle corners share a tangent. A corner is a place in `Mesh::indices`.
struct TangentGroups {
    std::vector<std::uint32_t> vertexOfCorner;  ///< Equal for vertices of equal position, normal and uv.
    std::vector<std::uint32_t> groupOfCorner;   ///< The corner that identifies the group.
    std::vector<TriangleKind> kinds;            ///< One per triangle.
    std::vector<bool> mirrored;                 ///< One per triangle: u × v points away from the front.
};

/// Sorts the corners of `mesh` into groups by the rules of scene/geometry/tangents.h; `uv` has one element a
/// vertex.
TangentGroups tangentGroups(const Mesh& mesh, const std::vector<glm::vec2>& uv);

}  // namespace candela
