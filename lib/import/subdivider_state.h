#pragma once

#include "import/plugin_file.h"

#include <candela/subdivider.h>

#include <memory>
#include <string>
#include <utility>

namespace candela {

/// The plugin behind a `Subdivider`, which it keeps loaded.
struct Subdivider::State {
    /// `loaded` offers a subdivider.
    explicit State(std::shared_ptr<const LoadedPlugin> loaded)
        : plugin(std::move(loaded)), name(plugin->plugin.name) {}

    std::shared_ptr<const LoadedPlugin> plugin;
    std::string name;
};

}  // namespace candela
