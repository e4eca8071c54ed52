#include "render/debug/probe.h"

#include "render/frame_uniforms.h"
#include "render/gbuffer/readback.h"

#include <candela/gbuffer.h>

#include <glm/geometric.hpp>

namespace candela {

namespace {

/// As `isLit` of shaders/lib/lighting.glsl.
std::uint32_t countLights(const GpuLights& lights, const glm::vec3& position) {
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < lights.reaches().size(); ++i) {
        const glm::vec4& record = lights.recordData()[layout::LIGHT_TEXELS * i];
        const glm::vec3 d = glm::vec3(record) - position;
        count += glm::dot(d, d) * record.w < 1.0f;
    }
    return count;
}

}  // namespace

std::optional<PixelProbe> probeSurface(const ProbedPixel& pixel) {
    const float depth = readDepthAt(pixel.targets, pixel.x, pixel.y);
    if (depth <= 0.0f) return std::nullopt;
    PixelProbe probe;
    probe.z = viewDistance(pixel.frame, depth);
    probe.position = worldPosition(pixel.frame, pixel.x, pixel.y, depth);
    const GBufferTexel texel = readSurfaceAt(pixel.targets, pixel.x, pixel.y);
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
