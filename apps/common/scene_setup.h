#pragma once

#include "scene_options.h"

#include <candela/scene.h>

#include <string>

/// The bounds of the scene's meshes and cages, or of its point and spot lights where it has neither; may be
/// empty.
candela::Bounds sceneBounds(const candela::Scene& scene, double time);

/// Adds the lights of `scatter` within the scene's bounds at time 0, so that every frame of an animation has
/// the same ones. Throws `candela::Error` (badInput) that names `sceneName` when the scene has no bounds.
void addScatteredLights(candela::Scene& scene, const ScatterOptions& scatter, const std::string& sceneName);
