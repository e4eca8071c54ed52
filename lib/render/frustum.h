#pragma once

#include "scene/model/view_window.h"

#include <candela/camera.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace candela {

/// The view frustum without a far plane, for culling spheres (shaders/shared/light_bounds.h).
class Frustum {
  public:
    /// `aspect` is width over height; read where the view has none.
    Frustum(const CameraView& view, float aspect) : Frustum(view, viewWindow(view, aspect)) {}
    /// Of what a window shows.
    Frustum(const CameraView& view, const ViewWindow& window);

    /// False only when the sphere lies wholly outside.
    bool meets(const glm::vec3& center, float radius) const;
    /// `size` is the largest side of points and lines that are drawn, a share of the window's height; 0 at
    /// first.
    void setElementSize(float size) { elementSize_ = size; }
    /// The radius of a sphere that holds what is drawn of points and lines whose corners lie in a sphere.
    float radiusOfElements(const glm::vec3& center, float radius) const;
    /// Does the sphere reach to the near plane or behind it?
    bool meetsNearPlane(const glm::vec3& center, float radius) const;

    /// The rectangle under the sphere's projection: minimum and maximum x and y, in units of the picture's
    /// width and height from its lower left corner, not clipped. The sphere must lie wholly in front of the
    /// near plane.
    struct Rectangle {
        glm::vec2 min, max;
    };
    Rectangle projectedBounds(const glm::vec3& center, float radius) const;

    /// Camera space: x right, y up, z the depth.
    glm::vec3 inCameraSpace(const glm::vec3& position) const;

  private:
    glm::vec3 eye_, right_, up_, forward_;
    float near_;
    glm::vec2 halfExtent_;  ///< Of the picture at a depth of one metre; 0 in an orthographic view.
    glm::vec2 base_;        ///< Half of the picture in an orthographic view; 0 in a perspective one.
    glm::vec2 shift_;       ///< As `CameraView::shift`.
    glm::vec2 edgeScale_;   ///< As in `ViewFrustum`.
    float elementSize_ = 0.0f;
};

}  // namespace candela
