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
    std::vector<std::string> notes;  ///< Parts of the file that are not drawn or not used, one line each.
};

struct ImportedScene {
    Scene scene;
    ImportReport report;
};

/// Called with the fraction done, 0 to 1, on the thread that called `importScene`. Returning false cancels
/// the import; an exception reaches the caller of `importScene`.
using ImportProgress = std::function<bool(double)>;

/// Reads a scene through the plugin that takes its scheme ("plaza:4096") or its file name ending
/// ("room.glb"). The scene has passed `validate`. Throws `Error`: badInput or unsupported with the file, the
/// element and the reason, badInput for an empty URI; environment when the file cannot be read; cancelled.
CANDELA_API ImportedScene importScene(const PluginRegistry& plugins, const std::string& uri,
                                      const ImportProgress& progress = {});

}  // namespace candela
