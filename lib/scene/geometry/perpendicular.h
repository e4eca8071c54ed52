#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace candela {

/// A unit vector perpendicular to the unit vector `axis`, made from the world axis that is farthest from it.
inline glm::dvec3 anyPerpendicular(const glm::dvec3& axis) {
    const glm::dvec3 size = glm::abs(axis);
    glm::dvec3 other(0.0, 0.0, 1.0);
    if (size.x <= size.y && size.x <= size.z) {
        other = {1.0, 0.0, 0.0};
    } else if (size.y <= size.z) {
        other = {0.0, 1.0, 0.0};
    }
    return glm::normalize(other - axis * glm::dot(axis, other));
}

}  // namespace candela
