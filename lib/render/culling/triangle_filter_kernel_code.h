#pragma once

// The kernels of the triangle filter. Each render/kernels_*.cpp includes this once and is compiled for its
// own instruction set, with CANDELA_TRIANGLE_KERNEL naming the table it defines.

#include "render/culling/triangle_filter_kernel.h"

#include "render/simd.h"

namespace candela {
namespace {

/// 0, 1, 2, ...
inline Ints laneNumbers() {
    Ints lanes;
    for (int lane = 0; lane < laneCount; ++lane) lanes[lane] = lane;
    return lanes;
}

inline Ints wordsAt(const std::uint32_t* words, Ints index) {
    return (Ints)lookUp(reinterpret_cast<const float*>(words), index);
}

inline Ints least(Ints a, std::int32_t b) {
    return a < b ? a : b - Ints{};
}

/// `rows[k]` times the position and 1.
inline Floats rowTimes(const float (&row)[4], Floats x, Floats y, Floats z) {
    return row[0] * x + row[1] * y + row[2] * z + row[3];
}

void transformVertices(const ScreenTransform& job) {
    // The rasteriser rounds to 1/256 pixel; and what dividing rounds.
    constexpr float snapping = 1.0f / 64.0f, rounding = 1.0e-6f;
    const auto last = static_cast<std::int32_t>(job.count - 1);
    const float* vertices = job.vertices;
    for (std::uint32_t i = 0; i < job.count; i += laneCount) {
        const Ints vertex = least(laneNumbers() + static_cast<std::int32_t>(i), last) * vertexFloats;
        const Floats px = lookUp(vertices, vertex), py = lookUp(vertices + 1, vertex),
                     pz = lookUp(vertices + 2, vertex);
        const Floats w = rowTimes(job.rows[2], px, py, pz);
        const Ints placed = w > 8.0f * job.errors[2];
        const Floats inverse = reciprocal(select(placed, w, splat(1.0f)));
        const Floats x = rowTimes(job.rows[0], px, py, pz) * inverse,
                     y = rowTimes(job.rows[1], px, py, pz) * inverse;
        // Of a quotient whose divisor is off by an eighth at most.
        const Floats error =
            max(job.errors[0] + abs(x) * job.errors[2], job.errors[1] + abs(y) * job.errors[2]);
        const Floats margin = 1.15f * error * inverse + (abs(x) + abs(y)) * rounding + snapping;
        store(job.out.x + i, select(placed, x, Floats{}));
        store(job.out.y + i, select(placed, y, Floats{}));
        store(job.out.margin + i, select(placed, margin, splat(anywhere)));
        store(job.out.depth + i, w + job.errors[2]);
    }
}

inline Floats max3(Floats a, Floats b, Floats c) {
    return max(max(a, b), c);
}
inline Floats min3(Floats a, Floats b, Floats c) {
    return min(min(a, b), c);
}

/// Lies the centre of a pixel, of `size` pixels, between `low` and `high`?
inline Ints holdsCenter(Floats low, Floats high, float size) {
    const Floats first = min(max(low - 0.5f, 0.0f), size), end = min(high - 0.5f, size - 1.0f);
    const Floats whole = __builtin_convertvector(__builtin_convertvector(first, Ints), Floats);
    const Floats center = select(whole < first, whole + 1.0f, whole);
    return center <= end;
}

/// The corners of triangles.
struct Corner {
    Floats x, y, margin;
};

inline Corner cornerAt(const ScreenColumns& vertices, Ints index) {
    return {lookUp(vertices.x, index), lookUp(vertices.y, index), lookUp(vertices.margin, index)};
}

/// Faces a triangle surely away?
inline Ints isTurned(const Corner& a, const Corner& b, const Corner& c, float facing) {
    const Floats abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
    const Floats area = (abx * acy - acx * aby) * facing;
    const Floats margin = max3(a.margin, b.margin, c.margin);
    const Floats reach = abs(abx) + abs(aby) + abs(acx) + abs(acy);
    // Each difference is off by two margins; and what the products round.
    const Floats error = 2.0f * margin * reach + 8.0f * margin * margin + 1.0e-6f * reach * reach;
    return area < -error;
}

inline Ints isKept(const FilterTriangles& job, Ints ia, Ints ib, Ints ic) {
    const Corner a = cornerAt(job.vertices, ia), b = cornerAt(job.vertices, ib),
                 c = cornerAt(job.vertices, ic);
    const Floats left = min3(a.x - a.margin, b.x - b.margin, c.x - c.margin);
    const Floats right = max3(a.x + a.margin, b.x + b.margin, c.x + c.margin);
    const Floats bottom = min3(a.y - a.margin, b.y - b.margin, c.y - c.margin);
    const Floats top = max3(a.y + a.margin, b.y + b.margin, c.y + c.margin);
    Ints kept = holdsCenter(left, right, job.width) & holdsCenter(bottom, top, job.height);
    if (job.facing != 0.0f) kept &= ~isTurned(a, b, c, job.facing);
    const Floats depth =
        max3(lookUp(job.vertices.depth, ia), lookUp(job.vertices.depth, ib), lookUp(job.vertices.depth, ic));
    return kept & (depth >= job.nearDepth);
}

std::uint32_t filterTriangles(const FilterTriangles& job) {
    std::uint32_t written = 0;
    const auto last = static_cast<std::int32_t>(job.count - 1);
    for (std::uint32_t i = 0; i < job.count; i += laneCount) {
        const Ints triangle = laneNumbers() + static_cast<std::int32_t>(i);
        const Ints first = least(triangle, last) * 3;
        const Ints a = wordsAt(job.indices, first), b = wordsAt(job.indices + 1, first),
                   c = wordsAt(job.indices + 2, first);
        const Ints kept = isKept(job, a, b, c) & (triangle <= last);
        for (int lane = 0; lane < laneCount; ++lane) {
            if (kept[lane] == 0) continue;
            const std::uint32_t* from = job.indices + 3 * (i + static_cast<std::uint32_t>(lane));
            for (int k = 0; k < 3; ++k) job.out[written++] = from[k];
        }
    }
    return written;
}

}  // namespace

extern const TriangleFilterKernel CANDELA_TRIANGLE_KERNEL;
const TriangleFilterKernel CANDELA_TRIANGLE_KERNEL{CANDELA_KERNEL_NAME, transformVertices, filterTriangles};

}  // namespace candela
