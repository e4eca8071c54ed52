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
    /// Where set, the lighting pass with only the first this many lights is measured too.
    std::optional<std::size_t> referenceLights;
};

/// Does `scene` name a scene of so many triangles: "triangles:N"?
bool isTriangles(const std::string& scene);

/// Loads the scene of the options with `lights` lights; without a number with 4096, or with the lights of the
/// file. Throws `candela::Error`.
BenchScene loadBenchScene(const candela::PluginRegistry& plugins, const BenchOptions& options,
                          std::optional<std::uint64_t> lights);
