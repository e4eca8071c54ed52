#include "animations.h"

#include <deque>

#include "animated_properties.h"
#include "animation_keys.h"
#include "animation_pointer.h"
#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

// glTF 2.0, 3.11: rotations and weights may be normalised integers.
constexpr Encoding normalizedEncodings[] = {float32, int8Normalized, uint8Normalized, int16Normalized,
                                            uint16Normalized};
// KHR_animation_pointer: numbers may be any.
constexpr Encoding allEncodings[] = {float32,         int8,   int8Normalized,   uint8, uint8Normalized, int16,
                                     int16Normalized, uint16, uint16Normalized, uint32};
constexpr Encoding boolEncodings[] = {uint8};

candela_animation_path pathOf(const std::string& path, const std::string& element) {
    if (path == "translation") return CANDELA_ANIMATE_TRANSLATION;
    if (path == "rotation") return CANDELA_ANIMATE_ROTATION;
    if (path == "scale") return CANDELA_ANIMATE_SCALE;
    if (path == "weights") return CANDELA_ANIMATE_MORPH_WEIGHTS;
    throw Failure{element, "path '" + readable(path) + "', expected translation, rotation, scale or weights"};
}

/// Whether a channel is one of the core specification, whose numbers have fewer encodings.
enum class Origin { core, pointer };

KeyForm formOf(candela_animation_path path, Origin origin) {
    const bool isAny = origin == Origin::pointer;
    if (path == CANDELA_ANIMATE_ROTATION)
        return {.components = 4,
                .encodings = isAny ? Encodings(allEncodings) : normalizedEncodings,
                .isRotation = true};
    return {.components = 3, .encodings = isAny ? Encodings(allEncodings) : onlyFloat};
}

KeyForm weightForm(std::size_t elements, Origin origin) {
    const bool isAny = origin == Origin::pointer;
    return {.components = 1,
            .encodings = isAny ? Encodings(allEncodings) : normalizedEncodings,
            .elements = elements};
}

KeyForm formOf(const PointerRow& row) {
    return {.components = row.components,
            .encodings = allEncodings,
            .min = row.min,
            .max = row.max,
            .clamps = true,
            .factor = row.factor};
}

class AnimationReader {
  public:
    AnimationReader(const Document& document, const AnimatedElements& elements, std::size_t index,
                    const Host& host)
        : document_(document),
          elements_(elements),
          index_(index),
          source_(document.model.animations[index]),
          element_(elementName("animation", index, source_.name)),
          host_(host) {}

    void add() {
        if (host_.leavesOut([&] { requireUsable(document_, element_); })) return;
        for (std::size_t i = 0; i < source_.channels.size(); ++i) {
            host_.leavesOut([&] { readChannel(i); });
        }
        if (channels_.empty() && properties_.empty()) return;
        candela_animation animation{};
        animation.struct_size = sizeof animation;
        animation.name = source_.name.c_str();
        animation.channel_count = static_cast<std::uint32_t>(channels_.size());
        animation.channels = channels_.data();
        animation.property_count = static_cast<std::uint32_t>(properties_.size());
        animation.properties = properties_.data();
        host_.add(animation);
    }

  private:
    /// Throws `Failure` and adds nothing when the channel is broken.
    void readChannel(std::size_t index) {
        const tinygltf::AnimationChannel& source = source_.channels[index];
        const std::string element = element_ + ", channel " + std::to_string(index);
        requireUsable(document_, element);
        if (source.target_path.empty()) return;  // It has no node.
        if (source.target_path == "pointer") return readPointer(index, samplerOf(source, element), element);
        const auto node = static_cast<std::size_t>(source.target_node);
        if (elements_.nodes.at(node) < 0) return;
        const tinygltf::AnimationSampler& sampler = samplerOf(source, element);
        const candela_animation_path path = pathOf(source.target_path, element);
        if (path != CANDELA_ANIMATE_MORPH_WEIGHTS)
            return readNode(node, path, Origin::core, sampler, element);
        const auto morphed = elements_.morphed.find(node);
        if (morphed == elements_.morphed.end())
            throw Failure{element, nodeName(node) + " has no mesh with morph targets"};
        readWeights(morphed->second, Origin::core, sampler, element);
    }

    void readPointer(std::size_t index, const tinygltf::AnimationSampler& sampler,
                     const std::string& element) {
        const auto pointer = document_.animationPointers.find({index_, index});
        if (pointer == document_.animationPointers.end())
            throw Failure{element, "path 'pointer', but no pointer of KHR_animation_pointer"};
        const PointerTarget target = resolvePointer(pointer->second, element);
        const PointerRow& row = *target.row;
        if (row.to == PointerTo::nodePath) {
            if (elements_.nodes.at(target.element) < 0) return;
            return readNode(target.element, candela_animation_path(row.value), Origin::pointer, sampler,
                            element);
        }
        if (row.to == PointerTo::nodeWeights || row.to == PointerTo::meshWeights) {
            return readWeights(target,
                               animatedWeights(document_, elements_, target, pointer->second, element),
                               sampler, element);
        }
        readProperty(animatedElements(document_, elements_, target, pointer->second, element), target,
                     sampler, element);
    }

    void readNode(std::size_t node, candela_animation_path path, Origin origin,
                  const tinygltf::AnimationSampler& sampler, const std::string& element) {
        if (!document_.model.nodes[node].matrix.empty())
            throw Failure{element, nodeName(node) + " has a matrix and cannot be animated"};
        addChannel(elements_.nodes[node], path, sampler,
                   readKeys(document_, sampler, formOf(path, origin), element, host_));
    }

    void readWeights(const std::vector<MorphedNode>& nodes, Origin origin,
                     const tinygltf::AnimationSampler& sampler, const std::string& element) {
        for (const MorphedNode& node : nodes)
            addChannel(node.node, CANDELA_ANIMATE_MORPH_WEIGHTS, sampler,
                       readKeys(document_, sampler, weightForm(node.targets, origin), element, host_));
    }

    void readWeights(const PointerTarget& target, const std::vector<MorphedNode>& nodes,
                     const tinygltf::AnimationSampler& sampler, const std::string& element) {
        if (!target.weight) return readWeights(nodes, Origin::pointer, sampler, element);
        const AnimationKeys keys =
            readKeys(document_, sampler, weightForm(1, Origin::pointer), element, host_);
        for (const MorphedNode& node : nodes)
            addProperty(CANDELA_PROPERTY_MORPH_WEIGHT, node.node, *target.weight, sampler, keys);
    }

    void readProperty(const std::vector<std::int32_t>& animated, const PointerTarget& target,
                      tinygltf::AnimationSampler sampler, const std::string& element) {
        if (animated.empty()) return;
        KeyForm form = formOf(*target.row);
        if (target.row->value == CANDELA_PROPERTY_VISIBILITY) {
            form.encodings = boolEncodings;
            takeSteps(sampler, element);
        }
        const AnimationKeys keys = readKeys(document_, sampler, form, element, host_);
        for (const std::int32_t index : animated)
            addProperty(candela_animated_property(target.row->value), index, target.slot, sampler, keys);
    }

    /// What is true or false has no values in between.
    void takeSteps(tinygltf::AnimationSampler& sampler, const std::string& element) const {
        if (sampler.interpolation == "STEP") return;
        if (sampler.interpolation == "CUBICSPLINE")
            throw Failure{element, "interpolation CUBICSPLINE, expected STEP"};
        host_.note(CANDELA_NOTE_REPAIRED, element,
                   "a linear interpolation of what is true or false: taken as STEP");
        sampler.interpolation = "STEP";
    }

    std::string nodeName(std::size_t node) const {
        return elementName("node", node, document_.model.nodes[node].name);
    }

    const tinygltf::AnimationSampler& samplerOf(const tinygltf::AnimationChannel& channel,
                                                const std::string& element) const {
        const auto index = static_cast<std::size_t>(channel.sampler);
        requireUsable(document_, element_ + ", sampler " + std::to_string(index));
        if (index < source_.samplers.size()) return source_.samplers[index];
        throw Failure{element, "sampler " + std::to_string(index) + " does not exist: the animation has " +
                                   std::to_string(source_.samplers.size())};
    }

    /// Of both kinds of channels.
    template <typename Channel>
    void setKeys(const tinygltf::AnimationSampler& sampler, AnimationKeys keys, Channel& channel) {
        keys_.push_back(std::move(keys));
        channel.interpolation = interpolationOf(sampler);
        channel.key_count = static_cast<std::uint32_t>(keys_.back().times.size());
        channel.times = keys_.back().times.data();
        channel.values = keys_.back().values.data();
    }

    void addChannel(std::int32_t node, candela_animation_path path, const tinygltf::AnimationSampler& sampler,
                    AnimationKeys keys) {
        candela_animation_channel channel{};
        channel.node = node;
        channel.path = path;
        setKeys(sampler, std::move(keys), channel);
        channels_.push_back(channel);
    }

    void addProperty(candela_animated_property property, std::int32_t index, std::size_t part,
                     const tinygltf::AnimationSampler& sampler, AnimationKeys keys) {
        candela_property_channel channel{};
        channel.property = property;
        channel.element = index;
        channel.part = static_cast<std::uint32_t>(part);
        setKeys(sampler, std::move(keys), channel);
        properties_.push_back(channel);
    }

    const Document& document_;
    const AnimatedElements& elements_;
    std::size_t index_;
    const tinygltf::Animation& source_;
    std::string element_;
    const Host& host_;
    std::vector<candela_animation_channel> channels_;
    std::vector<candela_property_channel> properties_;
    std::deque<AnimationKeys> keys_;  ///< Those of the channels, which point to them.
};

}  // namespace

void addAnimations(const Document& document, const AnimatedElements& elements, const Host& host) {
    for (std::size_t i = 0; i < document.model.animations.size(); ++i)
        AnimationReader(document, elements, i, host).add();
}

}  // namespace candela_plugins::gltf
