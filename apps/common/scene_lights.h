#pragma once

#include "scene_options.h"

#include <candela/camera.h>
#include <candela/exposure.h>
#include <candela/scene.h>

#include <optional>
#include <string>
#include <vector>

/// The bounds of the scene's meshes and cages, or of its point and spot lights where it has neither; may be
/// empty.
candela::Bounds sceneBounds(const candela::Scene& scene, double time);

/// Adds the lights of --scatter-lights. Throws `candela::Error` that names `sceneName`.
void addScatteredLights(candela::Scene& scene, const candela::LightScatter& scatter,
                        const std::string& sceneName);

/// Whether --default-lights lights the scene.
bool usesDefaultLights(const candela::Scene& scene, DefaultLights option);

/// The note on default lights that `auto` has added.
extern const char* const defaultLightsNote;

/// The scene's lights at `time` (seconds), and after them the default lights of a view, scaled to `exposure`
/// (stops).
std::vector<candela::WorldLight> lightsWithDefaults(const candela::Scene& scene, double time,
                                                    const candela::CameraView& view, double exposure);

/// Times, in seconds, at which --exposure auto measures: `time` where nothing moves, else some that are
/// evenly spread over the animations that play, so that each part of a sequence gets the same exposure.
std::vector<double> exposureTimes(const candela::Scene& scene, double time);

/// What is wrong with a picture as a user would say it, with the remedy, where nothing is in view, next to
/// nothing lit, or more than half over white.
std::optional<std::string> pictureNote(const candela::ExposureCounts& counts);
