#pragma once

#include "scene_options.h"

#include <candela/import.h>

#include <vector>

/// Gives the scene what the file of --lights has, which a plugin reads: its lights in place of the scene's
/// own, and its cameras. A camera takes the place of the one that `findCamera` finds by its name, others are
/// added. They stand as the file has them at 0 s, and animations of what they replace end. Nothing else of
/// the file is used, and the environment stays the one that the scene has without them. Nothing changes
/// without --lights.
///
/// Returns notes. Throws `candela::Error` that names the file, badInput too where it has no light.
std::vector<candela::ImportNote> takeLightFile(candela::Scene& scene, const candela::PluginRegistry& plugins,
                                               const SceneOptions& options);
