#pragma once

#include "render/culling/triangle_filter_kernel.h"
#include "render/gpu_scene/gpu_instances.h"
#include "render/layout.h"

#include <glm/vec4.hpp>

#include <span>

namespace candela {

/// What the filter sees instances with in one frame.
class FilterCamera {
  public:
    /// For the rasteriser of the current context.
    explicit FilterCamera(const layout::FrameUniforms& frame);

    /// `worldRows` are the rows of an instance's matrix, `sphere` holds its mesh; `facing` as in
    /// `FilterView`.
    layout::FilterView view(std::span<const glm::vec4> worldRows, const BoundingSphere& sphere,
                            float facing) const;

  private:
    glm::dvec4 toScreen_[3];  ///< From the world to x and y on the screen, both times w, and to w.
    float width_, height_, nearDepth_, snapping_;
};

}  // namespace candela
