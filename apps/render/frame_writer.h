#pragma once

#include "options.h"

#include <candela/color.h>
#include <candela/exposure.h>
#include <candela/gpu_scene.h>
#include <candela/renderer.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

/// The settings of a frame at the size of the options.
candela::FrameSettings frameSettings(const Options& options);

/// What one drawing of a frame took.
struct FrameTiming {
    double milliseconds = 0.0;  ///< Wall clock, up to the finished picture in memory.
    std::vector<candela::PassTime> passes;
};

/// Draws frames and writes them in the format that the options ask for.
class FrameWriter {
  public:
    /// All have to outlive it. `display` is set for a PNG.
    FrameWriter(candela::Renderer& renderer, candela::GpuScene& scene, const candela::ColorConfig& color,
                const std::optional<candela::DisplayTransform>& display, const Options& options);

    FrameTiming draw(const candela::CameraView& view);
    /// The frame drawn last; `draw` comes first.
    const candela::Frame& frame() const { return *frame_; }
    /// What a user should know of the frame drawn last. For an EXR, which takes no exposure, all that is lit
    /// counts as over black and nothing as over white.
    candela::ExposureCounts exposureCounts() const;
    /// Writes the frame drawn last; the file is whole or absent.
    void write(const std::filesystem::path& path);

  private:
    candela::Renderer& renderer_;
    candela::GpuScene& scene_;
    const candela::ColorConfig& color_;
    const std::optional<candela::DisplayTransform>& display_;
    const Options& options_;
    std::optional<candela::Frame> frame_;
    std::vector<std::uint8_t> pixels_;
};
