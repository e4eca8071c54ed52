#pragma once

#include "gl/framebuffer.h"
#include "gl/texture.h"

namespace candela {

/// What a pass does with the content of a target before it draws.
enum class LoadOp {
    load,      ///< Keeps it.
    clear,     ///< Sets it to zero.
    dontCare,  ///< Leaves it undefined: the pass or the next one writes every pixel.
};

/// The G-buffer of one picture size and the radiance target that goes with it.
struct GBufferTargets {
    GBufferTargets(int width, int height);

    int width, height;
    gl::Texture surface;                  ///< RG32UI: the two words of `GBufferTexel`.
    gl::Texture depth;                    ///< 32-bit float, reversed.
    gl::Texture radiance;                 ///< RGBA32F: emission, then the sum of all light.
    gl::Framebuffer surfaces;             ///< surface and depth.
    gl::Framebuffer surfacesAndEmission;  ///< surface, radiance and depth.
    gl::Framebuffer lit;                  ///< radiance alone.
};

}  // namespace candela
