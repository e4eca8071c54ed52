#include "bench_scene.h"

#include "common/scene_box.h"

#include <candela/import.h>

#include <algorithm>
#include <array>

namespace {

constexpr std::array proceduralScenes{"plaza", "cloud", "rooms"};

candela::CameraView viewOf(const candela::Scene& scene, const BenchOptions& options,
                           const std::vector<glm::mat4>& world) {
    if (!scene.cameras.empty()) return cameraView(scene, 0, world);
    return frameBounds(worldBounds(scene, world),
                       static_cast<float>(options.width) / static_cast<float>(options.height));
}

BenchScene place(const std::string& name, candela::Scene scene, const BenchOptions& options) {
    const std::vector<glm::mat4> world = worldTransforms(scene);
    BenchScene made{name, {}, worldLights(scene, world), viewOf(scene, options, world), {}};
    made.scene = std::move(scene);
    return made;
}

/// The lights of the plaza, turned round the camera to lie behind it.
void moveBehind(std::vector<candela::WorldLight>& lights, const candela::CameraView& view) {
    for (candela::WorldLight& light : lights) {
        light.position = 2.0f * view.eye() - light.position + glm::vec3(view.worldFromCamera[2]) * 4.0f;
    }
}

/// As many lights again, deep enough under the ground that none reaches it: they lie in the frustum, behind
/// what is seen.
void addHidden(std::vector<candela::WorldLight>& lights) {
    const std::size_t count = lights.size();
    for (std::size_t i = 0; i < count; ++i) {
        candela::WorldLight hidden = lights[i];
        hidden.position.y = -hidden.position.y - hidden.range - 1.0f;
        lights.push_back(hidden);
    }
}

}  // namespace

BenchScene loadBenchScene(const candela::PluginRegistry& plugins, const BenchOptions& options,
                          std::optional<std::uint64_t> lights) {
    const std::string count = std::to_string(lights.value_or(4096));
    if (std::ranges::find(proceduralScenes, options.scene) != proceduralScenes.end()) {
        return place(options.scene, importScene(plugins, options.scene + ":" + count).scene, options);
    }
    if (options.scene == "outside" || options.scene == "hidden") {
        BenchScene made = place(options.scene, importScene(plugins, "plaza:" + count).scene, options);
        made.referenceLights = options.scene == "outside" ? 0 : made.lights.size();
        if (options.scene == "outside") moveBehind(made.lights, made.view);
        if (options.scene == "hidden") addHidden(made.lights);
        return made;
    }
    candela::Scene scene = importScene(plugins, options.scene).scene;
    if (lights) {
        scene.lights.clear();
        ScatterOptions choice;
        choice.count = static_cast<std::uint32_t>(*lights);
        addScatteredLights(scene, choice, options.scene);
    }
    return place(options.scene, std::move(scene), options);
}
