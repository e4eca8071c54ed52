#pragma once

#include "options.h"
#include "picture_plan.h"
#include "run_report.h"

#include <candela/gpu_scene.h>
#include <candela/renderer.h>
#include <candela/sampling.h>
#include <candela/scene.h>

#include <glm/vec3.hpp>

#include <optional>
#include <vector>

/// Brings the scene on the device, and what lights it, to the time of a picture.
class Lighting {
  public:
    /// All have to outlive it. Notes on `report` that default lights are added.
    Lighting(RunReport& report, const Options& options, const candela::Scene& scene,
             candela::GpuScene& gpuScene);

    /// Brings the scene on the device to a time and, with default lights, to a view.
    void pose(double time, const candela::CameraView& view);
    /// Keeps where everything is, for the AOV `motion`.
    void keepPoses() { gpuScene_.keepPoses(); }

  private:
    const Options& options_;
    const candela::Scene& scene_;
    candela::GpuScene& gpuScene_;
    bool added_;
};

/// The samples of a picture.
class Samples {
  public:
    /// All have to outlive it.
    Samples(const Options& options, const candela::Scene& scene, Lighting& lighting, const PicturePlan& plan,
            const PlannedPicture& picture);

    /// Brings the scene to the time of a sample, and returns the view of the camera then.
    candela::CameraView view(std::uint32_t sample);
    /// For the AOV `motion`: lets the scene on the device keep the poses of the frame before, and returns the
    /// view of that. None where it is not asked for. Before any `view`.
    std::optional<candela::CameraView> keepFrameBefore();
    /// Whether the times of the samples differ.
    bool moves() const { return settings_.shutter > 0.0 && candela::isAnimated(scene_); }
    std::uint32_t count() const { return settings_.count; }

  private:
    const Options& options_;
    const candela::Scene& scene_;
    Lighting& lighting_;
    const PicturePlan& plan_;
    const PlannedPicture& picture_;
    candela::SamplingSettings settings_;
    double time_;
    std::optional<double> posed_;
    candela::CameraView view_;
};

/// The exposure that --exposure auto asks for, the same for every picture; 0 where nothing is lit. Notes it
/// on `report`. `luminanceWeights` are those of `candela::ColorConfig`.
double measureExposure(RunReport& report, const Options& options, candela::Renderer& renderer,
                       candela::GpuScene& gpuScene, Lighting& lighting, const PicturePlan& plan,
                       const std::vector<double>& times, const glm::vec3& luminanceWeights);
