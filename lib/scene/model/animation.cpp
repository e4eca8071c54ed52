#include "scene/model/animation.h"

#include "scene/model/key_values.h"
#include "scene/validate/scene_rules.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace candela {

namespace {

KeyValues keysOf(const AnimationChannel& channel) {
    return {channel.interpolation, channel.times, channel.values};
}

glm::dvec4 keyQuaternion(const KeyValues& keys, std::size_t key) {
    const float* value = keys.value(key);
    return {value[0], value[1], value[2], value[3]};
}

glm::dvec4 unitOr(const glm::dvec4& quaternion, const glm::dvec4& fallback) {
    const double length = glm::length(quaternion);
    return length > 0.0 ? quaternion / length : fallback;
}

// glTF 2.0, C.4: along the shorter arc.
glm::dvec4 slerp(const glm::dvec4& from, const glm::dvec4& to, double t) {
    const double cosine = glm::dot(from, to);
    const double side = cosine < 0.0 ? -1.0 : 1.0;
    const double angle = std::acos(std::min(std::abs(cosine), 1.0));
    // Below this angle sin(x) equals x in single precision.
    if (angle < 1e-4) return from * (1.0 - t) + to * (side * t);
    return (from * std::sin(angle * (1.0 - t)) + to * (side * std::sin(angle * t))) / std::sin(angle);
}

glm::dvec4 rotationAt(const KeyValues& keys, const Moment& moment) {
    const glm::dvec4 from = keyQuaternion(keys, moment.key);
    glm::dvec4 value = from;
    if (moment.duration > 0.0 && keys.interpolation == Interpolation::linear) {
        const glm::dvec4 to = keyQuaternion(keys, moment.key + 1);
        value = slerp(unitOr(from, from), unitOr(to, to), moment.t);
    } else {
        for (int i = 0; i < 4; ++i) value[i] = keys.numberAt(static_cast<std::size_t>(i), moment);
    }
    // A spline may pass through zero, which has no direction; then the previous key applies.
    return unitOr(value, unitOr(from, glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

}  // namespace

glm::dvec4 sampleChannel(const AnimationChannel& channel, double time) {
    assert(channel.path != AnimationPath::morphWeights);
    const KeyValues keys = keysOf(channel);
    const Moment moment = keys.momentAt(time);
    if (channel.path == AnimationPath::rotation) return rotationAt(keys, moment);
    return {keys.numberAt(0, moment), keys.numberAt(1, moment), keys.numberAt(2, moment), 0.0};
}

void applyMorphWeights(const AnimationChannel& channel, double time, std::vector<float>& weights) {
    assert(channel.path == AnimationPath::morphWeights);
    const KeyValues keys = keysOf(channel);
    const Moment moment = keys.momentAt(time);
    if (channel.morphTarget) {
        weights[*channel.morphTarget] = static_cast<float>(keys.numberAt(0, moment));
        return;
    }
    weights.resize(keys.numbersPerValue());
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] = static_cast<float>(keys.numberAt(i, moment));
}

void applyChannel(const AnimationChannel& channel, double time, PosedNode& pose) {
    if (channel.path == AnimationPath::morphWeights) return;
    const glm::dvec4 value = sampleChannel(channel, time);
    Transform& transform = pose.transform;
    switch (channel.path) {
        case AnimationPath::translation:
            transform.translation = glm::vec3(value);
            pose.translation = glm::dvec3(value);
            break;
        case AnimationPath::scale:
            transform.scale = glm::vec3(value);
            break;
        case AnimationPath::rotation: {
            const glm::vec4 q(value);
            transform.rotation = glm::quat(q.w, q.x, q.y, q.z);
            break;
        }
        case AnimationPath::morphWeights:
            break;
    }
}

std::vector<PosedNode> poseAnimatedNodes(const Scene& scene, double time) {
    std::map<std::uint32_t, PosedNode> poses;
    for (std::size_t a = 0; a < scene.animations.size(); ++a) {
        const Animation& animation = scene.animations[a];
        if (!animation.plays) continue;
        for (std::size_t c = 0; c < animation.channels.size(); ++c) {
            const AnimationChannel& channel = animation.channels[c];
            requireChannel(channel, c, scene, ErrorContext("animation", a, animation.name));
            if (channel.path == AnimationPath::morphWeights) continue;
            const Node& rest = scene.nodes[channel.node];
            const PosedNode still{channel.node, std::get<Transform>(rest.transform), exactTranslation(rest)};
            applyChannel(channel, time, poses.try_emplace(channel.node, still).first->second);
        }
    }
    std::vector<PosedNode> nodes;
    nodes.reserve(poses.size());
    for (const auto& [node, pose] : poses) nodes.push_back(pose);
    return nodes;
}

}  // namespace candela
