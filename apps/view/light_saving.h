#pragma once

#include "view_model.h"

#include <filesystem>
#include <string>

/// Writes the lights as they are shown, all edits included, and cameras, as a glTF file that --lights takes:
/// those of the scene that no animation moves, and that of the window, "candela-view", where it is neither a
/// camera of the scene nor one that frames it. The file is whole or not written. `model.document` has to
/// exist. Throws `candela::Error`; badInput where there is no light.
void saveLights(ViewModel& model, const std::filesystem::path& file);

/// `path`, with ".gltf" added unless it ends in .gltf or .glb.
std::string lightFileName(const std::string& path);

/// The options for candela-render: with --lights, where a file has the lights as they are shown. It then
/// draws them, and the environment and default lights that there are beside them.
SceneOptions optionsWithLights(const ViewModel& model);

/// Such as "; it does not include these edits: moved node 0"; empty without such edits.
std::string textOfOtherEdits(const Document& document);
