#include "render_request.h"

#include <algorithm>

namespace candela::python {

namespace {

/// Samples that are drawn in one call, after which signals are looked at.
constexpr std::uint32_t samplesTogether = 16;

bool isUploadOption(const std::string& name) {
    return std::string(uploadKeywords).find(" " + name + ":") != std::string::npos;
}

}  // namespace

Request requestOf(const nb::kwargs& options) {
    Request request;
    if (options.contains("settings") && !options["settings"].is_none())
        request.settings = ConvertClass<RenderSettings>::from(options["settings"], "settings");
    for (const auto& [key, value] : options) {
        const std::string name = nb::str(key).c_str();
        if (name == "aovs") {
            if (nb::isinstance<nb::str>(value)) failConversion("aovs", "a sequence of names", value);
            for (const std::string& aov : Convert<std::vector<std::string>>::from(value, "aovs"))
                request.aovs.push_back(channelName(aov));
        } else if (name == "time") {
            request.time = Convert<std::optional<double>>::from(value, "time");
        } else if (name == "previous_camera") {
            request.settings.frame.previousView = Convert<std::optional<CameraView>>::from(value, name);
        } else if (name == "progress") {
            request.progress = nb::borrow(value);
        } else if (isUploadOption(name)) {
            request.upload[key] = value;
        } else if (name != "settings") {
            recordOf<RenderSettings>().set(request.settings, name, value);
        }
    }
    // A debug view shows data of the first sample.
    if (request.settings.frame.debugView != DebugView::none) request.settings.samples = 1;
    if (request.settings.frame.width < 1 || request.settings.frame.height < 1)
        throw Error(ErrorKind::badInput, "", "the picture's width and height must be 1 pixel or more");
    checkSampling(request.settings.sampling());
    return request;
}

GpuScenePtr uploadedScene(RendererData& renderer, nb::handle scene, const Request& request) {
    if (nb::isinstance<GpuSceneHandle>(scene)) {
        if (request.upload.size() > 0)
            throw Error(ErrorKind::badInput, "",
                        "options of the upload belong to Renderer.upload, as the scene is a GpuScene");
        const GpuScenePtr& uploaded = nb::cast<GpuSceneHandle&>(scene).data;
        if (uploaded->context != renderer.context)
            throw Error(ErrorKind::badInput, "", "the GpuScene belongs to another context than the Renderer");
        return uploaded;
    }
    if (!nb::isinstance<SceneHandle>(scene)) failConversion("scene", "a Scene or a GpuScene", scene);
    const auto& handle = nb::cast<SceneHandle&>(scene);
    const std::string with = nb::repr(request.upload).c_str();
    if (renderer.uploaded && renderer.uploaded->source == handle.data &&
        renderer.uploaded->version == handle.data->version && renderer.uploadedWith == with)
        return renderer.uploaded;
    renderer.uploaded.reset();
    renderer.uploaded = upload(renderer.context, renderer.color, handle, request.upload);
    renderer.uploadedWith = with;
    return renderer.uploaded;
}

std::vector<CameraView> viewsOf(GpuSceneData& scene, const RenderSettings& settings, nb::handle camera,
                                double time) {
    const SamplingSettings sampling = settings.sampling();
    const auto whole =
        settings.frame.region.value_or(PictureRegion{settings.frame.width, settings.frame.height});
    const float aspect = static_cast<float>(whole.width) / static_cast<float>(whole.height);
    const bool moves = sampling.shutter > 0.0 && scene.isAnimated;
    std::vector<CameraView> views;
    for (std::uint32_t sample = 0; sample < (moves ? sampling.count : 1); ++sample)
        views.push_back(viewOf(scene, camera, sampleTime(time, sampling, sample), aspect));
    return views;
}

void drawSamples(const Session& session, FrameData& frame, const std::vector<CameraView>& views, double time,
                 const AccumulatorOptions& options, const Progress& progress) {
    RendererData& renderer = *frame.renderer;
    GpuScene& scene = *frame.scene->scene;
    if (!renderer.renderer) renderer.renderer.emplace(session.context());
    frame.number = ++renderer.number;
    if (frame.scene->isAnimated && time != frame.scene->time) scene.setTime(time);
    frame.scene->time = time;
    const SamplingSettings sampling = frame.settings.sampling();
    if (sampling.count == 1) {
        frame.frame.emplace(renderer.renderer->render(scene, views[0], frame.settings.frame));
        if (!options.aovs.empty()) *frame.aovs = frame.frame->aovs(options.aovs);
        return;
    }
    if (!renderer.accumulator || renderer.accumulated.aovs != options.aovs ||
        renderer.accumulated.aovFilter != options.aovFilter) {
        renderer.accumulator.emplace(session.context(), options);
        renderer.accumulated = options;
    }
    renderer.accumulator->reset();
    frame.accumulates = true;
    const std::uint32_t together = views.size() > 1 ? 1 : samplesTogether;
    for (std::uint32_t first = 0; first < sampling.count; first += together) {
        const std::uint32_t end = std::min(first + together, sampling.count);
        if (views.size() > 1) scene.setTime(sampleTime(time, sampling, first));
        const CameraView& view = views[std::min<std::size_t>(first, views.size() - 1)];
        frame.frame.emplace(renderer.accumulator->addSamples(*renderer.renderer, scene, view,
                                                             frame.settings.frame, sampling, first, end));
        passProgress(progress, end, sampling.count);
    }
    frame.samples = sampling.count;
    // The next picture shows the scene at this picture's time.
    if (views.size() > 1) scene.setTime(time);
    if (!options.aovs.empty()) *frame.aovs = renderer.accumulator->aovs();
}

}  // namespace candela::python
