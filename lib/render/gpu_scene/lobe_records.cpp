#include "render/gpu_scene/lobe_records.h"

#include "scene/model/material_textures.h"

#include <cmath>

namespace candela {

namespace {

std::span<const MaterialTexture> lobeTextures() {
    return materialTextures().subspan(basicTextureCount);
}

/// What a metre absorbs: the coefficient of Beer and Lambert's law.
glm::vec3 absorption(const Volume& volume) {
    constexpr float darkest = 1.0e-6f;  // A colour of 0 absorbs all within about one distance.
    glm::vec3 coefficient(0.0f);
    if (std::isinf(volume.attenuationDistance)) return coefficient;
    for (int i = 0; i < 3; ++i)
        coefficient[i] =
            -std::log(std::max(volume.attenuationColor[i], darkest)) / volume.attenuationDistance;
    return coefficient;
}

}  // namespace

bool isExtended(const Material& material) {
    constexpr glm::vec3 black(0.0f);
    if (material.unlit) return false;
    return material.ior != 1.5f || material.specular != Specular{} || material.clearcoat.factor > 0.0f ||
           material.sheen.color != black || material.anisotropy.strength > 0.0f ||
           material.iridescence.factor > 0.0f || material.transmission.factor > 0.0f ||
           material.diffuseTransmission.factor > 0.0f;
}

bool transmits(const Material& material) {
    return !material.unlit && material.transmission.factor > 0.0f;
}

bool letsLightThrough(const Material& material) {
    return material.alphaMode != AlphaMode::opaque || transmits(material);
}

LobeTextures lobeTexturesOf(const Material& material, GpuImages& images) {
    LobeTextures textures;
    const std::span<const MaterialTexture> sources = lobeTextures();
    for (std::size_t i = 0; i < textures.size(); ++i)
        textures[i] = images.get(sources[i].of(material), sources[i].content);
    return textures;
}

void writeLobeRecord(std::span<glm::vec4> record, const Material& material) {
    const Clearcoat& coat = material.clearcoat;
    const Anisotropy& anisotropy = material.anisotropy;
    const Iridescence& film = material.iridescence;
    record[layout::LOBE_SPECULAR] = {material.ior, material.specular.factor, coat.factor, coat.roughness};
    record[layout::LOBE_SPECULAR_COLOR] =
        glm::vec4(material.specular.color, coat.normalTexture ? coat.normalScale : 0.0f);
    record[layout::LOBE_SHEEN] = glm::vec4(material.sheen.color, material.sheen.roughness);
    record[layout::LOBE_ANISOTROPY] = {anisotropy.strength, std::cos(anisotropy.rotation),
                                       std::sin(anisotropy.rotation), anisotropy.texture ? 1.0f : 0.0f};
    record[layout::LOBE_IRIDESCENCE] = {film.factor, film.ior, film.minThickness, film.maxThickness};
    record[layout::LOBE_DIFFUSE_TRANSMISSION] =
        glm::vec4(material.diffuseTransmission.color, material.diffuseTransmission.factor);
    record[layout::LOBE_ABSORPTION] = glm::vec4(absorption(material.volume), material.transmission.factor);
    record[layout::LOBE_VOLUME] = {material.volume.thickness, material.volume.dispersion, 0.0f, 0.0f};
    std::size_t row = layout::LOBE_UV_ROWS;
    for (const MaterialTexture& texture : lobeTextures()) {
        for (const glm::vec4& coordinates : coordinateRows(texture.of(material))) record[row++] = coordinates;
    }
}

std::array<glm::vec4, 2> coordinateRows(const std::optional<Texture>& texture) {
    if (!texture) return {glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0)};
    const float c = std::cos(texture->rotation), s = std::sin(texture->rotation);
    const glm::vec2 scale = texture->scale;
    return {glm::vec4(c * scale.x, s * scale.y, texture->offset.x, static_cast<float>(texture->uvSet)),
            glm::vec4(-s * scale.x, c * scale.y, texture->offset.y, 0.0f)};
}

}  // namespace candela
