#pragma once

#include <cstdint>

namespace candela {

/// Sixteen occlusion rays, as kernels of every instruction set write them. Plain numbers only.
struct alignas(64) RayPacket {
    static constexpr int size = 16;

    float origin[3][size];
    float direction[3][size];      ///< Of any length over 0.
    float tMin[size], tMax[size];  ///< A hit at origin + t × direction counts for t between them.
    std::int32_t active[size];     ///< -1: the ray is traced; 0: it is not.
};

/// Fills `transmittance`, a number a ray: the share of light that passes along the active ray i, which is 1
/// where it meets nothing, 0 where it meets something opaque, and the product of 1 - alpha over the blended
/// surfaces that it meets; 1 for other rays. Sets bit i of the result where that is 0.
using TracePacket = std::uint32_t (*)(const void* structure, const RayPacket& packet, float* transmittance);

}  // namespace candela
