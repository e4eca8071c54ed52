#include "scene/limits.h"
#include "scene/validate_parts.h"

#include <cmath>

namespace candela {

namespace {

// One channel of an animation, as errors name it.
class ChannelElement {
  public:
    ChannelElement(const Element& animation, std::size_t index) : animation_(animation), index_(index) {}

    void require(bool holds, const char* rule) const {
        if (!holds) animation_.refuse("channel " + std::to_string(index_) + ": " + rule);
    }

  private:
    const Element& animation_;
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

void validateValues(const AnimationChannel& channel, const ChannelElement& element) {
    const bool rotates = channel.path == AnimationPath::rotation;
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    const std::size_t numbers = rotates ? 4 : 3;
    const std::size_t stride = numbers * (cubic ? 3 : 1);
    element.require(channel.values.size() == channel.times.size() * stride,
                    "the number of its values does not fit the number of its keys");
    for (const float value : channel.values) {
        // False for a NaN too.
        element.require(std::abs(value) <= farthestCoordinate,
                        "its values must be finite numbers of at most 1e9");
    }
    if (!rotates) return;
    for (std::size_t at = cubic ? numbers : 0; at < channel.values.size(); at += stride) {
        const float* q = channel.values.data() + at;
        element.require(q[0] != 0.0f || q[1] != 0.0f || q[2] != 0.0f || q[3] != 0.0f,
                        "a rotation must be a quaternion that is not 0");
    }
}

}  // namespace

void validateAnimation(const Animation& animation, const Scene& scene, const Element& element) {
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
        const AnimationChannel& channel = animation.channels[i];
        const ChannelElement channelElement(element, i);
        element.requireIndex("node", channel.node, scene.nodes.size());
        channelElement.require(std::holds_alternative<Trs>(scene.nodes[channel.node].transform),
                               "its node is placed by a matrix, which can not be animated");
        channelElement.require(
            channel.path >= AnimationPath::translation && channel.path <= AnimationPath::scale,
            "its path must be translation, rotation or scale");
        channelElement.require(channel.interpolation >= Interpolation::linear &&
                                   channel.interpolation <= Interpolation::cubicSpline,
                               "its interpolation must be linear, step or cubic spline");
        validateTimes(channel, channelElement);
        validateValues(channel, channelElement);
    }
}

}  // namespace candela
