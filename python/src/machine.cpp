#include "gpu_context.h"
#include "module.h"
#include "scene_types.h"

#include <candela/gbuffer.h>
#include <candela/renderer.h>
#include <candela/threads.h>
#include <candela/version.h>

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace candela::python {

const PluginRegistry& defaultPlugins() {
    // Never destroyed: plugins stay loaded until the process ends.
    static const auto* registry = new PluginRegistry();
    return *registry;
}

template <>
const Record<PluginReport>& recordOf<PluginReport>() {
    static const Record<PluginReport> record =
        Record<PluginReport>("PluginReport")
            .custom(
                "file", "str", "The plugin's file.", [](PluginReport&, nb::handle, const std::string&) {},
                [](const PluginReport& report) { return Convert<std::string>::to(report.file.string()); })
            .custom(
                "state", "str", "'loaded', or why it is not.",
                [](PluginReport&, nb::handle, const std::string&) {},
                [](const PluginReport& report) { return Convert<std::string>::to(toString(report.state)); })
            .field("detail", &PluginReport::detail, "Why it is not loaded, in one line.")
            .field("name", &PluginReport::name, "The plugin's name.")
            .field("version", &PluginReport::version, "The plugin's version.")
            .field("description", &PluginReport::description, "What it reads.")
            .field("extensions", &PluginReport::extensions, "Endings of file names that it takes.")
            .field("schemes", &PluginReport::schemes, "Schemes of URIs that it takes, as of 'plaza:4096'.")
            .field("subdivides", &PluginReport::subdivides, "Whether it refines subdivision cages.")
            .field("decodes_images", &PluginReport::decodesImages, "Whether it decodes images for importers.")
            .custom(
                "options", "tuple[str, ...]",
                "What the query behind a file's name takes, such as 'level=1..8'.",
                [](PluginReport&, nb::handle, const std::string&) {},
                [](const PluginReport& report) {
                    std::vector<std::string> texts;
                    for (const PluginOption& option : report.options)
                        texts.push_back(usageOf(option) + ": " + option.help);
                    return Convert<std::vector<std::string>>::to(texts);
                });
    return record;
}

namespace {

template <typename T>
nb::object tupleOf(const std::vector<T>& values) {
    nb::list list;
    for (const T& value : values) list.append(nb::cast(value));
    return nb::tuple(list);
}

nb::dict channelTable() {
    nb::dict table;
    for (const GBufferChannel& channel : gbufferChannels()) table[channel.name] = channel.meaning;
    return table;
}

}  // namespace

void bindMachine(nb::module_& module) {
    module.attr("version") = CANDELA_VERSION;
    bindValue<PluginReport>(module, "The result of loading one file that a PluginRegistry found.");
    nb::class_<PluginRegistry>(module, "PluginRegistry",
                               "Plugins, searched in the folders given, those of $CANDELA_PLUGIN_PATH, "
                               "`candela-plugins` beside the library, "
                               "and the install folder; the first of a name wins.")
        .def(nb::init<const std::vector<std::filesystem::path>&>(),
             nb::arg("folders") = std::vector<std::filesystem::path>(),
             nb::sig("def __init__(self, folders: typing.Sequence[str | os.PathLike[str]] = ()) -> None"))
        .def_prop_ro(
            "reports", [](const PluginRegistry& self) { return tupleOf(self.reports()); },
            nb::sig("def reports(self) -> tuple[PluginReport, ...]"), "One for each file found.");
    module.def(
        "default_plugins", [] { return defaultPlugins(); },
        "The plugins that are used where none are given, searched when they are needed first.");

    struct DeviceHandle {
        Device device;
    };
    nb::class_<DeviceHandle>(module, "Device", "An EGL device of this machine.")
        .def_prop_ro(
            "index", [](const DeviceHandle& self) { return self.device.index; },
            "What `Context(device=)` takes.")
        .def_prop_ro(
            "description", [](const DeviceHandle& self) { return self.device.description; },
            "Its render node or 'software rasteriser'.")
        .def_prop_ro(
            "software", [](const DeviceHandle& self) { return self.device.software; },
            "Whether it runs on the processor.")
        .def("__repr__", [](const DeviceHandle& self) {
            return "<Device " + std::to_string(self.device.index) + ": " + self.device.description + ">";
        });
    module.def(
        "devices",
        [] {
            requireOwnProcess();
            nb::list list;
            for (const Device& device : listDevices()) list.append(nb::cast(DeviceHandle{device}));
            return list;
        },
        nb::sig("def devices() -> list[Device]"),
        "The EGL devices of this machine; empty where EGL can not enumerate them.");

    module.def("aov_names", &Renderer::aovNames, "The AOVs that `Renderer.render` takes.");
    module.def("aov_meanings", &channelTable, nb::sig("def aov_meanings() -> dict[str, str]"),
               "What each AOV is, with its unit.");
    module.def("has_shadows", &hasShadows, "Whether the library was built with shadows.");
    module.def("set_thread_count", &setThreadCount, nb::arg("count"),
               "How many threads all parallel work shares; 0: as many as the process may use.");
    module.def("thread_count", &threadCount, "How many threads parallel work uses.");
    module.def(
        "candela_from_lumen",
        [](float lumen, std::optional<float> outerConeAngle) {
            return outerConeAngle ? candelaFromLumen(lumen, *outerConeAngle) : candelaFromLumen(lumen);
        },
        nb::arg("lumen"), nb::arg("outer_cone_angle") = nb::none(),
        "The intensity, candela, of a point light of so many lumen; of a spot light of this half angle, "
        "radians.");
}

}  // namespace candela::python
