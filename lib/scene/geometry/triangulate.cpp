#include "scene/geometry/triangulate.h"

#include "scene/geometry/axes.h"
#include "scene/geometry/point_grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace candela {

namespace {

/// The orientation of a, b, c: 1 counter-clockwise, -1 clockwise, 0 for less than rounding can tell of points
/// in the unit square.
int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 u = b - a, v = c - a;
    const double area = u.x * v.y - u.y * v.x;
    const double bound = 1e-14 * (std::abs(u.x) + std::abs(u.y) + std::abs(v.x) + std::abs(v.y));
    return area > bound ? 1 : area < -bound ? -1 : 0;
}

/// A first-in, first-out queue of corners. An entry is valid while the corner has the version
/// with which it was queued.
class CornerQueue {
  public:
    struct Entry {
        std::uint32_t corner, version;
    };
    bool empty() const { return head_ == entries_.size(); }
    void push(Entry entry) { entries_.push_back(entry); }
    Entry pop() { return entries_[head_++]; }

  private:
    std::vector<Entry> entries_;
    std::size_t head_ = 0;
};

/// Cuts ears off a polygon in the unit square until a triangle is left. An ear is a convex corner whose
/// triangle holds no other corner; only a corner that is not convex can be the first one inside. Cutting an
/// ear off may change the kind of its two neighbours, but never turns another corner into an ear: the corner
/// that prevents this lies outside the remaining polygon or on its border, and stays there. So a corner is
/// tested again only when its neighbours change.
class EarClipper {
  public:
    EarClipper(std::vector<glm::dvec2> points, std::vector<std::uint32_t>& triangles);
    void run();

  private:
    /// In the order in which to cut where there is no ear. Such a polygon crosses or touches itself.
    enum Kind { flat, blocked, reflex, ear };
    struct Corner {
        std::uint32_t previous, next;
        std::uint32_t version = 0;
        bool convex = false, cut = false;
    };

    static std::vector<std::uint32_t> findConvex(const std::vector<glm::dvec2>& points,
                                                 std::vector<Corner>& corners);
    int orientationAt(std::uint32_t corner) const;
    Kind kindOf(std::uint32_t corner);
    bool containsAnother(std::uint32_t corner);
    bool current(CornerQueue::Entry entry) const;
    std::uint32_t chooseCorner();
    void changeNeighbours(std::uint32_t corner, std::uint32_t previous, std::uint32_t next);
    void cut(std::uint32_t corner);
    void append(std::uint32_t corner);

    std::vector<glm::dvec2> points_;
    std::vector<Corner> corners_;
    PointGrid notConvex_;
    CornerQueue unknown_;
    std::array<CornerQueue, 3> known_;  // By kind.
    std::vector<std::uint32_t>& triangles_;
};

EarClipper::EarClipper(std::vector<glm::dvec2> points, std::vector<std::uint32_t>& triangles)
    : points_(std::move(points)), notConvex_(points_, findConvex(points_, corners_)), triangles_(triangles) {
    for (std::uint32_t corner = 0; corner < corners_.size(); ++corner) unknown_.push({corner, 0});
}

/// Fills `corners`, and returns those that are not convex.
std::vector<std::uint32_t> EarClipper::findConvex(const std::vector<glm::dvec2>& points,
                                                  std::vector<Corner>& corners) {
    const auto count = static_cast<std::uint32_t>(points.size());
    std::vector<std::uint32_t> notConvex;
    corners.resize(count);
    for (std::uint32_t corner = 0; corner < count; ++corner) {
        const std::uint32_t previous = (corner + count - 1) % count, next = (corner + 1) % count;
        const bool convex = orientation(points[previous], points[corner], points[next]) > 0;
        corners[corner] = {previous, next, 0, convex, false};
        if (!convex) notConvex.push_back(corner);
    }
    return notConvex;
}

void EarClipper::run() {
    for (std::size_t left = corners_.size(); left > 3; --left) cut(chooseCorner());
    append(chooseCorner());
}

std::uint32_t EarClipper::chooseCorner() {
    while (!unknown_.empty()) {
        const CornerQueue::Entry entry = unknown_.pop();
        if (!current(entry)) continue;
        const Kind kind = kindOf(entry.corner);
        if (kind == ear) return entry.corner;
        known_[kind].push(entry);
    }
    for (CornerQueue& queue : known_) {
        while (!queue.empty()) {
            const CornerQueue::Entry entry = queue.pop();
            if (current(entry)) return entry.corner;
        }
    }
    // Not reached: a corner that is left is always in one of the queues.
    return 0;
}

bool EarClipper::current(CornerQueue::Entry entry) const {
    const Corner& corner = corners_[entry.corner];
    return !corner.cut && corner.version == entry.version;
}

int EarClipper::orientationAt(std::uint32_t corner) const {
    return orientation(points_[corners_[corner].previous], points_[corner], points_[corners_[corner].next]);
}

EarClipper::Kind EarClipper::kindOf(std::uint32_t corner) {
    const int sign = orientationAt(corner);
    if (sign < 0) return reflex;
    if (sign == 0) return flat;
    return containsAnother(corner) ? blocked : ear;
}

/// Whether another corner lies in the triangle of this one or on its border. Corners where the triangle's own
/// are do not count: there two parts of the border meet that do not cross.
bool EarClipper::containsAnother(std::uint32_t corner) {
    const glm::dvec2 triangle[3] = {points_[corners_[corner].previous], points_[corner],
                                    points_[corners_[corner].next]};
    const auto& [a, b, c] = triangle;
    bool found = false;
    notConvex_.visitTriangle(triangle, [&](std::uint32_t other) {
        if (corners_[other].cut || corners_[other].convex) return PointGrid::Verdict::drop;
        const glm::dvec2& p = points_[other];
        if (orientation(a, b, p) < 0 || orientation(b, c, p) < 0 || orientation(c, a, p) < 0 || p == a ||
            p == b || p == c)
            return PointGrid::Verdict::keep;
        found = true;
        return PointGrid::Verdict::stop;
    });
    return found;
}

void EarClipper::cut(std::uint32_t corner) {
    append(corner);
    const auto [previous, next] = std::pair(corners_[corner].previous, corners_[corner].next);
    corners_[corner].cut = true;
    changeNeighbours(previous, corners_[previous].previous, next);
    changeNeighbours(next, previous, corners_[next].next);
}

void EarClipper::changeNeighbours(std::uint32_t corner, std::uint32_t previous, std::uint32_t next) {
    corners_[corner].previous = previous;
    corners_[corner].next = next;
    corners_[corner].convex = orientationAt(corner) > 0;
    unknown_.push({corner, ++corners_[corner].version});
}

void EarClipper::append(std::uint32_t corner) {
    triangles_.insert(triangles_.end(), {corners_[corner].previous, corner, corners_[corner].next});
}

/// Moves and scales points into the unit square.
void fitUnitSquare(std::vector<glm::dvec2>& points) {
    glm::dvec2 low = points[0], high = low;
    for (const glm::dvec2& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const double size = std::max(high.x - low.x, high.y - low.y);
    for (glm::dvec2& point : points) point = (point - low) / size;
}

void appendFan(std::uint32_t count, std::vector<std::uint32_t>& triangles) {
    for (std::uint32_t corner = 2; corner < count; ++corner)
        triangles.insert(triangles.end(), {0u, corner - 1, corner});
}

void cutQuad(std::span<const glm::vec3> corners, const PolygonPlane& plane,
             std::vector<std::uint32_t>& triangles) {
    const auto keepsWinding = [&](int a, int b, int c) {
        const glm::dvec3 from(corners[a]);
        const glm::dvec3 normal = glm::cross(glm::dvec3(corners[b]) - from, glm::dvec3(corners[c]) - from);
        return glm::dot(normal, plane.normal) > 0.0;
    };
    const bool from0 = keepsWinding(0, 1, 2) && keepsWinding(0, 2, 3);
    if (from0 || !(keepsWinding(1, 2, 3) && keepsWinding(1, 3, 0))) return appendFan(4, triangles);
    triangles.insert(triangles.end(), {1u, 2u, 3u, 1u, 3u, 0u});
}

}  // namespace

void triangulate(std::span<const glm::vec3> corners, std::vector<std::uint32_t>& triangles) {
    if (corners.size() <= 3) return appendFan(static_cast<std::uint32_t>(corners.size()), triangles);
    const std::optional<PolygonPlane> plane = polygonPlane(corners);
    if (!plane) return appendFan(static_cast<std::uint32_t>(corners.size()), triangles);
    if (corners.size() == 4) return cutQuad(corners, *plane, triangles);
    std::vector<glm::dvec2> points = plane->project(corners);
    fitUnitSquare(points);
    EarClipper(std::move(points), triangles).run();
}

}  // namespace candela
