#include "render/debug/probe.h"

#include "render/frame_uniforms.h"

#include <candela/gbuffer.h>

#include <glm/geometric.hpp>

namespace candela {

namespace {

GBufferTexel readSurface(const ProbedPixel& pixel) {
    GBufferTexel texel;
    glGetTextureSubImage(pixel.targets.surface.name(), 0, pixel.x, pixel.y, 0, 1, 1, 1, GL_RG_INTEGER,
                         GL_UNSIGNED_INT, sizeof texel, &texel);
    return texel;
}

float readDepth(const ProbedPixel& pixel) {
    float depth = 0.0f;
    glGetTextureSubImage(pixel.targets.depth.name(), 0, pixel.x, pixel.y, 0, 1, 1, 1, GL_DEPTH_COMPONENT,
                         GL_FLOAT, sizeof depth, &depth);
    return depth;
}

glm::vec3 readRadiance(const ProbedPixel& pixel) {
    glm::vec4 radiance(0.0f);
    glGetTextureSubImage(pixel.targets.radiance.name(), 0, pixel.x, pixel.y, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                         sizeof radiance, &radiance);
    return glm::vec3(radiance);
}

/// As `isLit` of shaders/lib/lighting.glsl.
std::uint32_t countLights(const GpuLights& lights, const glm::vec3& position) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < lights.reaches().size(); ++i) {
        const glm::vec4& place = lights.recordData()[layout::LIGHT_TEXELS * i];
        const glm::vec3 d = glm::vec3(place) - position;
        count += glm::dot(d, d) * place.w < 1.0f;
    }
    return count;
}

}  // namespace

std::optional<PixelProbe> probeSurface(const ProbedPixel& pixel) {
    const float depth = readDepth(pixel);
    if (depth <= 0.0f) return std::nullopt;
    PixelProbe probe;
    probe.z = pixel.frame.eye.w / depth;
    probe.position = worldPosition(pixel.frame, pixel.x, pixel.y, depth);
    probe.radiance = readRadiance(pixel);
    const GBufferTexel texel = readSurface(pixel);
    if (texel.y == 0) return probe;
    const GBufferSurface surface = unpackSurface(texel);
    probe.normal = surface.normal;
    probe.baseColor = surface.lobes.baseColor;
    probe.metallic = surface.lobes.metallic;
    probe.roughness = surface.lobes.roughness;
    probe.lightCount = countLights(pixel.lights, probe.position);
    return probe;
}

}  // namespace candela
