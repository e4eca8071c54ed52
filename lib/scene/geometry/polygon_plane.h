#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <span>
#include <vector>

namespace candela {

/// The axes of the plane in which a polygon is seen: orthonormal, with x × y = normal.
struct PolygonPlane {
    glm::dvec3 x, y, normal;

    /// The corners as the plane shows them, relative to the first.
    std::vector<glm::dvec2> view(std::span<const glm::vec3> corners) const;
};

/// The plane along the polygon's Newell normal, about which it goes counter-clockwise (I. Sutherland, R.
/// Sproull, R. Schumacker: "A characterization of ten hidden-surface algorithms", ACM Computing Surveys 6(1),
/// 1974, which credits M. Newell). None for a polygon without area.
std::optional<PolygonPlane> polygonPlane(std::span<const glm::vec3> corners);

}  // namespace candela
