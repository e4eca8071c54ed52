#pragma once

#include "host_material.h"
#include "texture_reader.h"
#include "texture_uses.h"

namespace candela_plugins::gltf {

// KHR_materials_pbrSpecularGlossiness as metallic-roughness: base colour is the diffuse colour, metallic 0,
// the index of refraction infinite, so that the colour of the specular lobe is the reflectance at normal
// incidence, and roughness is 1 minus glossiness.

/// Whether a material has specular-glossiness values.
bool hasSpecularGlossiness(const tinygltf::Material& material);

/// The factor of the glossiness of a material that has it.
float glossinessFactor(const tinygltf::Material& material);

/// Sets the factors and textures of `material`, which has specular-glossiness values. `textures` reads
/// textures, `uses` are those of the material.
void readSpecularGlossiness(const tinygltf::Material& source, const TextureUses& uses,
                            const TextureReader& textures, HostMaterial& material);

}  // namespace candela_plugins::gltf
