#include "frame.h"
#include "module.h"

#include <candela/exposure.h>

#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <span>

namespace candela::python {

namespace {

/// (H, W, 4) or (H, W, 3) of anything that becomes float32.
HdrImage radianceFrom(nb::handle value) {
    const nb::object array =
        nb::module_::import_("numpy").attr("ascontiguousarray")(value, nb::arg("dtype") = "float32");
    const auto pixels = nb::cast<nb::ndarray<const float, nb::c_contig, nb::device::cpu>>(array);
    const std::size_t channels = pixels.ndim() == 3 ? pixels.shape(2) : 0;
    if ((channels != 3 && channels != 4) || pixels.size() == 0)
        failConversion("radiance", "numbers of shape (height, width, 4) or (height, width, 3)", value);
    HdrImage image{static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)), {}};
    image.rgba.assign(pixels.shape(0) * pixels.shape(1) * 4, 1.0f);
    for (std::size_t i = 0; i < image.rgba.size() / 4; ++i)
        std::copy_n(pixels.data() + channels * i, channels,
                    image.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
    return image;
}

nb::object shownPicture(const ColorConfig& self, nb::handle radiance, const nb::kwargs& shown) {
    const HdrImage image = radianceFrom(radiance);
    const DisplayTransform transform = transformBy(self, shown, [&] {
        return autoExposure(std::span(&image, 1), self.luminanceWeights()).value_or(0.0);
    });
    std::vector<std::uint8_t> pixels;
    {
        const nb::gil_scoped_release release;
        pixels = displayPicture(image, transform);
    }
    return arrayOf(std::move(pixels),
                   {static_cast<std::size_t>(image.height), static_cast<std::size_t>(image.width), 4});
}

}  // namespace

void bindColor(nb::module_& module) {
    nb::class_<ColorConfig>(
        module, "ColorConfig",
        "An OpenColorIO config: the working space, and the displays and views a picture can be shown "
        "through.")
        .def_static("built_in", &ColorConfig::builtIn,
                    "candela's own: linear Rec.709; sRGB, Rec.1886 and P3 displays.")
        .def_static("load", &ColorConfig::load, nb::arg("path"), "Reads a config file.")
        .def_static("choose", &ColorConfig::choose, nb::arg("path") = nb::none(),
                    "`path` if given, else the file that $OCIO names, else the built-in config.")
        .def_prop_ro("source", &ColorConfig::source, "The path it was read from, or 'built-in'.")
        .def_prop_ro("displays", &ColorConfig::displays, "Names of displays.")
        .def("views", &ColorConfig::views, nb::arg("display"), "The views of a display.")
        .def_prop_ro("looks", &ColorConfig::looks, "Names of looks.")
        .def_prop_ro("default_display", &ColorConfig::defaultDisplay, "What '' stands for.")
        .def("default_view", &ColorConfig::defaultView, nb::arg("display"), "What '' stands for.")
        .def_prop_ro("working_space", &ColorConfig::workingSpace, "The space of radiance.")
        .def_prop_ro(
            "working_from_rec709",
            [](const ColorConfig& self) {
                const glm::dmat3 rows = glm::transpose(self.workingFromRec709());
                return frozenArray(std::span<const double>(&rows[0][0], 9), {3, 3});
            },
            nb::sig("def working_from_rec709(self) -> numpy.typing.NDArray[numpy.float64]"),
            "Converts linear Rec.709 colours into the working space, (3, 3).")
        .def_prop_ro(
            "luminance_weights",
            [](const ColorConfig& self) { return Convert<glm::vec3>::to(self.luminanceWeights()); },
            nb::sig("def luminance_weights(self) -> numpy.typing.NDArray[numpy.float32]"),
            "Luminance is the dot product of a colour with these, (3,).")
        .def("display_picture", &shownPicture, nb::arg("radiance"), nb::arg("shown"),
             nb::sig(kept(std::string("def display_picture(self, radiance: numpy.typing.ArrayLike, *, ") +
                          shownKeywords + ") -> numpy.typing.NDArray[numpy.uint8]")),
             "Shows scene-linear radiance in the working space, (height, width, 4) or (height, width, 3), "
             "as `Frame.rgba` shows a frame: (height, width, 4) of uint8.")
        .def_prop_ro("notes", &ColorConfig::notes, "Assumptions, one line each.")
        .def("__repr__", [](const ColorConfig& self) { return "<ColorConfig " + self.source() + ">"; });
}

}  // namespace candela::python
