#include "scene_lights.h"

#include "scene_selection.h"

#include <candela/default_lights.h>
#include <candela/error.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>

candela::Bounds sceneBounds(const candela::Scene& scene, double time) {
    const std::vector<glm::mat4> world = candela::worldTransforms(scene, time);
    candela::Bounds box = candela::worldBounds(scene, world, time);
    if (!box.empty()) return box;
    for (const candela::WorldLight& light : candela::worldLights(scene, world, time)) {
        if (light.type == candela::LightType::directional) continue;
        box.min = glm::min(box.min, light.position);
        box.max = glm::max(box.max, light.position);
    }
    return box;
}

void addScatteredLights(candela::Scene& scene, const candela::LightScatter& scatter,
                        const std::string& sceneName) {
    try {
        candela::scatterLights(scene, scatter);
    } catch (const candela::Error& error) {
        throw candela::Error(error.kind(), sceneName, error.what());
    }
}

bool usesDefaultLights(const candela::Scene& scene, DefaultLights option) {
    return option == DefaultLights::on || (option == DefaultLights::automatic && !candela::hasLight(scene));
}

const char* const defaultLightsNote =
    "the scene has no light: default lights are added (--default-lights off leaves them out)";

std::vector<candela::WorldLight> lightsWithDefaults(const candela::Scene& scene, double time,
                                                    const candela::CameraView& view, double exposure) {
    std::vector<candela::WorldLight> lights =
        candela::worldLights(scene, candela::worldTransforms(scene, time), time);
    const std::array<candela::WorldLight, 3> added = candela::defaultLights(view, exposure);
    lights.insert(lights.end(), added.begin(), added.end());
    return lights;
}

std::vector<double> exposureTimes(const candela::Scene& scene, double time) {
    const double end = lastKeyTime(scene);
    if (end == 0.0) return {time};
    constexpr int count = 8;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(end * i / (count - 1));
    return times;
}

std::optional<std::string> pictureNote(const candela::ExposureCounts& counts) {
    // Below this share of what is in view the rest is taken for unlit.
    constexpr double minLitShare = 0.05;
    const auto surfaces = static_cast<double>(counts.surfaces);
    if (counts.surfaces == 0)
        return "nothing of the scene is in view: without --camera and --eye, a camera of the scene or one "
               "that frames it is used";
    if (static_cast<double>(counts.lit) < minLitShare * surfaces)
        return "next to nothing in view is lit: --default-lights on adds lights";
    if (static_cast<double>(counts.overBlack) < minLitShare * surfaces)
        return "what is lit is too dark to be seen: --exposure auto brightens it";
    if (2 * counts.overWhite > counts.surfaces)
        return "more than half of what is in view is over white: --exposure auto darkens it";
    return std::nullopt;
}
