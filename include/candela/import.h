#pragma once

#include <candela/export.h>
#include <candela/plugin_registry.h>
#include <candela/scene.h>

#include <functional>
#include <string>
#include <vector>

namespace candela {

struct ImportReport {
    std::string plugin;              ///< Name of the plugin that read the scene.
    std::vector<std::string> notes;  ///< What of the file is not drawn or not used, a line each.
};

struct ImportedScene {
    Scene scene;
    ImportReport report;
};

/// Called with the share done, 0 to 1; returning false cancels the import.
using ImportProgress = std::function<bool(double)>;

/// Reads a scene through the plugin that takes its scheme ("plaza:4096") or its file name ending
/// ("room.glb"). What comes back has passed `validate`. Throws `Error`: badInput or unsupported with the
/// file, the element and the reason; environment when the file can not be read; cancelled.
CANDELA_API ImportedScene importScene(const PluginRegistry& plugins, const std::string& uri,
                                      const ImportProgress& progress = {});

}  // namespace candela
