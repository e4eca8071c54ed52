#include "scene_loader.h"

#include "common/light_file.h"
#include "common/scene_lights.h"
#include "common/scene_selection.h"

#include <candela/error.h>

#include <exception>
#include <mutex>
#include <utility>

namespace {

/// The window is woken when so much more of the scene has been read.
constexpr double shownStep = 0.005;

}  // namespace

void takeOptionsOfScene(const SceneOptions& from, SceneOptions& to) {
    to.scene = from.scene;
    to.camera = from.camera;
    to.eye = from.eye;
    to.verticalFov = from.verticalFov;
    to.orthographicHeight = from.orthographicHeight;
    to.lights = from.lights;
    to.scatter = from.scatter;
    to.animation = from.animation;
    to.variant = from.variant;
    to.time = from.time;
}

struct SceneLoader::Job {
    Job(const candela::PluginRegistry& registry, const SceneOptions& sceneOptions, void (*wakeUp)())
        : plugins(registry), options(sceneOptions), wake(wakeUp) {
        result.options = sceneOptions;
    }

    const candela::PluginRegistry plugins;
    const SceneOptions options;
    void (*const wake)();
    std::atomic<bool> cancelled{false};
    std::atomic<double> share{0.0};
    std::atomic<bool> ended{false};
    Result result;  ///< To be read once `ended` is set.

    bool goOn(double now) {
        if (now - share >= shownStep) {
            share = now;
            wake();
        }
        return !cancelled;
    }

    void read() {
        candela::ImportedScene imported = candela::importScene(
            plugins, options.scene, {options.strictness, [this](double now) { return goOn(now); }});
        for (candela::ImportNote& note : takeLightFile(imported.scene, plugins, options))
            imported.report.notes.push_back(std::move(note));
        if (const auto note = selectAnimations(imported.scene, options))
            imported.report.notes.push_back({candela::NoteKind::information, *note, {}, 1});
        selectVariant(imported.scene, options.variant, options.scene);
        if (options.scatter) addScatteredLights(imported.scene, *options.scatter, options.scene);
        result.scene = std::move(imported);
    }

    void run() {
        try {
            read();
        } catch (const std::exception& error) {
            if (!cancelled) result.error = error.what();
        }
        ended = true;
        wake();
    }
};

SceneLoader::~SceneLoader() {
    cancel();
    if (thread_.joinable()) thread_.join();
}

void SceneLoader::start(const candela::PluginRegistry& plugins, const SceneOptions& options, void (*wake)()) {
    cancel();
    if (thread_.joinable()) thread_.join();
    job_ = std::make_shared<Job>(plugins, options, wake);
    thread_ = std::thread([job = job_] { job->run(); });
}

void SceneLoader::cancel() {
    if (job_) job_->cancelled = true;
}

std::optional<LoadStatus> SceneLoader::status() const {
    if (!job_ || job_->cancelled) return std::nullopt;
    return LoadStatus{job_->options.scene, job_->share};
}

std::optional<SceneLoader::Result> SceneLoader::take() {
    if (!job_ || !job_->ended) return std::nullopt;
    thread_.join();
    Result result = std::move(job_->result);
    // It may have been read to its end before it heard of that.
    if (job_->cancelled) result = {result.options, std::nullopt, ""};
    job_.reset();
    return result;
}
