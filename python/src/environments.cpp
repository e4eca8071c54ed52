#include "module.h"
#include "scene_types.h"

#include <candela/image_file.h>

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

namespace candela::python {

template <>
const Record<Environment>& recordOf<Environment>() {
    static const Record<Environment> record =
        Record<Environment>("Environment")
            .custom(
                "picture", floatArray,
                "Radiance, linear Rec.709: (H, W, 4) or (H, W, 3) floats, equirectangular, rows from the top "
                "(+Y), the middle column at -Z.",
                [](Environment& environment, nb::handle value, const std::string& where) {
                    Element<Image> image{nullptr, 0, std::make_shared<Image>()};
                    const nb::object floats =
                        nb::module_::import_("numpy").attr("asarray")(value, nb::arg("dtype") = "float32");
                    recordOf<Image>().fields()[1].set(*image.own, floats, where);
                    environment.picture = std::move(*image.own);
                },
                [](const Environment& environment) {
                    return recordOf<Image>().fields()[1].get(environment.picture);
                })
            .field("rotation", &Environment::rotation,
                   "World from the picture's frame: a quaternion x, y, z, w.")
            .field("intensity", &Environment::intensity, "Factor on the radiance, 0 or more.")
            .field("is_background", &Environment::isBackground, "Whether it is seen behind the scene.")
            .field("occlusion_distance", &Environment::occlusionDistance,
                   "Metres: surfaces farther away do not hide it; None: all do.");
    return record;
}

namespace {

nb::object ownedLight(const Light& light) {
    return nb::cast(Element<Light>{nullptr, 0, std::make_shared<Light>(light)});
}

Environment fromFile(const std::filesystem::path& path) {
    HdrFile file;
    {
        const nb::gil_scoped_release release;
        file = readHdrFile(path);
    }
    for (const std::string& note : file.notes) warnUser(note);
    Environment environment;
    environment.picture = std::move(file.image);
    return environment;
}

}  // namespace

void bindEnvironments(nb::module_& module) {
    bindValue<Environment>(module,
                           "Light from everywhere: a picture of what surrounds a scene, infinitely far away.")
        .def_static("studio", &studioEnvironment,
                    "Five white soft boxes in a grey room; not seen behind the scene.")
        .def_static(
            "sky",
            [](double elevation, double azimuth, double turbidity) {
                Sky sky = skyEnvironment({elevation, azimuth, turbidity});
                return std::pair(nb::cast(std::move(sky.environment)), ownedLight(sky.sun));
            },
            nb::arg("sun_elevation") = SkyOptions{}.sunElevation,
            nb::arg("sun_azimuth") = SkyOptions{}.sunAzimuth, nb::arg("turbidity") = SkyOptions{}.turbidity,
            nb::sig(
                "def sky(sun_elevation: float = 0.7, sun_azimuth: float = -2.4, turbidity: float = 3.0) -> "
                "tuple[Environment, Light]"),
            "A clear sky, and its sun as a directional light. Angles in radians: elevation pi / 60 to pi / "
            "2, azimuth from -Z towards +X, -pi to pi; turbidity 2 (very clear) to 8.")
        .def_static(
            "from_file", &fromFile, nb::arg("path"),
            nb::sig("def from_file(path: str | os.PathLike[str]) -> Environment"),
            "Reads a Radiance (.hdr) or OpenEXR (.exr) picture. What was repaired is a CandelaWarning.")
        .def(
            "turned",
            [](const Environment& environment, double degrees) {
                Environment turned = environment;
                turned.rotation = glm::normalize(rotationAboutUp(degrees) * turned.rotation);
                return turned;
            },
            nb::arg("degrees"), "The same, turned about +Y, counter-clockwise as seen from above.")
        .def(
            "without_sun",
            [](const Environment& environment) {
                Environment rest = environment;
                const std::optional<Light> sun = takeSun(rest);
                return std::pair(nb::cast(std::move(rest)), sun ? ownedLight(*sun) : nb::none());
            },
            nb::sig("def without_sun(self) -> tuple[Environment, Light | None]"),
            "The same without the sun in its picture, and the sun as a directional light, which casts sharp "
            "shadows; None where there is no sun.");
}

}  // namespace candela::python
