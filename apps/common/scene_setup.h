#pragma once

#include "scene_options.h"

#include <candela/scene.h>

#include <cstdint>
#include <optional>
#include <string>

/// The bounds of the scene's meshes and cages, or of its point and spot lights where it has neither; may be
/// empty.
candela::Bounds sceneBounds(const candela::Scene& scene, double time);

/// Adds the lights of `scatter` within the scene's bounds at time 0, so that every frame of an animation has
/// the same ones. Throws `candela::Error` (badInput) that names `sceneName` when the scene has no bounds.
void addScatteredLights(candela::Scene& scene, const ScatterOptions& scatter, const std::string& sceneName);

/// The camera of the frames: the eye of the options, a camera of the scene, or a view that frames the scene
/// at the time of the first frame.
class CameraSelection {
  public:
    /// `scene` has to outlive it. Throws `candela::Error` (badInput) that lists the scene's cameras where
    /// none has the name or index of the options.
    CameraSelection(const candela::Scene& scene, const SceneOptions& options, double firstTime);

    /// The view at `time` (seconds); a camera may be on an animated node.
    candela::CameraView at(double time) const;

  private:
    const candela::Scene& scene_;
    std::optional<float> verticalFov_;
    std::optional<candela::CameraView> fixed_;
    std::uint32_t camera_ = 0;
};
