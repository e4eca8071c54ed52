#pragma once

#include "view_model.h"

#include <candela/camera.h>
#include <candela/renderer.h>

/// Brings the default lights of the options to a view: `model.document` is there.
void lightDocument(ViewModel& model, const candela::CameraView& view);

/// Sets the exposure at which the median of what is lit in a frame is mid-grey.
void measureExposure(ViewModel& model, const candela::Frame& frame);

/// Tells what a user should know of the first frame of a scene: added lights, and a picture that shows
/// nothing.
void noteFirstPicture(ViewModel& model, const candela::Frame& frame);
