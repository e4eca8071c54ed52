#include "renderer.h"

#include "module.h"
#include "render_request.h"

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

FrameHandle render(const RendererHandle& self, nb::handle scene, nb::handle camera,
                   const nb::kwargs& options) {
    const Request request = requestOf(options);
    RendererData& renderer = *self.data;
    auto frame = std::make_shared<FrameData>(self.data);
    frame->scene = uploadedScene(renderer, scene, request);
    frame->settings = request.settings;
    const double time = request.time.value_or(frame->scene->time);
    const std::vector<CameraView> views = viewsOf(*frame->scene, frame->settings, camera, time);
    frame->view = views.front();
    {
        const Session session(renderer.context, "Renderer");
        drawSamples(session, *frame, views, time, {request.aovs, request.settings.aovFilter},
                    {request.progress});
    }
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

const char* panoramaSignature() {
    return kept(
        "def render_panorama(self, scene: Scene | GpuScene, camera: CameraView | int | str | None = None, *, "
        "width: int = 2048, time: float | None = None, settings: RenderSettings | None = None, progress: "
        "typing.Callable[[float], object] | None = None" +
        recordOf<RenderSettings>().keywordsWithout(withoutPanorama) + std::string(uploadKeywords).substr(3) +
        ") -> numpy.typing.NDArray[numpy.float32]");
}

}  // namespace

void passProgress(const Progress& progress, std::uint32_t done, std::uint32_t count) {
    const nb::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    if (progress.callback.is_none()) return;
    const double share = static_cast<double>(done) / count;
    const double whole = (static_cast<double>(progress.part) + share) / static_cast<double>(progress.parts);
    if (progress.callback(whole).is(Py_False))
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
            "render_panorama",
            [](const RendererHandle& self, nb::handle scene, nb::handle camera, int width,
               const nb::kwargs& options) {
                return renderPanorama(self.data, scene, camera, width, options);
            },
            nb::arg("scene"), nb::arg("camera") = nb::none(), nb::kw_only(), nb::arg("width") = 2048,
            nb::arg("options"), nb::sig(panoramaSignature()),
            "Draws an equirectangular picture of all directions around the eye of a view, and returns its "
            "scene-linear radiance: (width / 2, width, 4) of float32, working space, rows from the top. "
            "`color.display_picture` shows it.\n\n"
            "The middle looks along the view axis, and up is the view's own: the middle of pixel (x, y) has "
            "the longitude 2 pi ((x + 0.5) / width - 0.5) to the right of it, and the latitude pi (0.5 - (y "
            "+ 0.5) / height). width: pixels, 4 or more and even. The further keywords are those of "
            "`render`.")
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
