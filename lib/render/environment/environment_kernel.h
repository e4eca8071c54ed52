#pragma once

#include "render/occlusion/visibility_filter.h"

#include <cstdint>
#include <vector>

namespace candela {

/// The part of a picture that lies in one cell of an octahedral grid: a point of light.
struct EnvironmentCell {
    float direction[3];  ///< The middle of its light, unit length; while cells are summed, its moment.
    float solidAngle;    ///< Steradian; 0 where no texel of the picture has its centre in the cell.
    float energy[3];     ///< Radiance times solid angle.
    float side;          ///< Of the cell, as an angle.
};

/// A square octahedral grid of cells.
struct CellGrid {
    const EnvironmentCell* cells;  ///< size × size, rows from -Z, columns from -X.
    int size;
};

/// Texels along a side of the blocks that are filtered together.
constexpr int filterBlockSize = 4;

/// An octahedral map to be filled with the radiance that a GGX lobe of normal incidence gathers around each
/// direction. Plain numbers only: each kernel is compiled for its own instruction set and must not share
/// inline functions with other files.
struct FilterJob {
    const CellGrid* grids;  ///< From coarse to fine: each has twice the size of the one before.
    int gridCount;
    float alpha;      ///< roughness²
    float cellShare;  ///< A cell is read as one point where its size is at most this share of its distance
                      ///< from a texel's direction, the width of the lobe added.
    int size;         ///< Texels along a side.
    float* texels;    ///< RGBA, `size` rows.
};

/// An octahedral map to be filled with irradiance.
struct IrradianceJob {
    CellGrid outlines;  ///< Of 4 × 4 cells each.
    CellGrid cells;
    CellGrid parts;  ///< Four of each cell; those of a dark cell do not count.
    int size;        ///< As above.
    float* texels;
};

/// The functions of one instruction set.
struct EnvironmentKernel {
    const char* name;
    /// Both fill row `row` of blocks. `scratch` has room for all cells of the finest grid and one.
    void (*filter)(const FilterJob& job, int row, const EnvironmentCell** scratch);
    void (*irradiance)(const IrradianceJob& job, int row, const EnvironmentCell** scratch);
    /// Fills the row `row` of pixels.
    void (*visibility)(const VisibilityFilterJob& job, int row);
};

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const EnvironmentKernel*> environmentKernels();

}  // namespace candela
