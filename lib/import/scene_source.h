#pragma once

#include <candela/plugin_registry.h>

#include <filesystem>
#include <optional>
#include <string>

namespace candela {

/// Where a scene comes from, and who reads it.
struct SceneSource {
    const candela_plugin* plugin = nullptr;
    std::filesystem::path folder;  ///< The scene file's folder; empty for a procedural scene.
    std::string name;  ///< The file's name in its folder; for a procedural scene what follows "scheme:".
    std::optional<std::string> query;  ///< What follows the '?' behind a file's name.
};

/// Finds what `uri` means. A file of that very name wins over a scheme, and a single letter before a colon is
/// no scheme. Where there is no file of that name, but the name holds a '?', and there is a file of the name
/// before the last one, then it means this file, with a query. A file that is itself a symbolic link counts
/// as lying where the link leads. Throws `Error`: environment when there is no such file, badInput when it is
/// no regular file, unsupported when no plugin takes it, or takes no query.
SceneSource findSource(const PluginRegistry& plugins, const std::string& uri);

}  // namespace candela
