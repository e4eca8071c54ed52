#pragma once

#include "render/gbuffer/gbuffer_targets.h"

#include <candela/gbuffer.h>

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Each reads a whole target back, rows from the bottom as OpenGL has them. Those with `into` fill memory of
/// the right size: two words, one float and four floats a pixel.
void readSurfaces(const GBufferTargets& targets, std::span<std::uint32_t> into);
void readDepth(const GBufferTargets& targets, std::span<float> into);
void readColor(const gl::Texture& texture, int width, int height, std::span<float> into);
std::vector<GBufferTexel> readSurfaces(const GBufferTargets& targets);
std::vector<float> readDepth(const GBufferTargets& targets);
/// RGBA.
std::vector<float> readColor(const gl::Texture& texture, int width, int height);

/// RGBA, 8 bits a channel.
std::vector<std::uint8_t> readBytes(const gl::Texture& texture, int width, int height);

/// The pixels that light falls on: all but the background and unlit surfaces.
std::uint64_t countLitSurfaces(const GBufferTargets& targets);

}  // namespace candela
