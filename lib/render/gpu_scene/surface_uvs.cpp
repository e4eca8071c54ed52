#include "render/gpu_scene/surface_uvs.h"

#include "scene/validate/error_context.h"

#include <string>

namespace candela {

SurfaceUvs::SurfaceUvs(const Scene& scene) : sets_(scene.materials.size()) {
    for (const Mesh& mesh : scene.meshes) {
        const Sets sets{!mesh.uv0.empty(), !mesh.uv1.empty()};
        for (const Submesh& submesh : mesh.submeshes) {
            if (submesh.material) add(*submesh.material, sets);
        }
    }
    for (const Cage& cage : scene.cages) {
        for (const std::optional<std::uint32_t>& material : cage.faceMaterials) {
            if (material) add(*material, {!cage.uvs.empty(), false});
        }
    }
}

void SurfaceUvs::add(std::uint32_t material, Sets sets) {
    sets_[material].all0 &= sets.all0;
    sets_[material].all1 &= sets.all1;
}

void SurfaceUvs::check(std::uint32_t index, const Material& material) const {
    for (const auto* texture :
         {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
          &material.occlusionTexture, &material.emissionTexture}) {
        if (!*texture) continue;
        const std::uint32_t set = (*texture)->uvSet;
        if (set == 0 ? sets_[index].all0 : sets_[index].all1) continue;
        ErrorContext("material", index, material.name)
            .refuse("a texture reads texture coordinates " + std::to_string(set) +
                    ", which a surface that wears it does not have");
    }
}

}  // namespace candela
