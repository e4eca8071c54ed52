#pragma once

#include "sampling_options.h"

#include <candela/brdf.h>
#include <candela/color.h>
#include <candela/gpu_scene.h>
#include <candela/import.h>
#include <candela/renderer.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// A camera position: metres, in the space of the scene's file.
struct EyeOptions {
    glm::dvec3 eye{0.0}, target{0.0};
};

/// --default-lights: whether lights are added that move with the camera.
enum class DefaultLights {
    automatic,  ///< Where the scene has neither light of its own nor an environment.
    on,
    off,
};

/// The word on the command line: "auto", "on", "off".
const char* toString(DefaultLights option);

/// --environment: what surrounds the scene. That of a file, or "studio" or "sky", replaces the scene's own.
struct EnvironmentOption {
    enum class Source { own, none, studio, sky, file };
    Source source = Source::own;  ///< The scene's own: the default.
    std::string file;             ///< Of Source::file.
    double degrees = 0.0;         ///< The rotation about +Y, counter-clockwise from above.
    double stops = 0.0;           ///< How much brighter: each doubles the light.
};

/// --show: a debug view, and overlays.
struct DebugViewOptions {
    candela::DebugView view = candela::DebugView::none;
    candela::Overlays overlays;

    bool isDefault() const {
        return view == candela::DebugView::none && !overlays.wireframe && !overlays.cage;
    }
};

/// The options that determine the picture, shared by candela-render and candela-view. Checked as far as
/// possible without a file or a device.
struct SceneOptions {
    std::string scene;
    candela::Strictness strictness = candela::Strictness::tolerant;
    std::optional<std::string> lights;  ///< A file whose lights replace those of the scene.
    std::optional<candela::LightScatter> scatter;
    std::vector<std::filesystem::path> pluginFolders;
    double time = 0.0;                     ///< Seconds.
    std::optional<std::string> animation;  ///< Name, index, "all" or "none"; none: the first one.
    std::optional<std::string> variant;    ///< Name or index; none: without a variant.
    bool repeatAnimations = false;         ///< After their last key, instead of holding the last pose.

    int width = 1280, height = 720;     ///< Pixels.
    std::optional<std::string> camera;  ///< Name or index.
    std::optional<EyeOptions> eye;
    std::optional<float> verticalFov;         ///< Radians.
    std::optional<float> orthographicHeight;  ///< Metres: an orthographic view.
    SamplingOptions sampling;

    DefaultLights defaultLights = DefaultLights::automatic;
    EnvironmentOption environment;
    std::uint32_t environmentRays =
        candela::FrameSettings{}.environmentOcclusion.rays;  ///< A pixel and sample.
    std::optional<bool> background;  ///< Whether the environment is seen; none: as `Environment` has it.
    candela::BrdfModel brdf = candela::BrdfModel::course;
    candela::Technique technique = candela::Technique::automatic;
    candela::TileBackend tileBackend = candela::TileBackend::automatic;
    candela::Shadows shadows = candela::FrameSettings{}.shadows;
    bool specularAntialiasing = candela::FrameSettings{}.specularAntialiasing;
    std::uint32_t layers = candela::FrameSettings{}.layers;
    float pointSize = candela::FrameSettings{}.pointSize;  ///< Pixels.
    float lineWidth = candela::FrameSettings{}.lineWidth;  ///< Pixels.
    float rangeLoss = candela::GpuSceneOptions{}.rangeLoss;
    candela::SubdivisionSettings subdivision;
    candela::VertexEvaluator vertexEvaluator = candela::VertexEvaluator::automatic;
    DebugViewOptions debug;

    std::optional<std::string> ocio;
    candela::DisplayOptions display;
    bool autoExposure = false;  ///< The exposure of `display` is to be measured.

    unsigned threads = 0;  ///< As `candela::setThreadCount` takes it.
};

/// Declares the options of a `SceneOptions` and fills it while the command line is parsed; `finish` checks
/// options that depend on each other.
class SceneOptionReader {
  public:
    /// `app` and `options` have to outlive it. `defaultSamples` is told in --help.
    SceneOptionReader(CLI::App& app, SceneOptions& options, std::uint32_t defaultSamples);

    /// Call after parsing. Throws `UsageError`.
    void finish();

  private:
    void declareScene(CLI::App& app);
    void declarePicture(CLI::App& app);
    void declareCamera(CLI::App& app);
    void declareLighting(CLI::App& app);
    void declareSubdivision(CLI::App& app);
    void declareColor(CLI::App& app);
    void declareThreads(CLI::App& app);

    const CLI::App& app_;
    SceneOptions& options_;
    std::optional<std::string> eye_, target_;
};

/// Readers of option values as in parse.h.
candela::LightScatter parseScatter(const std::string& text);
DefaultLights parseDefaultLights(const std::string& text);
DebugViewOptions parseDebugView(const std::string& text);
/// The lit picture and all debug views.
std::vector<candela::DebugView> selectableViews();
