#pragma once

// The kernels of the occlusion buffer. Each render/kernels_*.cpp includes this once and is compiled for its
// own instruction set, with CANDELA_OCCLUSION_KERNEL naming the table it defines.

#include "render/culling/occlusion_kernel.h"

#include "render/simd8.h"

namespace candela {
namespace {

namespace occlusion {

constexpr int side = occlusionBlockSide;
constexpr std::uint64_t allPixels = ~std::uint64_t{0};
/// From the middle of a block to the centres of its outer pixels.
constexpr float reach = 0.5f * (side - 1);

inline float larger(float a, float b) {
    return a > b ? a : b;
}
inline float smaller(float a, float b) {
    return a < b ? a : b;
}
inline float magnitude(float a) {
    return a < 0.0f ? -a : a;
}

inline float middleOf(int block) {
    return static_cast<float>(block * side) + 0.5f * side;
}

/// Blocks of a row from `first` to below `end`.
struct BlockSpan {
    int first, end;
};

/// Cuts the span down to the blocks whose middle is where a x + `rest` is 0 or more.
inline void cut(BlockSpan& span, float a, float rest) {
    if (magnitude(a) < 1.0e-6f) {
        if (rest < 0.0f) span.end = span.first;
        return;
    }
    // x of the middle is side × (block + 0.5).
    const float bound = smaller(larger(-rest / (a * side) - 0.5f, -1.0f), 1.0e6f);
    const int below = static_cast<int>(bound + 1.0f) - 1;  // rounded down
    if (a > 0.0f) {
        const int first = static_cast<float>(below) < bound ? below + 1 : below;
        span.first = span.first > first ? span.first : first;
    } else {
        span.end = span.end < below + 1 ? span.end : below + 1;
    }
}

inline std::uint64_t pixelsInside(const OccluderPolygon& polygon, int column, int row) {
    constexpr Eight centers{0.5f, 1.5f, 2.5f, 3.5f, 4.5f, 5.5f, 6.5f, 7.5f};
    const Eight x = centers + splat8(static_cast<float>(column * side));
    std::uint64_t pixels = allPixels;
    for (std::uint32_t i = 0; i < polygon.edgeCount; ++i) {
        const OccluderPolygon::Edge& edge = polygon.edges[i];
        const Eight across = splat8(edge.a) * x;
        std::uint64_t inside = 0;
        for (int y = 0; y < side; ++y) {
            const float rest = edge.b * (static_cast<float>(row * side + y) + 0.5f) + edge.c;
            inside |= std::uint64_t{bitsOf(across + splat8(rest) >= 0.0f)} << (side * y);
        }
        pixels &= inside;
        if (pixels == 0) break;
    }
    return pixels;
}

inline void addPartial(float& whole, PartialBlock& partial, std::uint64_t pixels, float nearness) {
    if (pixels == 0) return;
    const bool isStale = partial.pixels == 0 || partial.nearness <= whole;
    // What is much nearer starts anew: together they would be as far as the farther one.
    if (isStale || nearness - partial.nearness > partial.nearness - whole) {
        partial = {pixels, nearness};
    } else {
        partial.pixels |= pixels;
        partial.nearness = smaller(partial.nearness, nearness);
    }
    if (partial.pixels != allPixels) return;
    whole = larger(whole, partial.nearness);
    partial = {0, 0.0f};
}

void drawRow(const OccluderPolygon& polygon, const OcclusionRow& to) {
    const float y = middleOf(to.row);
    BlockSpan met{0, to.columns}, whole{0, to.columns};
    for (std::uint32_t i = 0; i < polygon.edgeCount; ++i) {
        const OccluderPolygon::Edge& edge = polygon.edges[i];
        // A hundredth of a pixel is more than these sums round.
        const float rest = edge.b * y + edge.c,
                    across = reach * (magnitude(edge.a) + magnitude(edge.b)) + 0.01f;
        cut(met, edge.a, rest + across);
        cut(whole, edge.a, rest - across);
    }
    if (met.first >= met.end) return;
    if (whole.first >= whole.end) whole = {met.end, met.end};
    const float planeX = polygon.plane[0], planeY = polygon.plane[1];
    const float rest = planeY * y + polygon.plane[2] - reach * (magnitude(planeX) + magnitude(planeY));
    const auto nearnessAt = [&](int column) {
        return larger(planeX * middleOf(column) + rest, polygon.farthest);
    };
    const auto drawPartial = [&](int column) {
        const float nearness = nearnessAt(column);
        if (nearness > to.nearness[column])
            addPartial(to.nearness[column], to.partial[column], pixelsInside(polygon, column, to.row),
                       nearness);
    };
    for (int column = met.first; column < whole.first; ++column) drawPartial(column);
    for (int column = whole.first; column < whole.end; ++column)
        to.nearness[column] = larger(to.nearness[column], nearnessAt(column));
    for (int column = whole.end; column < met.end; ++column) drawPartial(column);
}

}  // namespace occlusion

}  // namespace

extern const OcclusionKernel CANDELA_OCCLUSION_KERNEL;
const OcclusionKernel CANDELA_OCCLUSION_KERNEL{CANDELA_KERNEL_NAME, occlusion::drawRow};

}  // namespace candela
