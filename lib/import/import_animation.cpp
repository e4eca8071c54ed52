#include "import/abi_import.h"

#include "scene/model/animated_properties.h"
#include "scene/model/deformation.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <array>
#include <cstring>
#include <utility>
#include <variant>

namespace candela {

namespace {

std::vector<float> copiedNumbers(const AbiReader& element, const std::string& member, const float* from,
                                 std::size_t count) {
    std::vector<float> numbers;
    element.numbers(member.c_str(), from, count, numbers);
    return numbers;
}

std::uint32_t animatedElement(const AbiReader& element, const std::string& member, std::int32_t index,
                              const char* kind, std::size_t count) {
    const auto found = element.reference(member.c_str(), index, count);
    if (!found) element.refuse(joined(member, " is -1, but a ", kind, " was expected"));
    return *found;
}

// The numbers of a key's value. Refuses a node without what the path animates.
std::size_t numbersOf(const AnimationChannel& channel, const std::string& member, const AbiReader& element,
                      const Scene& scene) {
    const Node& node = scene.nodes[channel.node];
    if (channel.path == AnimationPath::morphWeights) {
        const std::size_t targets = morphTargetCount(scene, node);
        if (targets == 0)
            element.refuse(
                joined(member, " is ", channel.node, ", which has no mesh and no cage with morph targets"));
        return targets;
    }
    if (!std::holds_alternative<Transform>(node.transform))
        element.refuse(
            joined(member, " is ", channel.node, ", whose transform is a matrix, which cannot be animated"));
    return channel.path == AnimationPath::rotation ? 4 : 3;
}

void checkTimes(const AbiReader& element, const std::string& member, const std::vector<float>& times) {
    if (times.front() < 0.0f)
        element.refuse(joined(member, " 0 is ", times.front(), ", but 0 or more was expected"));
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] <= times[i - 1])
            element.refuse(joined(member, " ", i, " is ", times[i], ", but more than the time before it, ",
                                  times[i - 1], ", was expected"));
}

/// The keys of both kinds of channels. `member` is what messages call a member.
template <typename Source, typename Channel, typename Member>
void readKeys(const Source& source, std::size_t numbers, const AbiReader& element, const Member& member,
              Channel& channel) {
    constexpr std::array interpolations{Interpolation::linear, Interpolation::step,
                                        Interpolation::cubicSpline};
    channel.interpolation = interpolations[element.enumerator(member("interpolation").c_str(),
                                                              source.interpolation, interpolations.size())];
    if (source.key_count == 0) element.refuse(member("key_count is 0, but 1 or more was expected"));
    channel.times = copiedNumbers(element, member("time"), source.times, source.key_count);
    checkTimes(element, member("time"), channel.times);
    const std::size_t perKey = numbers * (channel.interpolation == Interpolation::cubicSpline ? 3u : 1u);
    channel.values = copiedNumbers(element, member("value"), source.values, source.key_count * perKey);
}

AnimationChannel channelFrom(const candela_animation_channel& source, std::uint32_t index,
                             const AbiReader& element, const Scene& scene) {
    constexpr std::array paths{AnimationPath::translation, AnimationPath::rotation, AnimationPath::scale,
                               AnimationPath::morphWeights};
    const auto member = [&](const char* name) { return joined("channel ", index, ": ", name); };
    AnimationChannel channel;
    channel.node = animatedElement(element, member("node"), source.node, "node", scene.nodes.size());
    channel.path = paths[element.enumerator(member("path").c_str(), source.path, paths.size())];
    const std::size_t numbers = numbersOf(channel, member("node"), element, scene);
    readKeys(source, numbers, element, member, channel);
    return channel;
}

AnimationChannel morphChannelFrom(const candela_property_channel& source, std::uint32_t index,
                                  const AbiReader& element, const Scene& scene) {
    const auto member = [&](const char* name) { return joined("property channel ", index, ": ", name); };
    AnimationChannel channel;
    channel.node = animatedElement(element, member("element"), source.element, "node", scene.nodes.size());
    channel.path = AnimationPath::morphWeights;
    channel.morphTarget = source.part;
    const std::size_t targets = numbersOf(channel, member("element"), element, scene);
    if (source.part >= targets)
        element.refuse(joined(member("part"), " is ", source.part, ", but there are ", targets, " targets"));
    readKeys(source, 1, element, member, channel);
    return channel;
}

std::pair<const char*, std::size_t> kindAndCountOf(AnimatedProperty property, const Scene& scene) {
    switch (elementOf(property)) {
        case AnimatedElement::node:
            return {"node", scene.nodes.size()};
        case AnimatedElement::material:
            return {"material", scene.materials.size()};
        case AnimatedElement::light:
            return {"light", scene.lights.size()};
        default:
            return {"camera", scene.cameras.size()};
    }
}

PropertyChannel propertyFrom(const candela_property_channel& source, std::uint32_t index,
                             AnimatedProperty property, const AbiReader& element, const Scene& scene) {
    const auto member = [&](const char* name) { return joined("property channel ", index, ": ", name); };
    const auto [kind, count] = kindAndCountOf(property, scene);
    const AnimatedPropertyRow& row = rowOf(property);
    PropertyChannel channel;
    channel.property = property;
    channel.element = animatedElement(element, member("element"), source.element, kind, count);
    if (std::holds_alternative<TextureNumbers>(row.place)) {
        const std::size_t slots = materialTextures().size();
        if (source.part >= slots)
            element.refuse(
                joined(member("part"), " is ", source.part, ", but 0 to ", slots - 1, " was expected"));
        channel.texture = static_cast<TextureSlot>(source.part);
    }
    readKeys(source, row.numbers, element, member, channel);
    return channel;
}

void takeProperties(const candela_animation& source, const AbiReader& element, const Scene& scene,
                    Animation& animation) {
    if (source.property_count > 0 && !source.properties)
        element.refuse(joined("properties is NULL, but property_count is ", source.property_count));
    // That of the weight of one morph target has no number of `AnimatedProperty`; the others follow it.
    constexpr auto count = static_cast<std::uint32_t>(AnimatedProperty::farPlane) + 2;
    static_assert(count == CANDELA_PROPERTY_FAR_PLANE + 1);
    for (std::uint32_t i = 0; i < source.property_count; ++i) {
        candela_property_channel channel{};
        std::memcpy(&channel, source.properties + i, sizeof channel);
        const std::uint32_t property =
            element.enumerator(joined("property channel ", i, ": property").c_str(), channel.property, count);
        if (property == CANDELA_PROPERTY_MORPH_WEIGHT) {
            animation.channels.push_back(morphChannelFrom(channel, i, element, scene));
        } else {
            animation.properties.push_back(
                propertyFrom(channel, i, AnimatedProperty(property - 1), element, scene));
        }
    }
}

}  // namespace

Animation animationFrom(const candela_animation& source, const AbiReader& element, const Scene& scene) {
    Animation animation;
    animation.name = element.name();
    if (source.channel_count > 0 && !source.channels)
        element.refuse(joined("channels is NULL, but channel_count is ", source.channel_count));
    for (std::uint32_t i = 0; i < source.channel_count; ++i) {
        candela_animation_channel channel{};
        std::memcpy(&channel, source.channels + i, sizeof channel);
        animation.channels.push_back(channelFrom(channel, i, element, scene));
    }
    takeProperties(source, element, scene, animation);
    validateAnimation(animation, scene, element.context());
    return animation;
}

}  // namespace candela
