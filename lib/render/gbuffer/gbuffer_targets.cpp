#include "render/gbuffer/gbuffer_targets.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace candela {

namespace {

constexpr GBufferWordTexture depthTexture{
    "G-buffer depth", GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4, layout::DEPTH_UNIT, -1};

/// In memory that is mapped, if `mapping` gains any.
gl::Texture makeTexture(const GBufferWordTexture& texture, int width, int height,
                        const gl::ExternalMemoryDevice* device, gl::TextureMapping& mapping) {
    if (device != nullptr) {
        const gl::TexelFormat format{texture.internalFormat, texture.readFormat, texture.readType,
                                     texture.bytes};
        if (auto mapped = gl::mappedTarget2d(*device, format, width, height, texture.label)) {
            mapping = std::move(mapped->mapping);
            return std::move(mapped->texture);
        }
    }
    return gl::Texture::target2d(texture.internalFormat, width, height, texture.label);
}

std::vector<gl::Texture> makeWordTextures(const std::vector<GBufferWordTexture>& layout, int width,
                                          int height, const gl::ExternalMemoryDevice* device,
                                          std::vector<gl::TextureMapping>& mappings) {
    std::vector<gl::Texture> textures;
    for (std::size_t i = 0; i < layout.size(); ++i)
        textures.push_back(makeTexture(layout[i], width, height, device, mappings[i]));
    return textures;
}

/// The colour attachments by fragment output. `radiance` may be null.
std::vector<const gl::Texture*> attachments(const std::vector<GBufferWordTexture>& layout,
                                            const std::vector<gl::Texture>& words,
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

std::vector<GBufferWordTexture> layoutOf(const GBufferParts& parts) {
    std::vector<GBufferWordTexture> layout{surfaceTexture};
    if (parts.shadowWord) layout.push_back(shadowTexture);
    if (parts.occlusion) layout.push_back(occlusionTexture);
    if (parts.lobes) {
        layout.push_back(lobesTexture);
        layout.push_back(diffuseTransmissionTexture);
    }
    if (parts.layer) layout.push_back(layerTexture);
    if (parts.refraction) layout.push_back(refractionTexture);
    return layout;
}

std::vector<std::string> definitionsOf(const GBufferParts& parts) {
    std::vector<std::string> definitions;
    if (parts.shadowWord) definitions.emplace_back("SHADOWS 1");
    if (parts.occlusion) definitions.emplace_back("OCCLUSION 1");
    if (parts.lobes) definitions.emplace_back("LOBES 1");
    if (parts.layer) definitions.emplace_back("LAYER 1");
    if (parts.refraction) definitions.emplace_back("REFRACTION 1");
    return definitions;
}

GBufferTargets::GBufferTargets(int pixelsWide, int pixelsHigh, const GBufferParts& wanted,
                               const gl::ExternalMemoryDevice* device)
    : width(pixelsWide),
      height(pixelsHigh),
      parts(wanted),
      memoryDevice(device),
      layout(layoutOf(parts)),
      wordMappings(layout.size()),
      words(makeWordTextures(layout, width, height, device, wordMappings)),
      depth(makeTexture(depthTexture, width, height, device, depthMapping)),
      radiance(gl::Texture::target2d(GL_RGBA32F, width, height, "radiance")),
      surfaces(attachments(layout, words, nullptr), &depth, "G-buffer"),
      surfacesAndEmission(attachments(layout, words, &radiance), &depth, "G-buffer with emission"),
      lit({&radiance}, nullptr, "radiance"),
      litWithDepth({&radiance}, &depth, "radiance with depth") {}

std::size_t GBufferTargets::indexOf(int output) const {
    const auto found = std::ranges::find(layout, output, &GBufferWordTexture::output);
    assert(found != layout.end());
    return static_cast<std::size_t>(found - layout.begin());
}

void GBufferTargets::clearSurfaces() const {
    constexpr std::array<GLuint, 4> nothing{0, 0, 0, 0};
    constexpr std::array<GLfloat, 4> none{0.0f, 0.0f, 0.0f, 0.0f};
    constexpr GLfloat farthest = 0.0f;
    for (const GBufferWordTexture& texture : layout) {
        if (texture.readType == GL_UNSIGNED_INT) {
            glClearNamedFramebufferuiv(surfaces.name(), GL_COLOR, texture.output, nothing.data());
        } else {
            glClearNamedFramebufferfv(surfaces.name(), GL_COLOR, texture.output, none.data());
        }
    }
    glClearNamedFramebufferfv(surfaces.name(), GL_DEPTH, 0, &farthest);
}

void GBufferTargets::clearRadiance() const {
    constexpr std::array<GLfloat, 4> black{0.0f, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(lit.name(), GL_COLOR, 0, black.data());
}

void GBufferTargets::bind() const {
    for (std::size_t i = 0; i < words.size(); ++i)
        glBindTextureUnit(static_cast<GLuint>(layout[i].unit), words[i].name());
    glBindTextureUnit(layout::DEPTH_UNIT, depth.name());
}

const gl::Texture& GBufferTargets::litRadiance() const {
    if (!memory.radiance.empty() && !memory.isUploaded) {
        const gl::PixelRectangle& part = memory.rectangle;
        const std::size_t first = static_cast<std::size_t>(part.y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(part.x);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, width);
        glTextureSubImage2D(radiance.name(), 0, part.x, part.y, part.width, part.height, GL_RGBA, GL_FLOAT,
                            memory.radiance.data() + 4 * first);
        glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
        memory.isUploaded = true;
    }
    return radiance;
}

const gl::Texture& GBufferTargets::takeLitRadiance() const {
    litRadiance();
    memory = {};
    return radiance;
}

}  // namespace candela
