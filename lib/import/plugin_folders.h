#pragma once

#include <filesystem>
#include <vector>

namespace candela {

/// The folders of plugins, by source.
struct PluginFolders {
    std::vector<std::filesystem::path> given;        ///< By the caller; each has to exist.
    std::vector<std::filesystem::path> environment;  ///< Of CANDELA_PLUGIN_PATH; each has to exist.
    std::vector<std::filesystem::path> standard;     ///< Beside the library, and installed; may be absent.
};

/// The folders of this process, with those that the caller gives.
PluginFolders processPluginFolders(const std::vector<std::filesystem::path>& given);

/// The folders to search: absolute, in order, without duplicates, also by links.
/// Throws `Error` (environment) when one that has to exist does not or is not a folder.
std::vector<std::filesystem::path> searchOrder(const PluginFolders& folders);

/// The regular files of a folder whose names end in ".so", sorted by name. Throws `Error` (environment) when
/// the folder can not be read.
std::vector<std::filesystem::path> pluginFilesIn(const std::filesystem::path& folder);

}  // namespace candela
