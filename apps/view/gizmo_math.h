#pragma once

#include <candela/camera.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <optional>

/// Clip coordinates of world points. Their depth means nothing, so that no plane cuts anything off.
glm::mat4 clipFromWorldOf(const candela::CameraView& view, float aspect);

/// A rectangle of the screen that shows what a camera sees. Any unit; y points down.
class ScreenView {
  public:
    ScreenView(const candela::CameraView& view, const glm::vec2& corner, const glm::vec2& size);

    /// Where a point of the world lies; none behind the camera.
    std::optional<glm::vec2> at(const glm::vec3& point) const;
    struct Ray {
        glm::vec3 origin{0.0f}, direction{0.0f, 0.0f, -1.0f};  ///< Unit length.
    };
    /// What lies under a place.
    Ray rayAt(const glm::vec2& place) const;
    /// The metres that a length on the screen covers at a point.
    float metresAt(const glm::vec3& point, float length) const;

  private:
    candela::CameraView view_;
    glm::vec2 corner_, size_;
    glm::mat4 clipFromWorld_;
};

/// What a gizmo does.
enum class GizmoMode { move, turn, scale };

/// A part of a gizmo that is dragged: an axis, or the middle.
enum class GizmoHandle { x, y, z, middle };

/// The shape of a gizmo on the screen: axes as lines, or circles about them.
struct GizmoShape {
    glm::vec3 origin{0.0f};
    float metres = 1.0f;  ///< Length of an axis, radius of a circle.
};
/// A circle about an axis as a closed line of world points.
std::array<glm::vec3, 49> circlePoints(const GizmoShape& shape, GizmoHandle axis);

/// The handle under a place, nearer than `reach` to it; none.
std::optional<GizmoHandle> handleAt(const ScreenView& screen, const GizmoShape& shape, GizmoMode mode,
                                    const glm::vec2& place, float reach);

/// What a drag from one place to another does to the world, about the origin of the gizmo. The identity where
/// the drag has no meaning, as along an axis that points to the eye.
glm::mat4 dragged(const ScreenView& screen, const GizmoShape& shape, GizmoMode mode, GizmoHandle handle,
                  const glm::vec2& from, const glm::vec2& to);
