#pragma once

#include "scene/geometry/perpendicular.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace candela {

/// The tangent for normal maps at a limit vertex, in the form of `Mesh::tangents`: the direction in which u
/// grows in the surface; bitangents point against growing v. `du` and `dv` are the surface's derivatives,
/// `uv` those of the texture coordinates, (du, dv), all along the same parameters. Where the coordinates span
/// no area, any perpendicular to the normal.
inline glm::vec4 limitTangent(const glm::vec3& normal, const glm::vec3& du, const glm::vec3& dv,
                              const glm::vec4& uv) {
    // The chain rule for du and dv, solved for the derivative along u; of its divisor only the sign counts.
    const glm::dvec3 axis(normal);
    const double area = double{uv.x} * uv.w - double{uv.y} * uv.z;
    const glm::dvec3 growing =
        (glm::dvec3(du) * double{uv.w} - glm::dvec3(dv) * double{uv.y}) * (area < 0.0 ? -1.0 : 1.0);
    const glm::dvec3 inPlane = growing - axis * glm::dot(axis, growing);
    const double length = glm::length(inPlane);
    if (area == 0.0 || !(length > 0.0)) return {glm::vec3(anyPerpendicular(axis)), 1.0f};
    return {glm::vec3(inPlane / length), area < 0.0 ? 1.0f : -1.0f};
}

}  // namespace candela
