#pragma once

#include "render/environment/environment_kernel.h"
#include "render/environment/environment_picture.h"

#include <glm/vec3.hpp>

#include <vector>

namespace candela {

/// A picture as points of light: every texel belongs to the cell of an octahedral grid in which its centre
/// lies, and each coarser grid sums four cells of the finer one. A picture of fewer than 2048 × 1024 texels
/// is first interpolated to at least as many. The grids hold all of the light and the whole sphere.
class EnvironmentCells {
  public:
    explicit EnvironmentCells(const EnvironmentPicture& picture);

    /// From coarse to fine.
    const std::vector<CellGrid>& grids() const { return grids_; }
    /// With `size` cells along a side: a power of two from `coarsestSize` to `finestSize`.
    const CellGrid& gridOf(int size) const;

    static constexpr int coarsestSize = 8, finestSize = 1024;

  private:
    void addQuadrant(const EnvironmentPicture& picture, int quadrant, float floor);

    std::vector<std::vector<EnvironmentCell>> cells_;
    std::vector<CellGrid> grids_;
};

/// A small source of much light.
struct EnvironmentPeak {
    glm::vec3 direction{0.0f};   ///< Unit length.
    glm::vec3 irradiance{0.0f};  ///< Of a surface that faces it.
    /// The cosines to its parts are spread about evenly by this much in both directions: over 0.
    float halfWidth = 0.0f;
};

constexpr std::size_t maxEnvironmentPeaks = 4;

/// The light of an environment for irradiance: a grid of 64 × 64 cells without the light of the peaks.
/// Sources of a radius up to 0.05 that hold more than a 20th of all light become peaks: their irradiance has
/// an edge where they set, which no map of moderate size holds.
struct DiffuseLight {
    explicit DiffuseLight(const EnvironmentCells& source);

    static constexpr int size = 64;  ///< Of the grid `cells`.
    std::vector<EnvironmentCell> cells;
    std::vector<EnvironmentPeak> peaks;
};

}  // namespace candela
