#include "cage_materials.h"

namespace candela_gltf {

std::int32_t CageMaterials::find(std::int32_t material) {
    if (material < 0) return material;
    const auto index = static_cast<std::size_t>(material);
    if (!materials_.uvSets.at(index)[1]) return material;
    const auto [entry, isNew] = copies_.try_emplace(material);
    if (isNew) {
        candela_material copy = materials_.pushed[index];
        for (candela_texture* texture :
             {&copy.base_color_texture, &copy.metallic_roughness_texture, &copy.normal_texture,
              &copy.occlusion_texture, &copy.emission_texture}) {
            texture->uv_set = 0;
        }
        entry->second = host_.add(copy);
    }
    return entry->second;
}

}  // namespace candela_gltf
