#include "camera_selection.h"

#include <candela/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <charconv>

namespace {

constexpr float defaultFov = 0.785398f;  // 45 degrees

/// The near plane of --eye, as a share of the distance to --target: what is looked at from close by may be a
/// small part of the scene.
constexpr float nearShareOfDistance = 0.01f;

std::uint32_t numberOf(const candela::Scene& scene, std::uint32_t index) {
    return scene.cameras[index].number.value_or(index);
}

const std::string& nodeNameOf(const candela::Scene& scene, std::uint32_t index) {
    static const std::string none;
    const auto& node = scene.cameras[index].node;
    return node ? scene.nodes[*node].name : none;
}

template <typename Matches>
std::optional<std::uint32_t> firstCamera(const candela::Scene& scene, const Matches& matches) {
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        if (matches(i)) return i;
    return std::nullopt;
}

std::string listCameras(const candela::Scene& scene) {
    if (scene.cameras.empty()) return "the scene has none";
    std::string text = "there are";
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
        text += (i == 0 ? " " : ", ") + cameraLabel(scene, i);
    return text;
}

candela::CameraView eyeView(const EyeOptions& eye, float fov, const candela::Bounds& box) {
    candela::CameraView view = candela::lookAt(eye.eye, eye.target, fov);
    view.nearPlane =
        std::min(candela::defaultNearPlane(box), nearShareOfDistance * glm::distance(eye.eye, eye.target));
    return view;
}

candela::CameraView frameView(const SceneOptions& options, const candela::Bounds& box) {
    const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
    return options.verticalFov ? candela::frameBounds(box, aspect, *options.verticalFov)
                               : candela::frameBounds(box, aspect);
}

}  // namespace

candela::Bounds framedBox(const candela::Scene& scene) {
    candela::Bounds box = candela::framingBounds(scene);
    if (!box.empty()) return box;
    for (const candela::WorldLight& light : candela::worldLights(scene, candela::worldTransforms(scene))) {
        if (light.type == candela::LightType::directional) continue;
        box.min = glm::min(box.min, light.position);
        box.max = glm::max(box.max, light.position);
    }
    return box;
}

std::optional<std::uint32_t> findCamera(const candela::Scene& scene, const std::string& text) {
    if (text.empty()) return std::nullopt;
    if (const auto found = firstCamera(scene, [&](std::uint32_t i) { return nodeNameOf(scene, i) == text; }))
        return found;
    if (const auto found = firstCamera(scene, [&](std::uint32_t i) { return scene.cameras[i].name == text; }))
        return found;
    std::uint32_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return firstCamera(scene, [&](std::uint32_t i) { return numberOf(scene, i) == number; });
}

std::string cameraText(const candela::Scene& scene, std::uint32_t index) {
    const std::string number = std::to_string(numberOf(scene, index));
    for (const std::string& text : {number, nodeNameOf(scene, index), scene.cameras[index].name})
        if (!text.empty() && findCamera(scene, text) == index) return text;
    return number;
}

std::string cameraLabel(const candela::Scene& scene, std::uint32_t index) {
    const std::string& name = scene.cameras[index].name;
    const std::string& node = nodeNameOf(scene, index);
    std::string label = std::to_string(numberOf(scene, index));
    if (!name.empty()) label += " \"" + name + "\"";
    if (!node.empty() && node != name) label += " of node \"" + node + "\"";
    return label;
}

CameraSelection::CameraSelection(const candela::Scene& scene, const SceneOptions& options,
                                 const std::function<candela::Bounds()>& box)
    : scene_(scene), verticalFov_(options.verticalFov) {
    if (options.camera) {
        const std::optional<std::uint32_t> found = findCamera(scene, *options.camera);
        if (!found)
            throw candela::Error(candela::ErrorKind::badInput, options.scene,
                                 "no camera \"" + *options.camera + "\"; " + listCameras(scene));
        camera_ = *found;
    }
    if (options.eye) {
        fixed_ = eyeView(*options.eye, options.verticalFov.value_or(defaultFov), box());
    } else if (scene.cameras.empty()) {
        fixed_ = frameView(options, box());
    }
}

candela::CameraView CameraSelection::at(double time) const {
    if (fixed_) return *fixed_;
    candela::CameraView view = candela::cameraView(scene_, camera_, candela::worldTransforms(scene_, time));
    view.verticalFov = verticalFov_.value_or(view.verticalFov);
    return view;
}
