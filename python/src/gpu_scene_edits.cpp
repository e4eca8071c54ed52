#include "gpu_scene.h"

#include "module.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

namespace candela::python {

namespace {

using Self = const GpuSceneHandle&;

/// An element by its index in the uploaded scene, by the element itself, or by the handle that adding
/// returned.
template <typename T>
Handle<T> handleFrom(nb::handle value) {
    if (nb::isinstance<Handle<T>>(value)) return nb::cast<Handle<T>>(value);
    if (nb::isinstance<Element<T>>(value)) {
        const auto& element = nb::cast<Element<T>&>(value);
        if (!element.own) return static_cast<std::uint32_t>(element.index);
    }
    const std::string name = recordOf<T>().name();
    if (!PyIndex_Check(value.ptr()))
        failConversion("GpuScene", "an index or a " + name + "Handle, or a " + name + " of the scene", value);
    return Convert<std::uint32_t>::from(value, name);
}

template <typename T>
void bindHandle(nb::module_& module) {
    const std::string element = recordOf<T>().name();
    nb::class_<Handle<T>>(module, kept(element + "Handle"),
                          kept("A " + element +
                               " that was added to a GpuScene. After its removal it is stale, "
                               "and its use an InputError."))
        .def_ro("index", &Handle<T>::index, "By which elements that are added refer to it.")
        .def_ro("generation", &Handle<T>::generation, "Grows when a place is given to another element.")
        .def("__repr__", [element](const Handle<T>& self) {
            return "<" + element + "Handle " + std::to_string(self.index) + ">";
        });
}

/// Signatures of edits of one element: "def NAME(self, node: NodeHandle | Node | int, ARGUMENTS) -> RESULT".
template <typename T>
nb::sig signature(const char* name, const std::string& arguments, const char* result = "None") {
    const std::string element = recordOf<T>().name();
    std::string argument = element;
    argument[0] = static_cast<char>(std::tolower(argument[0]));
    return nb::sig(kept(std::string("def ") + name + "(self, " + argument + ": " + element + "Handle | " +
                        element + " | int" + arguments + ") -> " + result));
}

/// Adds, replaces and removes elements of a type: `add(GpuScene&, const T&)` and the like.
template <typename T, typename Add>
void bindAdd(nb::class_<GpuSceneHandle>& cls, const char* name, Add add, const char* doc) {
    const std::string element = recordOf<T>().name();
    cls.def(
        name,
        [add](Self self, const Element<T>& added) {
            const T value = added.read();  // Python may change the element meanwhile.
            Handle<T> handle;
            edited(self, [&](GpuScene& scene) { handle = add(scene, value); });
            return handle;
        },
        nb::arg("element"),
        nb::sig(
            kept(std::string("def ") + name + "(self, element: " + element + ") -> " + element + "Handle")),
        doc);
}

template <typename T, typename Remove>
void bindRemove(nb::class_<GpuSceneHandle>& cls, const char* name, Remove remove, const char* doc) {
    cls.def(
        name,
        [remove](Self self, nb::handle element) {
            const Handle<T> handle = handleFrom<T>(element);
            edited(self, [&](GpuScene& scene) { remove(scene, handle); });
        },
        nb::arg("element"), signature<T>(name, ""), doc);
}

template <typename T, typename Replace>
void bindReplace(nb::class_<GpuSceneHandle>& cls, const char* name, Replace replace, const char* doc) {
    cls.def(
        name,
        [replace](Self self, nb::handle element, const Element<T>& value) {
            const Handle<T> handle = handleFrom<T>(element);
            const T read = value.read();
            edited(self, [&](GpuScene& scene) { replace(scene, handle, read); });
        },
        nb::arg("element"), nb::arg("value"),
        signature<T>(name, kept(std::string(", value: ") + recordOf<T>().name())), doc);
}

std::vector<NodeHandle> nodesFrom(nb::handle nodes) {
    std::vector<NodeHandle> handles;
    if (!nb::hasattr(nodes, "__iter__")) failConversion("nodes", "a sequence of nodes", nodes);
    for (const nb::handle node : nodes) handles.push_back(handleFrom<Node>(node));
    return handles;
}

void setTransforms(Self self, nb::handle nodes, nb::handle matrices) {
    const std::vector<NodeHandle> handles = nodesFrom(nodes);
    const nb::object rows = nb::module_::import_("numpy").attr("asarray")(matrices).attr("reshape")(-1, 4);
    const std::vector<float> numbers = floatsFrom(rows, 4, "matrices");
    if (numbers.size() != 16 * handles.size())
        failConversion("matrices", "(" + std::to_string(handles.size()) + ", 4, 4), one for each node",
                       matrices);
    std::vector<GpuScene::NodeTransform> transforms(handles.size());
    for (std::size_t i = 0; i < handles.size(); ++i) {
        glm::mat4 matrix;
        std::memcpy(&matrix[0][0], &numbers[16 * i], sizeof(matrix));
        transforms[i] = {handles[i], glm::transpose(matrix)};
    }
    edited(self, [&](GpuScene& scene) { scene.setTransforms(transforms); });
}

void setVisibilities(Self self, nb::handle nodes, nb::handle visible) {
    const std::vector<NodeHandle> handles = nodesFrom(nodes);
    std::vector<GpuScene::NodeVisibility> visibilities;
    const nb::list shown(
        nb::module_::import_("numpy").attr("asarray")(visible, nb::arg("dtype") = "bool").attr("tolist")());
    if (shown.size() != handles.size())
        failConversion("visible", std::to_string(handles.size()) + " values, one for each node", visible);
    for (std::size_t i = 0; i < handles.size(); ++i)
        visibilities.push_back({handles[i], Convert<bool>::from(shown[i], "visible")
                                                ? GpuScene::Visibility::shown
                                                : GpuScene::Visibility::hidden});
    edited(self, [&](GpuScene& scene) { scene.setVisibilities(visibilities); });
}

void bindNodes(nb::class_<GpuSceneHandle>& cls) {
    cls.def(
           "set_transform",
           [](Self self, nb::handle node, nb::handle matrix) {
               const NodeHandle handle = handleFrom<Node>(node);
               const glm::mat4 local = Convert<glm::mat4>::from(matrix, "matrix");
               edited(self, [&](GpuScene& scene) { scene.setTransform(handle, local); });
           },
           nb::arg("node"), nb::arg("matrix"),
           signature<Node>("set_transform", ", matrix: numpy.typing.ArrayLike"),
           "Sets a node's local matrix, (4, 4), which moves the node and all below it.")
        .def("set_transforms", &setTransforms, nb::arg("nodes"), nb::arg("matrices"),
             nb::sig("def set_transforms(self, nodes: typing.Iterable[NodeHandle | Node | int], matrices: "
                     "numpy.typing.ArrayLike) -> None"),
             "The same of many nodes: matrices (N, 4, 4).")
        .def(
            "set_visible",
            [](Self self, nb::handle node, bool visible) {
                const NodeHandle handle = handleFrom<Node>(node);
                const auto visibility = visible ? GpuScene::Visibility::shown : GpuScene::Visibility::hidden;
                edited(self, [&](GpuScene& scene) { scene.setVisibility(handle, visibility); });
            },
            nb::arg("node"), nb::arg("visible"), signature<Node>("set_visible", ", visible: bool"),
            "Shows or hides what the node itself shows.")
        .def("set_visibilities", &setVisibilities, nb::arg("nodes"), nb::arg("visible"),
             nb::sig("def set_visibilities(self, nodes: typing.Iterable[NodeHandle | Node | int], visible: "
                     "numpy.typing.ArrayLike) -> None"),
             "The same of many nodes: visible (N,) of bool.")
        .def(
            "set_casts_shadow",
            [](Self self, nb::handle node, bool casts) {
                const NodeHandle handle = handleFrom<Node>(node);
                const auto casting = casts ? GpuScene::ShadowCasting::on : GpuScene::ShadowCasting::off;
                edited(self, [&](GpuScene& scene) { scene.setCastsShadow(handle, casting); });
            },
            nb::arg("node"), nb::arg("casts_shadow"),
            signature<Node>("set_casts_shadow", ", casts_shadow: bool"),
            "Whether what the node itself shows casts shadows.")
        .def(
            "set_cage_points",
            [](Self self, nb::handle node, nb::handle points) {
                const NodeHandle handle = handleFrom<Node>(node);
                const std::vector<glm::vec3> positions = vectorsFrom<3>(points, "points");
                edited(self, [&](GpuScene& scene) { scene.setCagePoints(handle, positions); });
            },
            nb::arg("node"), nb::arg("points"),
            signature<Node>("set_cage_points", ", points: numpy.typing.ArrayLike"),
            "Replaces the points of the cage of a node, (N, 3), metres, in the node's frame.");
    bindAdd<Node>(
        cls, "add_node", [](GpuScene& scene, const Node& node) { return scene.addNode(node); },
        "Adds a node. Its parent, mesh, cage and skin are indices of handles, or those of the uploaded "
        "scene. A mesh may be deformed, a cage may not.");
    bindRemove<Node>(
        cls, "remove_node", [](GpuScene& scene, NodeHandle node) { scene.removeNode(node); },
        "Removes a node, all below it, and their lights.");
}

void bindMeshEdits(nb::class_<GpuSceneHandle>& cls) {
    bindAdd<Mesh>(
        cls, "add_mesh", [](GpuScene& scene, const Mesh& mesh) { return scene.addMesh(mesh); },
        "Uploads a mesh, which nodes that are added later may show.");
    bindReplace<Mesh>(
        cls, "replace_mesh",
        [](GpuScene& scene, MeshHandle handle, const Mesh& mesh) { scene.replaceMesh(handle, mesh); },
        "Replaces a mesh at all nodes that show it.");
    bindRemove<Mesh>(
        cls, "remove_mesh", [](GpuScene& scene, MeshHandle mesh) { scene.removeMesh(mesh); },
        "Removes a mesh that no node shows any more.");
    cls.def(
        "set_positions",
        [](Self self, nb::handle mesh, nb::handle positions, nb::handle normals) {
            const MeshHandle handle = handleFrom<Mesh>(mesh);
            const std::vector<glm::vec3> points = vectorsFrom<3>(positions, "positions");
            std::vector<glm::vec3> directions;
            if (!normals.is_none()) directions = vectorsFrom<3>(normals, "normals");
            edited(self, [&](GpuScene& scene) { scene.setPositions(handle, points, directions); });
        },
        nb::arg("mesh"), nb::arg("positions"), nb::arg("normals") = nb::none(),
        signature<Mesh>("set_positions",
                        ", positions: numpy.typing.ArrayLike, normals: numpy.typing.ArrayLike | None = None"),
        "Moves the vertices of a mesh: positions and normals (N, 3), None: these stay.");
}

void bindCageEdits(nb::class_<GpuSceneHandle>& cls) {
    cls.def(
        "add_cage",
        [](Self self, const Element<Cage>& added) {
            if (!self.data->subdivides) warnPolygons();
            const Cage cage = added.read();  // Python may change the element meanwhile.
            CageHandle handle;
            edited(self, [&](GpuScene& scene) { handle = scene.addCage(cage); });
            return handle;
        },
        nb::arg("element"), nb::sig("def add_cage(self, element: Cage) -> CageHandle"),
        "Adds a subdivision cage, which nodes that are added later may show.");
    bindReplace<Cage>(
        cls, "replace_cage",
        [](GpuScene& scene, CageHandle handle, const Cage& cage) { scene.replaceCage(handle, cage); },
        "Replaces a cage at all nodes that show it; not one that a skin or morph targets deform.");
    bindRemove<Cage>(
        cls, "remove_cage", [](GpuScene& scene, CageHandle cage) { scene.removeCage(cage); },
        "Removes a cage that no node shows any more.");
}

void bindImageEdits(nb::class_<GpuSceneHandle>& cls) {
    bindAdd<Image>(
        cls, "add_image", [](GpuScene& scene, const Image& image) { return scene.addImage(image); },
        "Adds an image, which is uploaded when a material first reads it.");
    bindReplace<Image>(
        cls, "replace_image",
        [](GpuScene& scene, ImageHandle handle, const Image& image) { scene.replaceImage(handle, image); },
        "Replaces an image in all materials.");
    bindRemove<Image>(
        cls, "remove_image", [](GpuScene& scene, ImageHandle image) { scene.removeImage(image); },
        "Removes an image that no material reads any more.");
    cls.def(
        "set_pixels",
        [](Self self, nb::handle image, std::uint32_t x, std::uint32_t y, nb::handle pixels) {
            const ImageHandle handle = handleFrom<Image>(image);
            Image part;
            recordOf<Image>().set(part, "pixels", pixels);
            edited(self, [&](GpuScene& scene) {
                scene.setPixels(handle, {x, y, part.width, part.height}, part.pixels);
            });
        },
        nb::arg("image"), nb::arg("x"), nb::arg("y"), nb::arg("pixels"),
        signature<Image>("set_pixels", ", x: int, y: int, pixels: numpy.typing.NDArray[numpy.generic]"),
        "Replaces texels from column x and row y on, in the type that the image has.");
}

}  // namespace

void bindGpuSceneEdits(nb::module_& module, nb::class_<GpuSceneHandle>& cls) {
    bindHandle<Node>(module);
    bindHandle<Mesh>(module);
    bindHandle<Cage>(module);
    bindHandle<Material>(module);
    bindHandle<Image>(module);
    bindHandle<Light>(module);
    bindNodes(cls);
    bindMeshEdits(cls);
    bindCageEdits(cls);
    bindImageEdits(cls);
    bindAdd<Material>(
        cls, "add_material",
        [](GpuScene& scene, const Material& material) { return scene.addMaterial(material); },
        "Adds a material.");
    bindReplace<Material>(
        cls, "set_material",
        [](GpuScene& scene, MaterialHandle handle, const Material& material) {
            scene.setMaterial(handle, material);
        },
        "Replaces a material, textures included.");
    bindRemove<Material>(
        cls, "remove_material",
        [](GpuScene& scene, MaterialHandle material) { scene.removeMaterial(material); },
        "Removes a material that no mesh or cage has any more.");
    bindAdd<Light>(
        cls, "add_light", [](GpuScene& scene, const Light& light) { return scene.addLight(light); },
        "Adds a light to those of the scene.");
    bindReplace<Light>(
        cls, "set_light",
        [](GpuScene& scene, LightHandle handle, const Light& light) { scene.setLight(handle, light); },
        "Replaces a light of the scene.");
    bindRemove<Light>(
        cls, "remove_light", [](GpuScene& scene, LightHandle light) { scene.removeLight(light); },
        "Removes a light of the scene.");
}

}  // namespace candela::python
