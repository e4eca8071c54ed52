#include <candela/light.h>

#include "scene/model/frame.h"

#include <candela/scene.h>

#include <glm/geometric.hpp>

#include <cassert>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

WorldLight withoutPlace(const Light& light) {
    WorldLight placed;
    placed.type = light.type;
    placed.position = light.position;
    placed.range = light.range.value_or(0.0f);
    placed.direction = light.direction;
    placed.intensity = light.color * light.intensity;
    placed.innerConeAngle = light.innerConeAngle;
    placed.outerConeAngle = light.outerConeAngle;
    return placed;
}

glm::vec3 unitOr(const glm::dvec3& vector, const glm::vec3& fallback) {
    const double length = glm::length(vector);
    return length > 0.0 ? glm::vec3(vector / length) : fallback;
}

}  // namespace

float candelaFromLumen(float lumen) {
    return static_cast<float>(lumen / (4.0 * std::numbers::pi));
}

float candelaFromLumen(float lumen, float outerConeAngle) {
    // 1 - cos(a) = 2 sin²(a / 2), which keeps its digits for narrow cones.
    const double sine = std::sin(0.5 * outerConeAngle);
    return static_cast<float>(lumen / (4.0 * std::numbers::pi * sine * sine));
}

float lumenFromWatt(float watt) {
    return watt * 683.0f;
}

WorldLight worldLight(const Light& light, const std::vector<glm::mat4>& world) {
    WorldLight placed = withoutPlace(light);
    glm::dvec3 direction(light.direction);
    if (light.node) {
        const glm::mat4& node = world[*light.node];
        placed.position = glm::vec3(node * glm::vec4(light.position, 1.0f));
        if (light.type != LightType::point) direction = unscaledFrame(node) * direction;
    }
    if (light.type != LightType::point) placed.direction = unitOr(direction, placed.direction);
    return placed;
}

std::vector<WorldLight> worldLights(const Scene& scene, const std::vector<glm::mat4>& world) {
    assert(world.size() == scene.nodes.size());
    std::vector<WorldLight> placed;
    placed.reserve(scene.lights.size());
    for (const Light& light : scene.lights) placed.push_back(worldLight(light, world));
    return placed;
}

}  // namespace candela
