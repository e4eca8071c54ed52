#include "lights.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace candela_plugins::gltf {
namespace {

std::optional<std::size_t> lightOf(const tinygltf::Node& node) {
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) return std::nullopt;
    return static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
}

candela_light_type typeOf(const std::string& type) {
    if (type == "point") return CANDELA_LIGHT_POINT;
    return type == "spot" ? CANDELA_LIGHT_SPOT : CANDELA_LIGHT_DIRECTIONAL;
}

/// Equal angles, or an inner one that rounding made the larger, are a hard edge.
void readCone(const tinygltf::SpotLight& spot, const std::string& element, const Host& host,
              candela_light& light) {
    constexpr double roundingError = 1e-4;  // of angles that were written with four decimals or in degrees
    light.outer_cone_angle =
        std::min(static_cast<float>(spot.outerConeAngle), std::numbers::pi_v<float> / 2.0f);
    if (!(light.outer_cone_angle > 0.0f))
        throw Failure{element + ", spot", "outerConeAngle is 0: it is dark"};
    light.inner_cone_angle =
        std::min(static_cast<float>(spot.innerConeAngle), std::nextafter(light.outer_cone_angle, 0.0f));
    if (spot.innerConeAngle <= spot.outerConeAngle + roundingError) return;
    host.note(CANDELA_NOTE_REPAIRED, element + ", spot",
              "innerConeAngle is more than outerConeAngle: drawn with a hard edge");
}

/// A range beyond any coordinate that a scene takes is none: exporters write the maximum float for it.
void readRange(const tinygltf::Light& source, const std::string& element, const Host& host,
               candela_light& light) {
    constexpr double maxRange = 1e9;
    light.range = source.range < maxRange ? static_cast<float>(source.range) : 0.0f;
    if (source.range < maxRange) return;
    host.note(CANDELA_NOTE_INFORMATION, element, "range is more than any distance: taken as none");
}

/// Exporters write what a user says of a light to its node too. Where that has a mesh, it is about the mesh:
/// a bulb need not shadow its own light.
void readShadow(const Document& document, std::size_t index, std::size_t nodeIndex, candela_light& light) {
    const ShadowExtras& extras = document.shadows;
    const bool isOfNode = !extras.lights.contains(index) && document.model.nodes[nodeIndex].mesh < 0;
    light.casts_no_shadow =
        isOfNode ? castsNoShadow(extras.nodes, nodeIndex) : castsNoShadow(extras.lights, index);
    const auto radius = extras.radii.find(index);
    if (radius != extras.radii.end()) light.radius = radius->second;
}

/// The host takes no product of intensity and colour beyond this.
void limitIntensity(const std::string& element, const Host& host, candela_light& light) {
    constexpr float max = 1e20f;
    const float brightest = std::max(1.0f, *std::max_element(light.color, light.color + 3));
    if (light.intensity <= max / brightest) return;
    light.intensity = max / brightest;
    host.note(CANDELA_NOTE_REPAIRED, element, "intensity times color is more than 1e20, clamped");
}

}  // namespace

AddedLights addLights(const Document& document, const std::vector<DrawnNode>& drawn,
                      const std::vector<std::int32_t>& nodes, const Host& host) {
    AddedLights added;
    for (const DrawnNode& placed : drawn) {
        const auto nodeIndex = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& node = document.model.nodes[nodeIndex];
        const std::optional<std::size_t> index = lightOf(node);
        if (!index || placed.hidden) continue;
        const tinygltf::Light& source = document.model.lights.at(*index);
        const std::string element = elementName("light", *index, source.name);
        candela_light light{};
        light.struct_size = sizeof light;
        light.name = source.name.empty() ? node.name.c_str() : source.name.c_str();
        light.type = typeOf(source.type);
        std::fill_n(light.color, 3, 1.0f);
        std::transform(source.color.begin(), source.color.end(), light.color,
                       [](double v) { return static_cast<float>(v); });
        light.intensity = static_cast<float>(source.intensity);
        limitIntensity(element, host, light);
        readRange(source, element, host, light);
        light.direction[2] = -1.0f;
        light.node = nodes[nodeIndex];
        readShadow(document, *index, nodeIndex, light);
        const bool isLeftOut = host.leavesOut([&] {
            requireUsable(document, element);
            if (light.type == CANDELA_LIGHT_SPOT) readCone(source.spot, element, host, light);
        });
        if (isLeftOut) continue;
        added.emplace(*index, AddedLight{host.add(light), light});
    }
    return added;
}

}  // namespace candela_plugins::gltf
