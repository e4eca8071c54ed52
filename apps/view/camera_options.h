#pragma once

#include "view_model.h"

#include <candela/camera.h>

#include <glm/vec2.hpp>

/// The view that the options name, as candela-render takes it: `model.document` is there.
candela::CameraView chosenView(const ViewModel& model);

/// Puts the hand's camera where the options say.
void takeCamera(ViewModel& model);

/// Takes the hand's camera along to `view`, which the options name: it may have moved with the time or with
/// the window's shape.
void followView(ViewModel& model, const candela::CameraView& view);

/// Makes the options say where the hand's camera is.
void giveCamera(ViewModel& model);

/// Looks through camera `index` of the scene.
void chooseSceneCamera(ViewModel& model, std::uint32_t index);

/// Brings a box into the picture.
void frameBox(ViewModel& model, const candela::Bounds& box);
