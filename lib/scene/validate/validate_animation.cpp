#include "scene/model/animated_properties.h"
#include "scene/model/material_textures.h"
#include "scene/model/property_animation.h"
#include "scene/validate/scene_rules.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace candela {

namespace {

// One channel of an animation, as errors name it.
class ChannelContext {
  public:
    ChannelContext(const ErrorContext& animation, const char* kind, std::size_t index)
        : animation_(animation), kind_(kind), index_(index) {}

    void require(bool holds, const char* rule) const {
        if (!holds) refuse(rule);
    }
    [[noreturn]] void refuse(const std::string& reason) const {
        animation_.refuse(kind_ + (" " + std::to_string(index_)) + ": " + reason);
    }

  private:
    const ErrorContext& animation_;
    const char* kind_;
    std::size_t index_;
};

void validateTimes(const std::vector<float>& times, const ChannelContext& element) {
    for (std::size_t i = 0; i < times.size(); ++i) {
        element.require(std::isfinite(times[i]), "its times must be finite numbers");
        element.require(i == 0 || times[i] > times[i - 1], "its times must be strictly increasing");
    }
}

std::size_t numbersOf(const AnimationChannel& channel, const Scene& scene) {
    if (channel.path == AnimationPath::rotation) return 4;
    if (channel.path != AnimationPath::morphWeights) return 3;
    return channel.morphTarget ? 1 : morphTargetCount(scene, scene.nodes[channel.node]);
}

/// Of both kinds of channels: that there are as many values as the keys require.
template <typename Channel>
void requireKeys(const Channel& channel, std::size_t numbers, const ChannelContext& element) {
    element.require(
        channel.interpolation >= Interpolation::linear && channel.interpolation <= Interpolation::cubicSpline,
        "its interpolation must be linear, step or cubic spline");
    element.require(!channel.times.empty(), "it must have at least one key");
    const std::size_t parts = channel.interpolation == Interpolation::cubicSpline ? 3 : 1;
    element.require(channel.values.size() == channel.times.size() * parts * numbers,
                    "the number of its values does not fit the number of its keys");
}

void requireAnimatedNode(const AnimationChannel& channel, const Scene& scene, const ChannelContext& element) {
    const Node& node = scene.nodes[channel.node];
    if (channel.path == AnimationPath::morphWeights) {
        const std::size_t targets = morphTargetCount(scene, node);
        element.require(targets > 0, "its node has no mesh and no cage with morph targets");
        element.require(!channel.morphTarget || *channel.morphTarget < targets,
                        "what its node shows does not have the morph target");
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

/// Whether the element of a channel has its property, and for a texture the texture.
template <typename Element>
bool hasProperty(const PropertyChannel& channel, const Scene& scene) {
    Element element = elementsOf<Element>(scene)[channel.element];
    const auto& place = rowOf(channel.property).place;
    if constexpr (std::is_same_v<Element, Light>) {
        return std::get<LightNumbers>(place)(element) != nullptr;
    } else if constexpr (std::is_same_v<Element, Camera>) {
        return std::get<CameraNumbers>(place)(element) != nullptr;
    } else if constexpr (std::is_same_v<Element, Material>) {
        return std::holds_alternative<MaterialNumbers>(place) || textureOf(element, channel.texture);
    } else {
        return true;
    }
}

template <typename Element>
void requireElement(const PropertyChannel& channel, const char* kind, const Scene& scene,
                    const ErrorContext& animation, const ChannelContext& context) {
    animation.requireIndex(kind, channel.element, elementsOf<Element>(scene).size());
    if (hasProperty<Element>(channel, scene)) return;
    const std::string name = rowOf(channel.property).name;
    context.refuse(kind + (" " + std::to_string(channel.element)) + " has no " + name + " to animate");
}

void requireElement(const PropertyChannel& channel, const Scene& scene, const ErrorContext& animation,
                    const ChannelContext& context) {
    switch (elementOf(channel.property)) {
        case AnimatedElement::node:
            return requireElement<Node>(channel, "node", scene, animation, context);
        case AnimatedElement::material:
            return requireElement<Material>(channel, "material", scene, animation, context);
        case AnimatedElement::light:
            return requireElement<Light>(channel, "light", scene, animation, context);
        case AnimatedElement::camera:
            return requireElement<Camera>(channel, "camera", scene, animation, context);
    }
}

void validateValues(const PropertyChannel& channel, const ChannelContext& element) {
    const AnimatedPropertyRow& row = rowOf(channel.property);
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    for (std::size_t i = 0; i < channel.values.size(); ++i) {
        const float value = channel.values[i];
        element.require(std::isfinite(value), "its values must be finite numbers");
        const bool isTangent = cubic && i / row.numbers % 3 != 1;
        if (isTangent || (value >= row.min && value <= row.max)) continue;
        element.refuse("a value of its " + std::string(row.name) + " is " + shortNumber(value) + ", but " +
                       shortNumber(row.min) + " to " + shortNumber(row.max) + " was expected");
    }
}

}  // namespace

void requireChannel(const AnimationChannel& channel, std::size_t index, const Scene& scene,
                    const ErrorContext& animation) {
    const ChannelContext element(animation, "channel", index);
    animation.requireIndex("node", channel.node, scene.nodes.size());
    element.require(channel.path >= AnimationPath::translation && channel.path <= AnimationPath::morphWeights,
                    "its path must be translation, rotation, scale or morph weights");
    requireAnimatedNode(channel, scene, element);
    requireKeys(channel, numbersOf(channel, scene), element);
}

void requireChannel(const PropertyChannel& channel, std::size_t index, const Scene& scene,
                    const ErrorContext& animation) {
    const ChannelContext element(animation, "property channel", index);
    const AnimatedPropertyRow* row = findRow(channel.property);
    element.require(row != nullptr, "its property is unknown");
    element.require(channel.texture >= TextureSlot::baseColor &&
                        static_cast<std::size_t>(channel.texture) < materialTextures().size(),
                    "its texture is unknown");
    requireElement(channel, scene, animation, element);
    element.require(
        channel.property != AnimatedProperty::visibility || channel.interpolation == Interpolation::step,
        "the interpolation of visibility must be step");
    requireKeys(channel, row->numbers, element);
}

void validateAnimation(const Animation& animation, const Scene& scene, const ErrorContext& element) {
    for (std::size_t i = 0; i < animation.channels.size(); ++i) {
        const AnimationChannel& channel = animation.channels[i];
        requireChannel(channel, i, scene, element);
        const ChannelContext channelContext(element, "channel", i);
        validateTimes(channel.times, channelContext);
        validateValues(channel, channelContext);
    }
    for (std::size_t i = 0; i < animation.properties.size(); ++i) {
        const PropertyChannel& channel = animation.properties[i];
        requireChannel(channel, i, scene, element);
        const ChannelContext channelContext(element, "property channel", i);
        validateTimes(channel.times, channelContext);
        validateValues(channel, channelContext);
    }
}

}  // namespace candela
