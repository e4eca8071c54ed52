#include "frame_writer.h"

#include "common/output_file.h"

#include <chrono>

candela::FrameSettings frameSettings(const Options& options) {
    candela::FrameSettings settings;
    settings.width = options.width;
    settings.height = options.height;
    settings.brdf = options.brdf;
    settings.technique = options.technique;
    settings.tileBackend = options.tileBackend;
    settings.shadows = options.shadows;
    settings.debugView = options.debug.view;
    settings.overlays = options.debug.overlays;
    settings.ambientOcclusion = options.ambientOcclusion;
    return settings;
}

FrameWriter::FrameWriter(candela::Renderer& renderer, candela::GpuScene& scene,
                         const candela::ColorConfig& color,
                         const std::optional<candela::DisplayTransform>& display, const Options& options)
    : renderer_(renderer), scene_(scene), color_(color), display_(display), options_(options) {}

FrameTiming FrameWriter::draw(const candela::CameraView& view) {
    const auto start = std::chrono::steady_clock::now();
    frame_.emplace(renderer_.render(scene_, view, frameSettings(options_)));
    if (display_) pixels_ = frame_->displayPicture(*display_);
    FrameTiming timing;
    timing.passes = frame_->passTimes();  // waits for the frame to end
    timing.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return timing;
}

candela::ExposureCounts FrameWriter::exposureCounts() const {
    candela::ExposureCounts counts = candela::countExposure(frame_->radiance(), color_.luminanceWeights(),
                                                            display_ ? display_->options().exposure : 0.0);
    if (display_) return counts;
    counts.overBlack = counts.lit;
    counts.overWhite = 0;
    return counts;
}

void FrameWriter::write(const std::filesystem::path& path) {
    if (display_)
        writeDisplayedFrame(path, options_.width, options_.height, pixels_, *display_);
    else
        writeRadiance(path, *frame_, options_.aovs, color_);
}
