#pragma once

#include <candela/camera.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace candela {

/// The rectangle that a picture, or a part of one, shows of a plane across the view axis.
struct ViewWindow {
    glm::dvec2
        halfExtent;    ///< Half of its sides: one metre from the eye, or anywhere of an orthographic view.
    glm::dvec2 shift;  ///< Of its middle from the axis, in units of its width and height.
};

/// `aspect` is read where the view has none. Throws `Error` (badInput) when a member of the view is not in
/// the range that it states.
ViewWindow viewWindow(const CameraView& view, double aspect);

/// A part of a window, in pixels of `whole` x `whole` ones: from (`first.x`, `first.y`), right of and above
/// the lower left corner, `size` of them. It may reach beyond the window.
ViewWindow partOf(const ViewWindow& window, const glm::dvec2& whole, const glm::dvec2& first,
                  const glm::dvec2& size);

/// `projection` for a window. Throws as it does.
glm::mat4 projection(const CameraView& view, const ViewWindow& window);

}  // namespace candela
