#pragma once

#include <candela/camera.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace candela {

struct TileFrame;

/// The view frustum without a far plane, for culling spheres, and the camera frame it stands in.
class Frustum {
  public:
    /// `aspect` is width over height.
    Frustum(const CameraView& view, float aspect);

    /// False only when the sphere lies wholly outside.
    bool meets(const glm::vec3& center, float radius) const;
    /// Does the sphere reach to the near plane or behind it?
    bool meetsNearPlane(const glm::vec3& center, float radius) const;

    /// The rectangle that the sphere's projection fills: least and greatest x and y, as shares of the picture
    /// (0 to 1 from its lower left corner), not clipped. The sphere must lie wholly in front of the near
    /// plane. Source: tangent lines from the eye, as in Mara and McGuire, "2D polyhedral bounds of a clipped,
    /// perspective-projected 3D sphere", 2013.
    struct Rectangle {
        glm::vec2 min, max;
    };
    Rectangle projectedBounds(const glm::vec3& center, float radius) const;

    /// The frustum as the kernels of the technique `tiles` read it.
    void copyTo(TileFrame& frame) const;

  private:
    glm::vec3 eye_, right_, up_, forward_;
    float near_;
    glm::vec2 halfExtent_;  ///< Of the picture at a depth of one metre.
    glm::vec2 edgeScale_;   ///< 1 / length of a side plane's unnormalised normal.
};

}  // namespace candela
