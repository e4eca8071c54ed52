#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Cuts a polygon into triangles and appends their corners to `triangles`: indices into `corners`, three per
/// triangle, in the winding of the polygon. There are always `corners.size()` - 2 triangles (none below three
/// corners), and every corner is in one of them. The coordinates have to be finite.
///
/// The polygon is seen along its Newell normal (scene/geometry/axes.h). Where it is simple in that view, the
/// triangles cover it without overlap; it may be concave, and have collinear corners or a slit to a hole. For
/// any other polygon only the number of triangles is guaranteed. A quad is cut from corner 0 to corner 2,
/// unless only the other diagonal keeps the winding of both halves.
void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles);

}  // namespace candela
