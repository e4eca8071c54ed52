#include "scene_box.h"

#include <candela/error.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// A flat scene still has room for lights above and below: no side counts for less than this share of the
/// longest.
constexpr float leastShare = 0.05f;

/// The side of the cube that each of `count` lights has to itself in `box`, metres.
float meanSpacing(const candela::Bounds& box, std::uint32_t count) {
    glm::vec3 sides = box.max - box.min;
    const float longest = std::max({sides.x, sides.y, sides.z});
    if (longest <= 0.0f) return 1.0f;
    sides = glm::max(sides, glm::vec3(longest * leastShare));
    return std::cbrt(sides.x * sides.y * sides.z / static_cast<float>(std::max(count, 1u)));
}

}  // namespace

candela::Bounds sceneBox(const candela::Scene& scene, double time) {
    const std::vector<glm::mat4> world = candela::worldTransforms(scene, time);
    candela::Bounds box = candela::worldBounds(scene, world);
    if (!box.empty()) return box;
    for (const candela::PlacedLight& light : candela::placeLights(scene, world)) {
        if (light.type == candela::LightType::directional) continue;
        box.min = glm::min(box.min, light.position);
        box.max = glm::max(box.max, light.position);
    }
    return box;
}

void addScatteredLights(candela::Scene& scene, const Options& options, double time) {
    if (!options.scatter) return;
    const candela::Bounds box = sceneBox(scene, time);
    if (box.empty())
        throw candela::Error(
            candela::ErrorKind::badInput, options.scene,
            "has neither a mesh nor a light, so --scatter-lights has no box to strew lights over");
    const ScatterChoice& choice = *options.scatter;
    const float range = choice.range.value_or(2.0f * meanSpacing(box, choice.count));
    const float candela = choice.candela.value_or(range * range / 10.0f);
    candela::scatterLights(scene.lights, box, choice.count, range, candela);
}
