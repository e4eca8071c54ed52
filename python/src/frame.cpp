#include "frame.h"

#include "module.h"
#include "words.h"

#include <candela/gbuffer.h>

#include <nanobind/ndarray.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>

namespace candela::python {

template <>
const Record<PixelProbe>& recordOf<PixelProbe>() {
    static const Record<PixelProbe> record =
        Record<PixelProbe>("PixelProbe")
            .field("node", &PixelProbe::node, "The node whose mesh or cage it is.")
            .field("depth", &PixelProbe::z, "Distance along the view axis, metres.")
            .field("position", &PixelProbe::position, "World, metres, (3,).")
            .field("normal", &PixelProbe::normal, "World, unit length, (3,).")
            .field("base_color", &PixelProbe::baseColor, "Linear, working space, (3,).")
            .field("metallic", &PixelProbe::metallic, "0 to 1.")
            .field("roughness", &PixelProbe::roughness, "0 to 1.")
            .field("emission", &PixelProbe::emission, "Radiance, (3,).")
            .field("radiance", &PixelProbe::radiance, "Radiance, (3,).")
            .field("light_count", &PixelProbe::lightCount, "Lights in whose range it lies.");
    return record;
}

template <>
const Record<PickedSurface>& recordOf<PickedSurface>() {
    static const Record<PickedSurface> record =
        Record<PickedSurface>("PickedSurface")
            .field("node", &PickedSurface::node, "The node whose mesh or cage it is.")
            .field("material", &PickedSurface::material, "Index into `Scene.materials`.")
            .field("pixels", &PickedSurface::pixels, "How many of the rectangle show it.")
            .field("depth", &PickedSurface::z, "The least distance along the view axis of these, metres.");
    return record;
}

std::string channelName(const std::string& name) {
    constexpr std::array others{std::pair{"depth", "Z"}, std::pair{"position", "P"},
                                std::pair{"normal", "N"}};
    for (const auto& [other, channel] : others)
        if (name == other) return channel;
    return name;
}

void FrameData::requireLast() const {
    if (renderer->number == number) return;
    throw Error(
        ErrorKind::badInput, "",
        "this Frame was overwritten by a later one of its Renderer: read it before the next render, or use "
        "another Renderer");
}

namespace {

/// An AOV as an array: (H, W) of one channel, without a copy, else (H, W, channels).
nb::object aovArray(const FrameHandle& self, std::size_t index) {
    const std::shared_ptr<std::vector<Aov>> all = self.data->aovs;
    const Aov& aov = (*all)[index];
    const std::size_t channels = aov.values.size();
    const auto height = static_cast<std::size_t>(self.data->settings.frame.height);
    const auto width = static_cast<std::size_t>(self.data->settings.frame.width);
    if (channels == 1) {
        auto* keep = new std::shared_ptr<std::vector<Aov>>(all);
        const nb::capsule owner(
            keep, [](void* p) noexcept { delete static_cast<std::shared_ptr<std::vector<Aov>>*>(p); });
        const std::array<std::size_t, 2> shape{height, width};
        return nb::cast(
            nb::ndarray<nb::numpy, float>(const_cast<float*>(aov.values[0].data()), 2, shape.data(), owner));
    }
    std::vector<float> values(height * width * channels);
    {
        const nb::gil_scoped_release release;
        for (std::size_t channel = 0; channel < channels; ++channel) {
            const std::vector<float>& plane = aov.values[channel];
            for (std::size_t i = 0; i < plane.size(); ++i) values[i * channels + channel] = plane[i];
        }
    }
    return arrayOf(std::move(values), {height, width, channels});
}

/// Reads an AOV that was not asked for, where the frame has one sample.
void readMore(FrameData& frame, const std::string& name) {
    if (frame.accumulates)
        throw Error(
            ErrorKind::badInput, "",
            "the AOV '" + name + "' is not in a Frame of many samples unless render(aovs=[...]) names it");
    std::vector<Aov> more = frame.frame->aovs({name});
    frame.aovs->push_back(std::move(more.front()));
}

nb::object aov(const FrameHandle& self, const std::string& asked) {
    const std::string name = channelName(asked);
    const std::vector<Aov>& aovs = *self.data->aovs;
    auto found = std::ranges::find(aovs, name, &Aov::name);
    if (found == aovs.end()) {
        reading(self, [&](FrameData& frame) { readMore(frame, name); });
        found = std::prev(aovs.end());
    }
    return aovArray(self, static_cast<std::size_t>(found - aovs.begin()));
}

nb::dict allAovs(const FrameHandle& self) {
    nb::dict result;
    for (std::size_t i = 0; i < self.data->aovs->size(); ++i)
        result[(*self.data->aovs)[i].name.c_str()] = aovArray(self, i);
    return result;
}

FrameHandle& addSamples(FrameHandle& self, std::uint32_t count, nb::handle progress) {
    FrameData& frame = *self.data;
    if (!frame.accumulates)
        throw Error(ErrorKind::badInput, "",
                    "add_samples: the Frame has to be drawn with samples of 2 or more");
    if (frame.settings.shutter > 0.0 && frame.scene->isAnimated)
        throw Error(ErrorKind::badInput, "",
                    "add_samples: pictures with a shutter get all samples from render");
    const std::uint32_t end = count > maxSamples - frame.samples ? maxSamples + 1 : frame.samples + count;
    SamplingSettings sampling = frame.settings.sampling();
    sampling.count = end;
    checkSampling(sampling);
    reading(self, [&](FrameData&) {
        constexpr std::uint32_t together = 16;
        for (std::uint32_t first = frame.samples; first < end; first = frame.samples) {
            const std::uint32_t until = std::min(first + together, end);
            frame.frame.emplace(frame.renderer->accumulator->addSamples(
                *frame.renderer->renderer, *frame.scene->scene, frame.view, frame.settings.frame, sampling,
                first, until));
            frame.samples = until;
            passProgress({progress}, until, end);
        }
        if (!frame.aovs->empty())
            frame.aovs = std::make_shared<std::vector<Aov>>(frame.renderer->accumulator->aovs());
    });
    frame.autoExposure.reset();
    return self;
}

nb::list passTimes(const FrameHandle& self) {
    const std::vector<PassTime> times = reading(self, [](FrameData& frame) {
        std::vector<PassTime> all = frame.frame->passTimes();
        if (!frame.accumulates) return all;
        for (PassTime& time : frame.renderer->accumulator->passTimes()) all.push_back(std::move(time));
        return all;
    });
    nb::list list;
    for (const PassTime& time : times) list.append(nb::make_tuple(time.name, time.milliseconds));
    return list;
}

nb::dict counts(const FrameHandle& self) {
    PairCounts pairs;
    ShadowCounts shadows;
    LayerCounts layers;
    reading(self, [&](FrameData& frame) {
        pairs = frame.frame->countPairs();
        shadows = frame.frame->shadowCounts();
        layers = frame.frame->layerCounts();
    });
    nb::dict result;
    result["lights_visible"] = pairs.lightsVisible;
    result["pairs_lit"] = pairs.pairsLit;
    result["pairs_evaluated"] = pairs.pairsEvaluated;
    result["lights_dropped"] = pairs.lightsDropped;
    result["shadow_rays_asked"] = shadows.raysAsked;
    result["shadow_rays_traced"] = shadows.raysTraced;
    result["layers"] = layers.layers;
    result["fragments_beyond_layers"] = layers.fragmentsBeyond;
    return result;
}

void bindReading(nb::class_<FrameHandle>& cls) {
    cls.def(
           "radiance", [](const FrameHandle& self) { return imageArray(reading(self, radianceOf)); },
           nb::sig("def radiance(self) -> numpy.typing.NDArray[numpy.float32]"),
           "Scene-linear radiance in the working space, (height, width, 4) of float32, rows from the top. A "
           "is the share of the pixel that surfaces cover; RGB is associated with it.")
        .def("rgba", &rgba, nb::arg("shown"),
             nb::sig(kept(std::string("def rgba(self, *, ") + shownKeywords +
                          ") -> numpy.typing.NDArray[numpy.uint8]")),
             "The picture as a display shows it, (height, width, 4) of uint8, rows from the top. exposure: "
             "stops, or 'auto', which brings the median of what is lit to mid-grey. display, view, look: "
             "names of the "
             "OpenColorIO config; '' is its default.")
        .def("rgb", &rgb, nb::arg("shown"),
             nb::sig(kept(std::string("def rgb(self, *, ") + shownKeywords +
                          ") -> numpy.typing.NDArray[numpy.uint8]")),
             "The same without alpha, (height, width, 3) of uint8.")
        .def("aov", &aov, nb::arg("name"),
             nb::sig("def aov(self, name: str) -> numpy.typing.NDArray[numpy.float32]"),
             "A channel of `candela.aov_names()`, or 'depth', 'position' or 'normal': (height, width) or "
             "(height, width, 3) of float32, rows from the top. A frame of many samples has those that "
             "`render` was asked "
             "for.")
        .def("__getitem__", &aov, nb::arg("name"),
             nb::sig("def __getitem__(self, name: str, /) -> numpy.typing.NDArray[numpy.float32]"),
             "As `aov`.")
        .def_prop_ro("aovs", &allAovs,
                     nb::sig("def aovs(self) -> dict[str, numpy.typing.NDArray[numpy.float32]]"),
                     "The AOVs that were read, by the names of the channel table.")
        .def(
            "probe",
            [](const FrameHandle& self, int x, int y) {
                const auto probe = reading(self, [&](FrameData& frame) { return frame.frame->probe(x, y); });
                return probe ? nb::cast(*probe) : nb::none();
            },
            nb::arg("x"), nb::arg("y"), nb::sig("def probe(self, x: int, y: int) -> PixelProbe | None"),
            "What the pixel of column x and row y (from the top) shows; None on the background.")
        .def(
            "pick",
            [](const FrameHandle& self, int x, int y, int width, int height) {
                const std::vector<PickedSurface> picked = reading(self, [&](FrameData& frame) {
                    return frame.frame->pick({x, y, width, height});
                });
                nb::list list;
                for (const PickedSurface& surface : picked) list.append(nb::cast(surface));
                return list;
            },
            nb::arg("x"), nb::arg("y"), nb::arg("width") = 1, nb::arg("height") = 1,
            nb::sig("def pick(self, x: int, y: int, width: int = 1, height: int = 1) -> list[PickedSurface]"),
            "The surfaces that a rectangle of pixels shows, by node and material: those of more pixels "
            "first. "
            "x, y: its upper left pixel.")
        .def("auto_exposure", &autoExposureOf,
             "The exposure of exposure='auto', stops; 0 where nothing is lit.")
        .def("notes", &notesOf, nb::arg("exposure") = 0.0,
             nb::sig("def notes(self, exposure: float = 0.0) -> list[str]"),
             "What is wrong with the picture, with the remedy: nothing in view, dark, or over white.")
        .def("pass_times", &passTimes, nb::sig("def pass_times(self) -> list[tuple[str, float]]"),
             "What each pass of the last sample took, milliseconds, in the order they ran.")
        .def("counts", &counts, nb::sig("def counts(self) -> dict[str, int]"),
             "Counts of lights, of pairs of a pixel and a light, of shadow rays and of layers.");
}

}  // namespace

void bindFrames(nb::module_& module) {
    bindValue<PixelProbe>(module, "What a pixel of a frame shows.");
    bindValue<PickedSurface>(module, "A surface that a rectangle of a frame shows.");
    bindPendingArrays(module);
    nb::class_<FrameHandle> cls(
        module, "Frame",
        "A picture that was drawn. Arrays that were read stay; what is read later needs its "
        "Renderer not to have drawn another one since.");
    bindReading(cls);
    bindPendingReads(cls);
    bindFrameTextures(module, cls);
    cls.def("save", &save, nb::arg("path"), nb::arg("shown"),
            nb::sig(kept(std::string("def save(self, path: str | os.PathLike[str], *, ") + shownKeywords +
                         ") -> None")),
            "Writes a .png as a display shows it, or an .exr of scene-linear radiance with the AOVs that "
            "were read. The file is whole or absent. A PNG that shows next to nothing is a CandelaWarning "
            "(`notes`).")
        .def("add_samples", &addSamples, nb::arg("count"), nb::arg("progress") = nb::none(),
             nb::rv_policy::none,
             nb::sig("def add_samples(self, count: int, progress: typing.Callable[[float], object] | None = "
                     "None) -> Frame"),
             "Draws further samples and adds them to the mean: a picture that can be shown at once and gets "
             "finer. Returns the frame.")
        .def_prop_ro(
            "width", [](const FrameHandle& self) { return self.data->settings.frame.width; }, "Pixels.")
        .def_prop_ro(
            "height", [](const FrameHandle& self) { return self.data->settings.frame.height; }, "Pixels.")
        .def_prop_ro(
            "samples", [](const FrameHandle& self) { return self.data->samples; }, "Samples in the mean.")
        .def_prop_ro(
            "camera", [](const FrameHandle& self) { return self.data->view; }, "The view that it shows.")
        .def_prop_ro(
            "settings", [](const FrameHandle& self) { return self.data->settings; }, "How it was drawn.")
        .def("__repr__", [](const FrameHandle& self) {
            return "<Frame " + std::to_string(self.data->settings.frame.width) + "x" +
                   std::to_string(self.data->settings.frame.height) + ", " +
                   std::to_string(self.data->samples) + " samples>";
        });
}

}  // namespace candela::python
