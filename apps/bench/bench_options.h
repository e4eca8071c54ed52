#pragma once

#include "common/device_option.h"
#include "common/scene_options.h"

#include <candela/brdf.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Whether the textbook programs and the bare one are measured too.
enum class Baseline { without, with };

/// What is printed.
enum class TableFormat { plain, markdown };

/// The scene that measures a moving subdivision cage, and no lights.
constexpr const char* cageScene = "cages";

struct BenchOptions {
    std::string scene = "plaza";
    std::optional<std::string> variant;  ///< Of a file: name or index; none: without a variant.
    std::vector<std::uint64_t> lights;   ///< Empty: 4096, or the lights of a file.
    std::vector<candela::Technique> techniques{candela::Technique::automatic};
    bool compares = false;  ///< --technique all: pictures are compared and must agree.
    std::vector<candela::TileBackend> tileBackends{candela::TileBackend::automatic};
    /// `on` and `off` as given; `off` without --shadows.
    std::vector<candela::Shadows> shadows;
    std::vector<std::uint32_t> samples{1};  ///< A pixel; each measured.
    EnvironmentOption environment;          ///< `own` adds no studio to a scene without light.
    std::uint32_t environmentRays = candela::FrameSettings{}.environmentOcclusion.rays;
    candela::BrdfModel brdf = candela::BrdfModel::course;
    Baseline baseline = Baseline::without;
    bool measuresCeiling = false;
    TableFormat table = TableFormat::plain;
    int width = 1280, height = 720;
    int frames = 20;
    std::optional<std::string> view;  ///< Of the built-in config's default display.
    std::filesystem::path json;
    std::optional<std::filesystem::path> plot;
    std::vector<std::filesystem::path> pluginFolders;
    DeviceOption device;
    candela::VertexEvaluator vertexEvaluator = candela::VertexEvaluator::automatic;
    unsigned threads = 0;  ///< As `candela::setThreadCount` takes it.
    bool quiet = false;
};

/// None after --help or --version, which have been printed. Throws `UsageError`.
std::optional<BenchOptions> parseBenchOptions(int argc, const char* const* argv);
