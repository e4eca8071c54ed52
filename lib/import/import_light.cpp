#include "import/abi_import.h"

#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>

namespace candela {
namespace {

void takeCone(const candela_light& pushed, const AbiReader& element, Light& light) {
    light.outerConeAngle =
        element.within("outer_cone_angle", pushed.outer_cone_angle, 0.0f, glm::half_pi<float>());
    light.innerConeAngle = element.zeroOrMore("inner_cone_angle", pushed.inner_cone_angle);
    if (light.innerConeAngle >= light.outerConeAngle)
        element.refuse(joined("inner_cone_angle is ", light.innerConeAngle,
                              ", but less than outer_cone_angle (", light.outerConeAngle, ") was expected"));
}

glm::vec3 unitDirection(const candela_light& pushed, const AbiReader& element) {
    const glm::dvec3 direction(element.finiteVector("direction", pushed.direction));
    const double length = std::hypot(direction.x, direction.y, direction.z);
    if (!(length > 0.0)) element.refuse("direction has the length 0");
    return glm::vec3(direction / length);
}

}  // namespace

Light lightFrom(const candela_light& pushed, const AbiReader& element, const Scene& scene) {
    constexpr std::array types{LightType::point, LightType::spot, LightType::directional};
    Light light;
    light.name = element.name();
    light.type = types[element.enumerator("type", pushed.type, types.size())];
    for (int i = 0; i < 3; ++i) light.color[i] = element.zeroOrMore("color", pushed.color[i]);
    light.intensity = element.zeroOrMore("intensity", pushed.intensity);
    if (const float range = element.zeroOrMore("range", pushed.range); range > 0.0f) light.range = range;
    if (light.type == LightType::spot) takeCone(pushed, element, light);
    if (light.type != LightType::directional)
        light.position = element.finiteVector("position", pushed.position);
    if (light.type != LightType::point) light.direction = unitDirection(pushed, element);
    light.node = element.reference("node", pushed.node, scene.nodes.size());
    return light;
}

}  // namespace candela
