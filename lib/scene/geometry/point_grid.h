#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela {

/// A uniform grid over the bounding rectangle of points, about one point per cell.
class PointGrid {
  public:
    /// A grid of `members` of `points`, which lie in the unit square.
    PointGrid(const std::vector<glm::dvec2>& points, const std::vector<std::uint32_t>& members);

    /// How to continue after a visited point.
    enum class Verdict { keep, drop, stop };
    /// Calls `visit(number)` for the points in all cells that the triangle meets, until it returns `stop`.
    template <typename Visit>
    void visitTriangle(const glm::dvec2 (&corners)[3], const Visit& visit);

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    // Cells are counted in the frame of the grid, in which it is the unit square.
    struct Span {
        double low, high;
        void add(double x) {
            low = std::min(low, x);
            high = std::max(high, x);
        }
    };
    glm::dvec2 inFrame(const glm::dvec2& point) const { return (point - origin_) * scale_; }
    /// The x at which the triangle has a y between those of the row, with a margin for rounding.
    Span spanInRow(const glm::dvec2 (&triangle)[3], std::size_t row) const;
    std::size_t cellAlong(double coordinate) const;
    template <typename Visit>
    bool visitCell(std::size_t cell, const Visit& visit);

    glm::dvec2 origin_{0.0}, scale_{1.0};
    std::size_t side_;                  // Cells along a side.
    std::vector<std::uint32_t> first_;  // One list per cell.
    std::vector<std::uint32_t> next_;   // One a point.
};

template <typename Visit>
void PointGrid::visitTriangle(const glm::dvec2 (&corners)[3], const Visit& visit) {
    const glm::dvec2 triangle[3] = {inFrame(corners[0]), inFrame(corners[1]), inFrame(corners[2])};
    const auto [low, high] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
    const std::size_t lastRow = cellAlong(high);
    for (std::size_t row = cellAlong(low); row <= lastRow; ++row) {
        const Span span = spanInRow(triangle, row);
        const std::size_t lastCell = row * side_ + cellAlong(span.high);
        for (std::size_t cell = row * side_ + cellAlong(span.low); cell <= lastCell; ++cell) {
            if (!visitCell(cell, visit)) return;
        }
    }
}

template <typename Visit>
bool PointGrid::visitCell(std::size_t cell, const Visit& visit) {
    std::uint32_t* link = &first_[cell];
    while (*link != none) {
        switch (visit(*link)) {
            case Verdict::stop:
                return false;
            case Verdict::drop:
                *link = next_[*link];
                break;
            case Verdict::keep:
                link = &next_[*link];
                break;
        }
    }
    return true;
}

}  // namespace candela
