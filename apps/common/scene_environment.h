#pragma once

#include "scene_options.h"

#include <candela/environment.h>
#include <candela/scene.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What lights a scene from everywhere.
struct EnvironmentLight {
    std::optional<candela::Environment> environment;
    std::optional<candela::Light> sun;  ///< Taken out of the environment's picture.
    std::string name;                   ///< "studio", "sky", "scene" or a file; empty without an environment.
    std::vector<std::string> notes;     ///< What a user should know of it.
};

/// The environment of the options before it is turned and brightened: that of `EnvironmentOption::source`, or
/// by default the scene's own, or a studio where the scene has no light at all. Throws `candela::Error` that
/// names the file.
EnvironmentLight loadEnvironment(const candela::Scene& scene, const SceneOptions& options);

/// The same as the options turn, brighten and show it.
EnvironmentLight placedEnvironment(EnvironmentLight loaded, const SceneOptions& options);

/// "FILE.hdr|FILE.exr|studio|sky|none[,DEGREES[,STOPS]]" of --environment. Throws `UsageError`.
EnvironmentOption parseEnvironment(const std::string& text);
/// The text that `parseEnvironment` reads as `option`.
std::string toString(const EnvironmentOption& option);
/// "N" of --environment-rays. Throws `UsageError`.
std::uint32_t parseEnvironmentRays(const std::string& text);
/// Whether a file is a picture that --environment takes, by the ending of its name.
bool isEnvironmentFile(const std::string& file);
