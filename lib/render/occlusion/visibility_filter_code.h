#pragma once

// The filter of what rays find of an environment, over vectors of pixels. Included only by
// environment_kernel_code.h.

#include "render/occlusion/visibility_filter.h"

#include "render/simd.h"

namespace candela {
namespace {

inline Vec3 loadColumns(const float* const (&columns)[3], std::ptrdiff_t at) {
    return {load(columns[0] + at), load(columns[1] + at), load(columns[2] + at)};
}

/// x, x + 1, ...
inline Floats columnsFrom(int x) {
    Floats columns;
    for (int lane = 0; lane < laneCount; ++lane) columns[lane] = static_cast<float>(x + lane);
    return columns;
}

/// The mean of `hidden` over the window of each of `laneCount` pixels of row y from column x on.
inline Floats meanHidden(const VisibilityFilterJob& job, int x, int y) {
    const std::ptrdiff_t pixel = static_cast<std::ptrdiff_t>(y) * job.width + x;
    const Vec3 normal = loadColumns(job.normal, pixel), position = loadColumns(job.position, pixel);
    const Floats limit = load(job.extent + pixel) * job.maxDistance;
    const Floats zero = splat(0.0f), one = splat(1.0f);
    Floats sum = zero, weight = zero;
    for (int row = y + job.bottom; row < y + job.bottom + job.side; ++row) {
        if (row < 0 || row >= job.height) continue;
        for (int across = job.left; across < job.left + job.side; ++across) {
            const std::ptrdiff_t other = static_cast<std::ptrdiff_t>(row) * job.width + x + across;
            const Vec3 otherNormal = loadColumns(job.normal, other);
            const Floats distance = dot(normal, loadColumns(job.position, other) - position);
            const Floats column = columnsFrom(x + across);
            const Ints counts = (abs(distance) <= limit) & (dot(normal, otherNormal) >= job.minCosine) &
                                (column >= 0.0f) & (column < static_cast<float>(job.width));
            sum = sum + select(counts, load(job.hidden + other), zero);
            weight = weight + select(counts, one, zero);
        }
    }
    return select(weight > 0.0f, sum * reciprocal(max(weight, 1.0f)), load(job.hidden + pixel));
}

/// Whether rays of any pixel in the windows of these have been hidden.
inline bool anyHidden(const VisibilityFilterJob& job, int x, int y) {
    Floats most = splat(0.0f);
    for (int row = y + job.bottom; row < y + job.bottom + job.side; ++row) {
        if (row < 0 || row >= job.height) continue;
        const float* hidden = job.hidden + static_cast<std::ptrdiff_t>(row) * job.width + x;
        most = max(most, max(load(hidden + job.left), load(hidden + job.left + job.side - 1)));
    }
    float lanes[laneCount];
    store(lanes, most);
    for (const float lane : lanes) {
        if (lane > 0.0f) return true;
    }
    return false;
}

void filterVisibilityRow(const VisibilityFilterJob& job, int y) {
    for (int x = 0; x < job.width; x += laneCount) {
        const Floats hidden = anyHidden(job, x, y) ? meanHidden(job, x, y) : splat(0.0f);
        float visible[laneCount];
        store(visible, (1.0f - hidden) * 255.0f);
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(y) * job.width + x;
        const int count = job.width - x < laneCount ? job.width - x : laneCount;
        for (int lane = 0; lane < count; ++lane) {
            const std::ptrdiff_t pixel = first + lane;
            const float texture =
                job.textures == nullptr ? 1.0f : static_cast<float>(job.textures[pixel]) * (1.0f / 255.0f);
            const float share = job.extent[pixel] > 0.0f ? visible[lane] * texture : 0.0f;
            job.visibility[pixel] = static_cast<std::uint8_t>(share + 0.5f);
        }
    }
}

}  // namespace
}  // namespace candela
