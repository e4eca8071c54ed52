#include "stencil_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../common/failure.h"

namespace candela_plugins::opensubdiv {

void replaceDerivatives(LimitStencil& stencil, const LimitStencil& other) {
    for (Weights& weights : stencil.values()) weights = {weights.value, 0.0, 0.0};
    for (std::size_t i = 0; i < other.indices().size(); ++i) {
        stencil.add(other.indices()[i], {0.0, other.values()[i].du, other.values()[i].dv});
    }
}

void StencilBuffer::add(const LimitStencil& stencil) {
    const std::size_t before = entries.size();
    for (std::size_t i = 0; i < stencil.indices().size(); ++i) {
        const Weights& weights = stencil.values()[i];
        const StencilEntry entry{static_cast<std::uint32_t>(stencil.indices()[i]),
                                 static_cast<float>(weights.value), static_cast<float>(weights.du),
                                 static_cast<float>(weights.dv)};
        if (entry.value != 0.0f || entry.du != 0.0f || entry.dv != 0.0f) entries.push_back(entry);
    }
    sizes.push_back(static_cast<std::uint32_t>(entries.size() - before));
}

StencilTable::StencilTable(std::span<StencilBuffer* const> buffers) {
    std::size_t stencils = 0, entries = 0;
    for (const StencilBuffer* buffer : buffers) {
        stencils += buffer->sizes.size();
        entries += buffer->entries.size();
    }
    if (entries > std::numeric_limits<std::uint32_t>::max()) {
        throw Failure{"", "the stencil table has " + std::to_string(entries) +
                              " entries, more than 4294967295; it needs a lower level"};
    }
    offsets_.reserve(stencils + 1);
    indices_.reserve(entries);
    weights_.reserve(entries);
    duWeights_.reserve(entries);
    dvWeights_.reserve(entries);
    for (StencilBuffer* buffer : buffers) {
        for (const std::uint32_t size : buffer->sizes) offsets_.push_back(offsets_.back() + size);
        for (const StencilEntry& entry : buffer->entries) {
            indices_.push_back(entry.index);
            weights_.push_back(entry.value);
            duWeights_.push_back(entry.du);
            dvWeights_.push_back(entry.dv);
        }
        *buffer = {};
    }
}

candela_stencil_table StencilTable::view() const {
    return {static_cast<std::uint32_t>(offsets_.size() - 1),
            offsets_.data(),
            indices_.data(),
            weights_.data(),
            duWeights_.data(),
            dvWeights_.data()};
}

namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The location of a slot, moved by `inset` towards the centre of its patch.
Place placeAt(std::uint32_t face, const FaceGrid& grid, const GridSlot& slot, double inset) {
    const double middle = grid.polygonSize == 3 ? 1.0 / 3.0 : 0.5;
    const double s = middle - slot.s, t = middle - slot.t;
    const double maxDistance = std::max(std::abs(s), std::abs(t));
    if (maxDistance == 0.0) return {face, slot.patch, slot.s + inset, slot.t + inset / 2};
    return {face, slot.patch, slot.s + s / maxDistance * inset, slot.t + t / maxDistance * inset};
}

}  // namespace

StencilBuilder::StencilBuilder(const CheckedCage& cage, const LimitSurface& positions,
                               const LimitSurface* uvs, std::uint32_t level)
    : cage_(cage),
      positions_(positions),
      uvs_(uvs),
      step_(std::ldexp(1.0, -static_cast<int>(level))),
      position_(cage.vertexCount),
      positionInside_(cage.vertexCount),
      uv_(cage.uvCount),
      uvInside_(cage.uvCount) {}

/// Where a parametrisation is degenerate, du × dv is no normal although the surface has one: where du and dv
/// are parallel, as at a smooth boundary through the corner of a single face, and where one of them vanishes,
/// as along an edge collapsed to a point. The normal there is the limit of the normals inside the face. The
/// weights of the derivatives are therefore evaluated a sixteenth of a step inside; the value is not. The
/// derivatives of the texture coordinates are evaluated at the same location as those of the position.
///
/// The test uses the current positions of the cage. Where a surface is only nearly degenerate, the normal
/// hardly changes within a sixteenth of a step, so false positives do no harm.
void StencilBuilder::add(std::uint32_t face, const FaceGrid& grid, std::span<const std::uint32_t> slots,
                         VertexStencils& stencils) {
    for (const std::uint32_t index : slots) {
        const GridSlot& slot = grid.slots[index];
        const Place place = placeAt(face, grid, slot, 0.0);
        const Place inside = placeAt(face, grid, slot, step_ / 16);
        positions_.evaluate(place, position_);
        const bool isDegenerateHere = isDegenerate(position_);
        if (isDegenerateHere) {
            positions_.evaluate(inside, positionInside_);
            replaceDerivatives(position_, positionInside_);
        }
        stencils.positions.add(position_);
        if (uvs_ == nullptr) continue;
        uvs_->evaluate(place, uv_);
        if (isDegenerateHere) {
            uvs_->evaluate(inside, uvInside_);
            replaceDerivatives(uv_, uvInside_);
        }
        stencils.uvs.add(uv_);
    }
}

bool StencilBuilder::isDegenerate(const LimitStencil& stencil) const {
    constexpr double minSine = 1e-4;    // of the angle between du and dv, times the ratio of their sizes
    constexpr double minLength = 1e-6;  // of the longer one, relative to the extent of the stencil's points
    const auto pointAt = [this](int index) {
        const float* point = &cage_.positions[3 * static_cast<std::size_t>(index)];
        return Vector{point[0], point[1], point[2]};
    };
    Vector du{}, dv{};
    double extent = 0.0;
    const Vector first = pointAt(stencil.indices().front());
    for (std::size_t i = 0; i < stencil.indices().size(); ++i) {
        Vector point = pointAt(stencil.indices()[i]);
        const Weights& weights = stencil.values()[i];
        // Relative to the first point, for precision: the weights of a derivative have the sum 0.
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

}  // namespace candela_plugins::opensubdiv
