#include "light_saving.h"

#include "common/output_file.h"
#include "common/scene_lights.h"
#include "common/scene_selection.h"
#include "interaction.h"
#include "lights_gltf.h"
#include "panels/panel_values.h"
#include "view_options.h"

#include <candela/error.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace {

constexpr const char* windowCamera = "candela-view";

bool animatesNode(const candela::Animation& animation, std::uint32_t node) {
    return std::ranges::any_of(animation.channels, [&](const candela::AnimationChannel& channel) {
        return channel.node == node && channel.path != candela::AnimationPath::morphWeights;
    });
}

bool animatesLens(const candela::Animation& animation, std::uint32_t camera) {
    return std::ranges::any_of(animation.properties, [&](const candela::PropertyChannel& channel) {
        return channel.element == camera &&
               candela::elementOf(channel.property) == candela::AnimatedElement::camera;
    });
}

/// Whether any animation moves a camera, or changes its lens. A frame callback may, whatever it sets now.
bool isAnimated(const candela::Scene& scene, std::uint32_t camera) {
    if (scene.frameCallback) return true;
    const auto any = [&](const auto& animates) { return std::ranges::any_of(scene.animations, animates); };
    if (any([&](const auto& animation) { return animatesLens(animation, camera); })) return true;
    for (auto node = scene.cameras[camera].node; node; node = scene.nodes[*node].parent)
        if (any([&](const auto& animation) { return animatesNode(animation, *node); })) return true;
    return false;
}

/// A name by which `findCamera` finds this camera.
std::string nameOf(const candela::Scene& scene, std::uint32_t camera) {
    const std::string name = cameraName(scene, camera);
    return findCamera(scene, name) == camera ? name : cameraText(scene, camera);
}

/// A glTF file needs the far plane of an orthographic camera: all of the scene is before it.
candela::CameraView withFarPlane(candela::CameraView view, const candela::Bounds& box) {
    if (!view.orthographicHeight || view.farPlane) return view;
    const float reach =
        box.empty() ? 1.0f
                    : glm::distance(view.eye(), 0.5f * (box.min + box.max)) + glm::distance(box.min, box.max);
    view.farPlane = view.nearPlane + reach;
    return view;
}

/// Whether the window looks otherwise than through a camera of the scene, or one that frames it.
bool hasOwnCamera(const ViewModel& model) {
    const SceneOptions& options = model.options;
    const bool ownLens = options.verticalFov || options.orthographicHeight;
    return options.eye || (ownLens && !model.document->scene().cameras.empty());
}

std::vector<SavedCamera> camerasOf(const ViewModel& model) {
    Document& document = *model.document;
    const candela::Scene& scene = document.scene();
    const candela::Bounds box = document.bounds();
    const double time = document.time();
    const std::vector<glm::mat4> world = candela::worldTransforms(scene, time);
    std::vector<SavedCamera> cameras;
    for (std::uint32_t i = 0; i < scene.cameras.size(); ++i) {
        const std::string name = nameOf(scene, i);
        if (isAnimated(scene, i) || name == windowCamera) continue;
        cameras.push_back({name, withFarPlane(candela::cameraView(scene, i, world, time), box)});
    }
    if (hasOwnCamera(model)) cameras.push_back({windowCamera, withFarPlane(selectedView(model), box)});
    return cameras;
}

}  // namespace

void saveLights(ViewModel& model, const std::filesystem::path& file) {
    Document& document = *model.document;
    if (document.lights().empty())
        throw candela::Error(candela::ErrorKind::badInput, file.string(), "there is no light to save");
    const std::vector<SavedCamera> cameras = camerasOf(model);
    const std::string gltf = lightsGltf(document.lights(), cameras, document.scene().origin);
    writeText(file, endingOf(file) == ".glb" ? glbOf(gltf) : gltf);
    document.keepSavedLights(file.string());
    model.messages.push_back(
        {Message::Kind::note, "wrote " + file.string() + ": " + countText(document.lights().size(), "light") +
                                  ", " + countText(cameras.size(), "camera") + textOfOtherEdits(document)});
}

std::string lightFileName(const std::string& path) {
    return endingOf(path) == ".glb" ? path : withEnding(path, ".gltf");
}

SceneOptions optionsWithLights(const ViewModel& model) {
    SceneOptions options = model.options;
    const std::optional<std::string> file = model.document->fileOfLights();
    if (!file) return options;
    options.lights = file;
    options.scatter.reset();
    if (options.defaultLights == DefaultLights::automatic &&
        usesDefaultLights(model.document->scene(), DefaultLights::automatic))
        options.defaultLights = DefaultLights::on;
    return options;
}

std::string textOfOtherEdits(const Document& document) {
    std::string text;
    for (const std::string& change : document.changes())
        text += (text.empty() ? "; it does not include these edits: " : ", ") + change;
    return text;
}
