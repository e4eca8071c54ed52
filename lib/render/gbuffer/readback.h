#pragma once

#include "render/gbuffer/gbuffer_targets.h"

#include <candela/gbuffer.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

// Whole targets, rows from the bottom as OpenGL has them.

/// Fills `into`, which has the words of each pixel, from the texture that `output` writes.
void readWords(const GBufferTargets& targets, int output, std::span<std::uint32_t> into);
/// Fills `into`, which has one byte a pixel. The targets have the part `occlusion`.
void readOcclusion(const GBufferTargets& targets, std::span<std::uint8_t> into);
/// Fills `into`, which has one float a pixel.
void readDepth(const GBufferTargets& targets, std::span<float> into);
/// Fills `into`, which has four floats a pixel.
void readColor(const gl::Texture& texture, int width, int height, std::span<float> into);
std::vector<GBufferTexel> readSurfaces(const GBufferTargets& targets);
std::vector<float> readDepth(const GBufferTargets& targets);
/// RGBA.
std::vector<float> readColor(const gl::Texture& texture, int width, int height);
/// RGBA, 8 bits a channel.
std::vector<std::uint8_t> readBytes(const gl::Texture& texture, int width, int height);
/// The pixels that light falls on: all but the background and unlit surfaces.
std::uint64_t countLitSurfaces(const GBufferTargets& targets);

/// What a shadow word holds.
struct ShadowSurface {
    glm::vec3 geometricNormal;  ///< Of the triangle, towards the eye; unit length.
    float lift;                 ///< Metres along it, 0 or more: see shaders/shared/shadow_ray.h.
};
ShadowSurface unpackShadowWord(std::uint32_t word);
/// Of the second word of a `GBufferTexel` that is not 0: the shading normal.
glm::vec3 unpackNormal(std::uint32_t word);

/// The words of a pixel whose material has more lobes; all 0 where its `GBufferTexel` is all.
struct GBufferLobeWords {
    std::array<std::uint32_t, 4> lobes{};
    std::uint32_t diffuseTransmission = 0;
};
/// `normal` is that of the pixel's `GBufferTexel`, as it is unpacked. Packing is that of the shaders.
GBufferLobeWords packLobeWords(const ExtendedLobes<float>& lobes, const glm::vec3& normal);
/// Of words that are not all 0.
ExtendedLobes<float> unpackLobeWords(const GBufferLobeWords& words, const glm::vec3& normal);

// One pixel, y from the bottom.

GBufferTexel readSurfaceAt(const GBufferTargets& targets, int x, int y);
float readDepthAt(const GBufferTargets& targets, int x, int y);
glm::vec3 readColorAt(const gl::Texture& texture, int x, int y);

}  // namespace candela
