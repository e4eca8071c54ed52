#include "render/gpu_scene/material_records.h"

#include "render/layout.h"

#include <candela/gbuffer.h>

#include <glm/vec3.hpp>

#include <array>
#include <bit>
#include <cmath>

namespace candela {

namespace {

glm::uvec4 bits(const glm::vec4& v) {
    return {std::bit_cast<std::uint32_t>(v.x), std::bit_cast<std::uint32_t>(v.y),
            std::bit_cast<std::uint32_t>(v.z), std::bit_cast<std::uint32_t>(v.w)};
}

/// The rows of a texture's coordinate transform: offset + rotate × scale.
std::array<glm::vec4, 2> coordinateRows(const std::optional<Texture>& texture) {
    if (!texture) return {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0)};
    const float c = std::cos(texture->rotation), s = std::sin(texture->rotation);
    const glm::vec2 scale = texture->scale;
    return {glm::vec4(c * scale.x, s * scale.y, texture->offset.x, static_cast<float>(texture->uvSet)),
            glm::vec4(-s * scale.x, c * scale.y, texture->offset.y, 0.0f)};
}

void append(std::vector<glm::uvec4>& records, const Material& material, const glm::dmat3& workingFromRec709) {
    const glm::vec3 working(workingFromRec709 * glm::dvec3(material.baseColor));
    const GBufferTexel packed =
        packSurface({.baseColor = working, .metallic = material.metallic, .roughness = material.roughness});
    const float cutoff = material.alphaMode == AlphaMode::mask ? material.alphaCutoff : -1.0f;
    // Without a normal texture the scale is 0: the default texel can not hold (0, 0, 1) exactly.
    const float normalScale = material.normalTexture ? material.normalScale : 0.0f;
    records.push_back(bits(material.baseColor));
    records.push_back(bits({material.metallic, material.roughness, normalScale, cutoff}));
    records.push_back(bits(glm::vec4(material.emission, material.unlit ? 1.0f : 0.0f)));
    records.push_back({packed.x, 0, 0, 0});
    for (const auto* texture : {&material.baseColorTexture, &material.metallicRoughnessTexture,
                                &material.normalTexture, &material.emissionTexture}) {
        for (const glm::vec4& row : coordinateRows(*texture)) records.push_back(bits(row));
    }
}

}  // namespace

std::vector<glm::uvec4> materialRecord(const Material& material, const glm::dmat3& workingFromRec709) {
    std::vector<glm::uvec4> record;
    append(record, material, workingFromRec709);
    return record;
}

std::vector<glm::uvec4> materialRecords(std::span<const Material> materials,
                                        const glm::dmat3& workingFromRec709) {
    std::vector<glm::uvec4> records;
    records.reserve((materials.size() + 1) * layout::MATERIAL_TEXELS);
    for (const Material& material : materials) append(records, material, workingFromRec709);
    append(records, Material{}, workingFromRec709);
    return records;
}

}  // namespace candela
