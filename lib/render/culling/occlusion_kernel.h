#pragma once

#include <cstdint>
#include <vector>

namespace candela {

// Plain numbers only, as in triangle_filter_kernel.h.

/// A convex part of the screen, pixels from the lower left corner: every pixel whose centre lies in it is
/// surely covered by an opaque surface.
struct OccluderPolygon {
    /// A half-plane: a x + b y + c is 0 or more inside. a and b are of unit length together.
    struct Edge {
        float a, b, c;
    };
    Edge edges[4];
    std::uint32_t edgeCount;
    /// 1 / w of the surface at a place, at least: x × plane[0] + y × plane[1] + plane[2], or `farthest`.
    float plane[3];
    float farthest;
    int minY, maxY;  ///< Of the pixels.
};

/// What covers a part of a block of pixels.
struct PartialBlock {
    std::uint64_t pixels;  ///< A bit each.
    float nearness;        ///< Of the farthest of them, at least.
};

/// A row of blocks.
struct OcclusionRow {
    int row, columns;
    float* nearness;        ///< Of whole blocks.
    PartialBlock* partial;  ///< One a block.
};

constexpr int occlusionBlockSide = 8;

/// The functions of one instruction set.
struct OcclusionKernel {
    const char* name;
    void (*draw)(const OccluderPolygon& polygon, const OcclusionRow& row);
};

/// One for each instruction set that this build has and this processor runs, widest first.
std::vector<const OcclusionKernel*> occlusionKernels();

}  // namespace candela
