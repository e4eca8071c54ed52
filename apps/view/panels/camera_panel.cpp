#include "common/camera_selection.h"
#include "interaction.h"
#include "panels/panel_values.h"
#include "panels/panels.h"
#include "panels/widgets.h"

#include <imgui.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>

namespace {

/// A drag over this many pixels crosses the distance to the target.
constexpr float pixelsToTarget = 500.0f;
/// The time slider's end where no animation gives one, in seconds.
constexpr double standardEnd = 10.0;

struct Kept {
    std::optional<double> lastKey;
};

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
    if (ImGui::BeginCombo("from", standpoint(model).c_str())) {
        for (std::uint32_t i = 0; i < scene.cameras.size(); ++i)
            if (listRow(i, Row::plain, cameraLabel(scene, i)))
                tryTo(model, [&] { selectSceneCamera(model, i); });
        ImGui::EndCombo();
    }
    ImGui::EndDisabled();
}

void editPlace(ViewModel& model) {
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
    model.options.verticalFov = model.camera.verticalFov();
}

void editTime(ViewModel& model, Kept& kept) {
    if (!kept.lastKey) kept.lastKey = lastKeyTime(model.document->scene());
    slideNumber("time", model.options.time, 0.0, *kept.lastKey > 0.0 ? *kept.lastKey : standardEnd, "%.3f s");
    ImGui::BeginDisabled(!model.document->animated() && !model.playing);
    if (ImGui::Button(model.playing ? "Pause" : "Play")) model.playing = !model.playing;
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (ImGui::Button("To the start")) model.options.time = 0.0;
}

}  // namespace

void drawCameraPanel(ViewModel& model) {
    const PanelWindow window(Panel::camera, "Camera", model.panels.camera);
    if (!window || !model.document) return;
    chooseCamera(model);
    editPlace(model);
    editFieldOfView(model);
    if (ImGui::Button("Frame all")) model.requests.frameAll = true;
    ImGui::SameLine();
    ImGui::BeginDisabled(!model.pickedNode);
    if (ImGui::Button("Frame picked")) model.requests.framePicked = true;
    ImGui::EndDisabled();
    ImGui::Separator();
    editTime(model, keptOfScene<Kept>(model));
}
