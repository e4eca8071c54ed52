#include "common/scene_selection.h"
#include "interaction.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace {

/// A drag over this many pixels crosses the distance to the target.
constexpr float pixelsToTarget = 500.0f;
/// What the list of cameras leaves for its label, in heights of a letter: their names need the rest.
constexpr float fromLetters = 4.2f;

/// Where the picture is taken from, in words.
std::string standpoint(const ViewModel& model) {
    const candela::Scene& scene = model.document->scene();
    if (model.options.eye) return "interactive";
    if (scene.cameras.empty()) return "frames the scene";
    return model.options.camera ? "camera " + *model.options.camera : "camera " + cameraLabel(scene, 0);
}

void chooseCamera(ViewModel& model) {
    const candela::Scene& scene = model.document->scene();
    ImGui::BeginDisabled(scene.cameras.empty());
    ImGui::SetNextItemWidth(-fromLetters * ImGui::GetFontSize());
    if (ImGui::BeginCombo("from", standpoint(model).c_str(), ImGuiComboFlags_HeightLargest)) {
        model.thumbnails.camerasShown = true;
        for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
            if (pictureRow(i, Row::plain, thumbnail(model.thumbnails.cameras, i), cameraLabel(scene, i)))
                tryTo(model, [&] { selectSceneCamera(model, i); });
        ImGui::EndCombo();
    }
    ImGui::EndDisabled();
}

/// Coordinates of a scene far from the origin of its file are small numbers too.
void tellOrigin(const candela::Scene& scene) {
    if (scene.origin == glm::dvec3(0.0)) return;
    const glm::dvec3& origin = scene.origin;
    ImGui::TextDisabled("relative to %.0f %.0f %.0f of the file", origin.x, origin.y, origin.z);
}

void editPlace(ViewModel& model) {
    tellOrigin(model.document->scene());
    glm::vec3 eye = model.camera.eye(), target = model.camera.target();
    const float speed = glm::distance(eye, target) / pixelsToTarget;
    bool changed = dragPoint("eye", eye, speed);
    changed = dragPoint("target", target, speed) || changed;
    if (!changed) return;
    tryTo(model, [&] {
        candela::lookAt(eye, target, model.camera.verticalFov());  // refuses an eye in its target
        model.camera.lookAt(eye, target);
        storeCamera(model);
    });
}

/// A camera of the file stays the one looked through, as --camera with --fov does.
void editFieldOfView(ViewModel& model) {
    float degrees = glm::degrees(model.camera.verticalFov());
    if (!slideNumber("field of view", degrees, {.min = 1.0f, .max = 175.0f, .format = "%.1f deg"})) return;
    model.camera.setVerticalFov(glm::radians(degrees));
    storeLens(model);
}

void editHeight(ViewModel& model) {
    float height = *model.camera.orthographicHeight();
    const float speed = height / pixelsToTarget;
    if (!dragNumber("height", height, {.min = 1e-6f, .max = 1e9f, .speed = speed, .format = "%.4g m"}))
        return;
    model.camera.setOrthographicHeight(height);
    storeLens(model);
}

/// Depth of field. It shows in the samples of a picture at rest.
void editAperture(ViewModel& model) {
    SamplingOptions& sampling = model.options.sampling;
    bool hasLens = sampling.fNumber.has_value();
    if (ImGui::Checkbox("depth of field", &hasLens)) {
        sampling.fNumber = hasLens ? std::optional(candela::Lens{}.fNumber) : std::nullopt;
        sampling.focusDistance = glm::distance(model.camera.eye(), model.camera.target());
    }
    if (!hasLens) return;
    slideNumber("f-number", *sampling.fNumber,
                {.min = 0.1f, .max = 32.0f, .format = "f/%.1f", .scale = NumberRange::Scale::logarithmic});
    const float speed = *sampling.focusDistance / pixelsToTarget;
    dragNumber("focus", *sampling.focusDistance,
               {.min = 1e-3f, .max = 1e6f, .speed = speed, .format = "%.4g m"});
    constexpr std::uint32_t mostBlades = 12;
    std::uint32_t blades = sampling.blades;
    if (slideLevel("blades", blades, 0, std::max(mostBlades, blades)))
        sampling.blades = blades == 0 ? 0 : std::max(blades, 3u);
}

void editLens(ViewModel& model) {
    bool orthographic = model.camera.orthographicHeight().has_value();
    if (ImGui::Checkbox("orthographic", &orthographic)) {
        model.camera.setOrthographicHeight(orthographic ? std::optional(model.camera.heightAtTarget())
                                                        : std::nullopt);
        storeLens(model);
    }
    if (orthographic) {
        editHeight(model);
    } else {
        editFieldOfView(model);
        editAperture(model);
    }
}

}  // namespace

void drawCameraPanel(ViewModel& model) {
    const PanelWindow window(model, Panel::camera, "Camera");
    if (!window || !model.document) return;
    chooseCamera(model);
    editPlace(model);
    editLens(model);
    if (ImGui::Button("Frame all")) model.requests.frameAll = true;
    ImGui::SameLine();
    ImGui::BeginDisabled(!model.pickedNode);
    if (ImGui::Button("Frame picked")) model.requests.framePicked = true;
    ImGui::EndDisabled();
}
