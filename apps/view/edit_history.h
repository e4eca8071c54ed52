#pragma once

#include "common/scene_options.h"
#include "light_values.h"

#include <candela/gpu_scene.h>
#include <candela/scene.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

// What a user has changed, with what was there before.

struct MaterialEdit {
    std::uint32_t material = 0;
    candela::Material before, after;
    bool changedBefore = false;  ///< An edit had changed it before.
};
struct VisibilityEdit {
    std::uint32_t node = 0;
    candela::GpuScene::Visibility before{}, after{};
};
/// Lights at their rest position: those from `first` on that were there, and those that are there instead.
struct LightsEdit {
    std::size_t first = 0;
    std::vector<candela::WorldLight> before, after;
    std::size_t scatteredBefore = 0, scatteredAfter = 0;  ///< The first light that was scattered.
    bool changedBefore = false, changedAfter = false;     ///< Whether an edit has changed lights.
};
/// The local transform of a node.
struct TransformEdit {
    std::uint32_t node = 0;
    candela::Node before;  ///< Only its transform counts.
    glm::mat4 after{1.0f};
    bool movedBefore = false;  ///< An edit had moved it before.
};
struct LightMotionEdit {
    LightMotion before, after;
};
/// All options but those that say what is looked at: scene, camera, time, size, animation and variant.
struct OptionsEdit {
    SceneOptions before, after;
};
using Edit =
    std::variant<MaterialEdit, VisibilityEdit, LightsEdit, TransformEdit, LightMotionEdit, OptionsEdit>;

/// The edits of a document as steps, each of which is undone and done again as a whole.
class EditHistory {
  public:
    using Step = std::vector<Edit>;

    /// Adds an edit to the step that is open, or begins one; what was undone can not be done again then. An
    /// edit of what the step's last edit has changed becomes one with it.
    void record(Edit edit);
    /// Records the change of the options since the last call, or since `rebase`.
    void watch(const SceneOptions& options);
    /// Takes the options as they are as unchanged.
    void rebase(const SceneOptions& options);
    /// What is recorded next is another step.
    void endStep() { open_ = false; }

    bool canUndo() const { return done_ > 0; }
    bool canRedo() const { return done_ < steps_.size(); }
    /// The step to be undone, from its last edit to its first: `canUndo` holds.
    const Step& undo();
    /// The step to be done again, from its first edit to its last: `canRedo` holds.
    const Step& redo();
    /// Forgets all steps.
    void clear();

  private:
    std::vector<Step> steps_;
    std::size_t done_ = 0;  ///< Of the steps, those that are not undone.
    bool open_ = false;
    SceneOptions watched_;
    std::string watchedText_;  ///< Empty before the first call.
};

/// Takes over the options that an `OptionsEdit` is about.
void takeEditedOptions(const SceneOptions& from, SceneOptions& to);
