#include "scene/validate/limits.h"
#include "scene/validate/validate_parts.h"

#include <cmath>

namespace candela {

namespace {

// One channel of an animation, as errors name it.
class ChannelElement {
  public:
    ChannelElement(const ErrorContext& animation, std::size_t index) : animation_(animation), index_(index) {}

    void require(bool holds, const char* rule) const {
        if (!holds) animation_.refuse("channel " + std::to_string(index_) + ": " + rule);
    }

  private:
    const ErrorContext& animation_;
    std::size_t index_;
};

void validateTimes(const AnimationChannel& channel, const ChannelElement& element) {
    element.require(!channel.times.empty(), "it must have at least one key");
    for (std::size_t i = 0; i < channel.times.size(); ++i) {
        element.require(std::isfinite(channel.times[i]), "its times must be finite numbers");
        element.require(i == 0 || channel.times[i] > channel.times[i - 1],
                        "its times must be strictly growing");
    }
}

std::size_t numbersOf(const AnimationChannel& channel, const Scene& scene) {
    if (channel.path == AnimationPath::rotation) return 4;
    if (channel.path != AnimationPath::morphWeights) return 3;
    return scene.cages[scene.nodes[channel.node].cage->cage].morphTargets.size();
}

void validateNode(const AnimationChannel& channel, const Scene& scene, const ChannelElement& element) {
    const Node& node = scene.nodes[channel.node];
    if (channel.path == AnimationPath::morphWeights) {
        element.require(node.cage && !scene.cages[node.cage->cage].morphTargets.empty(),
                        "its node shows no cage with morph targets");
        return;
    }
    element.require(std::holds_alternative<Transform>(node.transform),
                    "its node is placed by a matrix, which can not be animated");
}

void validateValues(const AnimationChannel& channel, const Scene& scene, const ChannelElement& element) {
    const bool rotates = channel.path == AnimationPath::rotation;
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    const std::size_t numbers = numbersOf(channel, scene);
    const std::size_t stride = numbers * (cubic ? 3 : 1);
    element.require(channel.values.size() == channel.times.size() * stride,
                    "the number of its values does not fit the number of its keys");
    for (const float value : channel.values) {
        // False for a NaN too.
        element.require(std::abs(value) <= maxAnimated, "its values must be finite numbers of at most 1e9");
    }
    if (!rotates) return;
    for (std::size_t at = cubic ? numbers : 0; at < channel.values.size(); at += stride) {
        const float* q = channel.values.data() + at;
        element.require(q[0] != 0.0f || q[1] != 0.0f || q[2] != 0.0f || q[3] != 0.0f,
                        "a rotation must be a quaternion that is not 0");
    }
}

}  // namespace

void validateAnimation(const Animation& animation, const Scene& scene, const ErrorContext& element) {
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
        const AnimationChannel& channel = animation.channels[i];
        const ChannelElement channelElement(element, i);
        element.requireIndex("node", channel.node, scene.nodes.size());
        channelElement.require(
            channel.path >= AnimationPath::translation && channel.path <= AnimationPath::morphWeights,
            "its path must be translation, rotation, scale or morph weights");
        validateNode(channel, scene, channelElement);
        channelElement.require(channel.interpolation >= Interpolation::linear &&
                                   channel.interpolation <= Interpolation::cubicSpline,
                               "its interpolation must be linear, step or cubic spline");
        validateTimes(channel, channelElement);
        validateValues(channel, scene, channelElement);
    }
}

}  // namespace candela
