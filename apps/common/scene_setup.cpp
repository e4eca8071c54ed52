#include "scene_setup.h"

#include <candela/error.h>

#include <glm/common.hpp>

#include <algorithm>
#include <charconv>
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

constexpr float defaultFov = 0.785398f;  // 45 degrees

std::string listCameras(const candela::Scene& scene) {
    if (scene.cameras.empty()) return "the scene has none";
    std::string text = "there are";
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        text += (i == 0 ? " " : ", ") + std::to_string(i) + " \"" + scene.cameras[i].name + "\"";
    return text;
}

/// By name first: a scene may call its cameras "1" and "2".
std::uint32_t findCamera(const candela::Scene& scene, const std::string& sceneName,
                         const std::string& nameOrIndex) {
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        if (scene.cameras[i].name == nameOrIndex) return i;
    std::uint32_t index = 0;
    const char* const end = nameOrIndex.data() + nameOrIndex.size();
    const auto [stop, error] = std::from_chars(nameOrIndex.data(), end, index);
    if (error == std::errc{} && stop == end && index < scene.cameras.size()) return index;
    throw candela::Error(candela::ErrorKind::badInput, sceneName,
                         "no camera \"" + nameOrIndex + "\"; " + listCameras(scene));
}

/// `frameBounds` frames for 45 degrees; for another field of view the distance changes.
candela::CameraView frameScene(const candela::Bounds& box, float aspect, float fov) {
    candela::CameraView view = candela::frameBounds(box, aspect);
    if (fov == defaultFov) return view;
    const glm::vec3 center = box.empty() ? glm::vec3(0.0f) : (box.min + box.max) * 0.5f;
    const float scale = std::sin(view.verticalFov * 0.5f) / std::sin(fov * 0.5f);
    view.worldFromCamera[3] = glm::vec4(center + (view.eye() - center) * scale, 1.0f);
    view.verticalFov = fov;
    return view;
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

CameraSelection::CameraSelection(const candela::Scene& scene, const SceneOptions& options, double firstTime)
    : scene_(scene), verticalFov_(options.verticalFov) {
    if (options.camera) camera_ = findCamera(scene, options.scene, *options.camera);
    const float fov = options.verticalFov.value_or(defaultFov);
    if (options.eye) {
        fixed_ = candela::lookAt(options.eye->eye, options.eye->target, fov);
    } else if (scene.cameras.empty()) {
        const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
        fixed_ = frameScene(sceneBounds(scene, firstTime), aspect, fov);
    }
}

candela::CameraView CameraSelection::at(double time) const {
    if (fixed_) return *fixed_;
    candela::CameraView view = candela::cameraView(scene_, camera_, candela::worldTransforms(scene_, time));
    view.verticalFov = verticalFov_.value_or(view.verticalFov);
    return view;
}
