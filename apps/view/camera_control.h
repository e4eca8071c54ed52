#pragma once

#include <candela/camera.h>
#include <candela/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

/// A camera controlled by pointer and keys: an eye that looks at a target, +Y up, without roll. Angles in
/// radians, lengths in metres.
class CameraControl {
  public:
    /// Sets the eye and the direction of `view`; the target lies on its axis, `distance` before the eye.
    void set(const candela::CameraView& view, float distance);
    /// Looks from `eye` at `target`.
    void lookAt(const glm::vec3& eye, const glm::vec3& target);
    /// Moves back along the axis until the box is in view; `aspect` is width over height.
    void frame(const candela::Bounds& box, float aspect);

    /// `drag` is in heights of the window; a drag over the whole height rotates by 180 degrees.
    void orbit(const glm::vec2& drag);
    /// The target's point follows the pointer.
    void pan(const glm::vec2& drag);
    /// Approaches the target by a factor for each step, or shows less of it in an orthographic view: 1 step
    /// is one click of the wheel.
    void dolly(float steps);
    /// Rotates the view direction; the eye stays.
    void lookAround(const glm::vec2& drag);
    /// Moves eye and target by `direction` (x right, y up, z back; camera space) times `metres`.
    void fly(const glm::vec3& direction, float metres);

    void setVerticalFov(float radians);
    /// Metres, over 0: an orthographic view; none: a perspective one.
    void setOrthographicHeight(std::optional<float> metres) { orthographicHeight_ = metres; }

    /// A view that `candela::lookAt` makes of eye and target: what candela-render draws for
    /// --eye, --target and --fov or --ortho with these numbers, but for the near plane.
    candela::CameraView view() const;
    const glm::vec3& eye() const { return eye_; }
    const glm::vec3& target() const { return target_; }
    float verticalFov() const { return verticalFov_; }
    const std::optional<float>& orthographicHeight() const { return orthographicHeight_; }
    /// The height, in metres, of what the picture shows at the target's distance.
    float heightAtTarget() const;

  private:
    glm::vec3 eye_{0.0f, 0.0f, 5.0f}, target_{0.0f};
    float verticalFov_ = 0.785398f;
    std::optional<float> orthographicHeight_;
};
