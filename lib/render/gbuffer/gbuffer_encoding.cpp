#include <candela/gbuffer.h>

#include <candela/error.h>

#include "render/gbuffer/srgb.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

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

// shaders/shared/gbuffer_encoding.h over GLM's vectors.
namespace encoding {

using namespace glm;

uint packUnorm4x8(const vec4& value) {
    const uvec4 code(floor(clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f));
    return code.x | code.y << 8 | code.z << 16 | code.w << 24;
}

vec4 unpackUnorm4x8(uint codes) {
    return vec4(codes & 0xffu, codes >> 8 & 0xffu, codes >> 16 & 0xffu, codes >> 24) / 255.0f;
}

#define SHARED_FUNCTION inline
#include "shared/gbuffer_encoding.h"
#undef SHARED_FUNCTION

}  // namespace encoding

}  // namespace

std::span<const GBufferChannel> gbufferChannels() {
    return channels;
}

GBufferTexel packSurface(const GBufferSurface& surface) {
    return {encoding::packBaseColor(surface.lobes.baseColor, surface.lobes.metallic),
            encoding::packNormalRoughness(surface.normal, surface.lobes.roughness)};
}

GBufferSurface unpackSurface(GBufferTexel texel) {
    if (texel.y == 0) {
        throw Error(ErrorKind::badInput, "",
                    "a G-buffer texel whose second word is 0 holds no surface to unpack");
    }
    return encoding::unpackSurfaceWords(texel.x, texel.y);
}

}  // namespace candela
