#pragma once

#include "scene_options.h"

#include <candela/scene.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

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

/// The camera of the pictures: the eye of the options, a camera of the scene, or a view that frames the scene
/// and the whole motion in it.
class CameraSelection {
  public:
    /// `scene` has to outlive it. `box` gives what `framedBox` does, and is only asked when it is needed.
    /// Throws `candela::Error` (badInput) that lists the scene's cameras where none has the name or number of
    /// the options.
    CameraSelection(const candela::Scene& scene, const SceneOptions& options,
                    const std::function<candela::Bounds()>& box);

    /// The view at `time` (seconds); a camera may be on an animated node.
    candela::CameraView at(double time) const;

  private:
    const candela::Scene& scene_;
    std::optional<float> verticalFov_;
    std::optional<candela::CameraView> fixed_;
    std::uint32_t camera_ = 0;
};
