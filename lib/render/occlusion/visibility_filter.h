#pragma once

#include <cstddef>
#include <cstdint>

namespace candela {

/// What pixels have found of their environment, to be averaged over windows of neighbours on one surface.
/// Plain numbers only, as for every kernel. Columns have a number a pixel, rows from the bottom; `padding`
/// numbers before and after them may be read.
struct VisibilityFilterJob {
    static constexpr std::size_t padding = 32;

    const float* normal[3];        ///< The triangle's; 0 where there is no surface.
    const float* position[3];      ///< Metres.
    const float* extent;           ///< The side of a pixel at the surface, metres; 0 where there is none.
    const float* hidden;           ///< 0 to 1.
    const std::uint8_t* textures;  ///< What occlusion textures leave, 255 is 1; null: all.
    std::uint8_t* visibility;      ///< To be filled; 0 where there is no surface.
    int width, height;
    int left, bottom, side;  ///< The window: the first offsets from the pixel, and how many along an axis.
    float maxDistance;       ///< From the plane of the pixel, over `extent`.
    float minCosine;         ///< Of the angle between the normals.
};

}  // namespace candela
