#include "camera_control.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// The eye stays this far from straight above or below: a view there has no upright.
constexpr float minPolarAngle = 0.01f;
constexpr float dollyFactor = 0.9f;
/// Metres from the target, of a target near the origin. Farther away floats have larger steps.
constexpr float minDistance = 1.0e-6f;
constexpr float minDistanceShare = 1.0e-4f;

float minDistanceTo(const glm::vec3& target) {
    return std::max(minDistance, minDistanceShare * glm::length(target));
}

/// A direction as angles: `azimuth` about +Y from +Z, `polar` from +Y.
struct Angles {
    float azimuth, polar;
};

Angles anglesOf(const glm::vec3& direction) {
    return {std::atan2(direction.x, direction.z), std::acos(std::clamp(direction.y, -1.0f, 1.0f))};
}

glm::vec3 directionOf(const Angles& angles) {
    const float polar = std::clamp(angles.polar, minPolarAngle, pi - minPolarAngle);
    return {std::sin(polar) * std::sin(angles.azimuth), std::cos(polar),
            std::sin(polar) * std::cos(angles.azimuth)};
}

/// `direction` (unit length) rotated by a drag.
glm::vec3 rotated(const glm::vec3& direction, const glm::vec2& drag) {
    Angles angles = anglesOf(direction);
    angles.azimuth -= drag.x * pi;
    angles.polar -= drag.y * pi;
    return directionOf(angles);
}

}  // namespace

void CameraControl::set(const candela::CameraView& view, float distance) {
    const glm::vec3 back(view.worldFromCamera[2]);
    eye_ = view.eye();
    target_ = eye_ - glm::normalize(back) * std::max(distance, minDistanceTo(eye_));
    verticalFov_ = view.verticalFov;
    orthographicHeight_ = view.orthographicHeight;
}

void CameraControl::lookAt(const glm::vec3& eye, const glm::vec3& target) {
    eye_ = eye;
    target_ = target;
}

void CameraControl::frame(const candela::Bounds& box, float aspect) {
    if (box.empty()) return;
    const glm::vec3 center = 0.5f * (box.min + box.max);
    const float radius = std::max(0.5f * glm::distance(box.min, box.max), minDistanceTo(center));
    const float halfHeight = 0.5f * verticalFov_;
    const float halfWidth = std::atan(std::tan(halfHeight) * aspect);
    const glm::vec3 back = glm::normalize(eye_ - target_);
    eye_ = center + back * (radius / std::sin(std::min(halfHeight, halfWidth)));
    target_ = center;
    if (orthographicHeight_) orthographicHeight_ = 2.0f * radius / std::min(1.0f, aspect);
}

float CameraControl::heightAtTarget() const {
    if (orthographicHeight_) return *orthographicHeight_;
    return 2.0f * std::tan(0.5f * verticalFov_) * glm::distance(eye_, target_);
}

void CameraControl::orbit(const glm::vec2& drag) {
    const float distance = glm::distance(eye_, target_);
    eye_ = target_ + distance * rotated((eye_ - target_) / distance, drag);
}

void CameraControl::pan(const glm::vec2& drag) {
    const glm::mat4 frame = view().worldFromCamera;
    const float metresAHeight = heightAtTarget();
    const glm::vec3 shift = metresAHeight * (drag.y * glm::vec3(frame[1]) - drag.x * glm::vec3(frame[0]));
    eye_ += shift;
    target_ += shift;
}

void CameraControl::dolly(float steps) {
    const float distance = glm::distance(eye_, target_);
    const float nearer = std::max(distance * std::pow(dollyFactor, steps), minDistanceTo(target_));
    eye_ = target_ + (eye_ - target_) * (nearer / distance);
    if (orthographicHeight_) *orthographicHeight_ *= nearer / distance;
}

void CameraControl::lookAround(const glm::vec2& drag) {
    const float distance = glm::distance(eye_, target_);
    target_ = eye_ - distance * rotated((eye_ - target_) / distance, drag);
}

void CameraControl::fly(const glm::vec3& direction, float metres) {
    const glm::vec3 shift = metres * (glm::mat3(view().worldFromCamera) * direction);
    eye_ += shift;
    target_ += shift;
}

void CameraControl::setVerticalFov(float radians) {
    verticalFov_ = radians;
}

candela::CameraView CameraControl::view() const {
    candela::CameraView view = candela::lookAt(eye_, target_, verticalFov_);
    view.orthographicHeight = orthographicHeight_;
    return view;
}
