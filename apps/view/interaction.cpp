#include "interaction.h"

#include "common/scene_selection.h"
#include "comparison.h"
#include "gizmo.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace {

/// The distance of the orbit centre: that of the scene's centre along the view direction.
float targetDistance(const ViewModel& model, const candela::CameraView& view) {
    const candela::Bounds box = model.document->bounds();
    if (box.empty()) return 1.0f;
    const glm::vec3 toMiddle = 0.5f * (box.min + box.max) - view.eye();
    const float along = glm::dot(toMiddle, -glm::vec3(view.worldFromCamera[2]));
    return along > 0.0f ? along : 0.5f * glm::distance(box.min, box.max);
}

/// A press that moves the pointer less than this is a click, in units of ImGui.
constexpr float clickDistance = 3.0f;
/// Flying crosses the distance to the target in so many seconds; with shift five times as fast.
constexpr float secondsToTarget = 2.0f;
constexpr float shiftFactor = 5.0f;
/// Seconds that a step of the flight lasts at most: the window may have been idle before it.
constexpr float longestStep = 0.1f;

enum Button : int { left = 0, right = 1, middle = 2 };

/// In heights of the picture.
glm::vec2 dragged(const ViewModel& model, const ImGuiIO& io) {
    return glm::vec2(io.MouseDelta.x, io.MouseDelta.y) / std::max(model.layout.picture.size.y, 1.0f);
}

glm::vec3 flyingDirection() {
    const auto axis = [](int forwards, int backwards) {
        return static_cast<float>(ImGui::IsKeyDown(forwards)) -
               static_cast<float>(ImGui::IsKeyDown(backwards));
    };
    return {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q), axis(GLFW_KEY_S, GLFW_KEY_W)};
}

Motion fly(CameraControl& camera, const ImGuiIO& io) {
    const glm::vec3 direction = flyingDirection();
    if (direction == glm::vec3(0.0f)) return Motion::rests;
    const float speed = glm::distance(camera.eye(), camera.target()) / secondsToTarget;
    const float seconds = std::min(io.DeltaTime, longestStep);
    camera.fly(glm::normalize(direction), speed * seconds * (io.KeyShift ? shiftFactor : 1.0f));
    return Motion::moves;
}

/// Whether a button was pressed over the picture and is still down.
bool holds(const ImGuiIO& io, Button button) {
    return io.MouseDown[button] && !io.MouseDownOwned[button];
}

/// Whether the left button moves the camera, or something else.
enum class LeftButton { free, taken };

/// Moves the camera by the pressed buttons.
Motion moveCamera(ViewModel& model, const ImGuiIO& io, LeftButton leftButton) {
    CameraControl& camera = model.camera;
    const glm::vec2 drag = dragged(model, io);
    const bool dragging = drag != glm::vec2(0.0f);
    if (holds(io, right)) {
        if (dragging) camera.lookAround(drag);
        return fly(camera, io) == Motion::moves || dragging ? Motion::moves : Motion::rests;
    }
    if (!dragging) return Motion::rests;
    if (holds(io, middle) || (holds(io, left) && io.KeyShift)) {
        camera.pan(drag);
        return Motion::moves;
    }
    if (leftButton == LeftButton::taken || !holds(io, left) || !ImGui::IsMouseDragging(left, clickDistance))
        return Motion::rests;
    camera.orbit(drag);
    return Motion::moves;
}

std::optional<glm::ivec2> pixelUnder(const ViewModel& model, const ImGuiIO& io, float pixelRatio) {
    const glm::ivec2 inWindow(std::floor(io.MousePos.x * pixelRatio), std::floor(io.MousePos.y * pixelRatio));
    const glm::ivec2 pixel = inWindow - model.pictureCorner;
    const bool inside =
        pixel.x >= 0 && pixel.y >= 0 && pixel.x < model.options.width && pixel.y < model.options.height;
    return inside ? std::optional(pixel) : std::nullopt;
}

bool clicked(const ImGuiIO& io) {
    // A press that closes a menu belongs to the menu, with its release.
    return ImGui::IsMouseReleased(left) && !io.MouseDownOwned[left] &&
           io.MouseDragMaxDistanceSqr[left] < clickDistance * clickDistance;
}

/// Picks a light by its icon, or what the pixel shows.
void click(ViewModel& model) {
    const std::optional<std::uint32_t> light = lightUnderPointer(model);
    if (!light) {
        model.requests.pick = model.pointer;
        return;
    }
    model.pickedLight = light;
    model.pickedNode.reset();
}

/// The numbers of the shortest decimals that are read as these floats: 0.1 and not 0.10000000149.
glm::dvec3 shortDecimals(const glm::vec3& point) {
    glm::dvec3 numbers(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        std::array<char, 64> text;
        const auto end = std::to_chars(text.data(), text.data() + text.size(), point[axis]).ptr;
        std::from_chars(text.data(), end, numbers[axis]);
    }
    return numbers;
}

}  // namespace

candela::CameraView selectedView(const ViewModel& model, double time) {
    const CameraSelection selection(model.document->scene(), model.options,
                                    [&] { return model.document->framedBox(); });
    return selection.at(time);
}

candela::CameraView selectedView(const ViewModel& model) {
    return selectedView(model, poseTime(model.document->scene(), model.options, model.options.time));
}

void loadCamera(ViewModel& model) {
    if (model.options.eye) {
        const glm::dvec3& origin = model.document->scene().origin;
        model.camera.lookAt(glm::vec3(model.options.eye->eye - origin),
                            glm::vec3(model.options.eye->target - origin));
        model.camera.setVerticalFov(model.options.verticalFov.value_or(candela::CameraView().verticalFov));
        model.camera.setOrthographicHeight(model.options.orthographicHeight);
        return;
    }
    const candela::CameraView view = selectedView(model);
    model.camera.set(view, targetDistance(model, view));
}

void followView(ViewModel& model, const candela::CameraView& view) {
    if (model.options.eye) return;
    const bool frames = model.document->scene().cameras.empty();
    model.camera.set(view, frames ? targetDistance(model, view)
                                  : glm::distance(model.camera.eye(), model.camera.target()));
}

void storeCamera(ViewModel& model) {
    model.options.camera.reset();
    const glm::dvec3& origin = model.document->scene().origin;
    model.options.eye =
        EyeOptions{origin + shortDecimals(model.camera.eye()), origin + shortDecimals(model.camera.target())};
    storeLens(model);
}

void storeLens(ViewModel& model) {
    model.options.orthographicHeight = model.camera.orthographicHeight();
    model.options.verticalFov = model.camera.verticalFov();
    if (model.options.orthographicHeight) model.options.verticalFov.reset();
}

void selectSceneCamera(ViewModel& model, std::uint32_t index) {
    model.options.camera = cameraText(model.document->scene(), index);
    model.options.eye.reset();
    model.options.verticalFov.reset();
    model.options.orthographicHeight.reset();
    loadCamera(model);
}

void frameBox(ViewModel& model, const candela::Bounds& box) {
    if (box.empty()) return;
    model.camera.frame(box,
                       static_cast<float>(model.options.width) / static_cast<float>(model.options.height));
    storeCamera(model);
}

Motion interact(ViewModel& model, float pixelRatio) {
    const ImGuiIO& io = ImGui::GetIO();
    model.pointer.reset();
    if (!model.document) return Motion::rests;
    const bool dragsGizmo = driveGizmo(model), dragsLine = driveComparison(model);
    const LeftButton leftButton = dragsGizmo || dragsLine ? LeftButton::taken : LeftButton::free;
    drawGuides(model);
    if (io.WantCaptureMouse) return Motion::rests;
    model.pointer = pixelUnder(model, io, pixelRatio);
    if (clicked(io) && !model.gizmo.tookPress && !model.comparison.tookPress) click(model);
    Motion motion = moveCamera(model, io, leftButton);
    if (io.MouseWheel != 0.0f) {
        model.camera.dolly(io.MouseWheel);
        motion = Motion::moves;
    }
    if (motion == Motion::moves) storeCamera(model);
    return motion;
}
