#pragma once

#include "render/gbuffer_targets.h"

#include <candela/gbuffer.h>

#include <cstdint>
#include <vector>

namespace candela {

/// Each reads a whole target back, rows from the bottom as OpenGL has them.
std::vector<GBufferTexel> readSurfaces(const GBufferTargets& targets);
std::vector<float> readDepth(const GBufferTargets& targets);
/// RGBA.
std::vector<float> readColor(const gl::Texture& texture, int width, int height);

/// RGBA, 8 bits a channel.
std::vector<std::uint8_t> readBytes(const gl::Texture& texture, int width, int height);

/// The pixels that light falls on: all but the background and unlit surfaces.
std::uint64_t countLitSurfaces(const GBufferTargets& targets);

}  // namespace candela
