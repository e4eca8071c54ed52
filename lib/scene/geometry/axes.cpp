#include "scene/geometry/axes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

// The length that a difference of equal unit vectors may have by rounding: about 1e-7 in single
// precision, times a few operations.
constexpr double roundingLength = 1e-6;

bool isZero(const glm::dvec3& vector) {
    return !(glm::length(vector) > 0.0);
}

// The part of `vector` perpendicular to the unit vector `axis`, at unit length; any perpendicular when there
// is no such part.
glm::dvec3 perpendicularPart(const glm::dvec3& vector, const glm::dvec3& axis) {
    if (isZero(vector)) return anyPerpendicular(axis);
    const glm::dvec3 unit = glm::normalize(vector);
    const glm::dvec3 part = unit - axis * glm::dot(axis, unit);
    return glm::length(part) > roundingLength ? glm::normalize(part) : anyPerpendicular(axis);
}

}  // namespace

glm::dvec3 anyPerpendicular(const glm::dvec3& axis) {
    const glm::dvec3 size = glm::abs(axis);
    glm::dvec3 other(0.0, 0.0, 1.0);
    if (size.x <= size.y && size.x <= size.z) {
        other = {1.0, 0.0, 0.0};
    } else if (size.y <= size.z) {
        other = {0.0, 1.0, 0.0};
    }
    return glm::normalize(other - axis * glm::dot(axis, other));
}

glm::dmat3 unscaledFrame(const glm::mat4& world) {
    const glm::dvec3 x(world[0]), y(world[1]), z(world[2]);
    glm::dvec3 unitZ = isZero(z) ? glm::cross(x, y) : z;
    if (isZero(unitZ)) unitZ = glm::dvec3(0.0, 0.0, 1.0);
    unitZ = glm::normalize(unitZ);
    const glm::dvec3 unitY = perpendicularPart(isZero(y) ? glm::cross(unitZ, x) : y, unitZ);
    const glm::dvec3 right = glm::cross(unitY, unitZ);
    return {glm::dot(right, x) < 0.0 ? -right : right, unitY, unitZ};
}

std::vector<glm::dvec2> PolygonPlane::project(std::span<const glm::vec3> corners) const {
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
    // Below this a normal consists of rounding errors.
    const double length = glm::length(normal);
    if (!(length > 1e-14 * size * size)) return {};
    normal /= length;
    const glm::dvec3 x = anyPerpendicular(normal);
    return PolygonPlane{x, glm::cross(normal, x), normal};
}

}  // namespace candela
