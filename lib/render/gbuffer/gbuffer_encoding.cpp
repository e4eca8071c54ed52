#include <candela/gbuffer.h>

#include "render/gbuffer/srgb.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace candela {

namespace {

constexpr std::array<const char*, 3> positionChannels{"P.X", "P.Y", "P.Z"};
constexpr std::array<const char*, 3> normalChannels{"N.X", "N.Y", "N.Z"};
constexpr std::array<const char*, 3> baseColorChannels{"base_color.R", "base_color.G", "base_color.B"};
constexpr std::array<const char*, 3> emissionChannels{"emission.R", "emission.G", "emission.B"};
constexpr std::array<const char*, 1> depthChannels{"Z"};
constexpr std::array<const char*, 1> metallicChannels{"metallic"};
constexpr std::array<const char*, 1> roughnessChannels{"roughness"};

constexpr std::array<GBufferChannel, 7> channels{{
    {"Z", "distance along the view axis in metres, 0 on the background", "reversed depth: near plane / Z",
     "32-bit float", depthChannels},
    {"P", "world position in metres", "follows from Z and the camera", "none of its own", positionChannels},
    {"N", "world normal, unit length", "octahedral, codes 1 to 4095 an axis", "2 × 12 bits", normalChannels},
    {"base_color", "base colour, linear in the working space", "sRGB curve", "3 × 8 bits", baseColorChannels},
    {"metallic", "metallic, 0 to 1", "linear", "8 bits", metallicChannels},
    {"roughness", "perceptual roughness, 0 to 1", "linear", "8 bits", roughnessChannels},
    {"emission", "emitted radiance, linear in the working space", "linear, in the radiance target",
     "3 × 32-bit float", emissionChannels},
}};

std::uint32_t unorm8(float value) {
    return static_cast<std::uint32_t>(std::floor(glm::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f));
}

float fromUnorm8(std::uint32_t code) {
    return static_cast<float>(code & 0xffu) / 255.0f;
}

glm::vec2 octahedralFold(const glm::vec2& p) {
    return (1.0f - glm::abs(glm::vec2(p.y, p.x))) *
           glm::vec2(p.x >= 0.0f ? 1.0f : -1.0f, p.y >= 0.0f ? 1.0f : -1.0f);
}

}  // namespace

std::span<const GBufferChannel> gbufferChannels() {
    return channels;
}

GBufferTexel packSurface(const GBufferSurface& surface) {
    const glm::vec3& n = surface.normal;
    glm::vec2 p = glm::vec2(n) / std::max(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1.0e-20f);
    if (n.z < 0.0f) p = octahedralFold(p);
    const glm::uvec2 code(glm::floor(glm::clamp(p, -1.0f, 1.0f) * 2047.0f + 2048.5f));
    const glm::vec3 color = glm::clamp(surface.baseColor, 0.0f, 1.0f);
    return {unorm8(srgbEncode(color.r)) | unorm8(srgbEncode(color.g)) << 8 |
                unorm8(srgbEncode(color.b)) << 16 | unorm8(surface.metallic) << 24,
            code.x | code.y << 12 | unorm8(surface.roughness) << 24};
}

GBufferSurface unpackSurface(GBufferTexel texel) {
    assert(texel.y != 0 && "no surface is here");
    GBufferSurface surface;
    surface.baseColor = {srgbDecode(fromUnorm8(texel.x)), srgbDecode(fromUnorm8(texel.x >> 8)),
                         srgbDecode(fromUnorm8(texel.x >> 16))};
    surface.metallic = fromUnorm8(texel.x >> 24);
    glm::vec2 p = (glm::vec2(texel.y & 0xfffu, texel.y >> 12 & 0xfffu) - 2048.0f) * (1.0f / 2047.0f);
    const float z = 1.0f - std::abs(p.x) - std::abs(p.y);
    if (z < 0.0f) p = octahedralFold(p);
    surface.normal = glm::normalize(glm::vec3(p, z));
    surface.roughness = fromUnorm8(texel.y >> 24);
    return surface;
}

}  // namespace candela
