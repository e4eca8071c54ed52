#pragma once

#include "render/occlusion/ray_packet.h"
#include "render/occlusion/wide_node.h"

#include <cstdint>

namespace candela {

// What the kernels read of an occlusion structure. Plain numbers only, as in
// render/lighting/tiled/tile_kernel.h.

/// An instance that casts a shadow.
struct OcclusionInstanceView {
    float localFromWorld[12];     ///< Three rows of four.
    const WideNode* nodes;        ///< Of its mesh; the first is the root.
    const TriangleBlock* blocks;  ///< One for each leaf.
    std::uint32_t opaqueCount;    ///< Triangles from here on mask or blend by alpha.
};

/// Instances that may hide one light from a box of pixels.
struct InstanceList {
    WideNode node;        ///< Their boxes, and their numbers as children.
    std::uint32_t count;  ///< Or `overflow`.

    static constexpr std::uint32_t overflow = WideNode::width + 1;
};

/// A tree over instances: the number of a leaf is that of an instance.
struct OcclusionView {
    const WideNode* nodes;  ///< Null: nothing casts a shadow.
    const OcclusionInstanceView* instances;
    const void* rays;  ///< What `trace` takes.
    TracePacket trace;
    bool blends;  ///< An instance lets a part of the light through.
};

}  // namespace candela
