#pragma once

// Which triangles can hide a light from a box of ray ends, and which of sixteen rays they hide. Kernel code:
// see render/lighting/tiled/tile_kernel_code.h, which includes it.
//
// All rays between a light and a box lie in the hull of both. The hull is the union of the boxes
// light + t (box - light) for t from 0 to 1, so that it meets the box of a tree node exactly where six
// inequalities that are linear in t have a common solution. For a directional light it is the union of
// box + t l for t from 0 on. Of the triangles in the leaves it meets, those remain whose plane separates
// light and box, and whose edges do not lie beside the box as the light sees them.

#include "render/occlusion/occlusion_view.h"
#include "render/simd.h"

namespace candela {
namespace {

typedef float Eight __attribute__((vector_size(32)));
typedef std::int32_t EightInts __attribute__((vector_size(32)));

inline Eight load8(const float* from) {
    Eight v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}
inline void store8(float* to, Eight v) {
    __builtin_memcpy(to, &v, sizeof v);
}
inline Eight splat8(float value) {
    return value - Eight{};
}

#if defined(__AVX2__)
inline Eight min8(Eight a, Eight b) {
    return (Eight)_mm256_min_ps((__m256)a, (__m256)b);
}
inline Eight max8(Eight a, Eight b) {
    return (Eight)_mm256_max_ps((__m256)a, (__m256)b);
}
inline std::uint32_t bitsOf(EightInts mask) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
}
#else
inline Eight min8(Eight a, Eight b) {
    return a < b ? a : b;
}
inline Eight max8(Eight a, Eight b) {
    return a > b ? a : b;
}
inline std::uint32_t bitsOf(EightInts mask) {
    std::uint32_t bits = 0;
    for (int lane = 0; lane < 8; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
    return bits;
}
#endif

inline Eight abs8(Eight a) {
    return max8(a, -a);
}

struct Eight3 {
    Eight x, y, z;
};

inline Eight3 operator-(Eight3 a, Eight3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Eight3 operator+(Eight3 a, Eight3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Eight3 operator*(Eight3 a, Eight b) {
    return {a.x * b, a.y * b, a.z * b};
}
inline Eight dot8(Eight3 a, Eight3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Eight3 cross8(Eight3 a, Eight3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Eight3 splat83(const float* v) {
    return {splat8(v[0]), splat8(v[1]), splat8(v[2])};
}

/// An axis-aligned box of ray ends.
struct EndBox {
    float min[3], max[3];
};

/// Where light comes from: a point (`isPoint`), or the direction towards a directional light.
struct LightSource {
    float place[3];
    bool isPoint;
};

// ---- The hull against nodes

/// The six inequalities. Each is a bound of t, (node - base) × scale, from below where `low` is infinite and
/// from above where `high` is minus infinite.
struct Hull {
    float base[6], scale[6], low[6], high[6];
    float maxT;
};

constexpr float hugeFloat = 3.0e38f;
/// More than the rounding of a bound of t, relative and absolute.
constexpr float hullTolerance = 1.0e-6f;

inline void setBound(Hull& hull, int i, float base, float slope, bool fromBelowWhenPositive) {
    hull.base[i] = base;
    // A slope of 0 decides by the sign of node - base alone.
    const float tiny = fromBelowWhenPositive ? 1.0e-30f : -1.0e-30f;
    hull.scale[i] = 1.0f / (slope == 0.0f ? tiny : slope);
    const bool fromBelow = (hull.scale[i] > 0.0f) == fromBelowWhenPositive;
    hull.low[i] = fromBelow ? hugeFloat : -hugeFloat;
    hull.high[i] = fromBelow ? hugeFloat : -hugeFloat;
}

inline Hull hullOf(const LightSource& light, const EndBox& box) {
    Hull hull;
    hull.maxT = light.isPoint ? 1.0f : hugeFloat;
    for (int axis = 0; axis < 3; ++axis) {
        const float o = light.place[axis], lo = box.min[axis], hi = box.max[axis];
        // Its upper side is above node.min, its lower side below node.max.
        setBound(hull, 2 * axis, light.isPoint ? o : hi, light.isPoint ? hi - o : o, true);
        setBound(hull, 2 * axis + 1, light.isPoint ? o : lo, light.isPoint ? lo - o : o, false);
    }
    return hull;
}

inline void applyBound(const Hull& hull, int i, const float* sides, Eight& low, Eight& high) {
    const Eight t = (load8(sides) - splat8(hull.base[i])) * splat8(hull.scale[i]);
    low = max8(low, min8(t, splat8(hull.low[i])));
    high = min8(high, max8(t, splat8(hull.high[i])));
}

/// A bit for each child whose box the hull meets.
inline std::uint32_t childrenMet(const Hull& hull, const WideNode& node) {
    Eight low = splat8(0.0f), high = splat8(hull.maxT);
    const float* const minimum[] = {node.minX, node.minY, node.minZ};
    const float* const maximum[] = {node.maxX, node.maxY, node.maxZ};
    for (int axis = 0; axis < 3; ++axis) {
        applyBound(hull, 2 * axis, minimum[axis], low, high);
        applyBound(hull, 2 * axis + 1, maximum[axis], low, high);
    }
    return bitsOf(low <= high * (1.0f + hullTolerance) + hullTolerance);
}

// ---- The hull against triangles

inline Eight3 load83(const float (&v)[3][8]) {
    return {load8(v[0]), load8(v[1]), load8(v[2])};
}
inline void store83(float (&to)[3][8], Eight3 v) {
    store8(to[0], v.x), store8(to[1], v.y), store8(to[2], v.z);
}

/// The centre of a box relative to `origin`, and half its size.
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

/// The largest value of dot(v, x) over the box.
inline Eight largestDot(Eight3 v, const CenteredBox& box) {
    return dot8(v, box.center) + abs8(v.x) * box.half.x + abs8(v.y) * box.half.y + abs8(v.z) * box.half.z;
}

/// A bit for each triangle that may hide the light from some point of the box.
inline std::uint32_t candidatesFor(const TrianglesSeen& seen, const CenteredBox& box) {
    EightInts kept = largestDot(load83(seen.normal), box) > load8(seen.distance);
    for (int k = 0; k < 3; ++k) kept &= largestDot(load83(seen.edge[k]), box) + load8(seen.offset[k]) >= 0.0f;
    return bitsOf(kept) & seen.candidates;
}

inline Eight3 cornerInWorld(const TriangleBlock& block, int corner, const float* rows) {
    const Eight x = load8(block.x[corner]), y = load8(block.y[corner]), z = load8(block.z[corner]);
    const auto row = [&](const float* r) {
        return splat8(r[0]) * x + splat8(r[1]) * y + splat8(r[2]) * z + splat8(r[3]);
    };
    return {row(rows), row(rows + 4), row(rows + 8)};
}

/// The triangles of a leaf relative to `origin`: the light itself for a point light. Edges are the cross
/// products of the difference and the sum of two corners, which round the same, but for the sign, in the
/// two triangles that share an edge: no ray slips between them.
inline void seeTriangles(const OcclusionInstanceView& instance, const TriangleBlock& block,
                         const LightSource& light, const float* origin, TrianglesSeen& seen) {
    Eight3 corner[3];
    for (int i = 0; i < 3; ++i)
        corner[i] = cornerInWorld(block, i, instance.worldFromLocal) - splat83(origin);
    Eight3 normal = cross8(corner[1] - corner[0], corner[2] - corner[0]);
    const Eight facing = light.isPoint ? dot8(normal, corner[0]) : -dot8(normal, splat83(light.place));
    // Turned so that the light is on the side of lower values. Seen from the side a triangle hides nothing.
    const Eight sign = facing < 0.0f ? splat8(-1.0f) : splat8(1.0f);
    normal = normal * sign;
    store83(seen.normal, normal);
    store8(seen.distance, dot8(normal, corner[0]));
    for (int k = 0; k < 3; ++k) {
        const Eight3 a = corner[k], b = corner[(k + 1) % 3];
        const Eight3 edge =
            (light.isPoint ? cross8(a - b, a + b) : cross8(b - a, splat83(light.place))) * sign;
        store83(seen.edge[k], edge);
        store8(seen.offset[k], light.isPoint ? splat8(0.0f) : -dot8(edge, (a + b) * splat8(0.5f)));
    }
    seen.candidates = bitsOf(facing != 0.0f);
    EightInts index;
    __builtin_memcpy(&index, block.triangle, sizeof index);
    seen.masked = bitsOf(index >= static_cast<std::int32_t>(instance.opaqueCount) - EightInts{});
}

// ---- Gathering

/// A list of triangles that may hide one light from one box.
struct TriangleList {
    TrianglesSeen* entries;
    std::uint32_t count, capacity;
};

constexpr int maxStack = 512;

inline EndBox transformed(const EndBox& box, const float* rows) {
    EndBox result;
    for (int axis = 0; axis < 3; ++axis) {
        const float* row = rows + 4 * axis;
        float low = row[3], high = row[3], largest = row[3] < 0.0f ? -row[3] : row[3];
        for (int i = 0; i < 3; ++i) {
            const float a = row[i] * box.min[i], b = row[i] * box.max[i];
            low += a < b ? a : b;
            high += a < b ? b : a;
            const float magnitude = (a < 0.0f ? -a : a) > (b < 0.0f ? -b : b) ? a : b;
            largest += magnitude < 0.0f ? -magnitude : magnitude;
        }
        // More than the sums have rounded.
        const float rounding = 1.0e-6f * largest;
        result.min[axis] = low - rounding;
        result.max[axis] = high + rounding;
    }
    return result;
}

inline LightSource transformed(const LightSource& light, const float* rows) {
    LightSource result;
    result.isPoint = light.isPoint;
    for (int axis = 0; axis < 3; ++axis) {
        const float* row = rows + 4 * axis;
        result.place[axis] = row[0] * light.place[0] + row[1] * light.place[1] + row[2] * light.place[2] +
                             (light.isPoint ? row[3] : 0.0f);
    }
    return result;
}

/// Appends the triangles of an instance. False where the list is full.
inline bool gatherInstance(const OcclusionInstanceView& instance, const LightSource& light,
                           const float* origin, const EndBox& box, TriangleList& list) {
    const Hull hull =
        hullOf(transformed(light, instance.localFromWorld), transformed(box, instance.localFromWorld));
    const CenteredBox centered = centeredBox(box, origin);
    std::uint32_t stack[maxStack];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const WideNode& node = instance.nodes[stack[--depth]];
        for (std::uint32_t met = childrenMet(hull, node); met != 0; met &= met - 1) {
            const std::uint32_t child = node.child[__builtin_ctz(met)];
            if ((child & WideNode::leafFlag) == 0) {
                if (depth == maxStack) return false;
                stack[depth++] = child;
                continue;
            }
            if (list.count == list.capacity) return false;
            TrianglesSeen& seen = list.entries[list.count];
            seeTriangles(instance, instance.blocks[child & ~WideNode::leafFlag], light, origin, seen);
            seen.candidates = candidatesFor(seen, centered);
            list.count += seen.candidates != 0 ? 1 : 0;
        }
    }
    return true;
}

/// Lists the triangles that may hide the light from the box. False where the list is full.
inline bool gatherTriangles(const OcclusionView& scene, const LightSource& light, const float* origin,
                            const EndBox& box, TriangleList& list) {
    const Hull hull = hullOf(light, box);
    std::uint32_t stack[maxStack];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const WideNode& node = scene.nodes[stack[--depth]];
        for (std::uint32_t met = childrenMet(hull, node); met != 0; met &= met - 1) {
            const std::uint32_t child = node.child[__builtin_ctz(met)];
            if ((child & WideNode::leafFlag) == 0) {
                if (depth == maxStack) return false;
                stack[depth++] = child;
                continue;
            }
            if (!gatherInstance(scene.instances[child & ~WideNode::leafFlag], light, origin, box, list))
                return false;
        }
    }
    return true;
}

// ---- Triangles against rays

constexpr int raysPerBlock = RayPacket::size;

/// Sixteen points, or vectors.
struct BlockVectors {
    float x[raysPerBlock], y[raysPerBlock], z[raysPerBlock];

    Vec3 lanes(int first) const { return {load(x + first), load(y + first), load(z + first)}; }
};

inline std::uint32_t laneBits(Ints mask) {
#if defined(__AVX512F__)
    return _mm512_movepi32_mask((__m512i)mask);
#elif defined(__AVX2__)
    return static_cast<std::uint32_t>(_mm256_movemask_ps((__m256)mask));
#else
    std::uint32_t bits = 0;
    for (int lane = 0; lane < laneCount; ++lane) bits |= (mask[lane] != 0 ? 1u : 0u) << lane;
    return bits;
#endif
}

/// A bit for each ray that triangle `lane` hides. `ends` are relative to the origin of the list; a hit nearer
/// to the light than the share `start[i]` of the ray does not count, where `start` is given.
inline std::uint32_t raysHidden(const TrianglesSeen& seen, int lane, const BlockVectors& ends,
                                const float* start) {
    std::uint32_t hidden = 0;
    for (int first = 0; first < raysPerBlock; first += laneCount) {
        const Vec3 x = ends.lanes(first);
        const auto product = [&](const float(&v)[3][8]) {
            return x.x * splat(v[0][lane]) + x.y * splat(v[1][lane]) + x.z * splat(v[2][lane]);
        };
        const Floats along = product(seen.normal);
        const Floats distance = splat(seen.distance[lane]);
        Ints inside = along > distance;
        if (start != nullptr) inside &= distance > along * load(start + first);
        for (int k = 0; k < 3; ++k) inside &= product(seen.edge[k]) + splat(seen.offset[k][lane]) >= 0.0f;
        hidden |= laneBits(inside) << first;
    }
    return hidden;
}

}  // namespace
}  // namespace candela
