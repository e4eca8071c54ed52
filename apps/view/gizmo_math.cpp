#include "gizmo_math.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using Ray = ScreenView::Ray;

/// Along an axis that is nearly that of the view, or in a plane that is seen from its edge, a drag has no
/// meaning: the sine of that angle.
constexpr float minSine = 0.05f;
/// A drag scales by no less.
constexpr float minScale = 0.01f;

/// The renderer chooses the planes of a view; without a far plane, an orthographic one has no projection.
glm::mat4 projectionOf(candela::CameraView view, float aspect) {
    view.nearPlane = 1.0f;
    view.farPlane = 2.0f;
    return candela::projection(view, aspect);
}

glm::vec3 axisOf(GizmoHandle handle) {
    glm::vec3 axis(0.0f);
    axis[static_cast<int>(handle)] = 1.0f;
    return axis;
}

/// How far along an axis through `origin` its nearest point to the ray lies (two skew lines; Ericson,
/// Real-Time Collision Detection, 5.1.8).
std::optional<float> alongAxis(const Ray& ray, const glm::vec3& origin, const glm::vec3& axis) {
    const float b = glm::dot(axis, ray.direction);
    const float sine = 1.0f - b * b;
    if (sine < minSine * minSine) return std::nullopt;
    const glm::vec3 toOrigin = origin - ray.origin;
    return (b * glm::dot(ray.direction, toOrigin) - glm::dot(axis, toOrigin)) / sine;
}

/// Where the ray meets the plane through `origin` with this normal, relative to `origin`.
std::optional<glm::vec3> onPlane(const Ray& ray, const glm::vec3& origin, const glm::vec3& normal) {
    const float cosine = glm::dot(ray.direction, normal);
    if (std::abs(cosine) < minSine) return std::nullopt;
    const float distance = glm::dot(origin - ray.origin, normal) / cosine;
    return ray.origin + distance * ray.direction - origin;
}

float distanceToSegment(const glm::vec2& place, const glm::vec2& a, const glm::vec2& b) {
    const glm::vec2 along = b - a;
    const float length = glm::dot(along, along);
    const float share = length > 0.0f ? std::clamp(glm::dot(place - a, along) / length, 0.0f, 1.0f) : 0.0f;
    return glm::distance(place, a + share * along);
}

float distanceTo(const ScreenView& screen, const GizmoShape& shape, GizmoMode mode, GizmoHandle handle,
                 const glm::vec2& place) {
    constexpr float far = 1.0e9f;
    if (mode != GizmoMode::turn) {
        const auto from = screen.at(shape.origin),
                   to = screen.at(shape.origin + shape.metres * axisOf(handle));
        return from && to ? distanceToSegment(place, *from, *to) : far;
    }
    float nearest = far;
    const auto points = circlePoints(shape, handle);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const auto from = screen.at(points[i - 1]), to = screen.at(points[i]);
        if (from && to) nearest = std::min(nearest, distanceToSegment(place, *from, *to));
    }
    return nearest;
}

glm::mat4 about(const glm::vec3& origin, const glm::mat4& change) {
    return glm::translate(glm::mat4(1.0f), origin) * change * glm::translate(glm::mat4(1.0f), -origin);
}

glm::mat4 moved(const ScreenView& screen, const GizmoShape& shape, GizmoHandle handle, const Ray& from,
                const Ray& to) {
    if (handle == GizmoHandle::middle) {
        // In the plane of the picture.
        const glm::vec3 normal = screen.rayAt(screen.at(shape.origin).value_or(glm::vec2(0.0f))).direction;
        const auto a = onPlane(from, shape.origin, normal), b = onPlane(to, shape.origin, normal);
        return a && b ? glm::translate(glm::mat4(1.0f), *b - *a) : glm::mat4(1.0f);
    }
    const glm::vec3 axis = axisOf(handle);
    const auto a = alongAxis(from, shape.origin, axis), b = alongAxis(to, shape.origin, axis);
    return a && b ? glm::translate(glm::mat4(1.0f), (*b - *a) * axis) : glm::mat4(1.0f);
}

glm::mat4 turned(const GizmoShape& shape, GizmoHandle handle, const Ray& from, const Ray& to) {
    if (handle == GizmoHandle::middle) return glm::mat4(1.0f);
    const glm::vec3 axis = axisOf(handle);
    const auto a = onPlane(from, shape.origin, axis), b = onPlane(to, shape.origin, axis);
    if (!a || !b) return glm::mat4(1.0f);
    const float angle = std::atan2(glm::dot(axis, glm::cross(*a, *b)), glm::dot(*a, *b));
    return about(shape.origin, glm::rotate(glm::mat4(1.0f), angle, axis));
}

glm::mat4 scaled(const ScreenView& screen, const GizmoShape& shape, GizmoHandle handle, const glm::vec2& from,
                 const glm::vec2& to) {
    glm::vec3 factors(1.0f);
    if (handle == GizmoHandle::middle) {
        // To the right and up is larger.
        const float length = screen.metresAt(shape.origin, (to.x - from.x) - (to.y - from.y));
        factors = glm::vec3(std::max(1.0f + length / shape.metres, minScale));
    } else {
        const glm::vec3 axis = axisOf(handle);
        const auto a = alongAxis(screen.rayAt(from), shape.origin, axis);
        const auto b = alongAxis(screen.rayAt(to), shape.origin, axis);
        if (!a || !b || std::abs(*a) < minScale * shape.metres) return glm::mat4(1.0f);
        factors[static_cast<int>(handle)] = std::max(*b / *a, minScale);
    }
    return about(shape.origin, glm::scale(glm::mat4(1.0f), factors));
}

}  // namespace

glm::mat4 clipFromWorldOf(const candela::CameraView& view, float aspect) {
    return projectionOf(view, aspect) * glm::inverse(view.worldFromCamera);
}

ScreenView::ScreenView(const candela::CameraView& view, const glm::vec2& corner, const glm::vec2& size)
    : view_(view), corner_(corner), size_(size), clipFromWorld_(clipFromWorldOf(view, size.x / size.y)) {}

std::optional<glm::vec2> ScreenView::at(const glm::vec3& point) const {
    const glm::vec4 clip = clipFromWorld_ * glm::vec4(point, 1.0f);
    if (clip.w <= 0.0f) return std::nullopt;
    const glm::vec2 share = 0.5f + 0.5f * glm::vec2(clip.x, -clip.y) / clip.w;
    return corner_ + share * size_;
}

/// By the frame of the camera: depth does not matter.
Ray ScreenView::rayAt(const glm::vec2& place) const {
    const glm::vec2 share = (place - corner_) / size_;
    const glm::vec2 normalised(2.0f * share.x - 1.0f, 1.0f - 2.0f * share.y);
    const glm::mat4 projection = projectionOf(view_, size_.x / size_.y);
    const glm::mat3 frame(view_.worldFromCamera);
    const glm::vec2 scale(projection[0][0], projection[1][1]);
    if (view_.orthographicHeight) {
        const glm::vec2 shift(projection[3][0], projection[3][1]);
        return {view_.eye() + frame * glm::vec3((normalised - shift) / scale, 0.0f), -frame[2]};
    }
    const glm::vec2 shift(projection[2][0], projection[2][1]);
    return {view_.eye(), glm::normalize(frame * glm::vec3((normalised + shift) / scale, -1.0f))};
}

float ScreenView::metresAt(const glm::vec3& point, float length) const {
    const float height = view_.orthographicHeight
                             ? *view_.orthographicHeight
                             : 2.0f * std::tan(0.5f * view_.verticalFov) *
                                   glm::dot(view_.eye() - point, glm::vec3(view_.worldFromCamera[2]));
    return height * length / size_.y;
}

std::array<glm::vec3, 49> circlePoints(const GizmoShape& shape, GizmoHandle axis) {
    const int first = (static_cast<int>(axis) + 1) % 3, second = (static_cast<int>(axis) + 2) % 3;
    std::array<glm::vec3, 49> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / 48.0f;
        points[i] = shape.origin;
        points[i][first] += shape.metres * std::cos(angle);
        points[i][second] += shape.metres * std::sin(angle);
    }
    return points;
}

std::optional<GizmoHandle> handleAt(const ScreenView& screen, const GizmoShape& shape, GizmoMode mode,
                                    const glm::vec2& place, float reach) {
    const auto middle = screen.at(shape.origin);
    if (!middle) return std::nullopt;
    if (mode != GizmoMode::turn && glm::distance(*middle, place) < reach) return GizmoHandle::middle;
    std::optional<GizmoHandle> found;
    for (const GizmoHandle handle : {GizmoHandle::x, GizmoHandle::y, GizmoHandle::z}) {
        const float distance = distanceTo(screen, shape, mode, handle, place);
        if (distance >= reach) continue;
        reach = distance;
        found = handle;
    }
    return found;
}

glm::mat4 dragged(const ScreenView& screen, const GizmoShape& shape, GizmoMode mode, GizmoHandle handle,
                  const glm::vec2& from, const glm::vec2& to) {
    switch (mode) {
        case GizmoMode::move:
            return moved(screen, shape, handle, screen.rayAt(from), screen.rayAt(to));
        case GizmoMode::turn:
            return turned(shape, handle, screen.rayAt(from), screen.rayAt(to));
        case GizmoMode::scale:
            return scaled(screen, shape, handle, from, to);
    }
    return glm::mat4(1.0f);
}
