#pragma once

#include <candela/plugin_registry.h>
#include <candela/subdivider.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace candela {

/// A loaded plugin with a valid description. The structs are the host's copies, of this version's size; their
/// strings and functions are the library's, which stays loaded as long as this lives.
struct LoadedPlugin {
    std::shared_ptr<void> library;
    candela_plugin plugin{};
    candela_importer importer{};           ///< Valid where `plugin.importer` points to it.
    candela_subdivider subdivider{};       ///< Valid where `plugin.subdivider` points to it.
    candela_image_decoder imageDecoder{};  ///< Valid where `plugin.image_decoder` points to it.
};

/// The result of loading one file.
struct PluginFile {
    PluginReport report;
    std::shared_ptr<const LoadedPlugin> loaded;  ///< Only when the report's state is `loaded`.
};

/// Loads one file. The report says what is wrong with it; nothing is thrown for that. `file` is absolute, so
/// that the dynamic loader does not search for it.
PluginFile openPluginFile(const std::filesystem::path& file);

/// Checks what a query function returned, reading no byte beyond the `struct_size` of each struct. Sets the
/// report's state and detail, and its other members as far as they could be read. With a valid description
/// the state is `loaded`, and `loaded` has the copies of the structs.
void checkDescription(const candela_plugin* description, LoadedPlugin& loaded, PluginReport& report);

/// The plugin behind a `Subdivider`, which it keeps loaded.
struct Subdivider::State {
    /// `loaded` offers a subdivider.
    explicit State(std::shared_ptr<const LoadedPlugin> loaded)
        : plugin(std::move(loaded)), name(plugin->plugin.name) {}

    std::shared_ptr<const LoadedPlugin> plugin;
    std::string name;
};

}  // namespace candela
