#pragma once

#include <cstdint>

namespace candela {

/// Sixteen pixels from which rays start to all sides, as kernels of every instruction set write them. Plain
/// numbers only.
struct alignas(64) HemisphereBlock {
    static constexpr int size = 16;

    float origin[3][size];           ///< Where rays start.
    float normal[3][size];           ///< For shading.
    float tangents[2][3][size];      ///< Perpendicular to it and to each other.
    float geometricNormal[3][size];  ///< The triangle's; 0 where there is no surface.
    float position[3][size];         ///< Of the surface, from the eye, metres.
    float extent[size];              ///< The side of a pixel at the surface, metres; 0 where there is none.
    std::int32_t active[size];       ///< As in `RayPacket`: the pixels with a surface.
};

}  // namespace candela
