#pragma once

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "render/layout.h"

#include <array>
#include <span>
#include <vector>

namespace candela {

/// A texture of the G-buffer that holds words of each pixel.
struct GBufferWordTexture {
    const char* label;
    GLenum internalFormat, readFormat;
    int words;   ///< 32-bit words a pixel.
    int unit;    ///< Texture unit from which shaders read it.
    int output;  ///< Fragment output of the geometry pass that writes it.
};

/// The word textures of a G-buffer. Targets, clears, bindings and readback follow it; in shaders
/// lib/gbuffer.glsl, lib/gbuffer_input.glsl and lib/gbuffer_output.glsl do. docs/gbuffer.md says how to add
/// one.
using GBufferLayout = std::span<const GBufferWordTexture>;

/// The words that every scene needs.
inline constexpr std::array baseWordTextures{GBufferWordTexture{
    "G-buffer surface", GL_RG32UI, GL_RG_INTEGER, 2, layout::SURFACE_UNIT, layout::SURFACE_OUTPUT}};

/// The words of frames with shadows: the programs of the geometry pass are compiled with SHADOWS.
inline constexpr std::array shadowWordTextures{
    baseWordTextures[0], GBufferWordTexture{"G-buffer shadow", GL_R32UI, GL_RED_INTEGER, 1,
                                            layout::SHADOW_UNIT, layout::SHADOW_OUTPUT}};

/// How a pass finds a target that it writes.
enum class LoadOp {
    load,      ///< With the content that earlier passes have left.
    clear,     ///< Cleared.
    dontCare,  ///< With undefined content: the pass, or a later one, writes every pixel.
};

/// The G-buffer of one picture size, and the radiance target that goes with it.
struct GBufferTargets {
    GBufferTargets(int width, int height, GBufferLayout layout = baseWordTextures);

    bool hasShadowWord() const { return layout.size() == shadowWordTextures.size(); }
    /// Binds the word textures and the depth for reading by shaders.
    void bind() const;
    /// The radiance of the frame, after its lighting: writes it first where it is still in memory.
    const gl::Texture& litRadiance() const;

    int width, height;
    GBufferLayout layout;
    std::vector<gl::Texture> words;       ///< One for each of `layout`.
    gl::Texture depth;                    ///< 32-bit float, reversed.
    gl::Texture radiance;                 ///< RGBA32F: emission, then the sum of all light.
    gl::Framebuffer surfaces;             ///< Words and depth.
    gl::Framebuffer surfacesAndEmission;  ///< Words, radiance and depth.
    gl::Framebuffer lit;                  ///< Radiance alone.
    gl::Framebuffer litWithDepth;         ///< Radiance and depth.
    /// What a technique on the CPU has left in its own memory: the radiance that `radiance` is still to get,
    /// RGBA, and the depth, rows from the bottom. Empty where `radiance` holds all.
    struct Memory {
        std::span<const float> radiance, depth;
    };
    mutable Memory memory;
};

}  // namespace candela
