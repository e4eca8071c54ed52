#pragma once

#include "view_model.h"
#include "view_options.h"

#include <filesystem>
#include <string>
#include <vector>

/// Where the settings of a session survive it: $XDG_CONFIG_HOME/candela, or ~/.config/candela. Empty where
/// neither is known.
std::filesystem::path settingsFolder();

/// Reads view.json of the folder into the model: size of the window, open panels, colour, drawing, recent
/// scenes. What the command line gives stays. A file that can not be read or understood leaves a message in
/// the model, and the defaults.
void readSettings(const std::filesystem::path& folder, const ViewOptions& options, ViewModel& model);

/// Writes view.json, whole or not at all, making the folder where it is missing. Throws `candela::Error`.
void writeSettings(const std::filesystem::path& folder, const ViewModel& model);

/// Removes what earlier sessions left in the folder. Throws `candela::Error` (environment).
void forgetSettings(const std::filesystem::path& folder);

/// The file in which ImGui keeps where the panels lie; empty where there is no folder.
std::filesystem::path layoutFile(const std::filesystem::path& folder);

/// Puts an opened scene at the front of the scenes that the settings keep, 10 at most.
void rememberScene(std::vector<std::string>& recent, const std::string& scene);
