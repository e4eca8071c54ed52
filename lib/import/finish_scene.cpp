#include "import/finish_scene.h"

#include "import/abi_reader.h"
#include "scene/geometry/normals.h"
#include "scene/geometry/perpendicular.h"
#include "scene/geometry/tangents.h"

#include <optional>

namespace candela {
namespace {

// The texture coordinates that the mesh's normal textures use, none without such a texture. Where two
// materials of a mesh disagree the first one's count: a vertex has only one tangent.
std::optional<std::uint32_t> normalTextureUvSet(const Scene& scene, const Mesh& mesh) {
    for (const Submesh& submesh : mesh.submeshes) {
        if (!submesh.material) continue;
        const auto& texture = scene.materials[*submesh.material].normalTexture;
        if (texture) return texture->uvSet;
    }
    return std::nullopt;
}

void fillWithPerpendiculars(Mesh& mesh) {
    for (const glm::vec3& normal : mesh.normals)
        mesh.tangents.emplace_back(glm::vec3(anyPerpendicular(glm::dvec3(normal))), 1.0f);
}

void addTangents(const Scene& scene, std::size_t index, Mesh& mesh, std::vector<std::string>& notes) {
    const auto uvSet = normalTextureUvSet(scene, mesh);
    if (!uvSet || !mesh.tangents.empty() || mesh.positions.empty()) return;
    if (!(*uvSet == 0 ? mesh.uv0 : mesh.uv1).empty()) return makeTangents(mesh, *uvSet);
    fillWithPerpendiculars(mesh);
    notes.push_back(joined(AbiReader("mesh", index, mesh.name.c_str()).label(),
                           ": its normal texture shows one texel, for the mesh has no texture coordinates ",
                           *uvSet));
}

}  // namespace

void addMissingAttributes(Scene& scene, std::vector<std::string>& notes) {
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
        Mesh& mesh = scene.meshes[i];
        if (mesh.normals.empty() && !mesh.positions.empty()) makeFlatNormals(mesh);
        addTangents(scene, i, mesh, notes);
    }
}

}  // namespace candela
