#pragma once

// The hull of a light and a box of ray ends, against the boxes of trees. Kernel code: see
// render/lighting/tiled/tile_kernel_code.h.
//
// All rays between a light and a box lie in the hull of both. The hull is the union of the boxes
// light + t (box - light) for t from 0 to 1, so that it meets the box of a tree node exactly where six
// inequalities that are linear in t have a common solution. For a directional light it is the union of
// box + t l for t from 0 on.

#include "render/occlusion/occlusion_view.h"
#include "render/simd8.h"

namespace candela {
namespace {

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

/// The six inequalities. Each is a bound of t, (node - base) × scale, from below where `low` is large and
/// from above where `high` is not. Elements 0 to 2 compare the lower sides of nodes along each axis, 3 to 5
/// the upper sides.
struct alignas(32) Hull {
    float base[8], scale[8], low[8], high[8];
    float maxT;
};

constexpr float hugeFloat = 3.0e38f;
/// More than the rounding of a bound of t, relative and absolute.
constexpr float hullTolerance = 1.0e-6f;

inline Hull hullOf(const LightSource& light, const EndBox& box) {
    const Eight place{light.place[0], light.place[1], light.place[2],
                      light.place[0], light.place[1], light.place[2]};
    // The upper sides of the hull lie above a node's lower side, and its lower sides below the upper one.
    const Eight sides{box.max[0], box.max[1], box.max[2], box.min[0], box.min[1], box.min[2]};
    constexpr EightInts upper{-1, -1, -1, 0, 0, 0, 0, 0};
    const Eight slope = light.isPoint ? sides - place : place;
    // A slope of 0 decides by the sign of node - base alone.
    const Eight tiny = upper ? splat8(1.0e-30f) : splat8(-1.0e-30f);
    const Eight scale = splat8(1.0f) / (slope == 0.0f ? tiny : slope);
    const EightInts fromBelow = ~((scale > 0.0f) ^ upper);
    Hull hull;
    store8(hull.base, light.isPoint ? place : sides);
    store8(hull.scale, scale);
    store8(hull.low, fromBelow ? splat8(hugeFloat) : splat8(-hugeFloat));
    store8(hull.high, fromBelow ? splat8(hugeFloat) : splat8(-hugeFloat));
    hull.maxT = light.isPoint ? 1.0f : hugeFloat;
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
    applyBound(hull, 0, node.minX, low, high);
    applyBound(hull, 1, node.minY, low, high);
    applyBound(hull, 2, node.minZ, low, high);
    applyBound(hull, 3, node.maxX, low, high);
    applyBound(hull, 4, node.maxY, low, high);
    applyBound(hull, 5, node.maxZ, low, high);
    return bitsOf(low <= high * (1.0f + hullTolerance) + hullTolerance);
}

constexpr int maxStack = 512;

/// The box of a child of a node.
struct ChildBox {
    const WideNode* node;
    int lane;
};

/// Calls `visit(leaf, box)` for the leaves that the hull meets, until one returns false. False then, and
/// where the stack is full.
template <typename Visit>
inline bool visitLeaves(const WideNode* nodes, const Hull& hull, const Visit& visit) {
    std::uint32_t stack[maxStack];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const WideNode& node = nodes[stack[--depth]];
        for (std::uint32_t met = childrenMet(hull, node); met != 0; met &= met - 1) {
            const int lane = __builtin_ctz(met);
            const std::uint32_t child = node.child[lane];
            if ((child & WideNode::leafFlag) != 0) {
                if (!visit(child & ~WideNode::leafFlag, ChildBox{&node, lane})) return false;
            } else {
                if (depth == maxStack) return false;
                stack[depth++] = child;
            }
        }
    }
    return true;
}

// ---- Boxes and lights in the space of an instance

inline EndBox transformed(const EndBox& box, const float* rows) {
    EndBox result;
    for (int axis = 0; axis < 3; ++axis) {
        const float* row = rows + 4 * axis;
        float low = row[3], high = row[3], size = row[3] < 0.0f ? -row[3] : row[3];
        for (int i = 0; i < 3; ++i) {
            const float a = row[i] * box.min[i], b = row[i] * box.max[i];
            low += a < b ? a : b;
            high += a < b ? b : a;
            size += (a < 0.0f ? -a : a) + (b < 0.0f ? -b : b);
        }
        // More than the sums have rounded.
        result.min[axis] = low - 5.0e-7f * size;
        result.max[axis] = high + 5.0e-7f * size;
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

/// The instances that may hide a light from a box: those whose boxes its hull meets.
inline void listInstances(const OcclusionView& scene, const LightSource& light, const EndBox& box,
                          InstanceList& list) {
    list.count = 0;
    if (scene.nodes == nullptr) return;
    const bool whole =
        visitLeaves(scene.nodes, hullOf(light, box), [&](std::uint32_t instance, ChildBox child) {
            if (list.count == WideNode::width) return false;
            const std::uint32_t to = list.count++;
            const WideNode& from = *child.node;
            list.node.minX[to] = from.minX[child.lane], list.node.maxX[to] = from.maxX[child.lane];
            list.node.minY[to] = from.minY[child.lane], list.node.maxY[to] = from.maxY[child.lane];
            list.node.minZ[to] = from.minZ[child.lane], list.node.maxZ[to] = from.maxZ[child.lane];
            list.node.child[to] = instance;
            return true;
        });
    if (!whole) list.count = InstanceList::overflow;
}

/// A bit for each instance of a list that may hide the light from a smaller box.
inline std::uint32_t instancesMet(const InstanceList& list, const Hull& hull) {
    return childrenMet(hull, list.node) & ((1u << list.count) - 1);
}

}  // namespace
}  // namespace candela
