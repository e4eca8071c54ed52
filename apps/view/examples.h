#pragma once

#include "scene_loader.h"
#include "view_model.h"
#include "viewport.h"

#include <candela/plugin_registry.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// The procedural scenes that are offered before a scene is open, of those whose scheme a plugin has.
std::vector<Example> exampleScenes(std::span<const std::string> schemes);

/// Draws the small pictures of examples, one after another: each is read on a thread of its own.
class ExamplePictures {
  public:
    ExamplePictures() = default;
    ExamplePictures(const ExamplePictures&) = delete;
    ExamplePictures& operator=(const ExamplePictures&) = delete;
    /// Waits for the thread. The context has to be current.
    ~ExamplePictures();

    struct Inputs {
        const candela::PluginRegistry& plugins;
        Viewport& viewport;  ///< Shows no scene.
        const candela::ColorConfig& color;
        const candela::DisplayTransform& display;
        const candela::GpuSceneOptions& upload;
        void (*wake)();  ///< Called from the thread when a scene is read.
    };
    /// Draws what is read by now into `examples` and begins with the next. Returns whether one was drawn.
    /// Without its picture an example stays that can not be drawn.
    bool advance(const Inputs& inputs, std::vector<Example>& examples);
    /// Reads nothing more.
    void stop() { loader_.cancel(); }

  private:
    void draw(const Inputs& inputs, SceneLoader::Result loaded, Example& example);

    SceneLoader loader_;
    std::size_t next_ = 0;  ///< The example that is read.
    bool reading_ = false;
    std::vector<unsigned> textures_;
};
