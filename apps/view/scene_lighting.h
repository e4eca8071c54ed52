#pragma once

#include "environment_loader.h"
#include "view_model.h"

#include <candela/camera.h>
#include <candela/renderer.h>

#include <functional>
#include <string>

/// Brings the environment of the options, and default lights, to a view: `model.document` is there. Throws
/// `candela::Error` when the environment can not be read; the options have the one before then.
void lightDocument(ViewModel& model, const candela::CameraView& view);

/// Brings the environment and default lights of other options to a view, which stay until the next call of
/// `lightDocument`. Throws `candela::Error` when the environment can not be read.
void lightDocumentAs(ViewModel& model, const SceneOptions& options, const candela::CameraView& view);

/// Runs `work` with the document lighted as `options` say for a view, and then as the options of the model
/// say again. Throws what `work` throws, and as `lightDocument`.
void withLighting(ViewModel& model, const SceneOptions& options, const candela::CameraView& view,
                  const std::function<void()>& work);

/// Asks for a file as environment if it is a picture of linear light by its ending. Returns whether it is.
bool takeAsEnvironment(ViewModel& model, const std::string& file);
/// Shows the environment that `loader` has read, if any, and lets the options name it. Throws
/// `candela::Error` when it could not be read.
void takeEnvironment(ViewModel& model, EnvironmentLoader& loader);

/// Sets the exposure at which the median of what is lit in a frame is mid-grey.
void measureExposure(ViewModel& model, const candela::Frame& frame);

/// Tells what a user should know of the first frame of a scene: added lights, and a picture that shows
/// nothing.
void noteFirstPicture(ViewModel& model, const candela::Frame& frame);
