#pragma once

#include <candela/plugin_registry.h>

#include <filesystem>
#include <optional>
#include <string>

namespace candela {

/// The source of a scene, and the plugin that reads it.
struct SceneSource {
    const candela_plugin* plugin = nullptr;
    std::filesystem::path folder;  ///< The scene file's folder; empty for a procedural scene.
    std::string name;  ///< The file's name in its folder; for a procedural scene the text after "scheme:".
    std::optional<std::string> query;  ///< The text after '?' in a file's name.
};

/// Finds the source of `uri`. A file of exactly this name has precedence over a scheme, and a single letter
/// before a colon is no scheme. Without a file of this name, what precedes the last '?' may be one, and the
/// rest is its query. The folder of a symbolic link is that of its target. Throws `Error`: environment when
/// there is no such file, badInput when it is no regular file, unsupported when no plugin takes it, or takes
/// no query.
SceneSource findSource(const PluginRegistry& plugins, const std::string& uri);

}  // namespace candela
