#pragma once

#include "common/scene_options.h"

#include <candela/import.h>
#include <candela/plugin_registry.h>

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <thread>

/// How far a scene is read.
struct LoadStatus {
    std::string scene;
    double share = 0.0;  ///< 0 to 1.
};

/// Copies the options that are about one scene: its name, camera, time, animation, variant and scattered
/// lights.
void takeOptionsOfScene(const SceneOptions& from, SceneOptions& to);

/// Reads scenes on a thread of its own, one at a time.
class SceneLoader {
  public:
    SceneLoader() = default;
    SceneLoader(const SceneLoader&) = delete;
    SceneLoader& operator=(const SceneLoader&) = delete;
    /// Cancels and waits.
    ~SceneLoader();

    /// What came of it.
    struct Result {
        SceneOptions options;  ///< Those given to `start`.
        std::optional<candela::ImportedScene> scene;
        std::string error;  ///< Where there is no scene; empty when it was cancelled.
    };

    /// Begins to read `options.scene` (with the lights of --scatter-lights); what is being read is cancelled.
    /// `wake` is called from the thread when there is something new to show.
    void start(const candela::PluginRegistry& plugins, const SceneOptions& options, void (*wake)());
    void cancel();
    std::optional<LoadStatus> status() const;
    /// The result, once, when the reading has ended.
    std::optional<Result> take();

  private:
    struct Job;
    std::shared_ptr<Job> job_;
    std::thread thread_;
};
