#include "scene/geometry/polygon_plane.h"

#include "scene/geometry/perpendicular.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace candela {

std::vector<glm::dvec2> PolygonPlane::view(std::span<const glm::vec3> corners) const {
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners) {
        const glm::dvec3 fromFirst = glm::dvec3(corner) - glm::dvec3(corners[0]);
        points.emplace_back(glm::dot(fromFirst, x), glm::dot(fromFirst, y));
    }
    return points;
}

std::optional<PolygonPlane> polygonPlane(std::span<const glm::vec3> corners) {
    if (corners.size() < 3) return {};
    const glm::dvec3 origin(corners[0]);
    glm::dvec3 normal(0.0), before(0.0);
    double size = 0.0;
    for (const glm::vec3& corner : corners) {
        const glm::dvec3 here = glm::dvec3(corner) - origin;
        normal += glm::cross(before, here);
        size = std::max({size, std::abs(here.x), std::abs(here.y), std::abs(here.z)});
        before = here;
    }
    // Below this a normal is made of rounding errors.
    const double length = glm::length(normal);
    if (!(length > 1e-14 * size * size)) return {};
    normal /= length;
    const glm::dvec3 x = anyPerpendicular(normal);
    return PolygonPlane{x, glm::cross(normal, x), normal};
}

}  // namespace candela
