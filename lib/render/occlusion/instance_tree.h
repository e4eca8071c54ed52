#pragma once

#include "render/occlusion/wide_tree.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// A bounding volume hierarchy over the boxes of instances, kept in step with them at a cost in proportion to
/// those that change. The number of a leaf is that of its instance.
///
/// Where an instance stays near its siblings, the boxes above it are refitted; else it is taken out and
/// inserted anew where the boxes grow least. The sum of the surface areas of all nodes, to which the number
/// of nodes that a ray visits is proportional, is compared with that at the last build: beyond `maxGrowth` of
/// it, and where many instances would be inserted anew, the tree is built anew.
class InstanceTree {
  public:
    /// Where the sum of the nodes' areas is more times that of the last build, the tree is built anew. Rays
    /// visit half as many nodes again at most.
    static constexpr double maxGrowth = 1.5;

    /// The world-space box of an instance. An empty box, or one that is not finite, takes it out of the tree.
    struct Change {
        std::uint32_t instance = 0;
        Bounds box;
    };
    /// Brings the tree in step with boxes that have changed: one entry an instance. Throws as `buildWideTree`
    /// does.
    void update(std::span<const Change> changes);

    /// The first is the root; parents precede children. None of an empty tree. Some may be unused: no node
    /// has them as children.
    std::span<const WideNode> nodes() const { return nodes_; }
    bool empty() const { return nodes_.empty(); }
    /// Instances in the tree.
    std::size_t size() const { return size_; }
    /// At least the number of nodes on the longest way from the root to a leaf; at most
    /// `WideTree::maxDepth`.
    unsigned depth() const { return depth_; }
    /// How often it was built.
    std::uint64_t builds() const { return builds_; }
    /// The sum of the surface areas of the boxes of all nodes but the root, square metres.
    double cost() const { return cost_; }
    std::size_t bytes() const;

    /// What has changed since the last `takeChanges`.
    struct Changes {
        bool all = true;                   ///< All nodes; `nodes` is empty.
        std::vector<std::uint32_t> nodes;  ///< Each once, in rising order.
    };
    Changes takeChanges();

  private:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// Where a node, or an instance, is a child.
    struct Place {
        std::uint32_t node = none;
        std::uint32_t lane = 0;
    };

    void build();
    void adopt(const WideTree& tree);
    bool manyMoveOn(std::span<const Change> changes) const;
    bool needsBuild() const;
    bool staysInPlace(std::uint32_t instance, const Bounds& box) const;
    void setBox(const Place& place, const Bounds& box);
    void setChild(const Place& place, std::uint32_t child, const Bounds& box);
    void remove(const Place& place);
    void insert(std::uint32_t instance, const Bounds& box);
    void split(const Place& place, std::uint32_t instance, const Bounds& box);
    void refit();
    void refitParentOf(std::uint32_t node);
    void markForRefit(std::uint32_t node) { refitted_[node / 64] |= std::uint64_t{1} << node % 64; }
    void markChanged(std::uint32_t node);

    std::vector<WideNode> nodes_;
    std::vector<Place> parents_;           ///< Of the nodes; none of the root.
    std::vector<double> builtAreas_;       ///< Of the nodes' boxes at the last build, or the insertion.
    std::vector<Bounds> boxes_;            ///< Of all instances.
    std::vector<Place> leaves_;            ///< Of all instances; none of those that are not in the tree.
    std::vector<std::uint64_t> refitted_;  ///< A bit for each node whose children have other boxes.
    std::vector<std::uint32_t> inserted_;  ///< By the update in progress.
    std::size_t size_ = 0, unusedNodes_ = 0;
    unsigned depth_ = 0;
    double cost_ = 0.0, builtCost_ = 0.0;
    std::uint64_t builds_ = 0;
    Changes changes_;
};

}  // namespace candela
