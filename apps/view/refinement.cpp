#include "refinement.h"

#include "common/output_file.h"
#include "common/scene_selection.h"
#include "interaction.h"
#include "scene_lighting.h"
#include "view_options.h"

#include <candela/sampling.h>

std::uint32_t wantedSamples(const ViewModel& model) {
    if (!model.options.debug.isDefault()) return 1;
    return model.options.sampling.count.value_or(defaultViewSamples);
}

void drawSample(const ViewModel& model, Viewport& viewport, const candela::DisplayTransform& display) {
    Document& document = *model.document;
    const SceneOptions& options = model.options;
    candela::SamplingSettings settings = options.sampling.settings(wantedSamples(model));
    if (model.camera.orthographicHeight()) settings.lens.reset();
    const std::uint32_t sample = viewport.samples();
    const auto poseAt = [&](double seconds) { return poseTime(document.scene(), options, seconds); };
    const double time = poseAt(candela::sampleTime(options.time, settings, sample));
    const bool moves = settings.shutter > 0.0 && document.animated();
    if (moves) document.gpuScene().setTime(time);
    const candela::CameraView view =
        candela::sampleView(selectedView(model, time), settings, options.width, options.height, sample);
    viewport.refine({document.gpuScene(), options, view, display});
    if (moves) document.gpuScene().setTime(poseAt(options.time));
}

void writePicture(ViewModel& model, Viewport& viewport, const candela::DisplayTransform& display,
                  const std::filesystem::path& file) {
    const candela::CameraView view = selectedView(model);
    lightDocument(model, view);
    viewport.draw({model.document->gpuScene(), model.options, view, display, 1});
    while (viewport.samples() < wantedSamples(model)) drawSample(model, viewport, display);
    const candela::Frame& frame = *viewport.frame();
    const candela::Accumulator* mean = viewport.mean();
    if (endingOf(file) == ".exr") {
        writeRadiance(file, mean != nullptr ? mean->radiance() : frame.radiance(),
                      frame.aovs(candela::Renderer::aovNames()), model.color);
    } else {
        writeDisplayedFrame(file, model.options.width, model.options.height,
                            mean != nullptr ? mean->displayPicture(display) : frame.displayPicture(display),
                            display);
    }
}
