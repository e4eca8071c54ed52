#pragma once

#include <opensubdiv/sdc/types.h>

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace candela_plugins::opensubdiv {

/// Where on a face its surface is evaluated.
struct GridSlot {
    std::uint32_t point;  ///< The face's point at this location.
    std::uint32_t patch;  ///< Which of its patches.
    double s, t;          ///< Parameters of the patch, 0 to 1.
};

/// The tessellation of the faces of one size. The points of a face are its corners, then
/// those within its edges, `segments - 1` each in the direction of the face, and those inside.
///
/// A slot is a location to evaluate, and becomes a vertex to draw. Slot i lies at point i; there are more
/// slots than points only with the bilinear scheme: a face of other than 4 corners is cut into sub-faces,
/// which it does not join smoothly.
struct FaceGrid {
    std::uint32_t size;      ///< Corners of the face.
    std::uint32_t segments;  ///< Of each edge: 2^level.
    std::uint32_t pointCount;
    std::vector<GridSlot> slots;
    std::uint32_t polygonSize;            ///< 4, or 3.
    std::vector<std::uint32_t> polygons;  ///< `polygonSize` slots each, counter-clockwise.

    std::uint32_t edgeSlots() const { return segments - 1; }
    std::uint32_t firstEdgeSlot(std::uint32_t edge) const { return size + edge * edgeSlots(); }
    std::uint32_t firstInnerSlot() const { return size * segments; }
    std::uint32_t innerPoints() const { return pointCount - firstInnerSlot(); }
    std::uint32_t extraSlots() const { return static_cast<std::uint32_t>(slots.size()) - pointCount; }
    std::uint32_t polygonCount() const { return static_cast<std::uint32_t>(polygons.size() / polygonSize); }
};

/// The number of points of a face at `level`.
std::uint64_t gridPoints(OpenSubdiv::Sdc::SchemeType scheme, std::uint64_t size, std::uint32_t level);

/// The grids of all face sizes of a cage, whose size `checkTableSize` has checked.
class FaceGrids {
  public:
    FaceGrids(OpenSubdiv::Sdc::SchemeType scheme, std::uint32_t level,
              std::span<const std::uint32_t> faceSizes);

    const FaceGrid& of(std::uint32_t faceSize) const { return grids_.at(faceSize); }

  private:
    std::map<std::uint32_t, FaceGrid> grids_;
};

}  // namespace candela_plugins::opensubdiv
