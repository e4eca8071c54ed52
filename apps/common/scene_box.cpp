#include "scene_box.h"

#include <candela/error.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// No side of the room that lights are scattered over is shorter than this share of the longest.
constexpr float minShare = 0.05f;

/// The box, made thicker where the scene is flat: lights in the plane of a floor would only graze it. Height
/// is added above, where a floor has its light.
candela::Bounds roomForLights(const candela::Bounds& box) {
    const glm::vec3 sides = box.max - box.min;
    const float longest = std::max({sides.x, sides.y, sides.z});
    const float least = longest > 0.0f ? longest * minShare : 1.0f;
    const glm::vec3 lacking = glm::max(glm::vec3(least) - sides, glm::vec3(0.0f));
    candela::Bounds room = box;
    room.min -= lacking * glm::vec3(0.5f, 0.0f, 0.5f);
    room.max += lacking * glm::vec3(0.5f, 1.0f, 0.5f);
    return room;
}

/// The side of the cube that each of `count` lights has to itself in `room`, metres.
float meanSpacing(const candela::Bounds& room, std::uint32_t count) {
    const glm::vec3 sides = room.max - room.min;
    return std::cbrt(sides.x * sides.y * sides.z / static_cast<float>(std::max(count, 1u)));
}

}  // namespace

candela::Bounds sceneBox(const candela::Scene& scene, double time) {
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

void addScatteredLights(candela::Scene& scene, const ScatterOptions& choice, const std::string& sceneName) {
    const candela::Bounds box = sceneBox(scene, 0.0);
    if (box.empty())
        throw candela::Error(
            candela::ErrorKind::badInput, sceneName,
            "has neither a mesh nor a light, so --scatter-lights has no box to scatter lights over");
    const candela::Bounds room = roomForLights(box);
    const float range = choice.range.value_or(2.0f * meanSpacing(room, choice.count));
    const float candela = choice.candela.value_or(range * range / 10.0f);
    candela::scatterLights(scene.lights, room, choice.count, range, candela, choice.seed);
}
