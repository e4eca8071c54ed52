#include "render/frustum.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

using Real = float;
using std::abs;
using std::max;
using std::sqrt;
#define SHARED_FUNCTION inline
#include "shared/light_bounds.h"
#undef SHARED_FUNCTION

}  // namespace

Frustum::Frustum(const CameraView& view, const ViewWindow& window)
    : eye_(view.eye()),
      right_(view.worldFromCamera[0]),
      up_(view.worldFromCamera[1]),
      forward_(-glm::vec3(view.worldFromCamera[2])),
      near_(view.nearPlane),
      halfExtent_(view.orthographicHeight ? glm::dvec2(0.0) : window.halfExtent),
      base_(view.orthographicHeight ? window.halfExtent : glm::dvec2(0.0)),
      shift_(window.shift),
      edgeScale_(edgeScale(halfExtent_.x, shift_.x), edgeScale(halfExtent_.y, shift_.y)) {}

glm::vec3 Frustum::inCameraSpace(const glm::vec3& position) const {
    const glm::vec3 way = position - eye_;
    return {glm::dot(way, right_), glm::dot(way, up_), glm::dot(way, forward_)};
}

bool Frustum::meets(const glm::vec3& center, float radius) const {
    const glm::vec3 c = inCameraSpace(center);
    const ViewFrustum frustum{near_,   halfExtent_.x, halfExtent_.y, edgeScale_.x, edgeScale_.y,
                              base_.x, base_.y,       shift_.x,      shift_.y};
    return distanceToFrustum(frustum, c.x, c.y, c.z) <= radius;
}

float Frustum::radiusOfElements(const glm::vec3& center, float radius) const {
    constexpr float halfDiagonal = 0.70710678f;  // of a square
    const float depth = std::max(inCameraSpace(center).z + radius, near_);
    return radius + halfDiagonal * elementSize_ * 2.0f * (halfExtent_.y * depth + base_.y);
}

bool Frustum::meetsNearPlane(const glm::vec3& center, float radius) const {
    return inCameraSpace(center).z - radius <= near_;
}

Frustum::Rectangle Frustum::projectedBounds(const glm::vec3& center, float radius) const {
    const glm::vec3 c = inCameraSpace(center);
    const Span across = projectedSpan(c.x, c.z, radius, halfExtent_.x, base_.x, shift_.x);
    const Span along = projectedSpan(c.y, c.z, radius, halfExtent_.y, base_.y, shift_.y);
    return {{across.first, along.first}, {across.last, along.last}};
}

}  // namespace candela
