#include "stencil_builder.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela_opensubdiv {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The place at a slot, or a part of a step off it towards the middle of its patch.
Place placeAt(std::uint32_t face, const FaceGrid& grid, const GridSlot& slot, double inset) {
    const double middle = grid.polygonSize == 3 ? 1.0 / 3.0 : 0.5;
    const double s = middle - slot.s, t = middle - slot.t;
    const double farther = std::max(std::abs(s), std::abs(t));
    if (farther == 0.0) return {face, slot.patch, slot.s + inset, slot.t + inset / 2};
    return {face, slot.patch, slot.s + s / farther * inset, slot.t + t / farther * inset};
}

}  // namespace

StencilBuilder::StencilBuilder(const GivenCage& cage, const LimitSurface& positions, const LimitSurface* uvs,
                               std::uint32_t level)
    : cage_(cage),
      positions_(positions),
      uvs_(uvs),
      step_(std::ldexp(1.0, -static_cast<int>(level))),
      position_(cage.vertexCount),
      positionInside_(cage.vertexCount),
      uv_(cage.uvCount),
      uvInside_(cage.uvCount) {}

/// There are places where a smooth surface has no normal in du × dv: where both run along the same line, as
/// at a boundary that is a smooth curve through the corner of a single face, and where one of them vanishes,
/// as along an edge collapsed to a point. The normal is there the limit of those inside the face. So the
/// weights of the derivatives are taken a sixteenth of a step inside; the value stays where it is. The
/// texture coordinates do the same, since their derivatives go with those of the position.
///
/// That depends on the positions of the cage as it stands. Where a surface is only nearly degenerate, the
/// normal hardly changes in a sixteenth of a step, so it does no harm to take in too many.
void StencilBuilder::add(std::uint32_t face, const FaceGrid& grid, std::span<const std::uint32_t> slots,
                         VertexRows& rows) {
    for (const std::uint32_t index : slots) {
        const GridSlot& slot = grid.slots[index];
        const Place place = placeAt(face, grid, slot, 0.0);
        const Place inside = placeAt(face, grid, slot, step_ / 16);
        positions_.evaluate(place, position_);
        const bool derivesInside = isDegenerate(position_);
        if (derivesInside) {
            positions_.evaluate(inside, positionInside_);
            replaceDerivatives(position_, positionInside_);
        }
        rows.positions.add(position_);
        if (uvs_ == nullptr) continue;
        uvs_->evaluate(place, uv_);
        if (derivesInside) {
            uvs_->evaluate(inside, uvInside_);
            replaceDerivatives(uv_, uvInside_);
        }
        rows.uvs.add(uv_);
    }
}

bool StencilBuilder::isDegenerate(const RowSum& row) const {
    constexpr double minSine = 1e-4;    // of the angle between du and dv, times the ratio of their lengths
    constexpr double minLength = 1e-6;  // of the longer one, beside the extent of the cage's points
    const auto pointAt = [this](int column) {
        const float* point = &cage_.positions[3 * static_cast<std::size_t>(column)];
        return Vector{point[0], point[1], point[2]};
    };
    Vector du{}, dv{};
    double extent = 0.0;
    const Vector first = pointAt(row.columns().front());
    for (std::size_t i = 0; i < row.columns().size(); ++i) {
        Vector point = pointAt(row.columns()[i]);
        const Weights& weights = row.values()[i];
        // Relative to one of them: the weights of a derivative have the sum 0, and large numbers lose digits.
        for (std::size_t axis = 0; axis < 3; ++axis) {
            point[axis] -= first[axis];
            du[axis] += weights.du * point[axis];
            dv[axis] += weights.dv * point[axis];
        }
        extent = std::max(extent, dot(point, point));
    }
    const Vector normal = cross(du, dv);
    const double longer = std::max(dot(du, du), dot(dv, dv));
    return dot(normal, normal) <= minSine * minSine * longer * longer ||
           longer <= minLength * minLength * extent;
}

}  // namespace candela_opensubdiv
