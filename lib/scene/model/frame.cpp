#include "scene/model/frame.h"

#include "scene/geometry/perpendicular.h"

#include <glm/geometric.hpp>

namespace candela {

namespace {

// Of a unit length, what rounding may leave of a vector that should be nothing: about 1e-7 in single
// precision, times a few operations.
constexpr double nothing = 1e-6;

bool isNothing(const glm::dvec3& vector) {
    return !(glm::length(vector) > 0.0);
}

// The part of `vector` perpendicular to the unit vector `axis`, at unit length; any perpendicular when there
// is no such part.
glm::dvec3 perpendicularPart(const glm::dvec3& vector, const glm::dvec3& axis) {
    if (isNothing(vector)) return anyPerpendicular(axis);
    const glm::dvec3 unit = glm::normalize(vector);
    const glm::dvec3 part = unit - axis * glm::dot(axis, unit);
    return glm::length(part) > nothing ? glm::normalize(part) : anyPerpendicular(axis);
}

}  // namespace

glm::dmat3 unscaledFrame(const glm::mat4& world) {
    const glm::dvec3 x(world[0]), y(world[1]), z(world[2]);
    glm::dvec3 unitZ = isNothing(z) ? glm::cross(x, y) : z;
    if (isNothing(unitZ)) unitZ = glm::dvec3(0.0, 0.0, 1.0);
    unitZ = glm::normalize(unitZ);
    const glm::dvec3 unitY = perpendicularPart(isNothing(y) ? glm::cross(unitZ, x) : y, unitZ);
    const glm::dvec3 right = glm::cross(unitY, unitZ);
    return {glm::dot(right, x) < 0.0 ? -right : right, unitY, unitZ};
}

}  // namespace candela
