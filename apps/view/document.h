#pragma once

#include "common/scene_environment.h"
#include "common/scene_options.h"
#include "edit_history.h"
#include "light_values.h"

#include <candela/gpu_scene.h>
#include <candela/import.h>
#include <candela/scene.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The open scene: as values, on the device, and with what was changed of it in the window. What the panels
/// show and edit; every change reaches the device at once.
class Document {
  public:
    /// Uploads. The last `scatteredLights` lights of `imported` are those of --scatter-lights. Throws
    /// `candela::Error`.
    Document(candela::ImportedScene imported, const candela::Context& context,
             const candela::GpuSceneOptions& options, std::size_t scatteredLights);

    /// With the environment that is shown.
    const candela::Scene& scene() const { return scene_; }
    /// Grows with everything that changes the picture.
    std::uint64_t revision() const { return revision_; }
    const std::vector<candela::ImportNote>& notes() const { return notes_; }
    candela::GpuScene& gpuScene() { return gpuScene_; }

    /// The scene on the device once more, as it is shown now: for another working space or other shaders.
    /// Throws `candela::Error`.
    candela::GpuScene upload(const candela::Context& context, const candela::GpuSceneOptions& options) const;
    /// The same with a variant of the scene, or none, that is not shown.
    candela::GpuScene uploadVariant(std::optional<std::uint32_t> variant, const candela::Context& context,
                                    const candela::GpuSceneOptions& options) const;
    /// Shows the result of `upload`.
    void adopt(candela::GpuScene uploaded);

    /// Shows the variant that `variant` names, as --variant does; none without it. Throws `candela::Error`
    /// and changes nothing where there is no such variant.
    void setVariant(const std::optional<std::string>& variant, const candela::Context& context,
                    const candela::GpuSceneOptions& options);

    /// Poses the scene (and moves the lights, if they move) as at `seconds`.
    void setTime(double seconds);
    double time() const { return time_; }
    bool animated() const;
    /// Lets the animations of these indices play, and no other.
    void playAnimations(const std::vector<std::uint32_t>& animations);

    /// Animations do not change the material any more.
    void setMaterial(std::uint32_t index, const candela::Material& material);
    void setVisibility(std::uint32_t node, candela::GpuScene::Visibility visibility);
    candela::GpuScene::Visibility visibility(std::uint32_t node) const { return visibility_[node]; }

    /// Replaces a node's local matrix, which moves the node and all below it; lights only while none was
    /// edited. Animations of its translation, rotation and scale end.
    void setTransform(std::uint32_t node, const glm::mat4& local);

    /// The lights in world space as they are shown now.
    const std::vector<candela::WorldLight>& lights() const { return shownLights_; }
    /// Replaces light `index` at its rest position. Throws `candela::Error` and leaves it when it is no
    /// light.
    void setLight(std::uint32_t index, const candela::WorldLight& light);
    void addLight(const candela::WorldLight& light);
    void removeLight(std::uint32_t index);
    /// Takes away the lights of an earlier call (or of --scatter-lights) and scatters others. Throws
    /// `candela::Error` and leaves the lights when there is nothing to scatter them over.
    void scatterLights(const candela::LightScatter& options);
    /// Adds the default lights of a view, scaled to an exposure (stops), behind all others; none takes them
    /// away. They are not among `lights`.
    struct DefaultLighting {
        candela::CameraView view;
        double exposure = 0.0;
    };
    void setDefaultLighting(const std::optional<DefaultLighting>& lighting);
    /// Shows the environment of the options: reads it where it is another one, and turns, brightens or shows
    /// it otherwise. Its sun is not among `lights`. Returns notes on what was read. Throws `candela::Error`
    /// and changes nothing when it can not be read.
    std::vector<std::string> setEnvironment(const SceneOptions& options);
    /// The same with the environment of a file that is read by now: what `loadEnvironment` has returned for
    /// the options, whose notes are left to the caller.
    void setEnvironment(const SceneOptions& options, EnvironmentLight loaded);
    /// Keeps the environments of files that are read from now on, so that several can take turns, until
    /// `forgetEnvironmentFiles`.
    void keepEnvironmentFiles();
    void forgetEnvironmentFiles() { keptFiles_.reset(); }
    /// What `setEnvironment` was given last.
    const EnvironmentOption& environmentOption() const { return shownEnvironment_.option; }
    void setLightMotion(const LightMotion& motion);
    const LightMotion& lightMotion() const { return motion_; }
    /// Remembers that a file has the lights as they are shown now.
    void keepSavedLights(const std::string& file);
    /// That file, while they are shown as they were then.
    std::optional<std::string> fileOfLights() const;

    /// All edits above, but the environment and default lights, which follow the options.
    EditHistory& history() { return history_; }
    /// Takes the last step back, or does it again; its changes of options go to `options`. Nothing without
    /// such a step. An animation that the edit of a material has ended stays ended.
    void undo(SceneOptions& options);
    void redo(SceneOptions& options);

    /// The edits that no option of candela-render can express, a line each, such as "material 3 'brass'".
    std::vector<std::string> changes() const;

    /// The world-space box of what node `node` shows, its children included; of the whole scene without one.
    candela::Bounds bounds() const;
    candela::Bounds bounds(std::uint32_t node) const;
    /// What the automatic camera frames.
    const candela::Bounds& framedBox();

  private:
    struct Shown;

    candela::GpuScene uploaded(const candela::Scene& scene, const candela::Context& context,
                               const candela::GpuSceneOptions& options) const;
    void poseLights();
    void showLights();
    void showMaterial(std::uint32_t index, const candela::Material& material);
    void showNode(std::uint32_t node, candela::GpuScene::Visibility visibility);
    void placeNode(std::uint32_t node, const candela::Node& placed);
    void changeLights(LightsEdit edit);
    void replaceLights(std::size_t first, std::size_t count, const std::vector<candela::WorldLight>& lights);
    void uploadLights(candela::GpuScene& scene) const;
    void worldLights();
    EnvironmentLight environmentOf(const SceneOptions& options);
    EnvironmentLight readEnvironment(const SceneOptions& options);
    void placeEnvironment(const SceneOptions& options);

    candela::Scene scene_;
    std::optional<candela::Environment> ownEnvironment_;  ///< Of the file.
    std::vector<candela::ImportNote> notes_;
    candela::GpuScene gpuScene_;
    std::uint64_t revision_ = 0;
    double time_ = 0.0;
    std::vector<candela::GpuScene::Visibility> visibility_;
    std::vector<candela::WorldLight> restingLights_, shownLights_;
    std::vector<candela::WorldLight> defaultLights_;
    std::optional<candela::WorldLight> sun_;  ///< Of the environment.
    /// The environment that is shown.
    struct ShownEnvironment {
        EnvironmentOption option;
        std::optional<bool> background;
        EnvironmentLight loaded;  ///< Before it is turned and brightened, without its picture.
        bool isLoaded = false;
    } shownEnvironment_;
    std::optional<std::map<std::string, EnvironmentLight>> keptFiles_;  ///< By name; none: not kept.
    std::size_t ownLights_;       ///< Of the scene's lights, those that were not scattered.
    std::size_t firstScattered_;  ///< Of the resting lights.
    LightMotion motion_;
    struct SavedLights {
        std::string file;  ///< Empty: none.
        std::vector<candela::WorldLight> lights;
    } savedLights_;
    EditHistory history_;
    std::optional<candela::Bounds> framedBox_;  ///< Once it is asked for.
    std::vector<bool> changedMaterials_, movedNodes_;
    bool lightsTaken_ = false;    ///< The device has the lights that the window places, not the scene's own.
    bool lightsChanged_ = false;  ///< By the user: nodes no longer move them.
};
