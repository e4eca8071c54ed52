#pragma once

#include "scene_options.h"

#include <candela/scene.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The animations that the options let play: those that `--animation` names, the first one without it. Throws
/// `candela::Error` (badInput) that lists the scene's animations where none has the name or number.
std::vector<std::uint32_t> selectedAnimations(const candela::Scene& scene, const SceneOptions& options);

/// Lets the selected animations of the scene play, and no other. Returns a note on those that the default
/// leaves out. Throws as `selectedAnimations`.
std::optional<std::string> selectAnimations(candela::Scene& scene, const SceneOptions& options);

/// Lets the animations of these indices play, and no other.
void playOnly(candela::Scene& scene, const std::vector<std::uint32_t>& animations);

/// An animation as lists and messages show it: 0 "Walk".
std::string animationLabel(const candela::Scene& scene, std::uint32_t index);

/// The variant that `text` names, by name or by number. None where the scene has no such variant.
std::optional<std::uint32_t> findVariant(const candela::Scene& scene, const std::string& text);

/// Gives the scene the variant that `variant` names; without one, none. Throws `candela::Error` (badInput)
/// for the file `path` that lists the scene's variants where none has the name or number.
void selectVariant(candela::Scene& scene, const std::optional<std::string>& variant, const std::string& path);

/// A variant as lists and messages show it: 0 "Red".
std::string variantLabel(const candela::Scene& scene, std::uint32_t index);

/// The last key of an animation, in seconds; 0 without any.
float lastKeyTime(const candela::Animation& animation);

/// The last key of the animations that play, or the end of the frame callback, in seconds; 0 without any.
double lastKeyTime(const candela::Scene& scene);

/// The time at which the scene is posed `seconds` after its start: the same where animations hold their last
/// pose, and from 0 to the last key where they repeat.
double poseTime(const candela::Scene& scene, const SceneOptions& options, double seconds);

/// The box that the automatic camera frames: `candela::framingBounds`, or the box around the point and spot
/// lights of a scene that shows nothing; may be empty.
candela::Bounds framedBox(const candela::Scene& scene);

/// The camera that `text` names: by the name of its node, its own name or its number in the file, in this
/// order. None where there is no such camera.
std::optional<std::uint32_t> findCamera(const candela::Scene& scene, const std::string& text);

/// A text by which `findCamera` finds camera `index`, or another camera where its node and itself have names
/// that others have too, and its number as well.
std::string cameraText(const candela::Scene& scene, std::uint32_t index);

/// A camera's name and that of its node, as lists and messages show them: "0 \"Camera\" of node \"Hero\"".
std::string cameraLabel(const candela::Scene& scene, std::uint32_t index);

/// What a user calls a camera: the name of its node, or its own, or its number in the file.
std::string cameraName(const candela::Scene& scene, std::uint32_t index);

/// The scene's cameras as messages list them, and which of them `wanted` was probably meant to be.
std::string listCameras(const candela::Scene& scene, const std::string& wanted);

/// The camera of the pictures: the eye of the options, a camera of the scene, or a view that frames the scene
/// and the whole motion in it.
class CameraSelection {
  public:
    /// `scene` has to outlive it. `box` gives what `framedBox` does, and is only asked when it is needed.
    /// Throws `candela::Error` (badInput) that lists the scene's cameras where none has the name or number of
    /// the options.
    CameraSelection(const candela::Scene& scene, const SceneOptions& options,
                    const std::function<candela::Bounds()>& box);

    /// Camera `index` of the scene, with the lens of the options.
    CameraSelection(const candela::Scene& scene, const SceneOptions& options, std::uint32_t index);

    /// The view at `time` (seconds); a camera may be animated, or on an animated node.
    candela::CameraView at(double time) const;

  private:
    void useLensOptions(candela::CameraView& view) const;

    const candela::Scene& scene_;
    std::optional<float> verticalFov_, orthographicHeight_;
    std::optional<candela::CameraView> fixed_;
    std::uint32_t camera_ = 0;
};
