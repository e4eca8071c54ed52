#pragma once

// The kernels of the triangle filter. Each render/kernels_*.cpp includes this once and is compiled for its
// own instruction set, with CANDELA_TRIANGLE_KERNEL naming the table it defines.

#include "render/culling/triangle_filter_kernel.h"

#include "render/culling/cluster_kernel_code.h"
#include "render/simd.h"

namespace candela {
namespace {

namespace triangles {

using layout::FilterView;
using Real = Floats;
using Mask = Ints;

inline Mask both(Mask a, Mask b) {
    return a & b;
}
inline Mask either(Mask a, Mask b) {
    return a | b;
}
inline Mask negated(Mask a) {
    return ~a;
}
inline Real wholeNumber(Real a) {
    const Real whole = __builtin_convertvector(__builtin_convertvector(a, Ints), Floats);
    return select(whole < a, whole + 1.0f, whole);
}

#define SHARED_FUNCTION __attribute__((always_inline)) inline
#include "shared/triangle_filter.h"
#undef SHARED_FUNCTION

}  // namespace triangles

/// 0, 1, 2, ...
inline Ints laneNumbers() {
    Ints lanes;
    for (int lane = 0; lane < laneCount; ++lane) lanes[lane] = lane;
    return lanes;
}

inline Ints least(Ints a, std::int32_t b) {
    return a < b ? a : b - Ints{};
}

/// The corners `corner` of the triangles whose indices start at `first`; those from `last` on are the same.
inline triangles::ScreenCorner cornersAt(const FilterTriangles& job, const std::uint32_t* first,
                                         std::uint32_t last) {
    const float* from[laneCount];
    for (std::uint32_t lane = 0; lane < laneCount; ++lane)
        from[lane] = job.vertices + std::size_t{first[3 * (lane < last ? lane : last)]} * vertexFloats;
    Floats x, y, z, unused;
    loadRecords(from, x, y, z, unused);
    return triangles::cornerOf(*job.view, x, y, z);
}

std::uint32_t filterTriangles(const FilterTriangles& job) {
    std::uint32_t written = 0;
    for (std::uint32_t i = 0; i < job.count; i += laneCount) {
        const std::uint32_t* first = job.indices + 3 * std::size_t{i};
        const std::uint32_t last = job.count - 1 - i;
        const Ints kept =
            triangles::mayShow(*job.view, cornersAt(job, first, last), cornersAt(job, first + 1, last),
                               cornersAt(job, first + 2, last));
        std::uint32_t bits = laneBits(kept);
        if (last < laneCount - 1) bits &= (2u << last) - 1;
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t* from = first + 3 * __builtin_ctz(bits);
            for (int k = 0; k < 3; ++k) job.out[written + static_cast<std::uint32_t>(k)] = from[k];
            written += 3;
        }
    }
    return written;
}

std::uint64_t cullClusters(const CullClusters& job) {
    constexpr auto floats = static_cast<std::int32_t>(sizeof(layout::TriangleCluster) / sizeof(float));
    std::uint64_t kept = 0;
    for (std::uint32_t i = 0; i < job.count; i += laneCount) {
        const Ints record =
            least(laneNumbers() + static_cast<std::int32_t>(i), static_cast<std::int32_t>(job.count - 1)) *
            floats;
        const float* from = job.clusters->center;
        triangles::ClusterBounds bounds;
        bounds.x = lookUp(from, record);
        bounds.y = lookUp(from + 1, record);
        bounds.z = lookUp(from + 2, record);
        bounds.radius = lookUp(from + 3, record);
        bounds.axisX = lookUp(from + 4, record);
        bounds.axisY = lookUp(from + 5, record);
        bounds.axisZ = lookUp(from + 6, record);
        bounds.cosine = lookUp(from + 7, record);
        bounds.altitude = lookUp(from + 8, record);
        kept |= std::uint64_t{laneBits(triangles::mayShowAny(*job.view, bounds))} << i;
    }
    return job.count == 64 ? kept : kept & ((std::uint64_t{1} << job.count) - 1);
}

}  // namespace

extern const TriangleFilterKernel CANDELA_TRIANGLE_KERNEL;
const TriangleFilterKernel CANDELA_TRIANGLE_KERNEL{CANDELA_KERNEL_NAME, cullClusters, filterTriangles,
                                                   boundClusters};

}  // namespace candela
