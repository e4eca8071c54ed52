#pragma once

#include "bench_options.h"

#include <candela/context.h>
#include <candela/plugin_registry.h>

#include <cstdint>
#include <string>

/// The measurements of a crowd of skinned meshes. Times are medians in milliseconds; compared variants are
/// measured alternately.
struct CrowdResult {
    std::string scene;
    std::uint64_t characters = 0, vertices = 0, joints = 0;  ///< Of all characters together.
    std::string evaluator;                                   ///< What has deformed them: "cpu" or "compute".
    unsigned threads = 0;                                    ///< Of the CPU.
    double pose = 0.0;    ///< From a new time to the matrices of all joints, and what else moves with them.
    double deform = 0.0;  ///< From there to deformed positions and normals in the buffers that draws read.
    double copy = 0.0;    ///< A memcpy of as many positions and normals on as many threads.

    /// How many copies a move takes.
    double ratio() const { return (pose + deform) / copy; }
};

/// Does `scene` name a crowd: "crowd:N"?
bool isCrowd(const std::string& scene);

/// --scene crowd:N. Throws `candela::Error` as the import, and when the scene has no skinned mesh.
CrowdResult measureCrowd(const candela::PluginRegistry& plugins, const candela::Context& context,
                         const BenchOptions& options);

/// {"renderer", "setup", "results": [one row]}.
std::string crowdResultJson(const std::string& renderer, const std::string& setup, const CrowdResult& result);
std::string crowdResultTable(const CrowdResult& result);
