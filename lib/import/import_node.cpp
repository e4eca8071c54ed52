#include "import/abi_import.h"

#include "scene/model/deformation.h"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <variant>

namespace candela {

namespace {

Transform transformFrom(const candela_node& source, const AbiReader& element) {
    Transform transform;
    transform.translation = element.finiteVector("translation", source.translation);
    transform.rotation = element.unitQuaternion("rotation", source.rotation);
    transform.scale = element.finiteVector("scale", source.scale);
    return transform;
}

glm::mat4 matrixFrom(const candela_node& source, const AbiReader& element) {
    std::vector<glm::mat4> copies;
    element.numbers("matrix", source.matrix, 1, copies);
    return element.affine("matrix", copies.front());
}

}  // namespace

Node nodeFrom(const candela_node& source, const AbiReader& element, const Scene& scene) {
    Node node;
    node.name = element.name();
    node.parent = element.reference("parent", source.parent, scene.nodes.size());
    node.mesh = element.reference("mesh", source.mesh, scene.meshes.size());
    for (int axis = 0; axis < 3; ++axis) {
        const double remainder = source.translation_remainder[axis];
        if (!std::isfinite(remainder))
            element.refuse(
                joined("translation_remainder is ", remainder, ", but a finite number was expected"));
        node.translationRemainder[axis] = remainder;
    }
    node.castsShadow = !element.flag("casts_no_shadow", source.casts_no_shadow);
    if (source.matrix)
        node.transform = matrixFrom(source, element);
    else
        node.transform = transformFrom(source, element);
    return node;
}

namespace {

void takeLens(const candela_camera& source, const AbiReader& element, Camera& camera) {
    const float height = element.zeroOrMore("orthographic_height", source.orthographic_height);
    if (height > 0.0f) {
        camera.orthographicHeight = height;
        return;
    }
    camera.verticalFov = element.finite("vertical_fov", source.vertical_fov);
    if (camera.verticalFov <= 0.0f || camera.verticalFov >= glm::pi<float>())
        element.refuse(joined("vertical_fov is ", camera.verticalFov,
                              ", but more than 0 and less than pi was expected"));
}

}  // namespace

Camera cameraFrom(const candela_camera& source, const AbiReader& element, const Scene& scene) {
    Camera camera;
    camera.name = element.name();
    takeLens(source, element, camera);
    const float nearPlane = element.zeroOrMore("near_plane", source.near_plane);
    if (nearPlane > 0.0f) camera.nearPlane = nearPlane;
    const float farPlane = element.zeroOrMore("far_plane", source.far_plane);
    if (farPlane > 0.0f && farPlane <= nearPlane)
        element.refuse(
            joined("far_plane is ", farPlane, ", but more than near_plane, ", nearPlane, ", was expected"));
    if (farPlane > 0.0f) camera.farPlane = farPlane;
    camera.node = element.reference("node", source.node, scene.nodes.size());
    if (source.number > 0) camera.number = source.number - 1;
    return camera;
}

namespace {

void takeCone(const candela_light& source, const AbiReader& element, Light& light) {
    light.outerConeAngle =
        element.within("outer_cone_angle", source.outer_cone_angle, 0.0f, glm::half_pi<float>());
    light.innerConeAngle = element.zeroOrMore("inner_cone_angle", source.inner_cone_angle);
    if (light.innerConeAngle >= light.outerConeAngle)
        element.refuse(joined("inner_cone_angle is ", light.innerConeAngle,
                              ", but less than outer_cone_angle (", light.outerConeAngle, ") was expected"));
}

glm::vec3 unitDirection(const candela_light& source, const AbiReader& element) {
    const glm::dvec3 direction(element.finiteVector("direction", source.direction));
    const double length = std::hypot(direction.x, direction.y, direction.z);
    if (!(length > 0.0)) element.refuse("direction has the length 0");
    return glm::vec3(direction / length);
}

}  // namespace

Light lightFrom(const candela_light& source, const AbiReader& element, const Scene& scene) {
    constexpr std::array types{LightType::point, LightType::spot, LightType::directional};
    Light light;
    light.name = element.name();
    light.type = types[element.enumerator("type", source.type, types.size())];
    for (int i = 0; i < 3; ++i) light.color[i] = element.zeroOrMore("color", source.color[i]);
    light.intensity = element.zeroOrMore("intensity", source.intensity);
    if (const float range = element.zeroOrMore("range", source.range); range > 0.0f) light.range = range;
    if (light.type == LightType::spot) takeCone(source, element, light);
    if (light.type != LightType::directional)
        light.position = element.finiteVector("position", source.position);
    if (light.type != LightType::point) light.direction = unitDirection(source, element);
    light.node = element.reference("node", source.node, scene.nodes.size());
    light.castsShadow = !element.flag("casts_no_shadow", source.casts_no_shadow);
    light.radius = element.zeroOrMore("radius", source.radius);
    return light;
}

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

AnimationChannel channelFrom(const candela_animation_channel& source, std::uint32_t index,
                             const AbiReader& element, const Scene& scene) {
    constexpr std::array paths{AnimationPath::translation, AnimationPath::rotation, AnimationPath::scale,
                               AnimationPath::morphWeights};
    constexpr std::array interpolations{Interpolation::linear, Interpolation::step,
                                        Interpolation::cubicSpline};
    const auto member = [&](const char* name) { return joined("channel ", index, ": ", name); };
    AnimationChannel channel;
    channel.node = animatedNode(element, member("node"), source.node, scene);
    channel.path = paths[element.enumerator(member("path").c_str(), source.path, paths.size())];
    const std::size_t numbers = numbersOf(channel, member("node"), element, scene);
    channel.interpolation = interpolations[element.enumerator(member("interpolation").c_str(),
                                                              source.interpolation, interpolations.size())];
    if (source.key_count == 0) element.refuse(member("key_count is 0, but 1 or more was expected"));
    channel.times = copiedNumbers(element, member("time"), source.times, source.key_count);
    checkTimes(element, member("time"), channel.times);
    const std::size_t perKey = numbers * (channel.interpolation == Interpolation::cubicSpline ? 3u : 1u);
    channel.values = copiedNumbers(element, member("value"), source.values, source.key_count * perKey);
    return channel;
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
    return animation;
}

}  // namespace candela
