#pragma once

#include <candela/plugin_registry.h>

#include <filesystem>
#include <string>

namespace candela {

/// Where a scene comes from, and who reads it.
struct SceneSource {
    const candela_plugin* plugin = nullptr;
    std::filesystem::path folder;  ///< The scene file's folder; empty for a made scene.
    std::string name;  ///< The file's name in its folder; for a made scene what follows "scheme:".
};

/// Finds what `uri` means. A file of that very name wins over a scheme, and a single letter before a colon is
/// no scheme. A file that is itself a symbolic link counts as lying where the link leads. Throws `Error`:
/// environment when there is no such file, badInput when it is no regular file, unsupported when no plugin
/// takes it.
SceneSource findSource(const PluginRegistry& plugins, const std::string& uri);

}  // namespace candela
