#include "render/occlusion/instance_tree.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <utility>

namespace candela {

namespace {

/// Half the surface area of a box; 0 of one without children.
double area(const Bounds& box) {
    const glm::dvec3 size = glm::dvec3(box.max) - glm::dvec3(box.min);
    if (size.x < 0.0) return 0.0;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

Bounds unionOf(Bounds a, const Bounds& b) {
    enclose(a, b);
    return a;
}

bool equal(const Bounds& a, const Bounds& b) {
    return a.min == b.min && a.max == b.max;
}

unsigned childCount(const WideNode& node) {
    unsigned count = 0;
    while (count < WideNode::width && node.child[count] != WideNode::noChild) ++count;
    return count;
}

/// The child whose box grows least by holding `box` too; of several the smallest.
unsigned nearestChild(const WideNode& node, const Bounds& box) {
    unsigned best = 0;
    double leastGrowth = 0.0, leastArea = 0.0;
    for (unsigned lane = 0; lane < WideNode::width; ++lane) {
        const Bounds own = childBounds(node, lane);
        const double ownArea = area(own), growth = area(unionOf(own, box)) - ownArea;
        if (lane > 0 && (growth > leastGrowth || (growth == leastGrowth && ownArea >= leastArea))) continue;
        best = lane;
        leastGrowth = growth;
        leastArea = ownArea;
    }
    return best;
}

}  // namespace

std::size_t InstanceTree::bytes() const {
    return nodes_.size() * (sizeof(WideNode) + sizeof(Place) + sizeof(double)) +
           boxes_.size() * (sizeof(Bounds) + sizeof(Place));
}

void InstanceTree::update(std::span<const Change> changes) {
    inserted_.clear();
    for (const auto& [instance, box] : changes) {
        if (instance >= boxes_.size()) {
            boxes_.resize(instance + 1);
            leaves_.resize(instance + 1);
        }
        boxes_[instance] = box;
    }
    if (manyMoveOn(changes)) return build();
    for (const auto& [instance, box] : changes) {
        const Place place = leaves_[instance];
        const bool isInTree = place.node != none, isTraced = isTraceable(box);
        if (isInTree && isTraced && staysInPlace(instance, box)) {
            setBox(place, box);
            markForRefit(place.node);
            continue;
        }
        if (isInTree) {
            leaves_[instance] = {};
            remove(place);
            --size_;
        }
        if (isTraced) inserted_.push_back(instance);
    }
    if (nodes_.empty() && !inserted_.empty()) return build();
    refit();
    for (const std::uint32_t instance : inserted_) insert(instance, boxes_[instance]);
    size_ += inserted_.size();
    if (needsBuild()) build();
}

/// Would so many be inserted that a new tree takes less? An insertion takes two to three times as long as an
/// instance of a new tree.
bool InstanceTree::manyMoveOn(std::span<const Change> changes) const {
    const std::size_t most = size_ / 4;
    if (changes.size() <= most) return false;
    std::size_t count = 0;
    for (const auto& [instance, box] : changes) {
        if (!isTraceable(box)) continue;
        const bool stays = leaves_[instance].node != none && staysInPlace(instance, box);
        if (!stays && ++count > most) return true;
    }
    return false;
}

bool InstanceTree::needsBuild() const {
    return cost_ > maxGrowth * builtCost_ || depth_ > WideTree::maxDepth || 2 * unusedNodes_ > nodes_.size();
}

void InstanceTree::build() {
    adopt(buildWideTree(boxes_, 1));
    ++builds_;
}

void InstanceTree::adopt(const WideTree& tree) {
    nodes_ = tree.nodes;
    depth_ = tree.depth;
    size_ = tree.leaves.size();
    unusedNodes_ = 0;
    cost_ = 0.0;
    parents_.assign(nodes_.size(), {});
    builtAreas_.resize(nodes_.size());
    leaves_.assign(boxes_.size(), {});
    refitted_.assign((nodes_.size() + 63) / 64, 0);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        for (std::uint32_t lane = 0; lane < childCount(nodes_[i]); ++lane) {
            std::uint32_t& child = nodes_[i].child[lane];
            if (!isLeaf(child)) {
                parents_[child] = {i, lane};
                builtAreas_[child] = area(childBounds(nodes_[i], lane));
                cost_ += builtAreas_[child];
                continue;
            }
            const std::uint32_t instance = tree.primitives[tree.leaves[child & ~WideNode::leafFlag].first];
            child = WideNode::leafFlag | instance;
            leaves_[instance] = {i, lane};
        }
    }
    builtCost_ = cost_;
    changes_ = {};
}

/// Not where the box of its node would be much larger than at the last build. Nor where an instance moves on
/// and on: the box is measured against the siblings' alone, which it does not take along.
bool InstanceTree::staysInPlace(std::uint32_t instance, const Bounds& box) const {
    constexpr double growth = 1.5;
    const Place place = leaves_[instance];
    if (place.node == 0) return true;
    const WideNode& node = nodes_[place.node];
    if (childCount(node) == 1) return false;
    Bounds siblings = invertedBounds;
    for (unsigned lane = 0; lane < WideNode::width; ++lane) {
        if (lane != place.lane) enclose(siblings, childBounds(node, lane));
    }
    return area(unionOf(siblings, box)) <=
           growth * std::max(builtAreas_[place.node], area(siblings) + area(box));
}

void InstanceTree::markChanged(std::uint32_t node) {
    if (changes_.all) return;
    changes_.nodes.push_back(node);
    if (changes_.nodes.size() > nodes_.size()) changes_ = {};
}

/// Of a child. The boxes above it are not touched.
void InstanceTree::setBox(const Place& place, const Bounds& box) {
    WideNode& node = nodes_[place.node];
    if (!isLeaf(node.child[place.lane])) cost_ += area(box) - area(childBounds(node, place.lane));
    setChildBounds(node, place.lane, box);
    markChanged(place.node);
}

/// Into a lane whose child, if it has one, is accounted for elsewhere.
void InstanceTree::setChild(const Place& place, std::uint32_t child, const Bounds& box) {
    WideNode& node = nodes_[place.node];
    node.child[place.lane] = child;
    setChildBounds(node, place.lane, box);
    (isLeaf(child) ? leaves_[child & ~WideNode::leafFlag] : parents_[child]) = place;
    markChanged(place.node);
}

/// Takes a leaf out, and nodes that are without children then. The last child gets its lane.
void InstanceTree::remove(const Place& place) {
    WideNode& node = nodes_[place.node];
    const unsigned last = childCount(node) - 1;
    if (!isLeaf(node.child[place.lane])) cost_ -= area(childBounds(node, place.lane));
    if (place.lane != last) setChild(place, node.child[last], childBounds(node, last));
    setMissing(node, last);
    markChanged(place.node);
    if (last > 0) return markForRefit(place.node);
    if (place.node == 0) {
        nodes_.clear();
        parents_.clear();
        builtAreas_.clear();
        refitted_.clear();
        builtCost_ = cost_ = 0.0;
        depth_ = 0;
        unusedNodes_ = 0;
        changes_ = {};
        return;
    }
    ++unusedNodes_;
    remove(parents_[place.node]);
}

/// Children follow their parents, so that nodes that are handled from the last one on read finished boxes.
void InstanceTree::refit() {
    for (std::size_t word = refitted_.size(); word-- > 0;) {
        while (refitted_[word] != 0) {
            const auto bit = static_cast<unsigned>(std::bit_width(refitted_[word]) - 1);
            refitted_[word] &= ~(std::uint64_t{1} << bit);
            refitParentOf(static_cast<std::uint32_t>(64 * word + bit));
        }
    }
}

void InstanceTree::refitParentOf(std::uint32_t node) {
    if (node == 0 || childCount(nodes_[node]) == 0) return;
    const Place& parent = parents_[node];
    const Bounds box = boundsOf(nodes_[node]);
    if (equal(box, childBounds(nodes_[parent.node], parent.lane))) return;
    setBox(parent, box);
    markForRefit(parent.node);
}

void InstanceTree::insert(std::uint32_t instance, const Bounds& box) {
    std::uint32_t node = 0;
    for (unsigned depth = 1;; ++depth) {
        const unsigned count = childCount(nodes_[node]);
        depth_ = std::max(depth_, depth);
        if (count < WideNode::width) return setChild({node, count}, WideNode::leafFlag | instance, box);
        const Place place{node, nearestChild(nodes_[node], box)};
        const std::uint32_t child = nodes_[node].child[place.lane];
        if (isLeaf(child)) {
            depth_ = std::max(depth_, depth + 1);
            return split(place, instance, box);
        }
        const Bounds before = childBounds(nodes_[node], place.lane), grown = unionOf(before, box);
        if (!equal(before, grown)) setBox(place, grown);
        node = child;
    }
}

/// Puts a node in the place of a leaf, which is a child of it then beside the instance.
void InstanceTree::split(const Place& place, std::uint32_t instance, const Bounds& box) {
    const std::uint32_t leaf = nodes_[place.node].child[place.lane];
    const Bounds leafBox = childBounds(nodes_[place.node], place.lane);
    const auto added = static_cast<std::uint32_t>(nodes_.size());
    WideNode& node = nodes_.emplace_back();
    for (unsigned lane = 0; lane < WideNode::width; ++lane) setMissing(node, lane);
    parents_.emplace_back();
    refitted_.resize((nodes_.size() + 63) / 64);
    setChild({added, 0}, leaf, leafBox);
    setChild({added, 1}, WideNode::leafFlag | instance, box);
    const Bounds shared = unionOf(leafBox, box);
    builtAreas_.push_back(area(shared));
    cost_ += builtAreas_.back();
    setChild(place, added, shared);
}

InstanceTree::Changes InstanceTree::takeChanges() {
    Changes taken = std::exchange(changes_, {.all = false, .nodes = {}});
    std::ranges::sort(taken.nodes);
    const auto repeated = std::ranges::unique(taken.nodes);
    taken.nodes.erase(repeated.begin(), repeated.end());
    return taken;
}

}  // namespace candela
