#include "module.h"
#include "scene_types.h"
#include "words.h"

#include <candela/default_lights.h>
#include <candela/geometry.h>

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <numeric>

namespace candela::python {

template <>
const Record<ImportNote>& recordOf<ImportNote>() {
    static const Record<ImportNote> record =
        Record<ImportNote>("ImportNote")
            .field("kind", &ImportNote::kind, "What it tells.")
            .field("text", &ImportNote::text, "One line, which names no element.")
            .field("elements", &ImportNote::elements, "Such as \"mesh 3 'wheel'\".")
            .field("count", &ImportNote::count, "The number of elements, or how often the note was made.");
    return record;
}

template <>
const Record<SceneInfo>& recordOf<SceneInfo>() {
    static const Record<SceneInfo> record =
        Record<SceneInfo>("SceneInfo")
            .field("up_axis", &SceneInfo::upAxis, "The axis of the file that points up.")
            .field("metres_per_unit", &SceneInfo::metresPerUnit, "Of the file, over 0.")
            .field("generator", &SceneInfo::generator, "The program that wrote it; empty: unknown.")
            .field("copyright", &SceneInfo::copyright, "To whom it belongs; empty: unknown.");
    return record;
}

Scene& SceneData::edit() {
    if (readers > 0)
        throw Error(ErrorKind::badInput, "",
                    "the scene is changed while another thread uploads it or reads it");
    ++version;
    return scene;
}

namespace {

// Edges of 40 degrees and more stay sharp.
constexpr float defaultCreaseAngle = 0.698f;

/// What `add_mesh` is given.
struct MeshArguments {
    Element<Mesh> mesh{nullptr, 0, std::make_shared<Mesh>()};
    Node node;
    nb::object material = nb::none();
    Topology topology = Topology::triangles;
    std::optional<float> creaseAngle;
};

void readArgument(MeshArguments& arguments, const std::string& name, nb::handle value) {
    if (value.is_none()) return;
    if (name == "material")
        arguments.material = nb::borrow(value);
    else if (name == "topology")
        arguments.topology = Convert<Topology>::from(value, name);
    else if (name == "crease_angle")
        arguments.creaseAngle = Convert<float>::from(value, name);
    else if (name == "matrix" || name == "parent" || name == "casts_shadow")
        recordOf<Node>().set(arguments.node, name, value);
    else
        recordOf<Mesh>().set(*arguments.mesh.own, name == "uvs" ? "uv0" : name, value);
}

// The positions of the first argument with the indices of the second, or a whole mesh.
void readGeometry(MeshArguments& arguments, nb::handle positions, nb::handle indices) {
    Mesh& mesh = *arguments.mesh.own;
    if (nb::isinstance<Element<Mesh>>(positions)) {
        mesh = nb::cast<Element<Mesh>&>(positions).read();
        if (!indices.is_none())
            failConversion("add_mesh", "no indices beside a Mesh, which has its own", indices);
        return;
    }
    recordOf<Mesh>().set(mesh, "positions", positions);
    if (!indices.is_none()) return recordOf<Mesh>().set(mesh, "indices", indices);
    mesh.indices.resize(mesh.positions.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

void completeMesh(MeshArguments& arguments, bool isWhole) {
    Mesh& mesh = *arguments.mesh.own;
    if (!isWhole || mesh.submeshes.empty()) {
        Submesh submesh;
        submesh.topology = arguments.topology;
        submesh.indexCount = static_cast<std::uint32_t>(mesh.indices.size());
        mesh.submeshes = {submesh};
    }
    const bool areTriangles = mesh.submeshes.front().topology == Topology::triangles;
    if (areTriangles && (mesh.normals.empty() || (isWhole && arguments.creaseAngle)))
        computeNormals(mesh, arguments.creaseAngle.value_or(defaultCreaseAngle));
    else if (mesh.normals.empty())
        mesh.normals.resize(mesh.positions.size(), glm::vec3(0.0f));
}

Element<Node> addMesh(SceneHandle& self, nb::handle positions, nb::handle indices,
                      const nb::kwargs& options) {
    MeshArguments arguments;
    readGeometry(arguments, positions, indices);
    for (const auto& [name, value] : options) readArgument(arguments, nb::str(name).c_str(), value);
    completeMesh(arguments, nb::isinstance<Element<Mesh>>(positions));
    Mesh& mesh = *arguments.mesh.own;
    if (!arguments.material.is_none()) {
        const std::optional<std::uint32_t> material = materialIndex(self, arguments.material);
        for (Submesh& submesh : mesh.submeshes) submesh.material = material;
    }
    Node& node = arguments.node;
    node.name = mesh.name;
    node.mesh = static_cast<std::uint32_t>(ElementList<Mesh>(self.data).append(arguments.mesh));
    self.data->edit().nodes.push_back(std::move(node));
    return {self.data, self.data->scene.nodes.size() - 1, nullptr};
}

SceneHandle importNamed(const std::string& uri, const std::optional<PluginRegistry>& plugins, bool strict,
                        nb::object progress) {
    SceneHandle handle;
    ImportOptions options;
    options.strictness = strict ? Strictness::strict : Strictness::tolerant;
    options.progress = [&](double share) {
        const nb::gil_scoped_acquire acquire;
        if (PyErr_CheckSignals() != 0) throw nb::python_error();
        return progress.is_none() || !progress(share).is(Py_False);
    };
    const PluginRegistry& registry = plugins ? *plugins : defaultPlugins();
    ImportedScene imported;
    {
        const nb::gil_scoped_release release;
        imported = importScene(registry, uri, options);
    }
    handle.data->scene = std::move(imported.scene);
    handle.data->notes = std::move(imported.report.notes);
    handle.data->plugin = std::move(imported.report.plugin);
    handle.data->info = std::move(imported.report.info);
    handle.data->source = uri;
    return handle;
}

nb::object boxOf(const Bounds& box) {
    if (box.empty()) return nb::none();
    const std::array<float, 6> corners{box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
    return frozenArray(corners, {2, 3});
}

template <typename T>
void list(nb::class_<SceneHandle>& cls, const char* name, const char* doc) {
    const std::string type = recordOf<T>().name();
    const char* getter = kept(std::string("def ") + name + "(self) -> " + type + "List");
    const char* setter =
        kept(std::string("def ") + name + "(self, value: typing.Iterable[" + type + "], /) -> None");
    cls.def_prop_rw(
        name, [](const SceneHandle& self) { return ElementList<T>(self.data); },
        [name](SceneHandle& self, nb::iterable elements) {
            const nb::list all(elements);
            std::vector<T> values;
            for (const nb::handle each : all) values.push_back(elementFrom<T>(each, name).read());
            listOf(self.data->edit(), static_cast<const T*>(nullptr)) = std::move(values);
        },
        nb::for_getter(nb::sig(getter)), nb::for_setter(nb::sig(setter)), doc);
}

void bindQuestions(nb::class_<SceneHandle>& cls) {
    cls.def(
           "validate",
           [](SceneHandle& self) {
               const SceneReader reader(*self.data);
               const nb::gil_scoped_release release;
               validate(self.data->scene);
           },
           "Raises InputError, naming the element, when the scene breaks a rule. Uploading does the same.")
        .def(
            "world_transforms",
            [](const SceneHandle& self, double time) {
                return Convert<std::vector<glm::mat4>>::to(worldTransforms(self.data->scene, time));
            },
            nb::arg("time") = 0.0,
            nb::sig("def world_transforms(self, time: float = 0.0) -> numpy.typing.NDArray[numpy.float32]"),
            "World matrices of all nodes, (N, 4, 4); animated nodes as at `time`, seconds.")
        .def(
            "bounds",
            [](const SceneHandle& self, double time) {
                return boxOf(worldBounds(self.data->scene, worldTransforms(self.data->scene, time), time));
            },
            nb::arg("time") = 0.0,
            nb::sig("def bounds(self, time: float = 0.0) -> numpy.typing.NDArray[numpy.float32] | None"),
            "The least and the largest corner of the box around everything, world space, metres, (2, 3); "
            "None of an empty scene.")
        .def(
            "node_bounds",
            [](const SceneHandle& self, std::uint32_t node, double time) {
                return boxOf(
                    nodeBounds(self.data->scene, node, worldTransforms(self.data->scene, time), time));
            },
            nb::arg("node"), nb::arg("time") = 0.0,
            nb::sig("def node_bounds(self, node: int, time: float = 0.0) -> "
                    "numpy.typing.NDArray[numpy.float32] | None"),
            "The same of what one node shows itself.")
        .def(
            "view",
            [](const SceneHandle& self, nb::object camera, double time, float aspect) {
                const Scene& scene = self.data->scene;
                return viewOf(scene, cameraFrom(scene, camera), time, aspect,
                              [&] { return framedBox(scene); });
            },
            nb::arg("camera") = nb::none(), nb::arg("time") = 0.0, nb::arg("aspect") = 16.0f / 9.0f,
            nb::sig("def view(self, camera: int | str | None = None, time: float = 0.0, aspect: float = "
                    "16 / 9) -> CameraView"),
            "The view of a camera of the scene, by index or name. None: the first camera, or a view that "
            "shows the whole scene where it has none; `aspect` is width over height.")
        .def(
            "has_light", [](const SceneHandle& self) { return hasLight(self.data->scene); },
            "Whether the scene brings light: lights, an environment, or materials that emit.")
        .def(
            "triangle_count", [](const SceneHandle& self) { return triangleCount(self.data->scene); },
            "The triangles that its meshes draw, times the nodes that show them.");
}

void bindChanges(nb::class_<SceneHandle>& cls) {
    cls.def("add_mesh", &addMesh, nb::arg("positions"), nb::arg("indices") = nb::none(), nb::arg("options"),
            nb::sig("def add_mesh(self, positions: numpy.typing.ArrayLike | Mesh, indices: "
                    "numpy.typing.ArrayLike | None = None, *, normals: numpy.typing.ArrayLike | None = None, "
                    "crease_angle: float | None = None, uvs: numpy.typing.ArrayLike | None = None, colors: "
                    "numpy.typing.ArrayLike | None = None, tangents: numpy.typing.ArrayLike | None = None, "
                    "material: Material | int | None = None, matrix: numpy.typing.ArrayLike = ..., parent: "
                    "int | None = None, casts_shadow: bool = True, topology: typing.Literal['triangles', "
                    "'lines', 'points'] = 'triangles', name: str = '') -> Node"),
            "Adds a mesh from arrays, or a Mesh, and a node that shows it, which is returned.\n\n"
            "positions: (N, 3), metres, or a Mesh, such as `Mesh.sphere()`. indices: (M, 3) of triangles, "
            "(M, 2) of lines, (M,) of points; None: vertices in their order. normals: (N, 3); without them "
            "triangles get those of `compute_normals` with crease_angle, radians: 0 is flat, pi smooth, None "
            "0.698 (40 degrees). uvs: (N, 2). colors: (N, 3) or (N, 4), linear. material: a Material, which "
            "is appended to the scene, or the index of one. matrix: (4, 4), the node's local transform.")
        .def(
            "add_lights",
            [](SceneHandle& self, nb::object positions, const nb::kwargs& options) {
                const LightArrays arrays(positions, options);
                std::vector<Light>& lights = self.data->edit().lights;
                lights.reserve(lights.size() + arrays.size());
                for (std::size_t i = 0; i < arrays.size(); ++i) lights.push_back(arrays.light(i));
            },
            nb::arg("positions").none(), nb::arg("options"),
            nb::sig(kept(std::string("def add_lights(self, positions: numpy.typing.ArrayLike | None") +
                         LightArrays::keywords() + ") -> None")),
            "Adds many lights in the world's frame.\n\n"
            "positions: (N, 3), metres; None for directional lights. color: linear Rec.709, (3,) or (N, 3). "
            "intensity: candela (directional: lux), a number or (N,). range: metres, a number, (N,) or None: "
            "as far as "
            "it matters. radius: metres, of the sphere that emits. direction: (3,) or (N, 3). Cone angles in "
            "radians.")
        .def(
            "scatter_lights",
            [](SceneHandle& self, std::uint32_t count, std::optional<float> range,
               std::optional<float> intensity, std::uint32_t seed) {
                scatterLights(self.data->edit(), {count, range, intensity, seed});
            },
            nb::arg("count"), nb::arg("range") = nb::none(), nb::arg("intensity") = nb::none(),
            nb::arg("seed") = 1,
            "Adds point lights of saturated colours over the surfaces. range: metres, None: twice their mean "
            "spacing; intensity: candela each, None: range squared / 10.")
        .def(
            "pose_properties",
            [](SceneHandle& self, double time) { poseProperties(self.data->edit(), time); }, nb::arg("time"),
            "Sets animated properties of nodes, materials, lights and cameras as at `time`, seconds.");
}

}  // namespace

void bindScenes(nb::module_& module) {
    bindValue<ImportNote>(module, "What an import did with one or more elements of a file.")
        .def("__str__", [](const ImportNote& note) { return note.line(); });

    bindValue<SceneInfo>(
        module, "What a file says of its scene as a whole. The Scene itself is in metres with +Y up.");

    nb::class_<SceneHandle> cls(
        module, "Scene",
        "A scene as plain values; elements refer to each other by index. Metres, right-handed, "
        "+Y up. Nothing of it is on a device: `Renderer.upload` copies it there.");
    cls.def(nb::init<>(), "An empty scene.");
    list<Image>(cls, "images", "Pictures that materials refer to.");
    list<Material>(cls, "materials", "Materials of submeshes.");
    list<Mesh>(cls, "meshes", "Meshes that nodes show.");
    list<Cage>(cls, "cages", "Subdivision cages that nodes show.");
    list<Skin>(cls, "skins", "Joints that move meshes and cages.");
    list<Node>(cls, "nodes", "The hierarchy; parents precede children.");
    list<Camera>(cls, "cameras", "Cameras of the scene.");
    list<Light>(cls, "lights", "Lights of the scene; `add_lights` adds many.");
    list<Animation>(cls, "animations", "What moves with time.");
    cls.def_prop_rw(
           "environment",
           [](const SceneHandle& self) {
               return Convert<std::optional<Environment>>::to(self.data->scene.environment);
           },
           [](SceneHandle& self, nb::object value) {
               self.data->edit().environment =
                   Convert<std::optional<Environment>>::from(value, "Scene.environment");
           },
           nb::for_getter(nb::sig("def environment(self) -> Environment | None")),
           nb::for_setter(nb::sig("def environment(self, value: Environment | None, /) -> None")),
           nb::arg("value").none(), "Light from everywhere; None: none.")
        .def_prop_rw(
            "origin",
            [](const SceneHandle& self) { return Convert<glm::dvec3>::to(self.data->scene.origin); },
            [](SceneHandle& self, nb::object value) {
                self.data->edit().origin = Convert<glm::dvec3>::from(value, "Scene.origin");
            },
            nb::for_getter(nb::sig("def origin(self) -> numpy.typing.NDArray[numpy.float64]")),
            nb::for_setter(nb::sig("def origin(self, value: numpy.typing.ArrayLike, /) -> None")),
            "Where world space lies in the space of the file, metres, (3,).")
        .def_prop_ro(
            "notes",
            [](const SceneHandle& self) { return Convert<std::vector<ImportNote>>::to(self.data->notes); },
            nb::sig("def notes(self) -> tuple[ImportNote, ...]"), "What the import noted, losses first.")
        .def_prop_ro(
            "info", [](const SceneHandle& self) { return nb::cast(self.data->info); },
            nb::sig("def info(self) -> SceneInfo"), "What the file says of the scene as a whole.")
        .def_prop_ro(
            "source", [](const SceneHandle& self) { return self.data->source; },
            "The URI that it was imported from; empty for a scene that was built.")
        .def_prop_ro(
            "plugin", [](const SceneHandle& self) { return self.data->plugin; }, "The plugin that read it.")
        .def(
            "copy",
            [](const SceneHandle& self) {
                return SceneHandle{std::make_shared<SceneData>(SceneData{self.data->scene, self.data->notes,
                                                                         self.data->plugin, self.data->source,
                                                                         self.data->info})};
            },
            "An independent copy.")
        .def("__repr__", [](const SceneHandle& self) {
            const Scene& scene = self.data->scene;
            return "<Scene " + self.data->source + (self.data->source.empty() ? "" : ": ") +
                   std::to_string(scene.nodes.size()) + " nodes, " + std::to_string(scene.meshes.size()) +
                   " meshes, " + std::to_string(scene.materials.size()) + " materials, " +
                   std::to_string(scene.lights.size()) + " lights, " + std::to_string(scene.cameras.size()) +
                   " cameras>";
        });
    bindQuestions(cls);
    bindChanges(cls);
    bindVariants(cls);
    module.def(
        "import_scene", &importNamed, nb::arg("uri"), nb::arg("plugins") = nb::none(),
        nb::arg("strict") = false, nb::arg("progress") = nb::none(),
        nb::sig("def import_scene(uri: str, plugins: PluginRegistry | None = None, strict: bool = False, "
                "progress: typing.Callable[[float], object] | None = None) -> Scene"),
        "Reads a scene as the file has it; `candela.load` is the way with warnings.");
}

}  // namespace candela::python
