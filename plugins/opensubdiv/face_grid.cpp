#include "face_grid.h"

#include <limits>

namespace candela_plugins::opensubdiv {
namespace {

namespace Sdc = OpenSubdiv::Sdc;

constexpr std::uint32_t unset = std::numeric_limits<std::uint32_t>::max();

/// Point t of an edge, 0 at its first corner and `segments` at its second.
std::uint32_t edgePoint(const FaceGrid& grid, std::uint32_t edge, std::uint32_t t) {
    if (t == 0) return edge;
    if (t == grid.segments) return (edge + 1) % grid.size;
    return grid.firstEdgeSlot(edge) + t - 1;
}

/// The point of a face of four corners at column i and row j of its grid.
std::uint32_t quadPoint(const FaceGrid& grid, std::uint32_t i, std::uint32_t j) {
    const std::uint32_t n = grid.segments;
    if (j == 0) return edgePoint(grid, 0, i);
    if (i == n) return edgePoint(grid, 1, j);
    if (j == n) return edgePoint(grid, 2, n - i);
    if (i == 0) return edgePoint(grid, 3, n - j);
    return grid.firstInnerSlot() + (j - 1) * (n - 1) + (i - 1);
}

/// The point of a Loop triangle at column i and row j.
std::uint32_t trianglePoint(const FaceGrid& grid, std::uint32_t i, std::uint32_t j) {
    const std::uint32_t n = grid.segments;
    if (j == 0) return edgePoint(grid, 0, i);
    if (i + j == n) return edgePoint(grid, 1, j);
    if (i == 0) return edgePoint(grid, 2, n - j);
    // Range j has n - 1 - j inner points.
    const std::uint32_t before = (j - 1) * (n - 1) - (j - 1) * j / 2;
    return grid.firstInnerSlot() + before + (i - 1);
}

/// The point of a sub-face at column i and row j: corner (0, 0) is the face's corner of the same number,
/// the columns run along the edge that begins there, and the far corner is the middle of the face. After that
/// middle come the points on the lines from the middles of the edges to it, then those inside sub-faces.
std::uint32_t subfacePoint(const FaceGrid& grid, std::uint32_t subface, std::uint32_t i, std::uint32_t j) {
    const std::uint32_t m = grid.segments / 2;
    const std::uint32_t before = (subface + grid.size - 1) % grid.size;
    const std::uint32_t lines = grid.firstInnerSlot() + 1;
    if (i == m && j == m) return grid.firstInnerSlot();
    if (j == 0) return edgePoint(grid, subface, i);
    if (i == 0) return edgePoint(grid, before, grid.segments - j);
    if (i == m) return lines + subface * (m - 1) + (j - 1);
    if (j == m) return lines + before * (m - 1) + (i - 1);
    const std::uint32_t insides = lines + grid.size * (m - 1);
    return insides + subface * (m - 1) * (m - 1) + (j - 1) * (m - 1) + (i - 1);
}

/// Adds slots to a grid whose `pointCount` is set.
class SlotBuilder {
  public:
    explicit SlotBuilder(FaceGrid& grid) : grid_(grid) {
        grid_.slots.assign(grid.pointCount, GridSlot{unset, 0, 0.0, 0.0});
    }

    /// The slot at a point, added for the first patch that needs it.
    std::uint32_t shared(const GridSlot& wanted) {
        GridSlot& slot = grid_.slots[wanted.point];
        if (slot.point == unset) slot = wanted;
        return wanted.point;
    }

    /// The same, with a slot for each patch.
    std::uint32_t separate(const GridSlot& wanted) {
        if (grid_.slots[wanted.point].point == unset) return shared(wanted);
        grid_.slots.push_back(wanted);
        return static_cast<std::uint32_t>(grid_.slots.size() - 1);
    }

  private:
    FaceGrid& grid_;
};

/// Cuts a patch of n × n quads whose slots are given row by row.
void addQuads(FaceGrid& grid, const std::vector<std::uint32_t>& slots, std::uint32_t n) {
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t first = j * (n + 1) + i;
            grid.polygons.insert(grid.polygons.end(), {slots[first], slots[first + 1], slots[first + n + 2],
                                                       slots[first + n + 1]});
        }
    }
}

void fillQuad(FaceGrid& grid) {
    SlotBuilder builder(grid);
    std::vector<std::uint32_t> slots;
    const double step = 1.0 / grid.segments;
    for (std::uint32_t j = 0; j <= grid.segments; ++j) {
        for (std::uint32_t i = 0; i <= grid.segments; ++i) {
            slots.push_back(builder.shared({quadPoint(grid, i, j), 0, i * step, j * step}));
        }
    }
    addQuads(grid, slots, grid.segments);
}

void fillTriangle(FaceGrid& grid) {
    SlotBuilder builder(grid);
    const std::uint32_t n = grid.segments;
    const double step = 1.0 / n;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i + j <= n; ++i) {
            builder.shared({trianglePoint(grid, i, j), 0, i * step, j * step});
        }
    }
    const auto add = [&](std::uint32_t i, std::uint32_t j) {
        grid.polygons.push_back(trianglePoint(grid, i, j));
    };
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i + j < n; ++i) {
            add(i, j), add(i + 1, j), add(i, j + 1);
            if (i + j + 1 < n) add(i + 1, j), add(i + 1, j + 1), add(i, j + 1);
        }
    }
}

void fillSubfaces(FaceGrid& grid, Sdc::SchemeType scheme) {
    SlotBuilder builder(grid);
    const std::uint32_t m = grid.segments / 2;
    const double step = 1.0 / m;
    for (std::uint32_t subface = 0; subface < grid.size; ++subface) {
        std::vector<std::uint32_t> slots;
        for (std::uint32_t j = 0; j <= m; ++j) {
            for (std::uint32_t i = 0; i <= m; ++i) {
                const GridSlot slot{subfacePoint(grid, subface, i, j), subface, i * step, j * step};
                slots.push_back(scheme == Sdc::SCHEME_BILINEAR ? builder.separate(slot)
                                                               : builder.shared(slot));
            }
        }
        addQuads(grid, slots, m);
    }
}

FaceGrid makeGrid(Sdc::SchemeType scheme, std::uint32_t size, std::uint32_t level) {
    const auto points = static_cast<std::uint32_t>(gridPoints(scheme, size, level));
    FaceGrid grid{size, std::uint32_t{1} << level, points, {}, 4, {}};
    if (scheme == Sdc::SCHEME_LOOP) {
        grid.polygonSize = 3;
        fillTriangle(grid);
    } else if (size == 4) {
        fillQuad(grid);
    } else {
        fillSubfaces(grid, scheme);
    }
    return grid;
}

}  // namespace

std::uint64_t gridPoints(Sdc::SchemeType scheme, std::uint64_t size, std::uint32_t level) {
    const std::uint64_t segments = std::uint64_t{1} << level;
    if (scheme == Sdc::SCHEME_LOOP) return (segments + 1) * (segments + 2) / 2;
    if (size == 4) return (segments + 1) * (segments + 1);
    const std::uint64_t half = segments / 2;
    return size * segments + 1 + size * (half - 1) + size * (half - 1) * (half - 1);
}

FaceGrids::FaceGrids(Sdc::SchemeType scheme, std::uint32_t level, std::span<const std::uint32_t> faceSizes) {
    for (const std::uint32_t size : faceSizes) {
        if (!grids_.contains(size)) grids_.emplace(size, makeGrid(scheme, size, level));
    }
}

}  // namespace candela_plugins::opensubdiv
