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

/// Sets bit i of the result where the active ray i meets something.
using TracePacket = std::uint32_t (*)(const void* structure, const RayPacket& packet);

}  // namespace candela
