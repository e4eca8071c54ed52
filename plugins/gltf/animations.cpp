#include "animations.h"

#include "animation_keys.h"
#include "primitives.h"

namespace candela_plugins::gltf {
namespace {

// glTF 2.0, 3.11: rotations and weights may be normalised integers.
constexpr Encoding normalizedEncodings[] = {float32, int8Normalized, uint8Normalized, int16Normalized,
                                            uint16Normalized};

candela_animation_path pathOf(const std::string& path, const std::string& element) {
    if (path == "translation") return CANDELA_ANIMATE_TRANSLATION;
    if (path == "rotation") return CANDELA_ANIMATE_ROTATION;
    if (path == "scale") return CANDELA_ANIMATE_SCALE;
    if (path == "weights") return CANDELA_ANIMATE_MORPH_WEIGHTS;
    throw Failure{element, "path '" + readable(path) + "', expected translation, rotation, scale or weights"};
}

candela_interpolation interpolationOf(const std::string& name) {
    if (name == "STEP") return CANDELA_INTERPOLATE_STEP;
    return name == "CUBICSPLINE" ? CANDELA_INTERPOLATE_CUBIC_SPLINE : CANDELA_INTERPOLATE_LINEAR;
}

std::vector<float> readValues(const Document& document, int accessor, candela_animation_path path,
                              std::size_t expected, const std::string& element) {
    const std::string where = element + ", output";
    const std::size_t count = document.model.accessors.at(static_cast<std::size_t>(accessor)).count;
    if (count != expected) {
        throw Failure{where, "accessor " + std::to_string(accessor) + " has " + std::to_string(count) +
                                 " elements, expected " + std::to_string(expected)};
    }
    if (path == CANDELA_ANIMATE_ROTATION) {
        return readFloats(document, accessor, 4, normalizedEncodings, where);
    }
    if (path == CANDELA_ANIMATE_MORPH_WEIGHTS) {
        return readFloats(document, accessor, 1, normalizedEncodings, where);
    }
    return readFloats(document, accessor, 3, onlyFloat, where);
}

class AnimationReader {
  public:
    AnimationReader(const Document& document, const std::vector<std::int32_t>& nodes,
                    const MorphedNodes& morphed, const tinygltf::Animation& source, std::string element)
        : document_(document),
          nodes_(nodes),
          morphed_(morphed),
          source_(source),
          element_(std::move(element)) {}

    void add(const Host& host) {
        if (host.leavesOut([&] { requireUsable(document_, element_); })) return;
        for (std::size_t i = 0; i < source_.channels.size(); ++i) {
            host.leavesOut([&] { readChannel(i, host); });
        }
        if (channels_.empty()) return;
        candela_animation animation{};
        animation.struct_size = sizeof animation;
        animation.name = source_.name.c_str();
        animation.channel_count = static_cast<std::uint32_t>(channels_.size());
        animation.channels = channels_.data();
        host.add(animation);
    }

  private:
    /// Throws `Failure` and adds nothing when the channel is broken.
    void readChannel(std::size_t index, const Host& host) {
        const tinygltf::AnimationChannel& source = source_.channels[index];
        const std::string element = element_ + ", channel " + std::to_string(index);
        requireUsable(document_, element);
        if (source.target_path.empty()) return;  // It has no node.
        const auto node = static_cast<std::size_t>(source.target_node);
        if (nodes_.at(node) < 0) return;
        candela_animation_channel channel{};
        channel.node = nodes_[node];
        channel.path = pathOf(source.target_path, element);
        if (channel.path != CANDELA_ANIMATE_MORPH_WEIGHTS) {
            refuseMatrix(node, element);
            readKeys(samplerOf(source, element), element, 1, host, channel);
            channels_.push_back(channel);
            return;
        }
        const auto morphed = morphed_.find(node);
        if (morphed == morphed_.end())
            throw Failure{element, nodeName(node) + " has no mesh with morph targets"};
        for (const MorphedNode& shown : morphed->second) {
            channel.node = shown.node;
            readKeys(samplerOf(source, element), element, shown.targets, host, channel);
            channels_.push_back(channel);
        }
    }

    std::string nodeName(std::size_t node) const {
        return elementName("node", node, document_.model.nodes[node].name);
    }

    void refuseMatrix(std::size_t node, const std::string& element) const {
        if (document_.model.nodes[node].matrix.empty()) return;
        throw Failure{element, nodeName(node) + " has a matrix and cannot be animated"};
    }

    const tinygltf::AnimationSampler& samplerOf(const tinygltf::AnimationChannel& channel,
                                                const std::string& element) const {
        const auto index = static_cast<std::size_t>(channel.sampler);
        requireUsable(document_, element_ + ", sampler " + std::to_string(index));
        if (index < source_.samplers.size()) return source_.samplers[index];
        throw Failure{element, "sampler " + std::to_string(index) + " does not exist: the animation has " +
                                   std::to_string(source_.samplers.size())};
    }

    /// A key has `perKey` elements of the output accessor.
    void readKeys(const tinygltf::AnimationSampler& sampler, const std::string& element, std::size_t perKey,
                  const Host& host, candela_animation_channel& channel) {
        channel.interpolation = interpolationOf(sampler.interpolation);
        AnimationKeys keys;
        keys.times = readFloats(document_, sampler.input, 1, onlyFloat, element + ", input");
        if (channel.interpolation == CANDELA_INTERPOLATE_CUBIC_SPLINE) perKey *= 3;
        keys.values =
            readValues(document_, sampler.output, channel.path, keys.times.size() * perKey, element);
        repairKeys(channel, keys, element, host);
        channel.key_count = static_cast<std::uint32_t>(keys.times.size());
        // Moving a vector does not move its elements.
        channel.times = keys.times.data();
        channel.values = keys.values.data();
        keys_.push_back(std::move(keys));
    }

    const Document& document_;
    const std::vector<std::int32_t>& nodes_;
    const MorphedNodes& morphed_;
    const tinygltf::Animation& source_;
    std::string element_;
    std::vector<candela_animation_channel> channels_;
    std::vector<AnimationKeys> keys_;
};

}  // namespace

void addAnimations(const Document& document, const std::vector<std::int32_t>& nodes,
                   const MorphedNodes& morphed, const Host& host) {
    for (std::size_t i = 0; i < document.model.animations.size(); ++i) {
        const tinygltf::Animation& source = document.model.animations[i];
        AnimationReader(document, nodes, morphed, source, elementName("animation", i, source.name)).add(host);
    }
}

}  // namespace candela_plugins::gltf
