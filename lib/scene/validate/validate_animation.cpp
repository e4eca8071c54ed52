#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

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
    return morphTargetCount(scene, scene.nodes[channel.node]);
}

void requireAnimatedNode(const AnimationChannel& channel, const Scene& scene, const ChannelContext& element) {
    const Node& node = scene.nodes[channel.node];
    if (channel.path == AnimationPath::morphWeights) {
        element.require(morphTargetCount(scene, node) > 0,
                        "its node has no mesh and no cage with morph targets");
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
