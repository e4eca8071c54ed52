// All errors of the device's rounding are bounded as in shaders/shared/triangle_filter.h, so that what is
// culled leaves no trace.

#include "render/culling/occluder_polygon.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

/// More than the kernels of the buffer round, pixels.
constexpr double bufferRounding = 0.01;
/// Thinner triangles are left out, pixels.
constexpr double minThickness = 4.0;
/// A multiple of the rounding of a single-precision number, which interpolating depth takes in all.
constexpr double depthUnit = 2.0e-6;

using Line = glm::dvec3;  ///< x, y and 1 times it.

/// x and y times w, and w.
glm::dvec3 projected(const layout::FilterView& view, const glm::vec3& position) {
    const auto row = [&](int k) {
        const float* r = view.rows[k];
        return glm::dot(glm::dvec3(r[0], r[1], r[2]), glm::dvec3(position)) + static_cast<double>(r[3]);
    };
    return {row(0), row(1), row(2)};
}

/// The least w of what is surely not clipped by the near plane.
double safeDepth(const layout::FilterView& view) {
    return 1.001 * static_cast<double>(view.nearDepth) + 16.0 * static_cast<double>(view.depthError);
}

/// How far on the screen the device may place a point elsewhere, pixels.
double marginAt(const layout::FilterView& view, const glm::dvec2& place, double w) {
    const double extent = std::max(std::abs(place.x), std::abs(place.y));
    return 1.15 * (static_cast<double>(view.screenError) + extent * static_cast<double>(view.depthError)) /
               w +
           extent * 1.0e-6 + static_cast<double>(view.snapping);
}

/// What of a triangle lies beyond `safeDepth`, as the device draws it.
struct VisiblePart {
    glm::dvec2 places[4];
    int count = 0;
    double margin = 0.0;                                   ///< The largest.
    double farthest = std::numeric_limits<double>::max();  ///< 1 / w.
    double nearest = 0.0;
    bool isClipped = false;

    void add(const layout::FilterView& view, const glm::dvec3& corner) {
        const glm::dvec2 place = glm::dvec2(corner) / corner.z;
        places[count++] = place;
        margin = std::max(margin, marginAt(view, place, corner.z));
        farthest = std::min(farthest, 1.0 / corner.z);
        nearest = std::max(nearest, 1.0 / (corner.z - static_cast<double>(view.depthError)));
    }
};

VisiblePart visiblePart(const layout::FilterView& view, const std::array<glm::dvec3, 3>& corners) {
    const double least = safeDepth(view);
    VisiblePart part;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 &a = corners[k], &b = corners[(k + 1) % 3];
        if (a.z > least) part.add(view, a);
        if ((a.z > least) == (b.z > least)) continue;
        glm::dvec3 between = a + (b - a) * ((least - a.z) / (b.z - a.z));
        between.z = least;
        part.add(view, between);
        part.isClipped = true;
    }
    return part;
}

/// Sizes of a part on the screen, pixels.
struct ScreenSize {
    double area = 0.0;    ///< Twice it; over 0 where it is counter-clockwise.
    double side = 0.0;    ///< The larger side of its box.
    double extent = 0.0;  ///< The largest coordinate.
    glm::dvec2 low{std::numeric_limits<double>::max()}, high{-std::numeric_limits<double>::max()};
};

ScreenSize sizeOf(const VisiblePart& part) {
    ScreenSize size;
    for (int i = 0; i < part.count; ++i) {
        const glm::dvec2 a = part.places[i] - part.places[0],
                         b = part.places[(i + 1) % part.count] - part.places[0];
        size.area += a.x * b.y - a.y * b.x;
        size.low = glm::min(size.low, part.places[i]), size.high = glm::max(size.high, part.places[i]);
        size.extent = std::max({size.extent, std::abs(part.places[i].x), std::abs(part.places[i].y)});
    }
    size.side = std::max(size.high.x - size.low.x, size.high.y - size.low.y);
    return size;
}

BoxOnScreen boxAround(const glm::dvec2& low, const glm::dvec2& high, double margin, double nearest) {
    const double more = margin + bufferRounding + 0.5;
    const auto pixel = [](double v) { return static_cast<int>(std::floor(std::clamp(v, -1.0e6, 1.0e6))); };
    // Depth of triangles is interpolated. Half a percent is what that rounds where one is a hundred thousand
    // times as long as it is wide on the screen.
    return {{pixel(low.x - more), pixel(low.y - more), pixel(high.x + more), pixel(high.y + more)},
            static_cast<float>(nearest * 1.005)};
}

/// Sets what its part on the screen tells. False where it is not drawn, or thin.
bool measure(const layout::FilterView& view, Occluder& occluder) {
    const VisiblePart part = visiblePart(view, occluder.corners);
    if (part.count < 3) return false;
    const ScreenSize size = sizeOf(part);
    occluder.orientation = size.area < 0.0 ? -1.0 : 1.0;
    const double thickness = std::abs(size.area) / size.side;
    if (!(thickness > minThickness + 16.0 * part.margin)) return false;
    if (view.facing != 0.0f && static_cast<double>(view.facing) != occluder.orientation) return false;
    occluder.margin = part.margin, occluder.farthest = part.farthest, occluder.isClipped = part.isClipped;
    occluder.sharpness = size.side / thickness;
    occluder.box = boxAround(size.low, size.high, part.margin, part.nearest);
    // The device's depth is linear on the screen, and in proportion to 1 / w: its slopes are off by the
    // rounding of differences of depths over the triangle's thickness, and reach as far as coordinates do.
    const double clipping = part.isClipped ? 8.0 : 1.0;
    occluder.depthError =
        clipping * depthUnit * part.nearest * (1.0 + (size.side + size.extent) / thickness) +
        static_cast<double>(view.depthError) * part.nearest * part.nearest;
    return true;
}

Occluder occluderOf(const OccluderMesh& mesh, const OccluderMesh::Triangle& triangle,
                    const layout::FilterView& view) {
    Occluder occluder{};
    for (std::size_t k = 0; k < 3; ++k)
        occluder.corners[k] = projected(view, mesh.corners[triangle.corners[k]]);
    const auto& [a, b, c] = occluder.corners;
    const glm::dvec3 ab = glm::cross(a, b);
    const double volume = glm::dot(ab, c);  // Its sign is that of the area on the screen.
    if (volume * static_cast<double>(view.facing) < 0.0 || !measure(view, occluder)) return occluder;
    occluder.nearness = (ab + glm::cross(b, c) + glm::cross(c, a)) / volume;
    occluder.slope = glm::length(glm::dvec2(occluder.nearness));
    occluder.isDrawn = std::isfinite(occluder.slope);
    return occluder;
}

/// Is the centre of a pixel within `radius` of a corner, or may it be?
bool touchesCenter(const glm::dvec3& corner, double radius) {
    const glm::dvec2 place = glm::dvec2(corner) / corner.z;
    const glm::dvec2 fromCenter = place - (glm::floor(place) + 0.5);
    return radius > 0.4 || glm::length(fromCenter) < radius;
}

/// The line through two corners, in an order that does not depend on the triangle, so that of two neighbours
/// one has the exact opposite of what the other has.
OccluderPolygon::Edge edgeBetween(const OccluderMesh& mesh, const OccluderMesh::Triangle& triangle,
                                  const Occluder& occluder, std::size_t k, const layout::FilterView& view) {
    const std::size_t next = (k + 1) % 3;
    const bool isForward = triangle.corners[k] < triangle.corners[next];
    const std::uint32_t low = triangle.corners[isForward ? k : next],
                        high = triangle.corners[isForward ? next : k];
    Line line = glm::cross(projected(view, mesh.corners[low]), projected(view, mesh.corners[high]));
    line /= glm::length(glm::dvec2(line));
    const float sign = (isForward ? 1.0f : -1.0f) * static_cast<float>(occluder.orientation);
    return {sign * static_cast<float>(line.x), sign * static_cast<float>(line.y),
            sign * static_cast<float>(line.z)};
}

/// Leaves out what the near plane may clip.
OccluderPolygon::Edge nearEdge(const layout::FilterView& view, const Occluder& occluder, double margin) {
    const double length = std::max(occluder.slope, 1.0e-30);
    const Line line = -occluder.nearness / length;
    return {static_cast<float>(line.x), static_cast<float>(line.y),
            static_cast<float>(line.z + 1.0 / (safeDepth(view) * length) - margin)};
}

bool isOutside(const layout::FilterView& view, const PixelBox& box) {
    return box.maxX < 0 || box.maxY < 0 || static_cast<float>(box.minX) >= view.width ||
           static_cast<float>(box.minY) >= view.height;
}

/// Sets the plane, `slack` below that of the occluder.
void setNearness(const layout::FilterView& view, const Occluder& occluder, double slack,
                 OccluderPolygon& polygon) {
    const glm::dvec3 plane = occluder.nearness;
    // Of the numbers of the plane.
    const double rounding =
        4.0e-7 * (std::abs(plane.x) * static_cast<double>(view.width) +
                  std::abs(plane.y) * static_cast<double>(view.height) + std::abs(plane.z));
    polygon.plane[0] = static_cast<float>(plane.x);
    polygon.plane[1] = static_cast<float>(plane.y);
    polygon.plane[2] = static_cast<float>(plane.z - slack - rounding);
    polygon.farthest = static_cast<float>(occluder.farthest * 0.999999 - slack);
    polygon.minY = std::max(occluder.box.pixels.minY, 0), polygon.maxY = occluder.box.pixels.maxY;
}

}  // namespace

void OccluderSetup::append(const OccluderMesh& mesh, const layout::FilterView& view,
                           const TriangleRange& drawn, std::span<const std::uint32_t> chosen,
                           std::vector<OccluderPolygon>& polygons, std::vector<TriangleBox>& boxes) {
    mesh_ = &mesh, view_ = &view, drawn_ = drawn;
    for (const std::uint32_t i : placed_) places_[i] = OccluderMesh::none;
    placed_.clear();
    occluders_.clear();
    if (places_.size() < mesh.triangles.size()) places_.resize(mesh.triangles.size(), OccluderMesh::none);
    for (const std::uint32_t i : chosen) {
        const Occluder own = occluder(i);
        if (!own.isDrawn || isOutside(view, own.box.pixels)) continue;
        polygons.push_back(polygonOf(i));
        if (!own.isClipped) boxes.push_back({i, own.box});
    }
}

const Occluder& OccluderSetup::occluder(std::uint32_t triangle) {
    std::uint32_t& place = places_[triangle];
    if (place == OccluderMesh::none) {
        place = static_cast<std::uint32_t>(occluders_.size());
        placed_.push_back(triangle);
        occluders_.push_back(occluderOf(*mesh_, mesh_->triangles[triangle], *view_));
    }
    return occluders_[place];
}

OccluderPolygon OccluderSetup::polygonOf(std::uint32_t triangle) {
    const Occluder own = occluder(triangle);
    const double margin = own.margin + bufferRounding;
    OccluderPolygon polygon{};
    double slack = own.depthError + margin * own.slope;
    for (std::size_t k = 0; k < 3; ++k) {
        OccluderPolygon::Edge edge = edgeBetween(*mesh_, mesh_->triangles[triangle], own, k, *view_);
        if (const std::optional<Occluder> neighbour = sharedWith(triangle, k)) {
            // Pixels beside the edge may be the neighbour's on the device.
            slack += margin * neighbour->slope + neighbour->depthError;
        } else {
            edge.c -= static_cast<float>(margin);
        }
        polygon.edges[polygon.edgeCount++] = edge;
    }
    if (own.isClipped) polygon.edges[polygon.edgeCount++] = nearEdge(*view_, own, margin);
    setNearness(*view_, own, slack, polygon);
    return polygon;
}

/// The neighbour across an edge where all pixels beside the edge are surely covered by one or the other.
std::optional<Occluder> OccluderSetup::sharedWith(std::uint32_t triangle, std::size_t edge) {
    const std::uint32_t other = mesh_->triangles[triangle].neighbours[edge];
    if (other == OccluderMesh::none || !drawn_.contains(other)) return std::nullopt;
    const Occluder own = occluder(triangle), neighbour = occluder(other);
    if (!neighbour.isDrawn || neighbour.orientation != own.orientation || neighbour.isClipped ||
        own.isClipped)
        return std::nullopt;
    // Around a corner a pixel may be in neither. The sharper the corner, the farther that reaches.
    const double radius = (2.0 * std::max(own.margin, neighbour.margin) + bufferRounding) *
                          std::max(own.sharpness, neighbour.sharpness);
    for (const std::size_t k : {edge, (edge + 1) % 3})
        if (touchesCenter(own.corners[k], radius)) return std::nullopt;
    return neighbour;
}

std::optional<BoxOnScreen> boxOnScreen(const Bounds& box, const layout::FilterView& view) {
    glm::dvec2 low(std::numeric_limits<double>::max()), high(-std::numeric_limits<double>::max());
    double nearest = 0.0, farthest = std::numeric_limits<double>::max(), margin = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 position((corner & 1) != 0 ? box.max.x : box.min.x,
                                 (corner & 2) != 0 ? box.max.y : box.min.y,
                                 (corner & 4) != 0 ? box.max.z : box.min.z);
        const glm::dvec3 at = projected(view, position);
        if (!(at.z > safeDepth(view))) return std::nullopt;
        const glm::dvec2 place = glm::dvec2(at) / at.z;
        low = glm::min(low, place), high = glm::max(high, place);
        nearest = std::max(nearest, 1.0 / (at.z - static_cast<double>(view.depthError)));
        farthest = std::min(farthest, 1.0 / at.z);
        margin = std::max(margin, marginAt(view, place, at.z));
    }
    // A device that snaps corners to its grid may extrapolate depth beyond a triangle that is seen from its
    // edge, by as much as the triangle has itself where it is as wide as the grid.
    return boxAround(low, high, margin, nearest + (nearest - farthest));
}

}  // namespace candela
