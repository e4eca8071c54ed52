#pragma once

#include "common/shadow_stats.h"
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

/// Takes the next rows of a picture, from the top.
using BandSink = std::function<void(DrawnPicture band)>;

/// What the frames of a picture have counted.
struct PictureCounters {
    /// Sums over the frames, margins of parts and overlaps of faces included; of `lightsVisible` and
    /// `lightListBytes` the largest.
    candela::PairCounts pairs;
    std::optional<ShadowStats> shadows;  ///< None without shadows.
};

/// Draws pictures of one or more samples and reads them back in the form that the options' format needs.
class FrameWriter {
  public:
    /// All have to outlive it. `display` is set unless the format is EXR.
    FrameWriter(const candela::Context& context, candela::Renderer& renderer, candela::GpuScene& scene,
                const candela::ColorConfig& color, const std::optional<candela::DisplayTransform>& display,
                const Options& options);

    /// Of a picture that is not drawn in parts; `take` returns it.
    FrameTiming draw(const SampleSource& source);
    /// Is the picture drawn in parts? Then memory does not hold it, and `drawBands` draws it.
    bool isParted() const { return parts_.size() > 1; }
    /// Hands rows of parts to `bands` as soon as they are drawn. The times are those of the drawing alone.
    FrameTiming drawBands(const SampleSource& source, const BandSink& bands);
    /// The frame drawn last, of the last sample; `draw` or `drawBands` comes first.
    const candela::Frame& frame() const { return *frame_; }
    /// The view of the first sample, which is the picture's without lens and shutter.
    const candela::CameraView& view() const { return view_; }
    /// Of the picture drawn last: the most layers of a frame, and all fragments beyond.
    const candela::LayerCounts& layerCounts() const { return layerCounts_; }
    /// Of the picture drawn last, for --stats. Counts what has not been counted yet.
    PictureCounters counters();
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
    void begin();
    bool isOfPieces() const { return options_.panorama || isParted(); }
    void addCounters();
    void drawPanorama(const SampleSource& source, FrameTiming& timing);
    candela::FrameSettings settings(const SampleSource& source) const;
    candela::HdrImage radiance() const;
    std::vector<candela::Aov> frameAovs() const;
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
    // Of the picture drawn last.
    candela::ExposureCounts exposure_;  ///< Of parts together.
    candela::LayerCounts layerCounts_;
    PictureCounters counters_;  ///< Of pieces together.
    std::optional<candela::HdrImage> panorama_;
    std::vector<candela::Aov> panoramaAovs_;
};
