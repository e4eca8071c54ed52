#include "interaction.h"

#include "camera_options.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace {

/// A press that moves the pointer less than this is a click, in units of ImGui.
constexpr float clickDistance = 3.0f;
/// Flying crosses the distance to the target in so many seconds; with shift five times as fast.
constexpr float secondsToTarget = 2.0f;
constexpr float haste = 5.0f;
/// Seconds that a step of the flight lasts at most: the window may have slept before it.
constexpr float longestStep = 0.1f;

enum Button : int { left = 0, right = 1, middle = 2 };

glm::vec2 dragged(const ImGuiIO& io) {
    return glm::vec2(io.MouseDelta.x, io.MouseDelta.y) / std::max(io.DisplaySize.y, 1.0f);
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
    camera.fly(glm::normalize(direction), speed * seconds * (io.KeyShift ? haste : 1.0f));
    return Motion::moves;
}

/// Moves the camera as the buttons say.
Motion moveCamera(CameraControl& camera, const ImGuiIO& io) {
    const glm::vec2 drag = dragged(io);
    const bool pulls = drag != glm::vec2(0.0f);
    if (ImGui::IsMouseDown(right)) {
        if (pulls) camera.turn(drag);
        return fly(camera, io) == Motion::moves || pulls ? Motion::moves : Motion::rests;
    }
    if (!pulls) return Motion::rests;
    if (ImGui::IsMouseDown(middle) || (ImGui::IsMouseDown(left) && io.KeyShift)) {
        camera.pan(drag);
        return Motion::moves;
    }
    if (!ImGui::IsMouseDragging(left, clickDistance)) return Motion::rests;
    camera.orbit(drag);
    return Motion::moves;
}

void readKeys(ViewModel& model, const ImGuiIO& io) {
    if (ImGui::IsKeyPressed(GLFW_KEY_F, false)) {
        model.requests.framePicked = io.KeyShift;
        model.requests.frameAll = !io.KeyShift;
    }
    if (ImGui::IsKeyPressed(GLFW_KEY_SPACE, false)) model.playing = !model.playing;
}

std::optional<glm::ivec2> pixelUnder(const ImGuiIO& io, float pixelRatio, const SceneOptions& options) {
    const glm::ivec2 pixel(std::floor(io.MousePos.x * pixelRatio), std::floor(io.MousePos.y * pixelRatio));
    const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < options.width && pixel.y < options.height;
    return inside ? std::optional(pixel) : std::nullopt;
}

bool clicked(const ImGuiIO& io) {
    return ImGui::IsMouseReleased(left) && io.MouseDragMaxDistanceSqr[left] < clickDistance * clickDistance;
}

}  // namespace

Motion interact(ViewModel& model, float pixelRatio) {
    const ImGuiIO& io = ImGui::GetIO();
    model.pointer.reset();
    if (!model.document) return Motion::rests;
    if (!io.WantCaptureKeyboard) readKeys(model, io);
    if (io.WantCaptureMouse) return Motion::rests;
    model.pointer = pixelUnder(io, pixelRatio, model.options);
    if (clicked(io)) model.requests.pick = model.pointer;
    Motion motion = moveCamera(model.camera, io);
    if (io.MouseWheel != 0.0f) {
        model.camera.dolly(io.MouseWheel);
        motion = Motion::moves;
    }
    if (motion == Motion::moves) giveCamera(model);
    return motion;
}
