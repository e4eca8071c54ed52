#pragma once

#include <candela/plugin_registry.h>

namespace candela {

struct LoadedPlugin;

/// Checks what a query function returned, reading no byte beyond the `struct_size` of each struct. Sets the
/// report's state and detail, and the name, version and the rest as far as they could be read. When all is
/// well, `loaded` has the copies of the structs and the state is `loaded`.
void checkDescription(const candela_plugin* description, LoadedPlugin& loaded, PluginReport& report);

}  // namespace candela
