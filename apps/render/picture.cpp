#include "picture.h"

#include "common/picture_file.h"

#include <chrono>

Painter::Painter(candela::Renderer& renderer, candela::GpuScene& scene, const candela::ColorConfig& color,
                 const std::optional<candela::DisplayTransform>& display, const Options& options)
    : renderer_(renderer), scene_(scene), color_(color), display_(display), options_(options) {}

FrameTiming Painter::draw(const candela::CameraView& view) {
    candela::FrameInputs inputs;
    inputs.width = options_.width;
    inputs.height = options_.height;
    inputs.view = view;
    inputs.brdf = options_.brdf;
    inputs.technique = options_.technique;
    inputs.show = options_.debug.view;
    inputs.overlays = options_.debug.overlays;

    const auto start = std::chrono::steady_clock::now();
    renderer_.render(scene_, inputs);
    if (display_) pixels_ = renderer_.displayPicture(*display_);
    FrameTiming timing;
    timing.passes = renderer_.passTimes();  // waits for the frame to end
    timing.milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return timing;
}

void Painter::write(const std::filesystem::path& path) {
    if (display_)
        writeShownPicture(path, options_.width, options_.height, pixels_, *display_);
    else
        writeRadiance(path, renderer_, scene_, options_.aovs, color_);
}
