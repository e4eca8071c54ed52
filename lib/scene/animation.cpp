#include "scene/animation.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace candela {

namespace {

std::size_t numbersPerValue(const AnimationChannel& channel) {
    return channel.path == AnimationPath::rotation ? 4 : 3;
}

// Which of a key's values; a cubic spline holds three, the others one.
enum class Part { inTangent, value, outTangent };

glm::dvec4 keyValue(const AnimationChannel& channel, std::size_t key, Part part = Part::value) {
    const std::size_t numbers = numbersPerValue(channel);
    const bool cubic = channel.interpolation == Interpolation::cubicSpline;
    const std::size_t index = cubic ? key * 3 + static_cast<std::size_t>(part) : key;
    const float* first = channel.values.data() + index * numbers;
    return {first[0], first[1], first[2], numbers == 4 ? first[3] : 0.0f};
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
    // Below this angle the sines are those of a straight line to more digits than a float holds.
    if (angle < 1e-4) return from * (1.0 - t) + to * (side * t);
    return (from * std::sin(angle * (1.0 - t)) + to * (side * std::sin(angle * t))) / std::sin(angle);
}

// glTF 2.0, C.5. `duration` is the time between the keys: tangents are slopes per second.
glm::dvec4 cubicSpline(const AnimationChannel& channel, std::size_t key, double t, double duration) {
    const double t2 = t * t, t3 = t2 * t;
    return keyValue(channel, key) * (2.0 * t3 - 3.0 * t2 + 1.0) +
           keyValue(channel, key, Part::outTangent) * (duration * (t3 - 2.0 * t2 + t)) +
           keyValue(channel, key + 1) * (3.0 * t2 - 2.0 * t3) +
           keyValue(channel, key + 1, Part::inTangent) * (duration * (t3 - t2));
}

glm::dvec4 between(const AnimationChannel& channel, std::size_t key, double time) {
    if (channel.interpolation == Interpolation::step) return keyValue(channel, key);
    const double start = channel.times[key];
    const double duration = channel.times[key + 1] - start;
    const double t = (time - start) / duration;
    if (channel.interpolation == Interpolation::cubicSpline) return cubicSpline(channel, key, t, duration);
    const glm::dvec4 from = keyValue(channel, key), to = keyValue(channel, key + 1);
    if (channel.path != AnimationPath::rotation) return from * (1.0 - t) + to * t;
    return slerp(unitOr(from, from), unitOr(to, to), t);
}

void apply(const AnimationChannel& channel, double time, Trs& trs) {
    const glm::dvec4 value = sampleChannel(channel, time);
    switch (channel.path) {
        case AnimationPath::translation:
            trs.translation = glm::vec3(value);
            break;
        case AnimationPath::scale:
            trs.scale = glm::vec3(value);
            break;
        case AnimationPath::rotation: {
            const glm::vec4 q(value);
            trs.rotation = glm::quat(q.w, q.x, q.y, q.z);
            break;
        }
    }
}

}  // namespace

glm::dvec4 sampleChannel(const AnimationChannel& channel, double time) {
    assert(!channel.times.empty());
    const auto after = std::upper_bound(channel.times.begin(), channel.times.end(), time);
    const auto index = static_cast<std::size_t>(after - channel.times.begin());
    const std::size_t key = index == 0 ? 0 : index - 1;
    const bool outside = index == 0 || index == channel.times.size();
    const glm::dvec4 value = outside ? keyValue(channel, key) : between(channel, key, time);
    if (channel.path != AnimationPath::rotation) return value;
    // A spline may pass through nothing, which has no direction; then the key before holds.
    return unitOr(value, unitOr(keyValue(channel, key), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

std::vector<PosedNode> poseAnimatedNodes(const Scene& scene, double time) {
    std::map<std::uint32_t, Trs> poses;
    for (const Animation& animation : scene.animations) {
        for (const AnimationChannel& channel : animation.channels) {
            const Trs& rest = std::get<Trs>(scene.nodes[channel.node].transform);
            apply(channel, time, poses.try_emplace(channel.node, rest).first->second);
        }
    }
    std::vector<PosedNode> nodes;
    nodes.reserve(poses.size());
    for (const auto& [node, trs] : poses) nodes.push_back({node, trs});
    return nodes;
}

}  // namespace candela
