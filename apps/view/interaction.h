#pragma once

#include "view_model.h"

#include <candela/camera.h>
#include <candela/scene.h>

#include <cstdint>

/// Whether the camera moves.
enum class Motion { rests, moves };

/// Reads the pointer and the keys of this ImGui frame, where no panel takes them, and moves the camera.
/// `pixelRatio` is the framebuffer's pixels for a unit of ImGui. To be called after the panels are drawn.
Motion interact(ViewModel& model, float pixelRatio);

/// The view that the options select, as in candela-render. `model.document` has to exist.
candela::CameraView selectedView(const ViewModel& model);
/// The same at another time, that of `poseTime`.
candela::CameraView selectedView(const ViewModel& model, double time);

/// Sets the interactive camera from the options.
void loadCamera(ViewModel& model);

/// Moves the interactive camera to `view`, which the options select: it depends on the time and on the aspect
/// ratio of the window.
void followView(ViewModel& model, const candela::CameraView& view);

/// Writes the interactive camera into the options.
void storeCamera(ViewModel& model);
/// Writes its lens into the options: the field of view, or the height of an orthographic view.
void storeLens(ViewModel& model);

/// Looks through camera `index` of the scene.
void selectSceneCamera(ViewModel& model, std::uint32_t index);

/// Moves the interactive camera until a box is in view.
void frameBox(ViewModel& model, const candela::Bounds& box);
