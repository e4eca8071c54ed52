#pragma once

#include <cstdint>

namespace candela {

/// A node of a `WideTree`: at most eight children with their boxes, laid out for vectors of eight. Plain
/// numbers only: kernels of every instruction set read it.
struct alignas(32) WideNode {
    static constexpr unsigned width = 8;
    static constexpr std::uint32_t leafFlag = 0x80000000u;
    static constexpr std::uint32_t noChild = 0xffffffffu;

    /// The box of a missing child is inverted: `min` is the largest float and `max` the lowest one.
    float minX[width], minY[width], minZ[width], maxX[width], maxY[width], maxZ[width];
    /// The index of a node; `leafFlag` plus the index of a leaf; or `noChild`. Missing children come last.
    std::uint32_t child[width];
};

/// The triangles of a leaf, laid out for vectors of eight. After the last triangle the first one is repeated.
struct alignas(32) TriangleBlock {
    static constexpr unsigned width = 8;

    float x[3][width], y[3][width], z[3][width];  ///< Of the corners.
    std::uint32_t triangle[width];                ///< Its index in the mesh.
};

}  // namespace candela
