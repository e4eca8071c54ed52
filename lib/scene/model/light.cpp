#include <candela/light.h>

#include "scene/geometry/axes.h"
#include "scene/model/animation.h"
#include "scene/model/property_animation.h"
#include "scene/validate/scene_rules.h"

#include <candela/scene.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace candela {

namespace {

WorldLight inNodeFrame(const Light& light) {
    WorldLight result;
    result.type = light.type;
    result.position = light.position;
    result.range = light.range.value_or(0.0f);
    result.direction = light.direction;
    result.intensity = light.color * light.intensity;
    result.innerConeAngle = light.innerConeAngle;
    result.outerConeAngle = light.outerConeAngle;
    result.castsShadow = light.castsShadow;
    result.radius = light.radius;
    return result;
}

glm::vec3 unitOr(const glm::dvec3& vector, const glm::vec3& fallback) {
    const double length = glm::length(vector);
    return length > 0.0 ? glm::vec3(vector / length) : fallback;
}

/// `node` is the matrix of the light's node; null without one.
WorldLight placed(const Light& light, const glm::mat4* node) {
    WorldLight result = inNodeFrame(light);
    glm::dvec3 direction(light.direction);
    if (node != nullptr) {
        result.position = glm::vec3(*node * glm::vec4(light.position, 1.0f));
        if (light.type != LightType::point) direction = unscaledFrame(*node) * direction;
    }
    if (light.type != LightType::point) result.direction = unitOr(direction, result.direction);
    return result;
}

// A photometric quantity has to be finite and 0 or more, as has what it converts to.
float checked(const char* quantity, double given, double converted) {
    const ErrorContext context(quantity);
    context.requireNotNegative("it", given);
    context.require(converted <= std::numeric_limits<float>::max(), "it is more than a float can hold");
    return static_cast<float>(converted);
}

}  // namespace

float candelaFromLumen(float lumen) {
    return checked("luminous flux", lumen, lumen / (4.0 * std::numbers::pi));
}

float candelaFromLumen(float lumen, float outerConeAngle) {
    const ErrorContext spot("spot light");
    spot.requirePositive("its outer cone angle", outerConeAngle);
    spot.requireWithin("its outer cone angle", outerConeAngle, 0.0, std::numbers::pi_v<float>);
    // 1 - cos(a) = 2 sin²(a / 2), which keeps its digits for narrow cones.
    const double sine = std::sin(0.5 * outerConeAngle);
    return checked("luminous flux", lumen, lumen / (4.0 * std::numbers::pi * sine * sine));
}

float lumenFromWatt(float watt) {
    return checked("radiant flux", watt, watt * 683.0f);
}

WorldLight worldLight(const Light& light, const std::vector<glm::mat4>& world) {
    return placed(light, light.node ? &world[*light.node] : nullptr);
}

WorldLight worldLight(const Light& light, const glm::mat4& worldFromNode) {
    static const Scene withoutNodes;
    const ErrorContext context("light", {}, light.name);
    context.requireFinite("the matrix of its node", worldFromNode);
    context.require(isAffine(worldFromNode), "the matrix of its node must be affine");
    Light alone = light;
    alone.node.reset();
    validateLight(alone, withoutNodes, context);
    return placed(light, &worldFromNode);
}

std::vector<WorldLight> worldLights(const Scene& scene, const std::vector<glm::mat4>& world, double time) {
    requireWorldMatrices(scene, world);
    const std::map<std::uint32_t, Light> posed = posedElements<Light>(scene, time);
    const std::vector<bool> visible = visibleNodes(scene, time);
    std::vector<WorldLight> lights;
    lights.reserve(scene.lights.size());
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const auto animated = posed.find(i);
        const Light& light = animated == posed.end() ? scene.lights[i] : animated->second;
        validateLight(light, scene, ErrorContext("light", i, light.name));
        lights.push_back(worldLight(light, world));
        if (light.node && !visible[*light.node]) lights.back().intensity = glm::vec3(0.0f);
    }
    return lights;
}

}  // namespace candela
