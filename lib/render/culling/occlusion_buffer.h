#pragma once

#include "render/culling/occlusion_kernel.h"

#include <span>
#include <vector>

namespace candela {

/// Pixels whose centres lie in a rectangle.
struct PixelBox {
    int minX, minY, maxX, maxY;  ///< `max` is included.
};

/// How near the farthest surface of each block of 8 × 8 pixels is, at least: a low-resolution depth buffer to
/// test bounds against. Depth is 1 / w, larger where it is nearer; 0 where nothing is known. Source:
/// Hasselgren, Andersson and Akenine-Möller, "Masked software occlusion culling", HPG 2016.
class OcclusionBuffer {
  public:
    explicit OcclusionBuffer(const OcclusionKernel& kernel = *occlusionKernels().front()) : kernel_(kernel) {}

    /// Forgets all, for a picture of `width` × `height` pixels.
    void clear(int width, int height);
    /// Adds polygons on all cores. Near ones are to come before far ones.
    void draw(std::span<const OccluderPolygon> polygons);
    /// Does every pixel of the box surely show a surface that is nearer than `nearest`? The box is not
    /// clipped. False where it is out of the picture.
    bool hides(const PixelBox& box, float nearest) const;

  private:
    const OcclusionKernel& kernel_;
    int width_ = 0, height_ = 0, columns_ = 0, rows_ = 0;
    std::vector<float> nearness_;  ///< Of whole blocks.
    std::vector<PartialBlock> partial_;
};

}  // namespace candela
