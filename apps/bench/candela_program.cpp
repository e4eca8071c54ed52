#include "common/shadow_stats.h"
#include "common/timing.h"
#include "gl_drawing.h"
#include "programs.h"

#include <optional>
#include <utility>
#include <vector>

namespace {

class CandelaProgram final : public Program {
  public:
    CandelaProgram(const candela::Context& context, const BenchScene& scene, const BenchOptions& options,
                   const CandelaDrawing& drawing)
        : clock_(context),
          renderer_(context),
          scene_(context, scene.scene),
          transform_(transformOf(options)),
          screen_(options.width, options.height),
          lights_(scene.lights) {
        scene_.setLights(scene.lights);
        view_ = scene.view;
        settings_ = {options.width, options.height, options.brdf, drawing.technique};
        settings_.tileBackend = drawing.tileBackend;
        settings_.shadows = drawing.shadows;
        settings_.environmentOcclusion.rays = options.environmentRays;
        sampling_.count = drawing.samples;
        if (drawing.samples > 1) accumulator_.emplace(context);
    }

    FrameTimes draw() override {
        clock_.start();
        const candela::Frame& frame = render();
        const candela::FrameTarget target{.framebuffer = screen_.framebuffer()};
        if (accumulator_)
            accumulator_->display(transform_, target);
        else
            frame.display(transform_, target);
        clock_.lap("frame");
        std::vector<candela::PassTime> passes = frame.passTimes();
        if (accumulator_)
            for (candela::PassTime& pass : accumulator_->passTimes()) passes.push_back(std::move(pass));
        return {clock_.times().frame, passes};
    }

    void count(Result& result) override {
        result.occlusion = shadowStats(*frame_, scene_, settings_.shadows);
        const candela::PairCounts pairs = frame_->countPairs();
        result.technique = candela::toString(frame_->technique());
        if (const auto backend = frame_->tileBackend()) result.tileBackend = candela::toString(*backend);
        result.pairsLit = pairs.pairsLit;
        result.pairsEvaluated = pairs.pairsEvaluated;
        result.lightsVisible = pairs.lightsVisible;
        result.lightsDropped = pairs.lightsDropped;
        result.lightListBytes = pairs.lightListBytes;
        result.triangles = scene_.triangleCount();
        result.picture = medianOf([&] {
            const candela::Frame& frame = render();
            if (accumulator_)
                accumulator_->displayPicture(transform_);
            else
                frame.displayPicture(transform_);
        });
        result.setLights = medianOf([&] {
            scene_.setLights(lights_);
            glFinish();
        });
    }

    std::vector<float> radiance() override {
        const candela::HdrImage radiance = accumulator_ ? accumulator_->radiance() : frame_->radiance();
        std::vector<float> rgb;
        rgb.reserve(radiance.rgba.size() / 4 * 3);
        for (std::size_t i = 0; i < radiance.rgba.size(); ++i) {
            if (i % 4 != 3) rgb.push_back(radiance.rgba[i]);
        }
        return rgb;
    }

  private:
    const candela::Frame& render() {
        if (!accumulator_) return frame_.emplace(renderer_.render(scene_, view_, settings_));
        accumulator_->reset();
        return frame_.emplace(
            accumulator_->addSamples(renderer_, scene_, view_, settings_, sampling_, 0, sampling_.count));
    }

    /// The median wall time in milliseconds of five runs of `work`, which has to wait for the device.
    template <typename Work>
    static double medianOf(Work&& work) {
        std::vector<double> times;
        for (int i = 0; i < 5; ++i) {
            times.push_back(measureMilliseconds(work));
        }
        return median(times);
    }

    static candela::DisplayTransform transformOf(const BenchOptions& options) {
        candela::DisplayOptions displayOptions;
        displayOptions.view = options.view.value_or("");
        return candela::ColorConfig::builtIn().displayTransform(displayOptions);
    }

    PassClock clock_;
    candela::Renderer renderer_;
    candela::GpuScene scene_;
    candela::DisplayTransform transform_;
    Screen screen_;
    std::vector<candela::WorldLight> lights_;
    candela::CameraView view_;
    candela::FrameSettings settings_;
    candela::SamplingSettings sampling_;
    std::optional<candela::Accumulator> accumulator_;  ///< Of more than one sample.
    std::optional<candela::Frame> frame_;              ///< Drawn last.
};

}  // namespace

std::unique_ptr<Program> makeCandelaProgram(const candela::Context& context, const BenchScene& scene,
                                            const BenchOptions& options, const CandelaDrawing& drawing) {
    return std::make_unique<CandelaProgram>(context, scene, options, drawing);
}
