#include "scene/model/property_animation.h"

#include "scene/model/animated_properties.h"
#include "scene/model/frame_callback.h"
#include "scene/model/key_values.h"
#include "scene/model/material_textures.h"
#include "scene/validate/scene_rules.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

void write(const AnimatedPropertyRow& row, const glm::vec4& value, float* numbers) {
    if (!numbers) return;
    for (std::size_t i = 0; i < row.numbers; ++i) numbers[i] = value[static_cast<glm::length_t>(i)];
}

/// The largest factor that keeps `color` times it at most 1e20.
float largestFactor(const glm::vec3& color) {
    const float brightest = std::max({color.r, color.g, color.b});
    return brightest > 1.0f ? maxIntensity / brightest : maxIntensity;
}

template <typename Element>
std::vector<Element>& elementsIn(Scene& scene) {
    return const_cast<std::vector<Element>&>(elementsOf<Element>(scene));
}

template <typename Element>
void pose(Scene& scene, double time) {
    for (auto& [index, element] : posedElements<Element>(scene, time))
        elementsIn<Element>(scene)[index] = element;
}

}  // namespace

template <>
const std::vector<Node>& elementsOf(const Scene& scene) {
    return scene.nodes;
}
template <>
const std::vector<Material>& elementsOf(const Scene& scene) {
    return scene.materials;
}
template <>
const std::vector<Light>& elementsOf(const Scene& scene) {
    return scene.lights;
}
template <>
const std::vector<Camera>& elementsOf(const Scene& scene) {
    return scene.cameras;
}

glm::vec4 sampleProperty(const PropertyChannel& channel, double time) {
    const AnimatedPropertyRow& row = rowOf(channel.property);
    const KeyValues keys{channel.interpolation, channel.times, channel.values};
    const Moment moment = keys.momentAt(time);
    glm::vec4 value(0.0f);
    for (std::size_t i = 0; i < row.numbers; ++i) {
        const double number = std::clamp<double>(keys.numberAt(i, moment), row.min, row.max);
        value[static_cast<glm::length_t>(i)] = static_cast<float>(number);
    }
    return value;
}

void setProperty(const PropertyChannel& channel, const glm::vec4& value, Node& node) {
    if (const auto* place = std::get_if<NodeFlag>(&rowOf(channel.property).place))
        *(*place)(node) = value.x != 0.0f;
}

void setProperty(const PropertyChannel& channel, const glm::vec4& value, Material& material) {
    const AnimatedPropertyRow& row = rowOf(channel.property);
    if (const auto* numbers = std::get_if<MaterialNumbers>(&row.place))
        return write(row, value, (*numbers)(material));
    std::optional<Texture>& texture = textureOf(material, channel.texture);
    const auto* numbers = std::get_if<TextureNumbers>(&row.place);
    if (numbers && texture) write(row, value, (*numbers)(*texture));
}

void setProperty(const PropertyChannel& channel, const glm::vec4& value, Light& light) {
    const AnimatedPropertyRow& row = rowOf(channel.property);
    if (const auto* numbers = std::get_if<LightNumbers>(&row.place)) write(row, value, (*numbers)(light));
}

void setProperty(const PropertyChannel& channel, const glm::vec4& value, Camera& camera) {
    const AnimatedPropertyRow& row = rowOf(channel.property);
    if (const auto* numbers = std::get_if<CameraNumbers>(&row.place)) write(row, value, (*numbers)(camera));
}

void settle(Node&) {}

void settle(Material& material) {
    material.emissionStrength = std::min(material.emissionStrength, largestFactor(material.emission));
}

void settle(Light& light) {
    light.intensity = std::min(light.intensity, largestFactor(light.color));
    if (light.type != LightType::spot) return;
    light.innerConeAngle = std::min(light.innerConeAngle, std::nextafter(light.outerConeAngle, 0.0f));
}

void settle(Camera& camera) {
    const float least = rowOf(AnimatedProperty::farPlane).min;
    if (camera.nearPlane && !camera.orthographicHeight) camera.nearPlane = std::max(*camera.nearPlane, least);
    if (!camera.farPlane) return;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    camera.farPlane = std::max(*camera.farPlane, std::nextafter(camera.nearPlane.value_or(0.0f), infinity));
}

template <typename Element>
std::map<std::uint32_t, Element> posedElements(const Scene& scene, double time) {
    requireTime(time);
    std::map<std::uint32_t, Element> posed;
    const auto pose = [&](const std::vector<PropertyChannel>& channels, const ErrorContext& source) {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            const PropertyChannel& channel = channels[c];
            if (elementOf(channel.property) != kindOf<Element>) continue;
            requireChannel(channel, c, scene, source);
            const Element& rest = elementsOf<Element>(scene)[channel.element];
            Element& element = posed.try_emplace(channel.element, rest).first->second;
            setProperty(channel, sampleProperty(channel, time), element);
        }
    };
    for (std::size_t a = 0; a < scene.animations.size(); ++a) {
        const Animation& animation = scene.animations[a];
        if (animation.plays) pose(animation.properties, ErrorContext("animation", a, animation.name));
    }
    if (const auto update = updateAt(scene, time)) pose(update->properties, ErrorContext("frame callback"));
    for (auto& [index, element] : posed) settle(element);
    return posed;
}

template std::map<std::uint32_t, Node> posedElements(const Scene& scene, double time);
template std::map<std::uint32_t, Material> posedElements(const Scene& scene, double time);
template std::map<std::uint32_t, Light> posedElements(const Scene& scene, double time);
template std::map<std::uint32_t, Camera> posedElements(const Scene& scene, double time);

std::vector<bool> visibleNodes(const Scene& scene, double time) {
    std::vector<bool> visible(scene.nodes.size());
    const std::map<std::uint32_t, Node> posed = posedElements<Node>(scene, time);
    auto next = posed.begin();
    for (std::uint32_t i = 0; i < visible.size(); ++i) {
        const bool isPosed = next != posed.end() && next->first == i;
        const Node& node = isPosed ? next->second : scene.nodes[i];
        if (isPosed) ++next;
        visible[i] = node.visible && (!node.parent || visible[*node.parent]);
    }
    return visible;
}

void poseProperties(Scene& scene, double time) {
    pose<Node>(scene, time);
    pose<Material>(scene, time);
    pose<Light>(scene, time);
    pose<Camera>(scene, time);
}

}  // namespace candela
