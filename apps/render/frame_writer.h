#pragma once

#include "options.h"
#include "picture_file.h"

#include <candela/accumulator.h>
#include <candela/color.h>
#include <candela/exposure.h>
#include <candela/gpu_scene.h>
#include <candela/picture_parts.h>
#include <candela/renderer.h>
#include <candela/sampling.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

/// The settings of a frame at the size of the options.
candela::FrameSettings frameSettings(const Options& options);

/// What one drawing of a frame took.
struct FrameTiming {
    double milliseconds = 0.0;  ///< Wall clock, up to the finished picture in memory.
    std::vector<candela::PassTime> passes;
};

/// What the samples of a picture are drawn of.
struct SampleSource {
    /// Brings the scene to the time of a sample and returns the view of the camera then.
    std::function<candela::CameraView(std::uint32_t sample)> viewOf;
    bool moves;                                            ///< Whether the times of the samples differ.
    std::optional<candela::CameraView> previousView = {};  ///< Of the frame before, for the AOV `motion`.
};

/// Draws pictures of one or more samples and reads them back in the form that the options' format needs.
class FrameWriter {
  public:
    /// All have to outlive it. `display` is set unless the format is EXR.
    FrameWriter(const candela::Context& context, candela::Renderer& renderer, candela::GpuScene& scene,
                const candela::ColorConfig& color, const std::optional<candela::DisplayTransform>& display,
                const Options& options);

    FrameTiming draw(const SampleSource& source);
    /// The frame drawn last, of the last sample; `draw` comes first.
    const candela::Frame& frame() const { return *frame_; }
    /// The view of the first sample, which is the picture's without lens and shutter.
    const candela::CameraView& view() const { return view_; }
    /// What a user should know of the picture drawn last; `picture` is what `take` returned of it. For an
    /// EXR, which takes no exposure, all that is lit counts as over black and nothing as over white.
    candela::ExposureCounts exposureCounts(const DrawnPicture& picture) const;
    /// The picture drawn last; once.
    DrawnPicture take();

  private:
    /// What a frame is of the picture: all of it, a part, or a face of a panorama.
    struct Piece {
        candela::FrameSettings settings;
        std::optional<candela::CameraView> view;  ///< None: the camera's.
    };
    void drawPiece(const SampleSource& source, const Piece& piece, FrameTiming& timing);
    void drawSamples(const SampleSource& source, const Piece& piece, FrameTiming& timing);
    void drawParts(const SampleSource& source, FrameTiming& timing);
    void drawPanorama(const SampleSource& source, FrameTiming& timing);
    candela::FrameSettings settings(const SampleSource& source) const;
    candela::HdrImage radiance() const;
    DrawnPicture takePiece();
    candela::ExposureCounts countsOf(const candela::HdrImage& radiance) const;
    void takeRadiance(DrawnPicture& picture) const;

    candela::Renderer& renderer_;
    candela::GpuScene& scene_;
    const candela::ColorConfig& color_;
    const std::optional<candela::DisplayTransform>& display_;
    const Options& options_;
    bool isSoftware_;
    std::uint32_t samples_;
    std::optional<candela::Accumulator> accumulator_;  ///< Of pictures with more than one sample.
    std::optional<candela::Frame> frame_;
    candela::CameraView view_;
    std::vector<std::uint8_t> pixels_;
    std::vector<candela::PicturePart> parts_;  ///< One where the picture is drawn as a whole.
    /// Of a picture of several frames, which is whole when the last one has been drawn.
    std::optional<DrawnPicture> whole_;
    candela::ExposureCounts counts_;             ///< Of its parts together.
    std::optional<candela::HdrImage> panorama_;  ///< Drawn last.
};
