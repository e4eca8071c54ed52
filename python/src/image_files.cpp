#include "convert.h"
#include "module.h"

#include <candela/image_file.h>

#include <nanobind/ndarray.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <cstring>
#include <deque>

namespace candela::python {

namespace {

using Bytes = nb::ndarray<const std::uint8_t, nb::c_contig, nb::device::cpu>;

void savePng(const std::filesystem::path& path, nb::object pixels) {
    const nb::module_ numpy = nb::module_::import_("numpy");
    const std::string expected =
        "pixels of shape (height, width), (height, width, 3) or (height, width, 4) of uint8";
    nb::object array = numpy.attr("asarray")(pixels);
    if (!nb::str(nb::object(array.attr("dtype"))).equal(nb::str("uint8")))
        failConversion("write_png", expected, array);
    if (nb::cast<int>(array.attr("ndim")) == 2)
        array =
            numpy.attr("repeat")(array.attr("__getitem__")(nb::make_tuple(nb::ellipsis(), nb::none())), 3, 2);
    const Bytes view = nb::cast<Bytes>(numpy.attr("ascontiguousarray")(array));
    const std::size_t channels = view.ndim() == 3 ? view.shape(2) : 0;
    if (channels != 3 && channels != 4) failConversion("write_png", expected, array);
    std::vector<std::uint8_t> rgba(view.shape(0) * view.shape(1) * 4, 255);
    for (std::size_t i = 0; i < rgba.size() / 4; ++i)
        std::memcpy(&rgba[4 * i], view.data() + channels * i, channels);
    const nb::gil_scoped_release release;
    writePng(path, static_cast<std::uint32_t>(view.shape(1)), static_cast<std::uint32_t>(view.shape(0)), rgba,
             {});
}

// An array of (height, width) is one channel of its name, one of (height, width, 3 or 4) NAME.R, NAME.G...
void saveExr(const std::filesystem::path& path, const nb::dict& arrays, const nb::dict& attributes) {
    const nb::module_ numpy = nb::module_::import_("numpy");
    std::deque<std::vector<float>> planes;
    std::vector<ExrChannel> channels;
    std::size_t width = 0, height = 0;
    for (const auto& [key, value] : arrays) {
        const std::string name = Convert<std::string>::from(key, "the name of an EXR channel");
        const nb::object array = numpy.attr("ascontiguousarray")(value, nb::arg("dtype") = "float32");
        const auto view = nb::cast<nb::ndarray<const float, nb::c_contig, nb::device::cpu>>(array);
        const std::size_t count = view.ndim() == 3 ? view.shape(2) : 1;
        if ((view.ndim() != 2 && view.ndim() != 3) || count > 4 || count == 0)
            failConversion("write_exr: " + name,
                           "an array of shape (height, width) or (height, width, 1 to 4)", array);
        if (!channels.empty() && (view.shape(0) != height || view.shape(1) != width))
            failConversion("write_exr: " + name, "the shape of the arrays before it", array);
        height = view.shape(0);
        width = view.shape(1);
        for (std::size_t channel = 0; channel < count; ++channel) {
            std::vector<float>& plane = planes.emplace_back(width * height);
            for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = view.data()[i * count + channel];
            const std::string component(1, "RGBA"[channel]);
            const std::string full = count == 1 ? name : name.empty() ? component : name + "." + component;
            channels.push_back({full, plane});
        }
    }
    std::vector<ExrAttribute> texts;
    for (const auto& [name, value] : attributes)
        texts.push_back({Convert<std::string>::from(name, "the name of an EXR attribute"),
                         Convert<std::string>::from(value, "the value of an EXR attribute")});
    const nb::gil_scoped_release release;
    writeExr(path, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), channels, {},
             texts);
}

nb::object readHdr(const std::filesystem::path& path) {
    HdrFile file;
    {
        const nb::gil_scoped_release release;
        file = readHdrFile(path);
    }
    std::vector<float> values(file.image.pixels.size() / sizeof(float));
    std::memcpy(values.data(), file.image.pixels.data(), file.image.pixels.size());
    for (const std::string& note : file.notes) warnUser(note);
    return arrayOf(std::move(values), {file.image.height, file.image.width, 4});
}

}  // namespace

void bindImageFiles(nb::module_& module) {
    module.def(
        "write_png", &savePng, nb::arg("path"), nb::arg("pixels"),
        nb::sig(
            "def write_png(path: str | os.PathLike[str], pixels: numpy.typing.NDArray[numpy.uint8]) -> None"),
        "Writes sRGB pixels, (height, width), (height, width, 3) or (height, width, 4) of uint8, rows from "
        "the top, alpha straight. The file is whole or absent.");
    module.def(
        "write_exr", &saveExr, nb::arg("path"), nb::arg("channels"), nb::arg("attributes") = nb::dict(),
        nb::sig("def write_exr(path: str | os.PathLike[str], channels: dict[str, numpy.typing.ArrayLike], "
                "attributes: dict[str, str] = {}) -> None"),
        "Writes 32-bit float channels, rows from the top. An array of (height, width) is the channel of its "
        "name; one of (height, width, 3) is NAME.R, NAME.G and NAME.B, or R, G and B where the name is ''. "
        "The file is whole or absent.");
    module.def(
        "read_hdr", &readHdr, nb::arg("path"),
        nb::sig("def read_hdr(path: str | os.PathLike[str]) -> numpy.typing.NDArray[numpy.float32]"),
        "Reads a Radiance (.hdr) or OpenEXR (.exr) picture: (height, width, 4) of float32, linear Rec.709.");
}

}  // namespace candela::python
