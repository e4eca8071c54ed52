#include "bench_scene.h"

#include "common/scene_environment.h"
#include "common/scene_lights.h"
#include "common/scene_selection.h"

#include <candela/import.h>

#include <algorithm>
#include <array>

namespace {

constexpr std::array proceduralScenes{"plaza", "cloud", "rooms"};

candela::CameraView defaultView(const candela::Scene& scene, const BenchOptions& options,
                                const std::vector<glm::mat4>& world) {
    if (!scene.cameras.empty()) return cameraView(scene, 0, world);
    return frameBounds(worldBounds(scene, world),
                       static_cast<float>(options.width) / static_cast<float>(options.height));
}

/// Gives the scene the environment of the options, and its sun.
void useEnvironment(candela::Scene& scene, const BenchOptions& options) {
    if (options.environment.source == EnvironmentOption::Source::own) return;
    SceneOptions lit;
    lit.environment = options.environment;
    EnvironmentLight light = placedEnvironment(loadEnvironment(scene, lit), lit);
    scene.environment = std::move(light.environment);
    if (light.sun) scene.lights.push_back(*light.sun);
}

BenchScene makeBenchScene(const std::string& name, candela::Scene scene, const BenchOptions& options) {
    selectVariant(scene, options.variant, name);
    useEnvironment(scene, options);
    const std::vector<glm::mat4> world = worldTransforms(scene);
    BenchScene bench{name, {}, worldLights(scene, world), defaultView(scene, options, world), {}};
    bench.scene = std::move(scene);
    return bench;
}

/// Point-reflects the lights at the eye, 4 m farther back, so that they lie behind the camera.
void moveBehind(std::vector<candela::WorldLight>& lights, const candela::CameraView& view) {
    for (candela::WorldLight& light : lights) {
        light.position = 2.0f * view.eye() - light.position + glm::vec3(view.worldFromCamera[2]) * 4.0f;
    }
}

/// Adds as many lights again under the ground, so deep that none reaches it: in the frustum, but lighting no
/// visible surface.
void addHidden(std::vector<candela::WorldLight>& lights) {
    const std::size_t count = lights.size();
    for (std::size_t i = 0; i < count; ++i) {
        candela::WorldLight hidden = lights[i];
        hidden.position.y = -hidden.position.y - hidden.range - 1.0f;
        lights.push_back(hidden);
    }
}

}  // namespace

bool isTriangles(const std::string& scene) {
    return scene.starts_with("triangles:");
}

BenchScene loadBenchScene(const candela::PluginRegistry& plugins, const BenchOptions& options,
                          std::optional<std::uint64_t> lights) {
    const std::string count = std::to_string(lights.value_or(4096));
    if (std::ranges::find(proceduralScenes, options.scene) != proceduralScenes.end()) {
        return makeBenchScene(options.scene, importScene(plugins, options.scene + ":" + count).scene,
                              options);
    }
    if (isTriangles(options.scene)) {
        return makeBenchScene(options.scene, importScene(plugins, options.scene + "," + count).scene,
                              options);
    }
    if (options.scene == "outside" || options.scene == "hidden") {
        BenchScene bench =
            makeBenchScene(options.scene, importScene(plugins, "plaza:" + count).scene, options);
        bench.referenceLights = options.scene == "outside" ? 0 : bench.lights.size();
        if (options.scene == "outside") moveBehind(bench.lights, bench.view);
        if (options.scene == "hidden") addHidden(bench.lights);
        return bench;
    }
    candela::Scene scene = importScene(plugins, options.scene).scene;
    if (lights) {
        scene.lights.clear();
        candela::LightScatter scatter;
        scatter.count = static_cast<std::uint32_t>(*lights);
        addScatteredLights(scene, scatter, options.scene);
    }
    return makeBenchScene(options.scene, std::move(scene), options);
}
