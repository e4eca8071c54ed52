#pragma once

#include "options.h"

#include <candela/scene.h>

/// The box around the scene's meshes, or around its lights where it has no mesh; may be empty.
candela::Bounds sceneBox(const candela::Scene& scene, double time);

/// Adds the lights that --scatter-lights asks for, over the scene's box at `time`. Throws `candela::Error`
/// (badInput) when the scene has neither mesh nor light.
void addScatteredLights(candela::Scene& scene, const Options& options, double time);
