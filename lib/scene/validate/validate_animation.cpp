#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <cmath>

// Validation of skins, morph weights and animations.

namespace candela {

namespace {

// How many joints a skin must have for the cage.
std::size_t jointsNeededBy(const Cage& cage) {
    const auto max = std::max_element(cage.joints.begin(), cage.joints.end());
    return max == cage.joints.end() ? 0 : std::size_t{*max} + 1;
}

void validateMorphWeights(const CageInstance& instance, const Cage& cage, const ErrorContext& element) {
    if (instance.morphWeights.empty()) return;
    if (instance.morphWeights.size() != cage.morphTargets.size()) {
        element.refuse("has " + std::to_string(instance.morphWeights.size()) +
                       " morph weights, but its cage has " + std::to_string(cage.morphTargets.size()) +
                       " morph targets");
    }
    element.requireEach("morph weight", instance.morphWeights, "must be a finite number of at most 1e9",
                        [](float weight) { return std::abs(weight) <= maxAnimated; });
}

// One channel of an animation, as errors name it.
class ChannelContext {
  public:
    ChannelContext(const ErrorContext& animation, std::size_t index) : animation_(animation), index_(index) {}

    void require(bool holds, const char* rule) const {
        if (!holds) animation_.refuse("channel " + std::to_string(index_) + ": " + rule);
    }

  private:
    const ErrorContext& animation_;
    std::size_t index_;
};

void validateTimes(const AnimationChannel& channel, const ChannelContext& element) {
    for (std::size_t i = 0; i < channel.times.size(); ++i) {
        element.require(std::isfinite(channel.times[i]), "its times must be finite numbers");
        element.require(i == 0 || channel.times[i] > channel.times[i - 1],
                        "its times must be strictly increasing");
    }
}

std::size_t numbersOf(const AnimationChannel& channel, const Scene& scene) {
    if (channel.path == AnimationPath::rotation) return 4;
    if (channel.path != AnimationPath::morphWeights) return 3;
    return scene.cages[scene.nodes[channel.node].cage->cage].morphTargets.size();
}

void requireAnimatedNode(const AnimationChannel& channel, const Scene& scene, const ChannelContext& element) {
    const Node& node = scene.nodes[channel.node];
    if (channel.path == AnimationPath::morphWeights) {
        const bool hasCage = node.cage && node.cage->cage < scene.cages.size();
        element.require(hasCage && !scene.cages[node.cage->cage].morphTargets.empty(),
                        "its node has no cage with morph targets");
        return;
    }
    element.require(std::holds_alternative<Transform>(node.transform),
                    "its node has a matrix, which cannot be animated");
}

void validateValues(const AnimationChannel& channel, const ChannelContext& element) {
    for (const float value : channel.values) {
        // False for a NaN too.
        element.require(std::abs(value) <= maxAnimated, "its values must be finite numbers of at most 1e9");
    }
    if (channel.path != AnimationPath::rotation) return;
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    for (std::size_t at = cubic ? 4 : 0; at < channel.values.size(); at += cubic ? 12 : 4) {
        const float* q = channel.values.data() + at;
        element.require(q[0] != 0.0f || q[1] != 0.0f || q[2] != 0.0f || q[3] != 0.0f,
                        "a rotation must be a quaternion that is not 0");
    }
}

}  // namespace

void validateSkin(const Skin& skin, const Scene& scene, const ErrorContext& element) {
    element.require(!skin.joints.empty(), "it must have at least one joint");
    for (const std::uint32_t joint : skin.joints) element.requireIndex("node", joint, scene.nodes.size());
    element.requireCount("inverse bind matrices", skin.inverseBindMatrices.size(), "joints",
                         skin.joints.size());
    element.requireEach("inverse bind matrix", skin.inverseBindMatrices, "must be finite numbers",
                        [](const glm::mat4& matrix) { return allFinite(matrix); });
    element.requireEach("inverse bind matrix", skin.inverseBindMatrices,
                        "must be affine: a last row of 0, 0, 0, 1", isAffine);
}

void validateCageInstances(const Scene& scene) {
    std::vector<std::size_t> jointCounts;
    jointCounts.reserve(scene.cages.size());
    for (const Cage& cage : scene.cages) jointCounts.push_back(jointsNeededBy(cage));
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
        if (!scene.nodes[i].cage) continue;
        const CageInstance& instance = *scene.nodes[i].cage;
        const ErrorContext element("node", i, scene.nodes[i].name);
        element.requireIndex("cage", instance.cage, scene.cages.size());
        element.requireIndex("skin", instance.skin, scene.skins.size());
        const Cage& cage = scene.cages[instance.cage];
        validateMorphWeights(instance, cage, element);
        if (!instance.skin) continue;
        element.require(cage.influenceCount > 0, "has a skin, but no joint moves a vertex of its cage");
        const std::size_t joints = scene.skins[*instance.skin].joints.size();
        if (jointCounts[instance.cage] <= joints) continue;
        element.refuse("its cage names joint " + std::to_string(jointCounts[instance.cage] - 1) +
                       ", but its skin has " + std::to_string(joints));
    }
}

void requireChannel(const AnimationChannel& channel, std::size_t index, const Scene& scene,
                    const ErrorContext& animation) {
    const ChannelContext element(animation, index);
    animation.requireIndex("node", channel.node, scene.nodes.size());
    element.require(channel.path >= AnimationPath::translation && channel.path <= AnimationPath::morphWeights,
                    "its path must be translation, rotation, scale or morph weights");
    requireAnimatedNode(channel, scene, element);
    element.require(
        channel.interpolation >= Interpolation::linear && channel.interpolation <= Interpolation::cubicSpline,
        "its interpolation must be linear, step or cubic spline");
    element.require(!channel.times.empty(), "it must have at least one key");
    const std::size_t parts = channel.interpolation == Interpolation::cubicSpline ? 3 : 1;
    element.require(channel.values.size() == channel.times.size() * parts * numbersOf(channel, scene),
                    "the number of its values does not fit the number of its keys");
}

void validateAnimation(const Animation& animation, const Scene& scene, const ErrorContext& element) {
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
        const AnimationChannel& channel = animation.channels[i];
        requireChannel(channel, i, scene, element);
        const ChannelContext channelContext(element, i);
        validateTimes(channel, channelContext);
        validateValues(channel, channelContext);
    }
}

}  // namespace candela
