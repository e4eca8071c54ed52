#include "frame_writer.h"

#include "common/output_file.h"

#include <chrono>

FrameWriter::FrameWriter(candela::Renderer& renderer, candela::GpuScene& scene,
                         const candela::ColorConfig& color,
                         const std::optional<candela::DisplayTransform>& display, const Options& options)
    : renderer_(renderer), scene_(scene), color_(color), display_(display), options_(options) {}

FrameTiming FrameWriter::draw(const candela::CameraView& view) {
    candela::FrameSettings settings;
    settings.width = options_.width;
    settings.height = options_.height;
    settings.brdf = options_.brdf;
    settings.technique = options_.technique;
    settings.tileBackend = options_.tileBackend;
    settings.debugView = options_.debug.view;
    settings.overlays = options_.debug.overlays;

    const auto start = std::chrono::steady_clock::now();
    frame_.emplace(renderer_.render(scene_, view, settings));
    if (display_) pixels_ = frame_->displayPicture(*display_);
    FrameTiming timing;
    timing.passes = frame_->passTimes();  // waits for the frame to end
    timing.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return timing;
}

void FrameWriter::write(const std::filesystem::path& path) {
    if (display_)
        writeDisplayedFrame(path, options_.width, options_.height, pixels_, *display_);
    else
        writeRadiance(path, *frame_, options_.aovs, color_);
}
