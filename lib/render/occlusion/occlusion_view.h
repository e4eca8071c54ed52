#pragma once

#include "render/occlusion/ray_packet.h"
#include "render/occlusion/wide_node.h"

#include <cstdint>

namespace candela {

// What the kernels read of an occlusion structure. Plain numbers only, as in
// render/lighting/tiled/tile_kernel.h.

/// An instance that casts a shadow.
struct OcclusionInstanceView {
    float worldFromLocal[12], localFromWorld[12];  ///< Three rows of four each.
    const WideNode* nodes;                         ///< Of its mesh; the first is the root.
    const TriangleBlock* blocks;                   ///< One for each leaf.
    std::uint32_t opaqueCount;                     ///< Triangles from here on are alpha-masked.
};

/// Eight triangles as one light sees them. A point x, relative to an origin, is hidden by a triangle where
/// dot(edge[k], x) + offset[k] >= 0 for each edge, and dot(normal, x) > distance. The origin is a point light
/// itself, whose offsets are 0, and any point for a directional light.
struct alignas(32) TrianglesSeen {
    float edge[3][3][8], offset[3][8];
    float normal[3][8], distance[8];
    std::uint32_t candidates;  ///< A bit for each triangle that may hide the light from the box of the list.
    std::uint32_t masked;      ///< A bit for each that is alpha-masked.
};

/// A tree over instances: the number of a leaf is that of an instance.
struct OcclusionView {
    const WideNode* nodes;  ///< Null: nothing casts a shadow.
    const OcclusionInstanceView* instances;
    const void* rays;  ///< What `trace` takes.
    TracePacket trace;
};

}  // namespace candela
