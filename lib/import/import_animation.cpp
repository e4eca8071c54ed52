#include "import/abi_import.h"

#include <array>
#include <variant>

namespace candela {
namespace {

std::vector<float> copiedNumbers(const AbiReader& element, const std::string& member, const float* from,
                                 std::size_t count) {
    std::vector<float> numbers;
    element.numbers(member.c_str(), from, count, numbers);
    return numbers;
}

std::uint32_t animatedNode(const AbiReader& element, const std::string& member, std::int32_t index,
                           const Scene& scene) {
    const auto node = element.reference(member.c_str(), index, scene.nodes.size());
    if (!node) element.refuse(member + " is -1, but a node was expected");
    return *node;
}

std::size_t morphTargetCount(const Scene& scene, const Node& node) {
    return node.cage ? scene.cages[node.cage->cage].morphTargets.size() : 0;
}

// How many numbers the value of a key has, for a node that has what the path moves.
std::size_t numbersOf(const AnimationChannel& channel, const std::string& member, const AbiReader& element,
                      const Scene& scene) {
    const Node& node = scene.nodes[channel.node];
    if (channel.path == AnimationPath::morphWeights) {
        const std::size_t targets = morphTargetCount(scene, node);
        if (targets == 0)
            element.refuse(joined(member, " is ", channel.node, ", which shows no cage with morph targets"));
        return targets;
    }
    if (!std::holds_alternative<Transform>(node.transform))
        element.refuse(
            joined(member, " is ", channel.node, ", whose transform is a matrix and can not be animated"));
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

AnimationChannel channelFrom(const candela_animation_channel& pushed, std::uint32_t index,
                             const AbiReader& element, const Scene& scene) {
    constexpr std::array paths{AnimationPath::translation, AnimationPath::rotation, AnimationPath::scale,
                               AnimationPath::morphWeights};
    constexpr std::array interpolations{Interpolation::linear, Interpolation::step,
                                        Interpolation::cubicSpline};
    const auto member = [&](const char* name) { return joined("channel ", index, ": ", name); };
    AnimationChannel channel;
    channel.node = animatedNode(element, member("node"), pushed.node, scene);
    channel.path = paths[element.enumerator(member("path").c_str(), pushed.path, paths.size())];
    const std::size_t numbers = numbersOf(channel, member("node"), element, scene);
    channel.interpolation = interpolations[element.enumerator(member("interpolation").c_str(),
                                                              pushed.interpolation, interpolations.size())];
    if (pushed.key_count == 0) element.refuse(member("key_count is 0, but 1 or more was expected"));
    channel.times = copiedNumbers(element, member("time"), pushed.times, pushed.key_count);
    checkTimes(element, member("time"), channel.times);
    const std::size_t perKey = numbers * (channel.interpolation == Interpolation::cubicSpline ? 3u : 1u);
    channel.values = copiedNumbers(element, member("value"), pushed.values, pushed.key_count * perKey);
    return channel;
}

}  // namespace

Animation animationFrom(const candela_animation& pushed, const AbiReader& element, const Scene& scene) {
    Animation animation;
    animation.name = element.name();
    if (pushed.channel_count > 0 && !pushed.channels)
        element.refuse(joined("channels is NULL, but channel_count is ", pushed.channel_count));
    for (std::uint32_t i = 0; i < pushed.channel_count; ++i) {
        candela_animation_channel channel{};
        std::memcpy(&channel, pushed.channels + i, sizeof channel);
        animation.channels.push_back(channelFrom(channel, i, element, scene));
    }
    return animation;
}

}  // namespace candela
