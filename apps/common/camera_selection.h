#pragma once

#include "scene_options.h"

#include <candela/scene.h>

#include <cstdint>
#include <optional>

/// Where the pictures are taken from: the options' eye, a camera of the scene, or a view that frames the
/// scene as it stands at the first picture.
class CameraSelection {
  public:
    /// `scene` has to outlive it. Throws `candela::Error` (badInput) that lists the scene's cameras when
    /// there is none of the name or number asked for.
    CameraSelection(const candela::Scene& scene, const SceneOptions& options, double firstTime);

    /// The view at `time` (seconds); a camera may ride on an animated node.
    candela::CameraView at(double time) const;

  private:
    const candela::Scene& scene_;
    std::optional<float> verticalFov_;
    std::optional<candela::CameraView> fixed_;
    std::uint32_t camera_ = 0;
};
