#include "convert.h"
#include "module.h"

#include <candela/color.h>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace candela::python {

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
        .def_prop_ro("notes", &ColorConfig::notes, "Assumptions, one line each.")
        .def("__repr__", [](const ColorConfig& self) { return "<ColorConfig " + self.source() + ">"; });
}

}  // namespace candela::python
