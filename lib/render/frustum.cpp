#include "render/frustum.h"

#include "render/lighting/tiled/tile_kernel.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace candela {

Frustum::Frustum(const CameraView& view, float aspect)
    : eye_(view.eye()),
      right_(view.worldFromCamera[0]),
      up_(view.worldFromCamera[1]),
      forward_(-glm::vec3(view.worldFromCamera[2])),
      near_(view.nearPlane),
      halfExtent_(std::tan(0.5f * view.verticalFov) * glm::vec2(aspect, 1.0f)),
      edgeScale_(1.0f / glm::sqrt(1.0f + halfExtent_ * halfExtent_)) {}

bool Frustum::meets(const glm::vec3& center, float radius) const {
    const glm::vec3 offset = center - eye_;
    const float depth = glm::dot(offset, forward_);
    if (depth + radius < near_) return false;
    const float x = std::abs(glm::dot(offset, right_)), y = std::abs(glm::dot(offset, up_));
    return (x - depth * halfExtent_.x) * edgeScale_.x <= radius &&
           (y - depth * halfExtent_.y) * edgeScale_.y <= radius;
}

bool Frustum::meetsNearPlane(const glm::vec3& center, float radius) const {
    return glm::dot(center - eye_, forward_) - radius <= near_;
}

void Frustum::copyTo(TileFrame& frame) const {
    for (int i = 0; i < 3; ++i) {
        frame.right[i] = right_[i];
        frame.up[i] = up_[i];
        frame.forward[i] = forward_[i];
    }
    for (int i = 0; i < 2; ++i) {
        frame.halfExtent[i] = halfExtent_[i];
        frame.edgeScale[i] = edgeScale_[i];
    }
}

Frustum::Rectangle Frustum::projectedBounds(const glm::vec3& center, float radius) const {
    const glm::vec3 offset = center - eye_;
    const float depth = glm::dot(offset, forward_);
    const glm::vec2 side{glm::dot(offset, right_), glm::dot(offset, up_)};
    const float radius2 = radius * radius;
    const glm::vec2 reach = radius * glm::sqrt(glm::max(side * side + depth * depth - radius2, 0.0f));
    const glm::vec2 scale = 0.5f / (halfExtent_ * (depth * depth - radius2));
    return {0.5f + (side * depth - reach) * scale, 0.5f + (side * depth + reach) * scale};
}

}  // namespace candela
