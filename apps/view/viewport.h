#pragma once

#include "common/scene_options.h"
#include "interaction.h"

#include <candela/accumulator.h>
#include <candela/camera.h>
#include <candela/color.h>
#include <candela/context.h>
#include <candela/renderer.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <chrono>
#include <cstdint>
#include <optional>

/// The image of the scene: drawn when it changes, copied to the window whenever that is redrawn.
class Viewport {
  public:
    explicit Viewport(const candela::Context& context);
    Viewport(const Viewport&) = delete;
    Viewport& operator=(const Viewport&) = delete;
    ~Viewport();

    struct Inputs {
        candela::GpuScene& scene;
        const SceneOptions& options;  ///< Its size is that of the frame.
        const candela::CameraView& view;
        const candela::DisplayTransform& display;
        int divisor = 1;  ///< Width and height are divided by it.
    };
    /// Draws a frame. Returns the milliseconds it took. Throws `candela::Error`.
    double draw(const Inputs& inputs);
    /// Draws sample `samples` of the picture that `draw` has begun at full size, of whose scene and settings
    /// `inputs` are, and shows the mean of all. Throws `candela::Error`.
    void refine(const Inputs& inputs);
    /// Draws a sample and adds it to `sum`. The picture that is shown stays.
    void addSample(const Inputs& inputs, std::uint32_t sample, candela::Accumulator& sum);
    const candela::Context& context() const { return context_; }
    /// The samples of the picture that is shown; 0 before the first frame.
    std::uint32_t samples() const { return samples_; }
    /// The mean of two or more samples; null where the picture has fewer.
    const candela::Accumulator* mean() const { return samples_ > 1 ? &*accumulator_ : nullptr; }
    /// The last frame, of one sample; null before the first one.
    const candela::Frame* frame() const { return frame_ ? &*frame_ : nullptr; }
    /// Copies the image to a rectangle of the window, whose framebuffer has `windowSize`. `corner` is its
    /// upper left pixel. Black around it; all black without a size, and before the first frame.
    void show(const glm::ivec2& windowSize, const glm::ivec2& corner, const glm::ivec2& size) const;

    /// Copies the columns of the image left of `column` over what `show` has shown at the same place.
    void showLeft(const glm::ivec2& windowSize, const glm::ivec2& corner, const glm::ivec2& size,
                  int column) const;

    /// The pixel of the frame that covers a pixel of the full size. Both count from the top.
    glm::ivec2 pixelAt(const glm::ivec2& pixel) const;
    /// Its display value, 0 to 1 each.
    glm::vec3 displayValue(const glm::ivec2& pixel) const;

    /// Recreates the renderer from the current shaders, and draws `inputs`, if given, with it. Throws
    /// `candela::Error` that has the compiler's message, and keeps the old renderer; the frame has to be
    /// drawn again then.
    void reloadShaders(const std::optional<Inputs>& inputs);

  private:
    candela::Frame render(candela::Renderer& renderer, const Inputs& inputs, std::uint32_t sample) const;
    candela::Frame draw(candela::Renderer& renderer, const Inputs& inputs);
    candela::FrameTarget target() const { return {.framebuffer = framebuffer_, .x = 0, .y = 0}; }
    void resize(const glm::ivec2& size);
    void copy(const glm::ivec2& windowSize, const glm::ivec2& corner, const glm::ivec2& size) const;

    const candela::Context& context_;
    candela::Renderer renderer_;
    unsigned texture_ = 0, framebuffer_ = 0;
    glm::ivec2 size_{0};
    glm::ivec2 fullSize_{1};
    std::optional<candela::Frame> frame_;
    std::optional<candela::Accumulator> accumulator_;  ///< Created when a picture rests.
    std::uint32_t samples_ = 0;
};

/// The divisor of the resolution: above 1 on a slow device while the camera moves, else 1.
class ResolutionScale {
  public:
    using Clock = std::chrono::steady_clock;

    /// The divisor of width and height of the next frame: 1, 2 or 4.
    int divisor(Motion motion, Clock::time_point now);
    /// Records the time of the last frame, drawn with the divisor returned last.
    void tookMilliseconds(double milliseconds) { fullMilliseconds_ = milliseconds * divisor_ * divisor_; }
    /// Whether the resolution is reduced, so that another frame is due when the camera stops.
    bool isReduced() const { return divisor_ > 1; }

  private:
    double fullMilliseconds_ = 0.0;  ///< Estimated time of a frame at full resolution.
    int divisor_ = 1;
    Clock::time_point lastMotion_{};
};
