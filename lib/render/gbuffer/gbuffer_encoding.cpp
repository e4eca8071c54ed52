#include <candela/gbuffer.h>

#include <candela/error.h>

#include "render/gbuffer/readback.h"
#include "render/gbuffer/srgb.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace candela {

namespace {

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

uint packHalf2x16(const vec2& value) {
    return uint{packHalf1x16(value.x)} | uint{packHalf1x16(value.y)} << 16;
}

vec2 unpackHalf2x16(uint halves) {
    return {unpackHalf1x16(static_cast<std::uint16_t>(halves)),
            unpackHalf1x16(static_cast<std::uint16_t>(halves >> 16))};
}

using ExtendedLobes = candela::ExtendedLobes<float>;

#define SHARED_FUNCTION inline
#include "shared/gbuffer_encoding.h"
#undef SHARED_FUNCTION

}  // namespace encoding

}  // namespace

GBufferTexel packSurface(const GBufferSurface& surface) {
    return {encoding::packBaseColor(surface.lobes.baseColor, surface.lobes.metallic),
            encoding::packNormalRoughness(surface.normal, surface.lobes.roughness)};
}

ShadowSurface unpackShadowWord(std::uint32_t word) {
    const encoding::ShadowSurface surface = encoding::unpackShadowWord(word);
    return {surface.geometricNormal, surface.lift};
}

glm::vec3 unpackNormal(std::uint32_t word) {
    return encoding::unpackNormal(word);
}

ExtendedLobes<float> unpackLobeWords(const GBufferLobeWords& words, const glm::vec3& normal) {
    const auto& [x, y, z, w] = words.lobes;
    return encoding::unpackExtendedLobes({{x, y, z, w}, words.diffuseTransmission}, normal);
}

GBufferLobeWords packLobeWords(const ExtendedLobes<float>& lobes, const glm::vec3& normal) {
    const encoding::LobeWords words = encoding::packExtendedLobes(lobes, normal);
    return {{words.lobes.x, words.lobes.y, words.lobes.z, words.lobes.w}, words.diffuseTransmission};
}

GBufferSurface unpackSurface(GBufferTexel texel) {
    if (texel.y == 0) {
        throw Error(ErrorKind::badInput, "",
                    "a G-buffer texel whose second word is 0 holds no surface to unpack");
    }
    return encoding::unpackSurfaceWords(texel.x, texel.y);
}

}  // namespace candela
