#include "scene_setup.h"

#include <candela/error.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// The minimum side of the bounds that lights are scattered in, as a share of the longest.
constexpr float minSideShare = 0.05f;

/// The bounds, thickened where the scene is flat: lights in the plane of a floor would light it at grazing
/// angles only. Height is added above, the other axes on both sides.
candela::Bounds scatterBounds(const candela::Bounds& box) {
    const glm::vec3 sides = box.max - box.min;
    const float longest = std::max({sides.x, sides.y, sides.z});
    const float minSide = longest > 0.0f ? longest * minSideShare : 1.0f;
    const glm::vec3 missing = glm::max(glm::vec3(minSide) - sides, glm::vec3(0.0f));
    candela::Bounds thick = box;
    thick.min -= missing * glm::vec3(0.5f, 0.0f, 0.5f);
    thick.max += missing * glm::vec3(0.5f, 1.0f, 0.5f);
    return thick;
}

/// The side of a cube of 1 / `count` of the volume of `box`, metres.
float meanSpacing(const candela::Bounds& box, std::uint32_t count) {
    const glm::vec3 sides = box.max - box.min;
    return std::cbrt(sides.x * sides.y * sides.z / static_cast<float>(std::max(count, 1u)));
}

}  // namespace

candela::Bounds sceneBounds(const candela::Scene& scene, double time) {
    const std::vector<glm::mat4> world = candela::worldTransforms(scene, time);
    candela::Bounds box = candela::worldBounds(scene, world, time);
    if (!box.empty()) return box;
    for (const candela::WorldLight& light : candela::worldLights(scene, world)) {
        if (light.type == candela::LightType::directional) continue;
        box.min = glm::min(box.min, light.position);
        box.max = glm::max(box.max, light.position);
    }
    return box;
}

void addScatteredLights(candela::Scene& scene, const ScatterOptions& scatter, const std::string& sceneName) {
    const candela::Bounds box = sceneBounds(scene, 0.0);
    if (box.empty())
        throw candela::Error(
            candela::ErrorKind::badInput, sceneName,
            "has neither a mesh nor a light, so that there are no bounds to scatter lights in");
    const candela::Bounds room = scatterBounds(box);
    const float range = scatter.range.value_or(2.0f * meanSpacing(room, scatter.count));
    const float candela = scatter.candela.value_or(range * range / 10.0f);
    candela::scatterLights(scene.lights, room, scatter.count, range, candela, scatter.seed);
}
