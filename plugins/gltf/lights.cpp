#include "lights.h"

#include <algorithm>
#include <numbers>
#include <optional>

namespace candela_gltf {
namespace {

std::optional<std::size_t> lightOf(const tinygltf::Node& node) {
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) return std::nullopt;
    return static_cast<std::size_t>(extension->second.Get("light").GetNumberAsInt());
}

candela_light_type typeOf(const std::string& type, const std::string& element) {
    if (type == "point") return CANDELA_LIGHT_POINT;
    if (type == "spot") return CANDELA_LIGHT_SPOT;
    if (type == "directional") return CANDELA_LIGHT_DIRECTIONAL;
    throw Failure{element, "type '" + readable(type) + "', expected point, spot or directional"};
}

void readCone(const tinygltf::SpotLight& spot, const std::string& element, candela_light& light) {
    light.inner_cone_angle = static_cast<float>(spot.innerConeAngle);
    light.outer_cone_angle =
        std::min(static_cast<float>(spot.outerConeAngle), std::numbers::pi_v<float> / 2.0f);
    if (light.inner_cone_angle < light.outer_cone_angle) return;
    throw Failure{element, "innerConeAngle " + std::to_string(light.inner_cone_angle) +
                               " is not less than outerConeAngle " + std::to_string(light.outer_cone_angle)};
}

}  // namespace

void pushLights(const Document& document, const std::vector<DrawnNode>& drawn,
                const std::vector<std::int32_t>& nodes, const Host& host) {
    for (const DrawnNode& placed : drawn) {
        const auto nodeIndex = static_cast<std::size_t>(placed.node);
        const tinygltf::Node& node = document.model.nodes[nodeIndex];
        const std::optional<std::size_t> index = lightOf(node);
        if (!index) continue;
        const tinygltf::Light& source = document.model.lights.at(*index);
        const std::string element = elementName("light", *index, source.name);
        candela_light light{};
        light.struct_size = sizeof light;
        light.name = source.name.empty() ? node.name.c_str() : source.name.c_str();
        light.type = typeOf(source.type, element);
        std::fill_n(light.color, 3, 1.0f);
        std::transform(source.color.begin(), source.color.end(), light.color,
                       [](double v) { return static_cast<float>(v); });
        light.intensity = static_cast<float>(source.intensity);
        light.range = static_cast<float>(source.range);
        light.direction[2] = -1.0f;
        light.node = nodes[nodeIndex];
        if (light.type == CANDELA_LIGHT_SPOT) readCone(source.spot, element, light);
        host.add(light);
    }
}

}  // namespace candela_gltf
