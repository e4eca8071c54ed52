#pragma once

#include <candela/plugin_registry.h>

#include <filesystem>
#include <memory>

namespace candela {

/// A plugin that is loaded and whose description keeps the rules. The structs are the host's own copies of
/// this version's size; their strings and functions are the library's, which stays loaded as long as this
/// lives.
struct LoadedPlugin {
    std::shared_ptr<void> library;
    candela_plugin plugin{};
    candela_importer importer{};      ///< Of use where `plugin.importer` points to it.
    candela_subdivider subdivider{};  ///< Of use where `plugin.subdivider` points to it.
};

/// What came of one file.
struct PluginFile {
    PluginReport report;
    std::shared_ptr<const LoadedPlugin> loaded;  ///< Only when the report's state is `loaded`.
};

/// Loads one file and judges it; never throws for what is wrong with the file. `file` is absolute, so that
/// the dynamic loader does not search for it.
PluginFile openPluginFile(const std::filesystem::path& file);

}  // namespace candela
