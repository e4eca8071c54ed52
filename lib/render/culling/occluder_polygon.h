#pragma once

#include "render/culling/occluder_mesh.h"
#include "render/culling/occlusion_buffer.h"
#include "render/culling/triangle_filter_kernel.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candela {

/// What a shape may cover of the screen, and how near it comes: 1 / w at most.
struct BoxOnScreen {
    PixelBox pixels;
    float nearest;
};

/// Consecutive triangles.
struct TriangleRange {
    std::uint32_t first, end;

    bool contains(std::uint32_t i) const { return i >= first && i < end; }
};

/// A triangle that surely covers a part of the screen.
struct Occluder {
    bool isDrawn = false;               ///< Else it faces away, or is thin on the screen.
    double orientation = 1.0;           ///< 1: counter-clockwise, or -1.
    std::array<glm::dvec3, 3> corners;  ///< x and y times w, and w.
    BoxOnScreen box;                    ///< Of what is not clipped.
    double sharpness;                   ///< Length over width, about 1 or more.
    double margin;                      ///< Pixels that the device may be off.
    double farthest;                    ///< The least 1 / w.
    bool isClipped;                     ///< By the near plane.
    glm::dvec3 nearness;                ///< x, y and 1 times it: 1 / w.
    double slope = 0.0;                 ///< Of 1 / w, over pixels.
    double depthError = 0.0;            ///< Of 1 / w, by the device's interpolation.
};

/// Where a triangle is, which the near plane does not clip.
struct TriangleBox {
    std::uint32_t triangle;
    BoxOnScreen box;
};

/// Finds what triangles of an instance surely cover.
class OccluderSetup {
  public:
    /// Appends polygons of the triangles `chosen`, but for those that face away or are thin on the screen.
    /// All of `drawn` are opaque and drawn, the chosen ones among them.
    void append(const OccluderMesh& mesh, const layout::FilterView& view, const TriangleRange& drawn,
                std::span<const std::uint32_t> chosen, std::vector<OccluderPolygon>& polygons,
                std::vector<TriangleBox>& boxes);

  private:
    OccluderPolygon polygonOf(std::uint32_t triangle);
    const Occluder& occluder(std::uint32_t triangle);
    std::optional<Occluder> sharedWith(std::uint32_t triangle, std::size_t edge);

    // Of the call in progress.
    const OccluderMesh* mesh_ = nullptr;
    const layout::FilterView* view_ = nullptr;
    TriangleRange drawn_{};
    std::vector<Occluder> occluders_;
    std::vector<std::uint32_t> places_;  ///< Of each triangle among them, or `OccluderMesh::none`.
    std::vector<std::uint32_t> placed_;  ///< Triangles that have one.
};

/// None where the box reaches to the near plane.
std::optional<BoxOnScreen> boxOnScreen(const Bounds& box, const layout::FilterView& view);

}  // namespace candela
