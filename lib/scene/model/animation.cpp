#include "scene/model/animation.h"

#include "scene/validate/scene_rules.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace candela {

namespace {

// Which of a key's values; a cubic spline has three, the others one.
enum class Part { inTangent, value, outTangent };

// The number of components of a value; the channel has as many as its keys require.
std::size_t numbersPerValue(const AnimationChannel& channel) {
    const std::size_t parts = channel.interpolation == Interpolation::cubicSpline ? 3 : 1;
    return channel.values.size() / (channel.times.size() * parts);
}

// The components of a key's value.
const float* keyValue(const AnimationChannel& channel, std::size_t key, Part part = Part::value) {
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    const std::size_t value = cubic ? key * 3 + static_cast<std::size_t>(part) : key;
    return channel.values.data() + value * numbersPerValue(channel);
}

// Component `index` of a key's value.
double keyNumber(const AnimationChannel& channel, std::size_t index, std::size_t key,
                 Part part = Part::value) {
    return keyValue(channel, key, part)[index];
}

// Where a time falls among the keys of a channel.
struct Moment {
    std::size_t key = 0;
    double t = 0.0;         // From 0 at the key to 1 at the next one.
    double duration = 0.0;  // Seconds from the key to the next one; 0: the value of the key.
};

Moment momentAt(const AnimationChannel& channel, double time) {
    assert(!channel.times.empty());
    const auto after = std::upper_bound(channel.times.begin(), channel.times.end(), time);
    const auto index = static_cast<std::size_t>(after - channel.times.begin());
    const std::size_t key = index == 0 ? 0 : index - 1;
    const bool outside = index == 0 || index == channel.times.size();
    if (outside || channel.interpolation == Interpolation::step) return {key};
    const double start = channel.times[key];
    const double duration = channel.times[key + 1] - start;
    return {key, (time - start) / duration, duration};
}

// glTF 2.0, C.5: tangents are slopes per second.
double cubicSpline(const AnimationChannel& channel, std::size_t index, const Moment& moment) {
    const double t = moment.t, t2 = t * t, t3 = t2 * t;
    return keyNumber(channel, index, moment.key) * (2.0 * t3 - 3.0 * t2 + 1.0) +
           keyNumber(channel, index, moment.key, Part::outTangent) * moment.duration * (t3 - 2.0 * t2 + t) +
           keyNumber(channel, index, moment.key + 1) * (3.0 * t2 - 2.0 * t3) +
           keyNumber(channel, index, moment.key + 1, Part::inTangent) * moment.duration * (t3 - t2);
}

// Component `index` of the channel's value, interpolated per component.
double numberAt(const AnimationChannel& channel, std::size_t index, const Moment& moment) {
    if (moment.duration == 0.0) return keyNumber(channel, index, moment.key);
    if (channel.interpolation == Interpolation::cubicSpline) return cubicSpline(channel, index, moment);
    return keyNumber(channel, index, moment.key) * (1.0 - moment.t) +
           keyNumber(channel, index, moment.key + 1) * moment.t;
}

glm::dvec4 keyQuaternion(const AnimationChannel& channel, std::size_t key) {
    const float* value = keyValue(channel, key);
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

glm::dvec4 rotationAt(const AnimationChannel& channel, const Moment& moment) {
    const glm::dvec4 from = keyQuaternion(channel, moment.key);
    glm::dvec4 value = from;
    if (moment.duration > 0.0 && channel.interpolation == Interpolation::linear) {
        const glm::dvec4 to = keyQuaternion(channel, moment.key + 1);
        value = slerp(unitOr(from, from), unitOr(to, to), moment.t);
    } else {
        for (int i = 0; i < 4; ++i) value[i] = numberAt(channel, static_cast<std::size_t>(i), moment);
    }
    // A spline may pass through zero, which has no direction; then the previous key applies.
    return unitOr(value, unitOr(from, glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

}  // namespace

glm::dvec4 sampleChannel(const AnimationChannel& channel, double time) {
    assert(channel.path != AnimationPath::morphWeights);
    const Moment moment = momentAt(channel, time);
    if (channel.path == AnimationPath::rotation) return rotationAt(channel, moment);
    return {numberAt(channel, 0, moment), numberAt(channel, 1, moment), numberAt(channel, 2, moment), 0.0};
}

std::vector<float> sampleMorphWeights(const AnimationChannel& channel, double time) {
    assert(channel.path == AnimationPath::morphWeights);
    const Moment moment = momentAt(channel, time);
    std::vector<float> weights(numbersPerValue(channel));
    for (std::size_t i = 0; i < weights.size(); ++i) {
        weights[i] = static_cast<float>(numberAt(channel, i, moment));
    }
    return weights;
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
