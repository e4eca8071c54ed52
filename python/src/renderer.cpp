#include "renderer.h"

#include "module.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

namespace candela::python {

namespace {

/// `Renderer` in Python.
struct RendererHandle {
    RendererPtr data;
};

/// Samples that are drawn in one call, after which signals are looked at.
constexpr std::uint32_t samplesTogether = 16;

/// What `render` was asked for.
struct Request {
    RenderSettings settings;
    std::vector<std::string> aovs;
    std::optional<double> time;
    nb::object progress = nb::none();
    nb::kwargs upload = nb::steal<nb::kwargs>(PyDict_New());
};

bool isUploadOption(const std::string& name) {
    return std::string(uploadKeywords).find(" " + name + ":") != std::string::npos;
}

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

/// The scene on the device: a `Scene` is uploaded, and again when it has changed.
GpuScenePtr uploadedScene(RendererData& renderer, nb::handle scene, const Request& request) {
    if (nb::isinstance<GpuSceneHandle>(scene)) {
        if (request.upload.size() > 0)
            throw Error(ErrorKind::badInput, "",
                        "options of the upload belong to Renderer.upload, as the scene is a GpuScene");
        return nb::cast<GpuSceneHandle&>(scene).data;
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

/// The views of all samples where the shutter sees motion; otherwise one.
std::vector<CameraView> viewsOf(FrameData& frame, nb::handle camera, double time) {
    const SamplingSettings sampling = frame.settings.sampling();
    const FrameSettings& settings = frame.settings.frame;
    const auto whole = settings.region.value_or(PictureRegion{settings.width, settings.height});
    const float aspect = static_cast<float>(whole.width) / static_cast<float>(whole.height);
    const bool moves = sampling.shutter > 0.0 && frame.scene->isAnimated;
    std::vector<CameraView> views;
    for (std::uint32_t sample = 0; sample < (moves ? sampling.count : 1); ++sample)
        views.push_back(viewOf(*frame.scene, camera, sampleTime(time, sampling, sample), aspect));
    return views;
}

void drawSamples(FrameData& frame, const std::vector<CameraView>& views, double time,
                 const AccumulatorOptions& options, nb::handle progress) {
    RendererData& renderer = *frame.renderer;
    const Session session(renderer.context, "Renderer");
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

FrameHandle render(const RendererHandle& self, nb::handle scene, nb::handle camera,
                   const nb::kwargs& options) {
    const Request request = requestOf(options);
    RendererData& renderer = *self.data;
    auto frame = std::make_shared<FrameData>(self.data);
    frame->scene = uploadedScene(renderer, scene, request);
    frame->settings = request.settings;
    if (frame->scene->context != renderer.context)
        throw Error(ErrorKind::badInput, "", "the GpuScene belongs to another context than the Renderer");
    const double time = request.time.value_or(frame->scene->time);
    const std::vector<CameraView> views = viewsOf(*frame, camera, time);
    frame->view = views.front();
    drawSamples(*frame, views, time, {request.aovs, request.settings.aovFilter}, request.progress);
    return {std::move(frame)};
}

void close(RendererData& renderer) {
    renderer.context->close([&] {
        renderer.accumulator.discard();
        renderer.renderer.discard();
    });
    renderer.uploaded.reset();
}

const char* renderSignature() {
    return kept(
        "def render(self, scene: Scene | GpuScene, camera: CameraView | int | str | None = None, *, aovs: "
        "typing.Sequence[str] = (), time: float | None = None, previous_camera: CameraView | None = None, "
        "settings: RenderSettings | None = None, "
        "progress: typing.Callable[[float], object] | None = None" +
        recordOf<RenderSettings>().keywords() + std::string(uploadKeywords).substr(3) + ") -> Frame");
}

}  // namespace

void passProgress(nb::handle progress, std::uint32_t done, std::uint32_t count) {
    const nb::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    if (progress.is_none()) return;
    if (progress(static_cast<double>(done) / count).is(Py_False))
        throw Error(ErrorKind::cancelled, "", "the picture was cancelled");
}

void bindRenderers(nb::module_& module) {
    nb::class_<RendererHandle>(
        module, "Renderer",
        "Draws pictures of scenes. Any thread may call; calls of one context run one "
        "after the other, without the GIL. It is a context manager, at whose end its context is closed.")
        .def(
            "__init__",
            [](RendererHandle* self, nb::object context, std::optional<ColorConfig> color) {
                new (self) RendererHandle{std::make_shared<RendererData>(
                    contextOf(context), color ? *color : ColorConfig::choose(std::nullopt))};
            },
            nb::arg("context") = nb::none(), nb::kw_only(), nb::arg("color") = nb::none(),
            nb::sig("def __init__(self, context: Context | None = None, *, color: ColorConfig | None = None) "
                    "-> None"),
            "context: None makes one, on a GPU where there is one. color: the OpenColorIO config; None: the "
            "one that $OCIO names, or the built-in one.")
        .def_prop_ro(
            "context", [](const RendererHandle& self) { return contextObject(self.data->context); },
            nb::sig("def context(self) -> Context"), "What it draws with.")
        .def_prop_ro(
            "color", [](const RendererHandle& self) { return self.data->color; }, "The OpenColorIO config.")
        .def(
            "upload",
            [](const RendererHandle& self, const SceneHandle& scene, const nb::kwargs& options) {
                return GpuSceneHandle{upload(self.data->context, self.data->color, scene, options)};
            },
            nb::arg("scene"), nb::arg("options"),
            nb::sig(kept("def upload(self, scene: Scene" + std::string(uploadKeywords) + ") -> GpuScene")),
            "Copies a scene to the device. The result can be edited and drawn often.\n\n"
            "environment: 'auto' is the scene's own, or a studio where the scene has no light at all; an "
            "Environment replaces it, None removes it. range_loss: what lights without a range may lose of "
            "their light "
            "at any point, as a share. subdivision_...: how far cages are refined, to a level or by their "
            "size on "
            "the screen.")
        .def("render", &render, nb::arg("scene"), nb::arg("camera") = nb::none(), nb::arg("options"),
             nb::sig(renderSignature()),
             "Draws a picture and returns it as a Frame, which can be read until the next one is drawn.\n\n"
             "scene: a Scene is uploaded when it is drawn first and when it has changed; a GpuScene, from "
             "`upload`, is there already. camera: a CameraView, the index or name of a camera of the scene, "
             "or None: its "
             "first camera, or a view of all of it. aovs: further channels, of `candela.aov_names()`. time: "
             "seconds, poses what is animated; None: as it stands. previous_camera: the view of the frame "
             "before, for the AOV motion. settings: values for what the further keywords leave "
             "out; these are the attributes of RenderSettings and the options of `upload` (of a Scene). "
             "progress: called "
             "with the share done; returning False cancels.")
        .def(
            "close", [](const RendererHandle& self) { close(*self.data); },
            "Ends its context, and frees what it holds on the device.")
        .def(
            "__enter__", [](nb::object self) { return self; }, nb::sig("def __enter__(self) -> Renderer"))
        .def(
            "__exit__", [](const RendererHandle& self, nb::args) { close(*self.data); },
            nb::sig("def __exit__(self, *exception: object) -> None"));
}

}  // namespace candela::python
