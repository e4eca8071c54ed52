#include "camera_options.h"

#include "common/scene_setup.h"

#include <glm/geometric.hpp>

namespace {

/// The distance of the point that the hand orbits: that of the scene's middle along the view's axis.
float targetDistance(const ViewModel& model, const candela::CameraView& view) {
    const candela::Bounds box = model.document->bounds();
    if (box.empty()) return 1.0f;
    const glm::vec3 toMiddle = 0.5f * (box.min + box.max) - view.eye();
    const float along = glm::dot(toMiddle, -glm::vec3(view.worldFromCamera[2]));
    return along > 0.0f ? along : 0.5f * glm::distance(box.min, box.max);
}

}  // namespace

candela::CameraView chosenView(const ViewModel& model) {
    return CameraSelection(model.document->scene(), model.options, model.options.time).at(model.options.time);
}

void takeCamera(ViewModel& model) {
    if (model.options.eye) {
        model.camera.lookAt(model.options.eye->eye, model.options.eye->target);
        model.camera.setVerticalFov(model.options.verticalFov.value_or(candela::CameraView().verticalFov));
        return;
    }
    const candela::CameraView view = chosenView(model);
    model.camera.set(view, targetDistance(model, view));
}

void followView(ViewModel& model, const candela::CameraView& view) {
    if (model.options.eye) return;
    const bool frames = model.document->scene().cameras.empty();
    model.camera.set(view, frames ? targetDistance(model, view)
                                  : glm::distance(model.camera.eye(), model.camera.target()));
}

void giveCamera(ViewModel& model) {
    model.options.camera.reset();
    model.options.eye = EyeOptions{model.camera.eye(), model.camera.target()};
    model.options.verticalFov = model.camera.verticalFov();
}

void chooseSceneCamera(ViewModel& model, std::uint32_t index) {
    model.options.camera = std::to_string(index);
    model.options.eye.reset();
    model.options.verticalFov.reset();
    takeCamera(model);
}

void frameBox(ViewModel& model, const candela::Bounds& box) {
    if (box.empty()) return;
    model.camera.frame(box,
                       static_cast<float>(model.options.width) / static_cast<float>(model.options.height));
    giveCamera(model);
}
