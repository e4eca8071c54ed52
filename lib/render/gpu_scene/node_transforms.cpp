#include "render/gpu_scene/node_transforms.h"

#include "scene/model/animation.h"

#include <algorithm>
#include <numeric>

namespace candela {

namespace {

bool isTransform(const AnimationChannel& channel) {
    return channel.path != AnimationPath::morphWeights;
}

}  // namespace

NodeTransforms::NodeTransforms(Scene& scene)
    : scene_(scene),
      animated_(scene.nodes.size()),
      world_(scene.nodes.size()),
      isMarked_(scene.nodes.size()) {
    local_.reserve(scene.nodes.size());
    for (const Node& node : scene.nodes) local_.push_back(localMatrix(node.transform));
    listChildren();
    listAnimated();
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) mark(i);
}

void NodeTransforms::listChildren() {
    const std::vector<Node>& nodes = scene_.nodes;
    firstChild_.assign(nodes.size() + 1, 0);
    for (const Node& node : nodes) {
        if (node.parent) ++firstChild_[*node.parent + 1];
    }
    std::partial_sum(firstChild_.begin(), firstChild_.end(), firstChild_.begin());
    children_.resize(firstChild_.back());
    std::vector<std::uint32_t> next(firstChild_);
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent) children_[next[*nodes[i].parent]++] = i;
    }
}

void NodeTransforms::listAnimated() {
    for (const Animation& animation : scene_.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (isTransform(channel)) animated_[channel.node] = true;
        }
    }
}

std::span<const std::uint32_t> NodeTransforms::childrenOf(std::uint32_t node) const {
    return std::span(children_).subspan(firstChild_[node], firstChild_[node + 1] - firstChild_[node]);
}

void NodeTransforms::setLocal(std::uint32_t node, const glm::mat4& local) {
    if (animated_[node]) {
        for (Animation& animation : scene_.animations) {
            std::erase_if(animation.channels, [&](const AnimationChannel& channel) {
                return channel.node == node && isTransform(channel);
            });
        }
        animated_[node] = false;
    }
    scene_.nodes[node].transform = local;
    local_[node] = local;
    mark(node);
}

void NodeTransforms::setTime(double seconds) {
    timeChanged_ = timeChanged_ || seconds != time_;
    time_ = seconds;
}

void NodeTransforms::mark(std::uint32_t node) {
    if (isMarked_[node]) return;
    isMarked_[node] = true;
    marked_.push_back(node);
}

void NodeTransforms::pose() {
    timeChanged_ = false;
    for (const PosedNode& posed : poseAnimatedNodes(scene_, time_)) {
        const glm::mat4 local = localMatrix(posed.trs);
        if (local == local_[posed.node]) continue;
        local_[posed.node] = local;
        mark(posed.node);
    }
}

std::span<const std::uint32_t> NodeTransforms::update() {
    updated_.clear();
    if (timeChanged_) pose();
    // Parents stand before their children: when a node's turn comes, no marked node above it is left.
    std::ranges::sort(marked_);
    for (const std::uint32_t node : marked_) {
        if (isMarked_[node]) updateSubtree(node);
    }
    marked_.clear();
    return updated_;
}

void NodeTransforms::updateSubtree(std::uint32_t root) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
        const std::uint32_t node = stack_.back();
        stack_.pop_back();
        const std::optional<std::uint32_t> parent = scene_.nodes[node].parent;
        world_[node] = parent ? world_[*parent] * local_[node] : local_[node];
        isMarked_[node] = false;
        updated_.push_back(node);
        const std::span<const std::uint32_t> children = childrenOf(node);
        stack_.insert(stack_.end(), children.begin(), children.end());
    }
}

}  // namespace candela
