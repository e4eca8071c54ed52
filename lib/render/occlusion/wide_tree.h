#pragma once

#include "render/occlusion/wide_node.h"

#include <candela/scene.h>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace candela {

inline bool isLeaf(std::uint32_t child) {
    return (child & WideNode::leafFlag) != 0;
}

/// What a missing child has, and the union of no boxes.
inline constexpr Bounds invertedBounds{glm::vec3(std::numeric_limits<float>::max()),
                                       glm::vec3(-std::numeric_limits<float>::max())};

/// Makes a box hold another one.
inline void enclose(Bounds& bounds, const Bounds& other) {
    bounds.min = glm::min(bounds.min, other.min);
    bounds.max = glm::max(bounds.max, other.max);
}

/// May rays meet it? False for an empty box and for one that is not finite.
inline bool isTraceable(const Bounds& box) {
    constexpr float farthest = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.min[axis] <= box.max[axis]) || !(std::abs(box.min[axis]) <= farthest) ||
            !(std::abs(box.max[axis]) <= farthest))
            return false;
    }
    return true;
}

/// The box of a child.
inline Bounds childBounds(const WideNode& node, unsigned lane) {
    return {{node.minX[lane], node.minY[lane], node.minZ[lane]},
            {node.maxX[lane], node.maxY[lane], node.maxZ[lane]}};
}

inline void setChildBounds(WideNode& node, unsigned lane, const Bounds& bounds) {
    node.minX[lane] = bounds.min.x;
    node.minY[lane] = bounds.min.y;
    node.minZ[lane] = bounds.min.z;
    node.maxX[lane] = bounds.max.x;
    node.maxY[lane] = bounds.max.y;
    node.maxZ[lane] = bounds.max.z;
}

inline void setMissing(WideNode& node, unsigned lane) {
    setChildBounds(node, lane, invertedBounds);
    node.child[lane] = WideNode::noChild;
}

/// The union of the boxes of the children.
inline Bounds boundsOf(const WideNode& node) {
    Bounds bounds = invertedBounds;
    for (unsigned lane = 0; lane < WideNode::width; ++lane) enclose(bounds, childBounds(node, lane));
    return bounds;
}

/// A bounding volume hierarchy with up to eight children a node, over primitives of which only the boxes
/// count.
struct WideTree {
    /// At most this many nodes lie on a way from the root to a leaf.
    static constexpr unsigned maxDepth = 24;

    /// A run of `primitives`: 1 to 8.
    struct Leaf {
        std::uint32_t first = 0, count = 0;
    };

    std::vector<WideNode> nodes;  ///< The first is the root; parents precede children. None of an empty tree.
    std::vector<Leaf> leaves;
    std::vector<std::uint32_t> primitives;  ///< Indices, each at most once.
    Bounds bounds;                          ///< Of all primitives.
    unsigned depth = 0;                     ///< Nodes on the longest way from the root to a leaf.

    bool empty() const { return nodes.empty(); }
    std::size_t bytes() const;
};

/// The triangles of a mesh; the indices are below the number of positions.
struct TriangleSpan {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;

    /// Exact.
    Bounds bounds(std::size_t triangle) const;
};

/// Builds a tree with at most `maxLeaf` (1 to 8) primitives a leaf. Boxes that are empty or not finite are
/// left out: no ray meets them. All threads of the library take part. Throws `Error` (limit) when there is
/// not enough memory.
WideTree buildWideTree(std::span<const Bounds> boxes, unsigned maxLeaf);
/// The same, with eight triangles a leaf at most. Triangles without area are kept.
WideTree buildWideTree(const TriangleSpan& triangles);

/// Adapts the boxes of a tree to primitives that have moved; what is a child of what stays. As many
/// primitives as the tree was built of, in the same order. A primitive that was left out of the tree stays
/// out.
void refit(WideTree& tree, std::span<const Bounds> boxes);
void refit(WideTree& tree, const TriangleSpan& triangles);

/// One block for each leaf of the tree, which was built of these triangles; `blocks` is replaced.
void fillTriangleBlocks(const WideTree& tree, const TriangleSpan& triangles,
                        std::vector<TriangleBlock>& blocks);

}  // namespace candela
