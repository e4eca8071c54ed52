#pragma once

#include "scene_options.h"

#include <candela/scene.h>

/// The box around the scene's meshes and cages, or around its lights where it has neither; may be empty.
candela::Bounds sceneBox(const candela::Scene& scene, double time);

/// Adds the lights of `choice` over the scene's box at time 0, so that every picture of an animation has the
/// same ones. Throws `candela::Error` (badInput) that names `sceneName` when the scene has neither mesh, cage
/// nor light.
void addScatteredLights(candela::Scene& scene, const ScatterOptions& choice, const std::string& sceneName);
