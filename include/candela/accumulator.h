#pragma once

#include <candela/color.h>
#include <candela/context.h>
#include <candela/export.h>
#include <candela/frame_data.h>
#include <candela/frame_settings.h>
#include <candela/pending.h>
#include <candela/sampling.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

class Frame;
class GpuScene;
class Renderer;

/// How the samples of an AOV become one value.
enum class AovFilter {
    automatic,  ///< As the channel has it (`GBufferChannel::filter`).
    average,    ///< The mean of all samples, the background's zeros included.
    first,      ///< The value of the first sample, which lies in the middle of the pixel.
};

/// The name on the command line: "auto", "average", "first".
CANDELA_API const char* toString(AovFilter filter);

struct AccumulatorOptions {
    /// AOVs that are read of every frame that is added; names as `Frame::aovs` takes them.
    std::vector<std::string> aovs = {};
    AovFilter aovFilter = AovFilter::automatic;
};

/// The mean of frames: of the samples of a picture (candela/sampling.h). It can be shown after any frame, and
/// is finer after the next one. The mean is taken of scene-linear radiance. The sum stays on the device, or
/// in memory where lighting runs on the CPU; it is in single precision and in two levels of 256 frames each,
/// whose rounding is at most 3.1e-5 of the mean. Every function throws `Error` (environment) when the context
/// is not current on the calling thread, and (badInput) after a move.
class CANDELA_API Accumulator {
  public:
    /// Throws `Error` as `Frame::aovs` does of the options' names.
    explicit Accumulator(const Context& context, AccumulatorOptions options = {});
    Accumulator(Accumulator&&) noexcept;
    Accumulator& operator=(Accumulator&&) noexcept;
    ~Accumulator();

    /// Adds a frame. Throws `Error`: badInput when its size is another one than that of the frames before,
    /// it shows a debug view, it belongs to another context or its renderer has drawn another one since;
    /// limit after `maxSamples` frames.
    void add(const Frame& frame);
    /// Draws samples `first` to `end` (excluded) of a picture of `scene` from `view` and adds them: what
    /// `Renderer::render` with `sampleView`, and `add`, do for each, faster. What does not change between
    /// samples is done once, and on a software device a sample is drawn while the one before is lit. Returns
    /// the frame of the last one. The scene stays at its time. `settings.sample` is not read. Throws `Error`
    /// as these functions do, and badInput unless `first` is below `end`.
    Frame addSamples(Renderer& renderer, GpuScene& scene, const CameraView& view,
                     const FrameSettings& settings, const SamplingSettings& sampling, std::uint32_t first,
                     std::uint32_t end);
    /// Forgets all frames; the next one may have another size.
    void reset();

    /// The number of frames added.
    std::uint32_t count() const;

    // What follows throws `Error` (badInput) while no frame has been added.

    int width() const;
    int height() const;
    /// Shows the mean as `Frame::display` shows a frame.
    void display(const DisplayTransform& transform, const FrameTarget& target) const;
    /// Shows the mean and reads it back: 8-bit RGBA, rows from the top.
    std::vector<std::uint8_t> displayPicture(const DisplayTransform& transform) const;
    /// Reads the mean radiance back. A is the share of the samples in which a surface covers the pixel; RGB
    /// is associated with it, the background being black.
    HdrImage radiance() const;
    /// `displayPicture` and `radiance` without waiting for them, as those of `Frame`.
    PendingPicture readDisplayPicture(const DisplayTransform& transform) const;
    PendingRadiance readRadiance() const;
    /// The mean as a texture, "radiance", and as it is shown, "display", as `Frame::textures` and
    /// `Frame::displayTexture` hand them out. Their names and their content are valid until a frame is added
    /// or `reset`, that of "display" until the next call of a function that shows the mean.
    FrameTexture radianceTexture() const;
    FrameTexture displayTexture(const DisplayTransform& transform) const;
    /// The AOVs of the options, in their order.
    std::vector<Aov> aovs() const;
    /// How the samples of one of these have become one value, never `automatic`. Throws `Error` (badInput)
    /// when it is not among the options' AOVs.
    AovFilter filterOf(const std::string& aov) const;
    /// What the last `add`, and showing the mean since, took. Waits for them to end.
    std::vector<PassTime> passTimes() const;

  private:
    struct State;
    State& state() const;
    State& filled() const;

    std::shared_ptr<State> state_;
};

}  // namespace candela
