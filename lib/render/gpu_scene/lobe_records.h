#pragma once

#include "render/gpu_scene/gpu_images.h"
#include "render/layout.h"

#include <candela/material.h>

#include <glm/vec4.hpp>

#include <array>
#include <span>

namespace candela {

/// Does a material have more lobes than metallic and roughness describe?
bool isExtended(const Material& material);
/// Does light pass through its surfaces (`Material::transmission`)?
bool transmits(const Material& material);
/// May rays pass through its surfaces: by a mask, by alpha or by transmission?
bool letsLightThrough(const Material& material);

/// The textures of these lobes, in the order of shaders/lib/extended_material.glsl.
using LobeTextures = std::array<SampledTexture, layout::LOBE_TEXTURE_COUNT>;
/// White ones where there are none. Throws as `GpuImages::get`.
LobeTextures lobeTexturesOf(const Material& material, GpuImages& images);

/// Fills the `LOBE_TEXELS` texels that shaders read of a material's lobes.
void writeLobeRecord(std::span<glm::vec4> record, const Material& material);

/// The rows of a texture's coordinate transform: offset + rotate × scale. The set is in w of the first.
std::array<glm::vec4, 2> coordinateRows(const std::optional<Texture>& texture);

}  // namespace candela
