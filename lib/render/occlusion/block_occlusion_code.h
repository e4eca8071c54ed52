#pragma once

// Which of sixteen rays between a light and the pixels of a block are blocked. Kernel code: see
// render/lighting/tiled/tile_kernel_code.h, which includes it.
//
// Of the triangles in the leaves that the hull of light and block meets (hull_code.h), those remain whose
// plane separates the light from a part of the block's box, and whose edges do not lie beside the box as the
// light sees them. These are tested against each ray.

#include "render/occlusion/hull_code.h"

namespace candela {
namespace {

// ---- The triangles of a leaf, as a light sees them

constexpr int raysPerBlock = RayPacket::size;

/// Sixteen points, or vectors.
struct BlockVectors {
    float x[raysPerBlock], y[raysPerBlock], z[raysPerBlock];

    Vec3 lanes(int first) const { return {load(x + first), load(y + first), load(z + first)}; }
};

/// The rays of a block from one light, in the world or in the space of an instance.
struct BlockRays {
    LightSource light;
    float origin[3];  ///< What the ends are relative to: the light, or the centre of the box.
    BlockVectors ends;
};

inline Vec3 transformedDirection(Vec3 v, const float* rows) {
    const auto row = [&](const float* r) {
        return splat(r[0]) * v.x + splat(r[1]) * v.y + splat(r[2]) * v.z;
    };
    return {row(rows), row(rows + 4), row(rows + 8)};
}

inline BlockRays transformed(const BlockRays& rays, const float* rows) {
    BlockRays result;
    result.light = transformed(rays.light, rows);
    const LightSource origin =
        transformed(LightSource{{rays.origin[0], rays.origin[1], rays.origin[2]}, true}, rows);
    for (int axis = 0; axis < 3; ++axis) result.origin[axis] = origin.place[axis];
    for (int first = 0; first < raysPerBlock; first += laneCount) {
        const Vec3 end = transformedDirection(rays.ends.lanes(first), rows);
        store(result.ends.x + first, end.x), store(result.ends.y + first, end.y),
            store(result.ends.z + first, end.z);
    }
    return result;
}

/// Rays, and the part of each next to a point light that is left out, as a share of its length.
struct StartedRays {
    BlockRays rays;
    float start[raysPerBlock];
};

/// Eight triangles, relative to the origin of the rays. A point x is hidden from the light by one of them
/// where dot(edge[k], x) + offset[k] >= 0 for each edge, and dot(normal, x) > distance. Offsets are 0 for a
/// point light.
struct TrianglesSeen {
    Eight3 edge[3], normal;
    Eight offset[3], distance;
    std::uint32_t candidates;  ///< A bit for each triangle that may hide the light from a point of the box.
};

/// A box relative to the origin of the rays.
struct CenteredBox {
    Eight3 center, half;
};

inline CenteredBox centeredBox(const EndBox& box, const float* origin) {
    float center[3], half[3];
    for (int axis = 0; axis < 3; ++axis) {
        center[axis] = 0.5f * (box.min[axis] + box.max[axis]) - origin[axis];
        half[axis] = 0.5f * (box.max[axis] - box.min[axis]);
    }
    return {splat83(center), splat83(half)};
}

/// The largest value of dot(v, x) over a box.
inline Eight largestDot(Eight3 v, const CenteredBox& box) {
    return dot8(v, box.center) + abs8(v.x) * box.half.x + abs8(v.y) * box.half.y + abs8(v.z) * box.half.z;
}

/// Edges are the cross products of the difference and the sum of two corners, which round the same, but for
/// the sign, in the two triangles that share an edge: no ray slips between them.
inline TrianglesSeen seeTriangles(const TriangleBlock& block, const BlockRays& rays, const CenteredBox& box) {
    TrianglesSeen seen;
    const LightSource& light = rays.light;
    Eight3 corner[3];
    for (int i = 0; i < 3; ++i)
        corner[i] = Eight3{load8(block.x[i]), load8(block.y[i]), load8(block.z[i])} - splat83(rays.origin);
    const Eight3 normal = cross8(corner[1] - corner[0], corner[2] - corner[0]);
    const Eight facing = light.isPoint ? dot8(normal, corner[0]) : -dot8(normal, splat83(light.place));
    // Turned so that the light is on the side of lower values. Seen from the side a triangle hides nothing.
    const Eight sign = facing < 0.0f ? splat8(-1.0f) : splat8(1.0f);
    seen.normal = normal * sign;
    seen.distance = light.isPoint ? facing * sign : dot8(seen.normal, corner[0]);
    EightInts kept = (facing != 0.0f) & (largestDot(seen.normal, box) > seen.distance);
    seen.candidates = bitsOf(kept);
    if (seen.candidates == 0) return seen;
    for (int k = 0; k < 3; ++k) {
        const Eight3 a = corner[k], b = corner[(k + 1) % 3];
        seen.edge[k] = (light.isPoint ? cross8(a - b, a + b) : cross8(b - a, splat83(light.place))) * sign;
        seen.offset[k] = light.isPoint ? splat8(0.0f) : -dot8(seen.edge[k], (a + b) * splat8(0.5f));
        kept &= largestDot(seen.edge[k], box) + seen.offset[k] >= 0.0f;
    }
    seen.candidates = bitsOf(kept);
    return seen;
}

/// A bit for each ray that triangle `lane` hides. A hit nearer to a point light than the share `start` of the
/// ray does not count.
inline std::uint32_t raysHidden(const TrianglesSeen& seen, int lane, const BlockRays& rays,
                                const float* start) {
    std::uint32_t hidden = 0;
    for (int first = 0; first < raysPerBlock; first += laneCount) {
        const Vec3 x = rays.ends.lanes(first);
        const auto product = [&](const Eight3& v) {
            return x.x * splat(v.x[lane]) + x.y * splat(v.y[lane]) + x.z * splat(v.z[lane]);
        };
        const Floats along = product(seen.normal), distance = splat(seen.distance[lane]);
        Ints inside = along > distance;
        if (rays.light.isPoint) inside &= distance > along * load(start + first);
        for (int k = 0; k < 3; ++k) inside &= product(seen.edge[k]) + splat(seen.offset[k][lane]) >= 0.0f;
        hidden |= laneBits(inside) << first;
    }
    return hidden;
}

// ---- The rays against boxes

/// The rays as they are clipped by boxes. The side of a box at the coordinate `c` of an axis is met at
/// c × inverse + offset of that axis, for 0 to `maxT`.
struct ClippedRays {
    BlockVectors inverse, offset;
    float maxT;
    float rounding;  ///< More than boxes and rays together are off.
};

inline Floats inverseOf(Floats v) {
    return 1.0f / select(v == 0.0f, splat(1.0e-30f), v);
}

inline ClippedRays clippedRays(const BlockRays& rays) {
    ClippedRays clipped;
    const bool isPoint = rays.light.isPoint;
    clipped.maxT = isPoint ? 1.0f : hugeFloat;
    Floats largest = splat(0.0f);
    for (int first = 0; first < raysPerBlock; first += laneCount) {
        const Vec3 end = rays.ends.lanes(first);
        const Vec3 from = isPoint ? splat3(rays.origin) : splat3(rays.origin) + end;
        const Vec3 way = isPoint ? end : splat3(rays.light.place);
        largest = max(largest, max(maxMagnitude(splat3(rays.origin)), maxMagnitude(end)));
        const Vec3 inverse{inverseOf(way.x), inverseOf(way.y), inverseOf(way.z)};
        store(clipped.inverse.x + first, inverse.x), store(clipped.offset.x + first, -from.x * inverse.x);
        store(clipped.inverse.y + first, inverse.y), store(clipped.offset.y + first, -from.y * inverse.y);
        store(clipped.inverse.z + first, inverse.z), store(clipped.offset.z + first, -from.z * inverse.z);
    }
    clipped.rounding = -2.0e-6f * minOfLanes(-largest);
    return clipped;
}

/// A bit for each ray that meets the box.
inline std::uint32_t raysInto(const ClippedRays& rays, ChildBox box) {
    const WideNode& node = *box.node;
    const int lane = box.lane;
    std::uint32_t into = 0;
    for (int first = 0; first < raysPerBlock; first += laneCount) {
        const Vec3 inverse = rays.inverse.lanes(first), offset = rays.offset.lanes(first);
        Floats low = splat(0.0f), high = splat(rays.maxT);
        const auto clip = [&](Floats scale, Floats shift, float lower, float upper) {
            const Floats a = (lower - rays.rounding) * scale + shift,
                         b = (upper + rays.rounding) * scale + shift;
            low = max(low, min(a, b));
            high = min(high, max(a, b));
        };
        clip(inverse.x, offset.x, node.minX[lane], node.maxX[lane]);
        clip(inverse.y, offset.y, node.minY[lane], node.maxY[lane]);
        clip(inverse.z, offset.z, node.minZ[lane], node.maxZ[lane]);
        into |= laneBits(low <= high * (1.0f + hullTolerance) + hullTolerance) << first;
    }
    return into;
}

// ---- The rays of a block

/// What the tests of a block have found.
struct BlockHits {
    std::uint32_t lit;         ///< The rays that are asked for, a bit each.
    std::uint32_t hidden = 0;  ///< Those blocked.
    std::uint32_t leaves = 0;  ///< Visited so far.
    bool tested = false;       ///< Single rays were tested.
    bool undecided = false;    ///< The rays that are not blocked have to be traced.
};

/// From here on tracing the rays takes less than testing their block.
constexpr std::uint32_t maxLeaves = 24;

/// Tests the triangles of an instance. `box` is that of the ray ends in the instance's space. `rays()` gives
/// the rays in the world, which are needed where the hull meets a leaf. False where nothing is left to test.
template <typename Rays>
inline bool testInstance(const OcclusionInstanceView& instance, const LightSource& light, const EndBox& box,
                         const Rays& rays, BlockHits& hits) {
    const Hull hull = hullOf(transformed(light, instance.localFromWorld), box);
    BlockRays local;
    ClippedRays clipped;
    CenteredBox centered;
    const float* start = nullptr;
    const bool whole = visitLeaves(instance.nodes, hull, [&](std::uint32_t leaf, ChildBox leafBox) {
        if (start == nullptr) {
            const StartedRays& world = rays();
            start = world.start;
            local = transformed(world.rays, instance.localFromWorld);
            clipped = clippedRays(local);
            centered = centeredBox(box, local.origin);
        }
        if ((raysInto(clipped, leafBox) & hits.lit & ~hits.hidden) == 0) return true;
        if (++hits.leaves > maxLeaves) return false;
        const TriangleBlock& block = instance.blocks[leaf];
        const TrianglesSeen seen = seeTriangles(block, local, centered);
        for (std::uint32_t left = seen.candidates; left != 0; left &= left - 1) {
            const int lane = __builtin_ctz(left);
            if (block.triangle[lane] >= instance.opaqueCount) {
                hits.undecided = true;
                continue;
            }
            hits.tested = true;
            hits.hidden |= raysHidden(seen, lane, local, start);
        }
        return (hits.lit & ~hits.hidden) != 0;
    });
    if (!whole && (hits.lit & ~hits.hidden) != 0) hits.undecided = true;
    return whole;
}

}  // namespace
}  // namespace candela
