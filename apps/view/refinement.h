#pragma once

#include "view_model.h"
#include "viewport.h"

#include <candela/color.h>

#include <cstdint>
#include <filesystem>

/// The samples a pixel that a picture at rest gets: one of a debug view.
std::uint32_t wantedSamples(const SceneOptions& options);

/// Draws the next sample of the picture that `viewport` has begun at full size, at the sample's time, after
/// which the scene returns to the time of the picture. `options` are those of the picture, which may differ
/// from the model's in what `takeComparedOptions` takes. `model.document` has to exist. Throws
/// `candela::Error`.
void drawSample(const ViewModel& model, const SceneOptions& options, Viewport& viewport,
                const candela::DisplayTransform& display);

/// Draws the picture at full size with all its samples, and writes it as PNG or EXR. `model.document` has to
/// exist. Throws `candela::Error`.
void writePicture(ViewModel& model, Viewport& viewport, const candela::DisplayTransform& display,
                  const std::filesystem::path& file);
