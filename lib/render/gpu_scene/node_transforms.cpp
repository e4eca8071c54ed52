#include "render/gpu_scene/node_transforms.h"

#include "base/thread_pool.h"
#include "scene/model/animation.h"

#include <algorithm>
#include <map>
#include <utility>
#include <variant>

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
    parents_.reserve(scene.nodes.size());
    local_.resize(scene.nodes.size());
    if (isFar(scene)) {
        exactLocal_.resize(scene.nodes.size());
        exactWorld_.resize(scene.nodes.size());
    }
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        rest(i);
        parents_.push_back(scene.nodes[i].parent.value_or(none));
        links_.emplace_back();
        link(i);
    }
    listAnimated();
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) mark(i);
}

void NodeTransforms::link(std::uint32_t node) {
    const std::uint32_t parent = parents_[node];
    if (parent == none) return;
    std::uint32_t& first = links_[parent].firstChild;
    links_[node].nextSibling = first;
    if (first != none) links_[first].previousSibling = node;
    first = node;
}

void NodeTransforms::add(std::uint32_t node) {
    if (node == parents_.size()) {
        parents_.push_back(none);
        links_.emplace_back();
        animated_.push_back(false);
        local_.emplace_back();
        world_.emplace_back();
        isMarked_.push_back(0);
        if (isFar(scene_)) {
            exactLocal_.emplace_back();
            exactWorld_.emplace_back();
        }
    }
    parents_[node] = scene_.nodes[node].parent.value_or(none);
    links_[node] = {};
    link(node);
    rest(node);
    mark(node);
}

void NodeTransforms::remove(std::uint32_t node) {
    removeChannels(node);
    const Links& links = links_[node];
    if (links.nextSibling != none) links_[links.nextSibling].previousSibling = links.previousSibling;
    if (links.previousSibling != none) links_[links.previousSibling].nextSibling = links.nextSibling;
    if (parents_[node] != none && links_[parents_[node]].firstChild == node)
        links_[parents_[node]].firstChild = links.nextSibling;
    links_[node] = {};
    parents_[node] = none;
    rest(node);
    mark(node);
}

void NodeTransforms::listAnimated() {
    for (const Animation& animation : scene_.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            if (isTransform(channel)) animated_[channel.node] = true;
        }
    }
}

void NodeTransforms::removeChannels(std::uint32_t node) {
    if (update_) {
        isEdited_.resize(parents_.size());
        isEdited_[node] = true;
        std::erase(given_, node);
    }
    if (!animated_[node]) return;
    for (Animation& animation : scene_.animations) {
        std::erase_if(animation.channels, [&](const AnimationChannel& channel) {
            return channel.node == node && isTransform(channel);
        });
    }
    animated_[node] = false;
    playingListed_ = false;
}

void NodeTransforms::setLocal(std::uint32_t node, const glm::mat4& local) {
    removeChannels(node);
    local_[node] = local;
    if (isFar(scene_)) exactLocal_[node] = glm::dmat4(local);
    mark(node);
}

void NodeTransforms::rest(std::uint32_t index) {
    const Node& node = scene_.nodes[index];
    local_[index] = localMatrix(node.transform);
    if (isFar(scene_)) exactLocal_[index] = exactLocalMatrix(node.transform, exactTranslation(node));
}

void NodeTransforms::setTime(double seconds, std::shared_ptr<const SceneUpdate> update) {
    timeChanged_ = timeChanged_ || seconds != time_ || update != update_;
    time_ = seconds;
    update_ = std::move(update);
}

void NodeTransforms::resetAnimated() {
    timeChanged_ = true;
    playingListed_ = false;
    for (std::uint32_t i = 0; i < local_.size(); ++i) {
        if (!animated_[i]) continue;
        rest(i);
        mark(i);
    }
}

void NodeTransforms::mark(std::uint32_t node) {
    if (isMarked_[node] != 0) return;
    isMarked_[node] = 1;
    marked_.push_back(node);
}

void NodeTransforms::listPlaying() {
    std::map<std::uint32_t, std::vector<const AnimationChannel*>> channels;
    for (const Animation& animation : scene_.animations) {
        if (!animation.plays) continue;
        for (const AnimationChannel& channel : animation.channels)
            if (isTransform(channel)) channels[channel.node].push_back(&channel);
    }
    playing_.clear();
    for (auto& [node, ofNode] : channels) playing_.push_back({{node, {}, {}}, std::move(ofNode)});
    playingListed_ = true;
}

void NodeTransforms::pose() {
    timeChanged_ = false;
    if (!playingListed_) listPlaying();
    for (const std::uint32_t node : given_) {
        rest(node);
        mark(node);
    }
    given_.clear();
    constexpr std::size_t blockSize = 128;
    ThreadPool::shared()->run((playing_.size() + blockSize - 1) / blockSize,
                              [&](std::size_t block, unsigned) {
                                  const std::size_t end = std::min((block + 1) * blockSize, playing_.size());
                                  for (std::size_t i = block * blockSize; i < end; ++i) {
                                      PosedNode& pose = playing_[i].pose;
                                      const Node& node = scene_.nodes[pose.node];
                                      pose.transform = std::get<Transform>(node.transform);
                                      pose.translation = exactTranslation(node);
                                      for (const AnimationChannel* channel : playing_[i].channels)
                                          applyChannel(*channel, time_, pose);
                                  }
                              });
    for (const Playing& playing : playing_) {
        const PosedNode& posed = playing.pose;
        const glm::mat4 local = localMatrix(posed.transform);
        bool moved = local != local_[posed.node];
        local_[posed.node] = local;
        if (isFar(scene_)) {
            const glm::dmat4 exact = exactLocalMatrix(posed.transform, posed.translation);
            moved = moved || exact != exactLocal_[posed.node];
            exactLocal_[posed.node] = exact;
        }
        if (moved) mark(posed.node);
    }
    if (update_) takeUpdate();
}

void NodeTransforms::takeUpdate() {
    isEdited_.resize(parents_.size());
    for (const SceneUpdate::NodeMatrix& node : update_->nodes) {
        if (isEdited_[node.node]) continue;
        local_[node.node] = glm::mat4(node.local);
        if (isFar(scene_)) exactLocal_[node.node] = node.local;
        given_.push_back(node.node);
        mark(node.node);
    }
}

std::span<const std::uint32_t> NodeTransforms::update() {
    updated_.clear();
    if (timeChanged_) pose();
    if (marked_.size() > parents_.size() / 8) {
        updateAll();
    } else {
        // Parents precede their children: no marked node is left above the next one.
        std::ranges::sort(marked_);
        for (const std::uint32_t node : marked_) {
            if (isMarked_[node] != 0) updateSubtree(node);
        }
    }
    marked_.clear();
    return updated_;
}

/// One pass over all nodes, which is faster where many are marked.
void NodeTransforms::updateAll() {
    for (std::uint32_t i = 0; i < parents_.size(); ++i) {
        if (parents_[i] != none) isMarked_[i] |= isMarked_[parents_[i]];
        if (isMarked_[i] != 0) updateNode(i);
    }
    std::ranges::fill(isMarked_, std::uint8_t{0});
}

void NodeTransforms::updateNode(std::uint32_t node) {
    if (isFar(scene_)) {
        updateFarNode(node);
    } else {
        world_[node] = parents_[node] == none ? local_[node] : world_[parents_[node]] * local_[node];
    }
    updated_.push_back(node);
}

void NodeTransforms::updateFarNode(std::uint32_t node) {
    exactWorld_[node] = parents_[node] == none ? exactRootMatrix(scene_, exactLocal_[node])
                                               : exactWorld_[parents_[node]] * exactLocal_[node];
    world_[node] = glm::mat4(exactWorld_[node]);
}

void NodeTransforms::updateSubtree(std::uint32_t root) {
    stack_.assign(1, root);
    while (!stack_.empty()) {
        const std::uint32_t node = stack_.back();
        stack_.pop_back();
        updateNode(node);
        isMarked_[node] = 0;
        forEachChild(node, [&](std::uint32_t child) { stack_.push_back(child); });
    }
}

}  // namespace candela
