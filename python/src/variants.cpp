#include "module.h"
#include "scene_types.h"

#include <algorithm>

namespace candela::python {

namespace {

/// What a variant gives another material.
struct Changed {
    std::optional<std::size_t> mesh, cage;  ///< Indices of the scene.
    nb::handle material;
};

template <typename T>
std::size_t indexIn(const ScenePtr& scene, const Element<T>& element) {
    if (element.own || element.scene != scene)
        throw Error(ErrorKind::badInput, "",
                    std::string("add_variant: the ") + recordOf<T>().name() + " is not one of this scene");
    element.read();  // refuses one that is no longer there
    return element.index;
}

Changed changedBy(const ScenePtr& scene, nb::handle key, nb::handle material) {
    if (nb::isinstance<Element<Mesh>>(key))
        return {indexIn(scene, nb::cast<Element<Mesh>&>(key)), std::nullopt, material};
    if (nb::isinstance<Element<Cage>>(key))
        return {std::nullopt, indexIn(scene, nb::cast<Element<Cage>&>(key)), material};
    if (!nb::isinstance<Element<Node>>(key)) failConversion("add_variant", "a Node, a Mesh or a Cage", key);
    const std::size_t index = indexIn(scene, nb::cast<Element<Node>&>(key));
    const Node& node = scene->scene.nodes[index];
    if (!node.mesh && !node.cage)
        throw Error(ErrorKind::badInput, "",
                    "add_variant: node " + std::to_string(index) + " shows neither a mesh nor a cage");
    return {node.mesh, node.cage, material};
}

/// Every submesh gets the material in the variant; without a variant it has the one that it has now.
void addTo(Mesh& mesh, std::uint32_t variant, std::optional<std::uint32_t> material) {
    if (mesh.submeshes.empty())
        mesh.submeshes.push_back({0, static_cast<std::uint32_t>(mesh.indices.size()), std::nullopt});
    for (std::uint32_t i = 0; i < mesh.submeshes.size(); ++i) {
        const auto isOwn = [i](const VariantMaterial& each) { return each.submesh == i && !each.variant; };
        if (std::ranges::none_of(mesh.variantMaterials, isOwn))
            mesh.variantMaterials.push_back({i, std::nullopt, mesh.submeshes[i].material});
        mesh.variantMaterials.push_back({i, variant, material});
    }
}

void addTo(Cage& cage, std::uint32_t variant, std::optional<std::uint32_t> material) {
    const auto isOwn = [](const CageVariant& each) { return !each.variant; };
    if (std::ranges::none_of(cage.variants, isOwn))
        cage.variants.push_back({std::nullopt, cage.faceMaterials});
    cage.variants.push_back({variant, std::vector(cage.faceSizes.size(), material)});
}

std::uint32_t addVariant(SceneHandle& self, const std::string& name, const nb::dict& materials) {
    std::vector<Changed> all;
    for (const auto& [key, material] : materials) all.push_back(changedBy(self.data, key, material));
    Scene& scene = self.data->edit();
    const auto variant = static_cast<std::uint32_t>(scene.variants.size());
    std::vector<std::optional<std::uint32_t>> indices;
    for (const Changed& changed : all) indices.push_back(materialIndex(self, changed.material));
    scene.variants.push_back(name);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].mesh) addTo(scene.meshes.at(*all[i].mesh), variant, indices[i]);
        if (all[i].cage) addTo(scene.cages.at(*all[i].cage), variant, indices[i]);
    }
    return variant;
}

void select(SceneHandle& self, nb::handle variant) {
    Scene& scene = self.data->edit();
    if (!nb::isinstance<nb::str>(variant))
        return selectVariant(scene, Convert<std::optional<std::uint32_t>>::from(variant, "variant"));
    const std::string name = nb::str(variant).c_str();
    const auto found = std::ranges::find(scene.variants, name);
    if (found == scene.variants.end())
        throw Error(ErrorKind::badInput, self.data->source, "there is no variant '" + name + "'");
    selectVariant(scene, static_cast<std::uint32_t>(found - scene.variants.begin()));
}

}  // namespace

std::optional<std::uint32_t> materialIndex(SceneHandle& scene, nb::handle material) {
    if (material.is_none()) return std::nullopt;
    if (!nb::isinstance<Element<Material>>(material))
        return Convert<std::uint32_t>::from(material, "material");
    auto& element = nb::cast<Element<Material>&>(material);
    if (!element.own && element.scene == scene.data) return static_cast<std::uint32_t>(element.index);
    return static_cast<std::uint32_t>(ElementList<Material>(scene.data).append(element));
}

void bindVariants(nb::class_<SceneHandle>& cls) {
    using Names = Convert<std::vector<std::string>>;
    cls.def_prop_rw(
           "variants", [](const SceneHandle& self) { return Names::to(self.data->scene.variants); },
           [](SceneHandle& self, nb::object names) {
               self.data->edit().variants = Names::from(names, "Scene.variants");
           },
           nb::for_getter(nb::sig("def variants(self) -> tuple[str, ...]")),
           nb::for_setter(nb::sig("def variants(self, value: typing.Iterable[str], /) -> None")),
           "Names of the looks of `select_variant`. `Mesh.variant_materials` and `Cage.variants` refer to "
           "them by index.")
        .def(
            "add_variant",
            [](SceneHandle& self, nb::handle name, const nb::dict& materials) {
                return addVariant(self, Convert<std::string>::from(name, "name"), materials);
            },
            nb::arg("name"), nb::arg("materials") = nb::dict(),
            nb::sig("def add_variant(self, name: str, materials: dict[Node | Mesh | Cage, Material | int | "
                    "None] = {}) -> int"),
            "Adds a look of the scene, in which meshes and cages (or those of nodes) have other materials as "
            "a whole, and returns its index. A Material that belongs to no scene is appended. What is not "
            "named keeps its material. Submeshes one by one: `Mesh.variant_materials`; faces: "
            "`Cage.variants`.")
        .def("select_variant", &select, nb::arg("variant").none(),
             nb::sig("def select_variant(self, variant: int | str | None) -> None"),
             "Gives meshes and cages the materials of a variant, by index or name; None: those without a "
             "variant.");
}

}  // namespace candela::python
