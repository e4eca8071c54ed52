#pragma once

#include "environment_loader.h"
#include "examples.h"
#include "interaction.h"
#include "outline.h"
#include "scene_loader.h"
#include "shader_watch.h"
#include "thumbnails.h"
#include "view_model.h"
#include "view_options.h"
#include "viewport.h"
#include "window.h"

#include <candela/plugin_registry.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

/// candela-view: brings window, scene, picture and panels together.
class Application {
  public:
    /// Opens the window. Throws `candela::Error` and `UsageError`.
    explicit Application(const ViewOptions& options);
    Application(const Application&) = delete;
    Application& operator=(const Application&) = delete;
    ~Application();

    /// Until the window is closed or the program is interrupted, or a scripted run has ended. Throws
    /// `candela::Error` when a scripted run fails.
    void run();

    /// What `run` does again and again, once the events are handled: takes what was loaded, dropped and
    /// asked for, and draws the window.
    void step();

    /// Whether the window sleeps until an event: a `step` before it shows nothing new.
    bool isIdle() const { return sleep() == Window::Sleep::untilEvent; }
    /// Whether events wait for the next steps.
    bool hasPendingInput() const { return window_.hasPendingInput(); }

    /// All that the window shows, as its panels read and change it.
    ViewModel& model() { return model_; }

  private:
    using Clock = std::chrono::steady_clock;
    /// ImGui reacts to an event in the next frame, a window of a new size in the one after it.
    static constexpr int settlingFrames = 3;

    void listPlugins();
    void placePicture();
    void recordEdits();
    void outlinePicked();
    void open(const std::string& scene);
    void takeLoaded();
    void install(SceneLoader::Result loaded);
    void reportFailure(const std::string& text);
    void showVariant(const std::string& variant);
    void reloadShaders();
    void serveRequests();
    void serveReadings();
    void changeConfig(const std::optional<std::string>& config,
                      const candela::DisplayOptions& displayOptions);
    void changeDisplay();
    void chooseFirstColor();
    void writePicture(const std::filesystem::path& file);
    void finishScript();
    void copyCommand();
    void pick(const glm::ivec2& pixel);
    void advanceTime();
    void drawExamplePictures();
    void drawPicture(Motion motion);
    void drawWholePicture(const std::string& key);
    void drawLeftSide();
    /// Draws more of what rests: another sample, until the picture has as many as it should.
    void refine();
    void refinePicture();
    void refineLeftSide();
    void lightLeftSide(const SceneOptions& options, const candela::CameraView& view);
    void lightRightSide();
    bool isRefining() const;
    bool isRefiningPicture() const;
    bool isRefiningLeft() const;
    bool leftIsNext() const;
    bool showsLeftSide() const;
    Viewport& besideViewport();
    /// The column of the picture at the line of a comparison.
    int lineColumn() const;
    const Viewport& viewportAt(const glm::ivec2& pixel) const;
    void measureExposure();
    bool exposesScenes() const;
    void probePointer();
    candela::GpuSceneOptions uploadOptions(const candela::ColorConfig& color) const;
    std::uint32_t wantedFrames() const;
    Window::Sleep sleep() const;
    bool timeAdvances() const;
    bool ended() const;

    /// Runs `work`; what it throws becomes a message in the window.
    template <typename Work>
    void guarded(Work&& work) {
        try {
            work();
        } catch (const std::exception& error) {
            reportFailure(error.what());
        }
    }

    ViewOptions options_;
    std::filesystem::path settingsFolder_;
    ViewModel model_;
    Window window_;
    candela::Context context_;
    candela::PluginRegistry plugins_;
    Viewport viewport_;
    SceneLoader loader_;
    EnvironmentLoader environments_;
    ExamplePictures examples_;
    ThumbnailPictures thumbnails_;
    std::optional<Viewport> beside_;  ///< Of the left side of a comparison, or of thumbnails.
    std::optional<candela::DisplayTransform> leftDisplay_;
    bool hasLeftLight_ = false;  ///< The document is lighted for the left side.
    std::string drawnLeft_;      ///< What the left side shows: see `pictureKey`; empty: nothing.
    Outline outline_;
    ShaderWatch shaders_;
    std::optional<candela::DisplayTransform> display_;
    candela::DisplayOptions appliedDisplayOptions_;
    glm::ivec2 pictureSize_{1};  ///< That it has in the window, in pixels.
    std::string drawnPicture_;   ///< What the picture shows: see `pictureKey`.
    ResolutionScale resolutionScale_;
    Motion motion_ = Motion::rests;  ///< In the last step.
    int settling_ = 0;               ///< Frames left in which panels settle after something has happened.
    bool newDocument_ = false;       ///< No frame of it has been drawn yet.
    std::uint32_t drawnFrames_ = 0;
    Clock::time_point lastStep_ = Clock::now();
};
