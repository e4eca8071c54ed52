#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace candela {

// Orthonormal axes: of a direction, of a node, of a polygon.

/// A unit vector perpendicular to the unit vector `axis`, derived from the world axis that is farthest from
/// it.
glm::dvec3 anyPerpendicular(const glm::dvec3& axis);

/// The orthonormal axes of a node's frame: its world matrix without translation, scale and shear. Z keeps its
/// direction, Y is orthogonalised against it, X completes them with the handedness of the matrix: a mirror
/// stays a mirror. An axis that the matrix scales to zero is replaced by a perpendicular one.
glm::dmat3 unscaledFrame(const glm::mat4& world);

/// The axes of a polygon's plane: orthonormal, with x × y = normal.
struct PolygonPlane {
    glm::dvec3 x, y, normal;

    /// The corners projected into the plane, relative to the first.
    std::vector<glm::dvec2> project(std::span<const glm::vec3> corners) const;
};

/// The plane along the polygon's Newell normal, about which it goes counter-clockwise (I. Sutherland, R.
/// Sproull, R. Schumacker: "A characterization of ten hidden-surface algorithms", ACM Computing Surveys 6(1),
/// 1974, which credits M. Newell). None for a polygon without area.
std::optional<PolygonPlane> polygonPlane(std::span<const glm::vec3> corners);

}  // namespace candela
