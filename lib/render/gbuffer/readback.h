#pragma once

#include "render/gbuffer/gbuffer_targets.h"

#include <candela/gbuffer.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

// Rows from the bottom as OpenGL has them.

/// The pixels of the targets.
gl::PixelRectangle wholeOf(const GBufferTargets& targets);

// These fill the pixels of a rectangle in `into`, which is of the targets' size, and leave the others alone.

/// The words of the texture that `output` writes.
void readWords(const GBufferTargets& targets, const gl::PixelRectangle& from, int output,
               std::span<std::uint32_t> into);
/// One byte a pixel. The targets have the part `occlusion`.
void readOcclusion(const GBufferTargets& targets, const gl::PixelRectangle& from,
                   std::span<std::uint8_t> into);
/// One float a pixel.
void readDepth(const GBufferTargets& targets, const gl::PixelRectangle& from, std::span<float> into);
/// Four floats a pixel.
void readRadiance(const GBufferTargets& targets, const gl::PixelRectangle& from, std::span<float> into);

// Whole targets.

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
