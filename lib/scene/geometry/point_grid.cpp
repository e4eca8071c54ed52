#include "scene/geometry/point_grid.h"

#include <glm/common.hpp>

#include <cmath>

namespace candela {

PointGrid::PointGrid(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& members)
    : side_(std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(members.size())))),
      first_(side_ * side_, none),
      next_(points.size(), none) {
    if (members.empty()) return;
    glm::dvec2 low(1.0), high(0.0);
    for (const std::uint32_t number : members) {
        low = glm::min(low, points[number]);
        high = glm::max(high, points[number]);
    }
    origin_ = low;
    // Not smaller, so that what is rounded in the unit square stays far below the margin of spanInRow.
    scale_ = 1.0 / glm::max(high - low, glm::dvec2(1e-4));
    for (const std::uint32_t number : members) {
        const glm::dvec2 place = inFrame(points[number]);
        std::uint32_t& first = first_[cellAlong(place.y) * side_ + cellAlong(place.x)];
        next_[number] = first;
        first = number;
    }
}

std::size_t PointGrid::cellAlong(double coordinate) const {
    const double cell = coordinate * static_cast<double>(side_);
    if (!(cell > 0.0)) return 0;
    return std::min(static_cast<std::size_t>(cell), side_ - 1);
}

PointGrid::Span PointGrid::spanInRow(const glm::dvec2 (&triangle)[3], std::size_t row) const {
    constexpr double margin = 1e-9;
    const double height = 1.0 / static_cast<double>(side_);
    const double low = static_cast<double>(row) * height - margin, high = low + height + 2.0 * margin;
    Span span{1.0, 0.0};
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 a = triangle[i], b = triangle[(i + 1) % 3];
        const auto [minY, maxY] = std::minmax(a.y, b.y);
        if (maxY < low || minY > high) continue;
        if (maxY - minY < margin) {
            span.add(a.x);
            span.add(b.x);
            continue;
        }
        const double slope = (b.x - a.x) / (b.y - a.y);
        span.add(a.x + (std::max(low, minY) - a.y) * slope);
        span.add(a.x + (std::min(high, maxY) - a.y) * slope);
    }
    span.low -= margin;
    span.high += margin;
    return span;
}

}  // namespace candela
