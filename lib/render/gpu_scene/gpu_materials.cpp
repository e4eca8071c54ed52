#include "render/gpu_scene/gpu_materials.h"

#include "base/error_context.h"
#include "render/gpu_scene/lobe_records.h"
#include "render/layout.h"
#include "scene/model/material_textures.h"

#include <candela/error.h>
#include <candela/gbuffer.h>

#include <glm/vec3.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <string>

namespace candela {

namespace {

glm::uvec4 bits(const glm::vec4& v) {
    return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
            std::bit_cast<std::uint32_t>(v.z), std::bit_cast<std::uint32_t>(v.w)};
}

/// An alpha equal to the cutoff is kept, though interpolation and the product of factor, vertex colour and
/// texel round it. More than these roundings, less than a step of a 16-bit texel.
constexpr float alphaRounding = 1e-5f;

/// Below which alpha a fragment is not drawn where surfaces are masks. Of a surface that blends only the part
/// whose alpha is over a half counts.
float cutoffOf(const Material& material) {
    if (material.alphaMode == AlphaMode::opaque) return -1.0f;
    return material.alphaMode == AlphaMode::mask ? material.alphaCutoff - alphaRounding
                                                 : 0.5f + alphaRounding;
}

void writeRecord(std::span<glm::uvec4> record, const Material& material,
                 const glm::dmat3& workingFromRec709) {
    const glm::vec3 working(workingFromRec709 * glm::dvec3(material.baseColor));
    const GBufferTexel packed = packSurface({.lobes = {working, material.metallic, material.roughness}});
    // Without a normal texture the scale is 0: the default texel can not hold (0, 0, 1) exactly.
    const float normalScale = material.normalTexture ? material.normalScale : 0.0f;
    record[layout::MATERIAL_BASE_COLOR] = bits(material.baseColor);
    record[layout::MATERIAL_FACTORS] =
        bits({material.metallic, material.roughness, normalScale, cutoffOf(material)});
    record[layout::MATERIAL_EMISSION] =
        bits(glm::vec4(material.emission * material.emissionStrength, material.unlit ? 1.0f : 0.0f));
    const float occlusionStrength = material.occlusionTexture ? material.occlusionStrength : 0.0f;
    record[layout::MATERIAL_PACKED] = {packed.x, std::bit_cast<std::uint32_t>(occlusionStrength),
                                       material.alphaMode == AlphaMode::blend ? 1u : 0u, packed.y >> 24};
    std::size_t row = layout::MATERIAL_UV_ROWS;
    for (const MaterialTexture& texture : materialTextures().first(basicTextureCount)) {
        for (const glm::vec4& coordinates : coordinateRows(texture.of(material)))
            record[row++] = bits(coordinates);
    }
}

}  // namespace

GpuMaterials::GpuMaterials(const Scene& scene, const glm::dmat3& workingFromRec709)
    : workingFromRec709_(workingFromRec709),
      commonUvs_(scene.materials.size(), ~UvSets{0}),
      records_(GL_RGBA32UI, layout::MATERIAL_TEXELS, "materials"),
      lobeRecords_(GL_RGBA32F, layout::LOBE_TEXELS, "material lobes") {
    for (const Mesh& mesh : scene.meshes) {
        for (const Submesh& submesh : mesh.submeshes) {
            if (submesh.material) commonUvs_[*submesh.material] &= uvSetsOf(mesh);
        }
    }
    for (const Cage& cage : scene.cages) {
        for (const std::optional<std::uint32_t>& material : cage.faceMaterials) {
            if (material) commonUvs_[*material] &= cage.uvs.empty() ? 0u : 1u;
        }
    }
    const std::size_t count = scene.materials.size();
    records_.reserve(count + 1);
    records_.resize(count + 1);
    for (const Material& material : scene.materials) reserve(material);
    for (std::uint32_t i = 0; i < count; ++i) set(i, scene.materials[i]);
    set(static_cast<std::uint32_t>(count), Material{});
}

void GpuMaterials::requireUvs(std::uint32_t index, const Material& material) const {
    for (const MaterialTexture& use : materialTextures()) {
        const std::optional<Texture>& texture = use.of(material);
        if (!texture) continue;
        const std::uint32_t set = texture->uvSet;
        if ((commonUvs_[index] >> set & 1u) != 0) continue;
        ErrorContext("material", index, material.name)
            .refuse("a texture reads texture coordinates " + std::to_string(set) +
                    ", which a surface of this material does not have");
    }
}

void GpuMaterials::reserve(const Material& material) {
    if (!isExtended(material) || !lobeRecords_.texels().empty()) return;
    GLint units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    constexpr int needed = layout::OPAQUE_DEPTH_UNIT + 1;  // with those of layers
    if (units < needed) {
        throw Error(ErrorKind::limit, "",
                    "material '" + material.name + "' has lobes whose textures need " +
                        std::to_string(needed) + " texture units, but the device has " +
                        std::to_string(units) + " for a fragment shader");
    }
    lobeRecords_.reserve(commonUvs_.size());
    lobeRecords_.resize(commonUvs_.size());
}

void GpuMaterials::grow(std::size_t count) {
    if (count > records_.size()) records_.grow(count);
    if (count > commonUvs_.size()) commonUvs_.resize(count, ~UvSets{0});
    if (!lobeRecords_.texels().empty() && count > lobeRecords_.size()) lobeRecords_.grow(count);
}

void GpuMaterials::set(std::uint32_t index, const Material& material) {
    writeRecord(records_.edit(index), material, workingFromRec709_);
    if (isExtended(material)) writeLobeRecord(lobeRecords_.edit(index), material);
}

std::size_t GpuMaterials::upload() {
    lobeRecords_.upload();
    return records_.upload();
}

}  // namespace candela
