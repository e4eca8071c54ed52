#include "module.h"
#include "scene_types.h"
#include "words.h"

#include <candela/default_lights.h>

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <glm/geometric.hpp>

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

Scene& SceneData::edit() {
    if (readers > 0)
        throw Error(ErrorKind::badInput, "",
                    "the scene is changed while another thread uploads it or reads it");
    ++version;
    return scene;
}

namespace {

/// Normals for a mesh of triangles that has none: of a face each, or smooth ones.
void addNormals(Mesh& mesh, bool smooth) {
    if (!smooth) {
        Mesh flat;
        for (const std::uint32_t index : mesh.indices) {
            if (index >= mesh.positions.size()) return;
            flat.positions.push_back(mesh.positions[index]);
            if (index < mesh.uv0.size()) flat.uv0.push_back(mesh.uv0[index]);
            if (index < mesh.colors.size()) flat.colors.push_back(mesh.colors[index]);
            flat.indices.push_back(static_cast<std::uint32_t>(flat.indices.size()));
        }
        mesh.positions = std::move(flat.positions);
        mesh.uv0 = std::move(flat.uv0);
        mesh.colors = std::move(flat.colors);
        mesh.indices = std::move(flat.indices);
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* corner = &mesh.indices[i];
        if (std::max({corner[0], corner[1], corner[2]}) >= mesh.positions.size()) return;
        const glm::vec3 a = mesh.positions[corner[0]];
        const glm::vec3 area = glm::cross(mesh.positions[corner[1]] - a, mesh.positions[corner[2]] - a);
        for (int k = 0; k < 3; ++k) mesh.normals[corner[k]] += area;
    }
    for (glm::vec3& normal : mesh.normals) {
        const float length = glm::length(normal);
        normal = length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

/// Index of the material that `add_mesh` was given.
std::optional<std::uint32_t> materialIndex(SceneHandle& self, nb::handle material) {
    if (material.is_none()) return std::nullopt;
    if (!nb::isinstance<Element<Material>>(material))
        return Convert<std::uint32_t>::from(material, "material");
    auto& element = nb::cast<Element<Material>&>(material);
    if (!element.own && element.scene == self.data) return static_cast<std::uint32_t>(element.index);
    return static_cast<std::uint32_t>(ElementList<Material>(self.data).append(element));
}

Element<Node> addMesh(SceneHandle& self, nb::handle positions, nb::handle indices,
                      const nb::kwargs& options) {
    Element<Mesh> mesh{nullptr, 0, std::make_shared<Mesh>()};
    Node node;
    Submesh submesh;
    nb::object material = nb::none();
    bool smooth = true;
    const Record<Mesh>& record = recordOf<Mesh>();
    record.set(*mesh.own, "positions", positions);
    for (const auto& [key, value] : options) {
        const std::string name = nb::str(key).c_str();
        if (value.is_none()) continue;
        if (name == "material")
            material = nb::borrow(value);
        else if (name == "topology")
            submesh.topology = Convert<Topology>::from(value, "topology");
        else if (name == "smooth")
            smooth = Convert<bool>::from(value, "smooth");
        else if (name == "uvs")
            record.set(*mesh.own, "uv0", value);
        else if (name == "matrix" || name == "parent" || name == "casts_shadow")
            recordOf<Node>().set(node, name, value);
        else
            record.set(*mesh.own, name, value);
    }
    if (!indices.is_none()) {
        record.set(*mesh.own, "indices", indices);
    } else {
        for (std::uint32_t i = 0; i < mesh.own->positions.size(); ++i) mesh.own->indices.push_back(i);
    }
    if (mesh.own->normals.empty() && submesh.topology == Topology::triangles) addNormals(*mesh.own, smooth);
    if (mesh.own->normals.empty()) mesh.own->normals.resize(mesh.own->positions.size(), glm::vec3(0.0f));
    submesh.indexCount = static_cast<std::uint32_t>(mesh.own->indices.size());
    submesh.material = materialIndex(self, material);
    mesh.own->submeshes = {submesh};
    node.name = mesh.own->name;
    node.mesh = static_cast<std::uint32_t>(ElementList<Mesh>(self.data).append(mesh));
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
            "None of an "
            "empty scene.")
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
                return resolveView(self.data->scene, camera, time, aspect,
                                   [&] { return framedBox(self.data->scene); });
            },
            nb::arg("camera") = nb::none(), nb::arg("time") = 0.0, nb::arg("aspect") = 16.0f / 9.0f,
            nb::sig("def view(self, camera: CameraView | int | str | None = None, time: float = 0.0, aspect: "
                    "float = "
                    "16 / 9) -> CameraView"),
            "The view of a camera of the scene, by index or name. None: the first camera, or a view that "
            "shows the "
            "whole scene where it has none; `aspect` is width over height.")
        .def(
            "has_light", [](const SceneHandle& self) { return hasLight(self.data->scene); },
            "Whether the scene brings light: lights, an environment, or materials that emit.")
        .def(
            "triangle_count", [](const SceneHandle& self) { return triangleCount(self.data->scene); },
            "The triangles that its meshes draw, times the nodes that show them.");
}

void bindChanges(nb::class_<SceneHandle>& cls) {
    cls.def("add_mesh", &addMesh, nb::arg("positions"), nb::arg("indices") = nb::none(), nb::arg("options"),
            nb::sig("def add_mesh(self, positions: numpy.typing.ArrayLike, indices: numpy.typing.ArrayLike | "
                    "None = "
                    "None, *, normals: numpy.typing.ArrayLike | None = None, smooth: bool = True, uvs: "
                    "numpy.typing.ArrayLike | None = None, colors: numpy.typing.ArrayLike | None = None, "
                    "tangents: "
                    "numpy.typing.ArrayLike | None = None, material: Material | int | None = None, matrix: "
                    "numpy.typing.ArrayLike = ..., parent: int | None = None, casts_shadow: bool = True, "
                    "topology: "
                    "typing.Literal['triangles', 'lines', 'points'] = 'triangles', name: str = '') -> Node"),
            "Adds a mesh from arrays and a node that shows it, which is returned.\n\n"
            "positions: (N, 3), metres. indices: (M, 3) of triangles, (M, 2) of lines, (M,) of points; None: "
            "vertices "
            "in their order. normals: (N, 3); without them triangles get smooth ones, or with `smooth=False` "
            "flat "
            "ones. uvs: (N, 2). colors: (N, 3) or (N, 4), linear. material: a Material, which is appended to "
            "the "
            "scene, or the index of one. matrix: (4, 4), the node's local transform.")
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
            "intensity: "
            "candela (directional: lux), a number or (N,). range: metres, a number, (N,) or None: as far as "
            "it matters. "
            "radius: metres, of the sphere that emits. direction: (3,) or (N, 3). Cone angles in radians.")
        .def(
            "scatter_lights",
            [](SceneHandle& self, std::uint32_t count, std::optional<float> range,
               std::optional<float> intensity, std::uint32_t seed) {
                scatterLights(self.data->edit(), {count, range, intensity, seed});
            },
            nb::arg("count"), nb::arg("range") = nb::none(), nb::arg("intensity") = nb::none(),
            nb::arg("seed") = 1,
            "Adds point lights of saturated colours over the surfaces. range: metres, None: twice their mean "
            "spacing; "
            "intensity: candela each, None: range squared / 10.")
        .def(
            "select_variant",
            [](SceneHandle& self, nb::object variant) {
                Scene& scene = self.data->edit();
                if (!nb::isinstance<nb::str>(variant))
                    return selectVariant(scene,
                                         Convert<std::optional<std::uint32_t>>::from(variant, "variant"));
                const std::string name = nb::str(variant).c_str();
                const auto found = std::ranges::find(scene.variants, name);
                if (found == scene.variants.end())
                    throw Error(ErrorKind::badInput, self.data->source, "there is no variant '" + name + "'");
                selectVariant(scene, static_cast<std::uint32_t>(found - scene.variants.begin()));
            },
            nb::arg("variant").none(), nb::sig("def select_variant(self, variant: int | str | None) -> None"),
            "Gives submeshes the materials of a variant, by index or name; None: those without a variant.")
        .def(
            "pose_properties",
            [](SceneHandle& self, double time) { poseProperties(self.data->edit(), time); }, nb::arg("time"),
            "Sets animated properties of nodes, materials, lights and cameras as at `time`, seconds.");
}

}  // namespace

void bindScenes(nb::module_& module) {
    bindValue<ImportNote>(module, "What an import did with one or more elements of a file.")
        .def("__str__", [](const ImportNote& note) { return note.line(); });

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
            "variants",
            [](const SceneHandle& self) {
                return Convert<std::vector<std::string>>::to(self.data->scene.variants);
            },
            nb::sig("def variants(self) -> tuple[str, ...]"), "Names of the looks of `select_variant`.")
        .def_prop_ro(
            "notes",
            [](const SceneHandle& self) { return Convert<std::vector<ImportNote>>::to(self.data->notes); },
            nb::sig("def notes(self) -> tuple[ImportNote, ...]"), "What the import noted, losses first.")
        .def_prop_ro(
            "source", [](const SceneHandle& self) { return self.data->source; },
            "The URI that it was imported from; empty for a scene that was built.")
        .def_prop_ro(
            "plugin", [](const SceneHandle& self) { return self.data->plugin; }, "The plugin that read it.")
        .def(
            "copy",
            [](const SceneHandle& self) {
                return SceneHandle{std::make_shared<SceneData>(
                    SceneData{self.data->scene, self.data->notes, self.data->plugin, self.data->source})};
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
    module.def(
        "import_scene", &importNamed, nb::arg("uri"), nb::arg("plugins") = nb::none(),
        nb::arg("strict") = false, nb::arg("progress") = nb::none(),
        nb::sig("def import_scene(uri: str, plugins: PluginRegistry | None = None, strict: bool = False, "
                "progress: typing.Callable[[float], object] | None = None) -> Scene"),
        "Reads a scene as the file has it; `candela.load` is the way with warnings.");
}

}  // namespace candela::python
