#include "render/gbuffer/gbuffer_targets.h"

namespace candela {

namespace {

std::vector<gl::Texture> makeWordTextures(GBufferLayout layout, int width, int height) {
    std::vector<gl::Texture> textures;
    for (const GBufferWordTexture& texture : layout)
        textures.push_back(gl::Texture::target2d(texture.internalFormat, width, height, texture.label));
    return textures;
}

/// The colour attachments by fragment output. `radiance` may be null.
std::vector<const gl::Texture*> attachments(GBufferLayout layout, const std::vector<gl::Texture>& words,
                                            const gl::Texture* radiance) {
    std::vector<const gl::Texture*> outputs;
    const auto attach = [&](int output, const gl::Texture* texture) {
        const auto index = static_cast<std::size_t>(output);
        if (outputs.size() <= index) outputs.resize(index + 1, nullptr);
        outputs[index] = texture;
    };
    for (std::size_t i = 0; i < words.size(); ++i) attach(layout[i].output, &words[i]);
    if (radiance != nullptr) attach(layout::RADIANCE_OUTPUT, radiance);
    return outputs;
}

}  // namespace

GBufferTargets::GBufferTargets(int pixelsWide, int pixelsHigh, GBufferLayout wordTextures)
    : width(pixelsWide),
      height(pixelsHigh),
      layout(wordTextures),
      words(makeWordTextures(wordTextures, width, height)),
      depth(gl::Texture::target2d(GL_DEPTH_COMPONENT32F, width, height, "G-buffer depth")),
      radiance(gl::Texture::target2d(GL_RGBA32F, width, height, "radiance")),
      surfaces(attachments(layout, words, nullptr), &depth, "G-buffer"),
      surfacesAndEmission(attachments(layout, words, &radiance), &depth, "G-buffer with emission"),
      lit({&radiance}, nullptr, "radiance"),
      litWithDepth({&radiance}, &depth, "radiance with depth") {}

void GBufferTargets::bind() const {
    for (std::size_t i = 0; i < words.size(); ++i)
        glBindTextureUnit(static_cast<GLuint>(layout[i].unit), words[i].name());
    glBindTextureUnit(layout::DEPTH_UNIT, depth.name());
}

const gl::Texture& GBufferTargets::litRadiance() const {
    if (!memory.radiance.empty()) {
        glTextureSubImage2D(radiance.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT,
                            memory.radiance.data());
        memory = {};
    }
    return radiance;
}

}  // namespace candela
