#include "refinement.h"

#include "common/output_file.h"
#include "common/scene_selection.h"
#include "interaction.h"
#include "scene_lighting.h"
#include "view_options.h"

#include <candela/accumulator.h>
#include <candela/sampling.h>

#include <string>
#include <vector>

std::uint32_t wantedSamples(const SceneOptions& options) {
    if (!options.debug.isDefault()) return 1;
    return options.sampling.count.value_or(defaultViewSamples);
}

namespace {

/// Calls `draw` with the inputs of a sample, at whose time the scene is then.
template <typename Draw>
void atSample(const ViewModel& model, const SceneOptions& options, const candela::DisplayTransform& display,
              std::uint32_t sample, const Draw& draw) {
    Document& document = *model.document;
    candela::SamplingSettings settings = options.sampling.settings(wantedSamples(options));
    if (model.camera.orthographicHeight()) settings.lens.reset();
    const auto poseAt = [&](double seconds) { return poseTime(document.scene(), options, seconds); };
    const double time = poseAt(candela::sampleTime(options.time, settings, sample));
    const bool moves = settings.shutter > 0.0 && document.animated();
    if (moves) document.gpuScene().setTime(time);
    const candela::CameraView view =
        candela::sampleView(selectedView(model, time), settings, options.width, options.height, sample);
    draw(Viewport::Inputs{document.gpuScene(), options, view, display});
    if (moves) document.gpuScene().setTime(poseAt(options.time));
}

/// All channels, over all samples, as candela-render writes them.
void writeRadianceOfSamples(const ViewModel& model, Viewport& viewport,
                            const candela::DisplayTransform& display, const std::filesystem::path& file) {
    const std::vector<std::string> aovs = candela::Renderer::aovNames();
    candela::Accumulator mean(viewport.context(), {aovs, candela::AovFilter::automatic});
    for (std::uint32_t sample = 0; sample < wantedSamples(model.options); ++sample)
        atSample(model, model.options, display, sample,
                 [&](const Viewport::Inputs& inputs) { viewport.addSample(inputs, sample, mean); });
    std::vector<candela::ExrAttribute> attributes{{"samples", std::to_string(mean.count())}};
    for (const std::string& aov : aovs)
        attributes.push_back({"filter." + aov, candela::toString(mean.filterOf(aov))});
    writeRadiance(file, mean.radiance(), mean.aovs(), model.color, attributes);
}

}  // namespace

void drawSample(const ViewModel& model, const SceneOptions& options, Viewport& viewport,
                const candela::DisplayTransform& display) {
    atSample(model, options, display, viewport.samples(),
             [&](const Viewport::Inputs& inputs) { viewport.refine(inputs); });
}

void writePicture(ViewModel& model, Viewport& viewport, const candela::DisplayTransform& display,
                  const std::filesystem::path& file) {
    const candela::CameraView view = selectedView(model);
    lightDocument(model, view);
    viewport.draw({model.document->gpuScene(), model.options, view, display, 1});
    const bool isExr = endingOf(file) == ".exr";
    if (isExr && wantedSamples(model.options) > 1)
        return writeRadianceOfSamples(model, viewport, display, file);
    if (isExr) {
        const candela::Frame& frame = *viewport.frame();
        return writeRadiance(file, frame.radiance(), frame.aovs(candela::Renderer::aovNames()), model.color);
    }
    while (viewport.samples() < wantedSamples(model.options))
        drawSample(model, model.options, viewport, display);
    const candela::Accumulator* mean = viewport.mean();
    writeDisplayedFrame(
        file, model.options.width, model.options.height,
        mean != nullptr ? mean->displayPicture(display) : viewport.frame()->displayPicture(display), display);
}
