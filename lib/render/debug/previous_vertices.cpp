#include "render/debug/previous_vertices.h"

#include "render/layout.h"

#include <map>

namespace candela {

PreviousVertices::PreviousVertices(GpuScene::State& scene, std::span<const SurfaceId> seen)
    : offsets_(scene.instances.size(), layout::PREVIOUS_NONE) {
    std::vector<bool> isSeen(scene.instances.size());
    for (const SurfaceId& id : seen) {
        if (id.instance != 0) isSeen[id.instance - 1] = true;
    }
    std::map<std::uint32_t, std::int32_t> offsetsOfMeshes;
    for (std::uint32_t i = 0; i < isSeen.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (!isSeen[i] || instance.isRemoved || scene.instances.isNew(i)) continue;
        if (!instance.mesh) {
            add(i, scene.cages.keptPositions(instance.cageInstance), 0);
        } else if (const std::optional<std::uint32_t> deformed = scene.deformations.ofNode(instance.node)) {
            add(i, scene.deformations.keptPositions(*deformed), 0);
        } else if (const SceneUpdate::MeshVertices* moved = scene.keptVertices(*instance.mesh)) {
            // All nodes that show the mesh have its vertices.
            const auto [offset, isNew] = offsetsOfMeshes.try_emplace(*instance.mesh);
            if (isNew) {
                add(i, moved->positions, scene.meshes.places()[*instance.mesh].baseVertex);
                offset->second = offsets_[i];
            }
            offsets_[i] = offset->second;
        }
    }
}

void PreviousVertices::add(std::uint32_t instance, const std::vector<glm::vec3>& positions,
                           std::int32_t baseVertex) {
    if (positions.empty()) return;
    offsets_[instance] = static_cast<std::int32_t>(vertices_.size()) - baseVertex;
    for (const glm::vec3& position : positions) vertices_.emplace_back(position, 1.0f);
}

void PreviousVertices::bind() {
    vertexTexture_ = gl::BufferTexture(GL_RGBA32F, "previous vertices");
    vertexTexture_.upload(std::span<const glm::vec4>(vertices_));
    offsetTexture_ = gl::BufferTexture(GL_R32UI, "offsets of previous vertices");
    offsetTexture_.upload(std::span<const std::int32_t>(offsets_));
    glBindTextureUnit(layout::PREVIOUS_VERTICES_UNIT, vertexTexture_.name());
    glBindTextureUnit(layout::PREVIOUS_OFFSETS_UNIT, offsetTexture_.name());
}

}  // namespace candela
