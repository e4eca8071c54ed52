#include "import/abi_import.h"

#include "base/runs.h"
#include "import/abi_reader.h"
#include "import/note_list.h"
#include "scene/geometry/axes.h"
#include "scene/geometry/normals.h"
#include "scene/geometry/tangents.h"
#include "scene/geometry/topology.h"
#include "scene/model/uv_sets.h"

#include <candela/scene.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace candela {
namespace {

// For each material whether it is anisotropic, at some time of its animations.
std::vector<bool> anisotropicMaterials(const Scene& scene) {
    std::vector<bool> anisotropic;
    for (const Material& material : scene.materials)
        anisotropic.push_back(material.anisotropy.strength > 0.0f);
    for (const Animation& animation : scene.animations) {
        for (const PropertyChannel& channel : animation.properties) {
            if (channel.property == AnimatedProperty::anisotropyStrength) anisotropic[channel.element] = true;
        }
    }
    return anisotropic;
}

// The texture coordinates along which a material needs tangents; none where it needs no tangents. A normal
// texture decides, and the coordinates 0 where anisotropy has no texture.
std::optional<std::uint32_t> tangentUvSet(const Material& material, bool isAnisotropic) {
    for (const std::optional<Texture>* texture :
         {&material.normalTexture, &material.clearcoat.normalTexture, &material.anisotropy.texture}) {
        if (*texture) return (*texture)->uvSet;
    }
    if (isAnisotropic) return 0;
    return std::nullopt;
}

// The texture coordinates along which a mesh needs tangents. Where two materials of a mesh differ, the first
// one counts: a vertex has only one tangent.
std::optional<std::uint32_t> tangentUvSet(const Scene& scene, const std::vector<bool>& anisotropic,
                                          const Mesh& mesh) {
    const auto setOf = [&](std::optional<std::uint32_t> material) {
        return material ? tangentUvSet(scene.materials[*material], anisotropic[*material]) : std::nullopt;
    };
    for (const Submesh& submesh : mesh.submeshes) {
        if (!isTriangles(submesh)) continue;
        if (const auto set = setOf(submesh.material)) return set;
    }
    for (const VariantMaterial& entry : mesh.variantMaterials) {
        if (!isTriangles(mesh.submeshes[entry.submesh])) continue;
        if (const auto set = setOf(entry.material)) return set;
    }
    return std::nullopt;
}

void fillWithPerpendiculars(Mesh& mesh) {
    for (const glm::vec3& normal : mesh.normals)
        mesh.tangents.emplace_back(
            normal == glm::vec3(0.0f) ? glm::vec3(1, 0, 0) : glm::vec3(anyPerpendicular(glm::dvec3(normal))),
            1.0f);
}

enum class TangentSource { given, uvs, none };

// Gives a mesh the tangents that its materials need. They come from no texture coordinates where it has none.
TangentSource addTangents(const Scene& scene, const std::vector<bool>& anisotropic, Mesh& mesh) {
    const auto uvSet = tangentUvSet(scene, anisotropic, mesh);
    if (!uvSet || !mesh.tangents.empty() || mesh.positions.empty()) return TangentSource::given;
    if (!uvsOf(mesh, *uvSet).empty()) {
        generateTangents(mesh, *uvSet);
        return TangentSource::uvs;
    }
    fillWithPerpendiculars(mesh);
    return TangentSource::none;
}

}  // namespace

void addMissingAttributes(Scene& scene, NoteList& notes) {
    const std::vector<bool> anisotropic = anisotropicMaterials(scene);
    std::vector<TangentSource> tangents(scene.meshes.size());
    const auto sizeOf = [&](std::size_t i) { return scene.meshes[i].indices.size(); };
    forEachElement(scene.meshes.size(), sizeOf, [&](std::size_t i) {
        Mesh& mesh = scene.meshes[i];
        if (mesh.normals.empty() && !mesh.positions.empty()) generateFlatNormals(mesh);
        tangents[i] = addTangents(scene, anisotropic, mesh);
    });
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        if (tangents[i] != TangentSource::none) continue;
        notes.add(NoteKind::missing, AbiReader("mesh", i, scene.meshes[i].name.c_str()).label(),
                  "the directions of its normal texture or anisotropy, for want of texture coordinates");
    }
}

}  // namespace candela
