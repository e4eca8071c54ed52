#pragma once

#include "bench_options.h"

#include <candela/plugin_registry.h>
#include <candela/scene.h>

#include <optional>
#include <string>
#include <vector>

/// A scene to measure.
struct BenchScene {
    std::string name;
    candela::Scene scene;
    std::vector<candela::WorldLight> lights;
    candela::CameraView view;
    /// Set where the cost of the lights after the first so many is asked for.
    std::optional<std::size_t> referenceLights;
};

/// The scene of the options with `lights` lights; with none given, a file's own. Throws `candela::Error`.
BenchScene loadBenchScene(const candela::PluginRegistry& plugins, const BenchOptions& options,
                          std::optional<std::uint64_t> lights);
