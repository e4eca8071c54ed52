#include "camera_selection.h"

#include "scene_box.h"

#include <candela/error.h>

#include <charconv>
#include <cmath>
#include <string>

namespace {

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
                         const std::string& wanted) {
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        if (scene.cameras[i].name == wanted) return i;
    std::uint32_t index = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, index);
    if (error == std::errc{} && stop == end && index < scene.cameras.size()) return index;
    throw candela::Error(candela::ErrorKind::badInput, sceneName,
                         "no camera \"" + wanted + "\"; " + listCameras(scene));
}

/// `frameBounds` frames for 45 degrees; a narrower field of view has to stand further off.
candela::CameraView frameScene(const candela::Bounds& box, float aspect, float fov) {
    candela::CameraView view = candela::frameBounds(box, aspect);
    if (fov == defaultFov) return view;
    const glm::vec3 center = box.empty() ? glm::vec3(0.0f) : (box.min + box.max) * 0.5f;
    const float farther = std::sin(view.verticalFov * 0.5f) / std::sin(fov * 0.5f);
    view.worldFromCamera[3] = glm::vec4(center + (view.eye() - center) * farther, 1.0f);
    view.verticalFov = fov;
    return view;
}

}  // namespace

CameraSelection::CameraSelection(const candela::Scene& scene, const SceneOptions& options, double firstTime)
    : scene_(scene), verticalFov_(options.verticalFov) {
    if (options.camera) camera_ = findCamera(scene, options.scene, *options.camera);
    const float fov = options.verticalFov.value_or(defaultFov);
    if (options.eye) {
        fixed_ = candela::lookAt(options.eye->eye, options.eye->target, fov);
    } else if (scene.cameras.empty()) {
        const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
        fixed_ = frameScene(sceneBox(scene, firstTime), aspect, fov);
    }
}

candela::CameraView CameraSelection::at(double time) const {
    if (fixed_) return *fixed_;
    candela::CameraView view = candela::cameraView(scene_, camera_, candela::worldTransforms(scene_, time));
    view.verticalFov = verticalFov_.value_or(view.verticalFov);
    return view;
}
