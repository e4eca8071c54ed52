#pragma once

#include "gl/framebuffer.h"
#include "gl/mapped_texture.h"
#include "gl/texture.h"
#include "render/layout.h"

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

namespace candela {

/// A texture of the G-buffer that holds words of each pixel, or bytes.
struct GBufferWordTexture {
    const char* label;
    GLenum internalFormat, readFormat, readType;
    std::size_t bytes;  ///< A pixel.
    int unit;           ///< Texture unit from which shaders read it.
    int output;         ///< Fragment output of the geometry pass that writes it.
};

/// The texture that every scene needs.
inline constexpr GBufferWordTexture surfaceTexture{"G-buffer surface",    GL_RG32UI, GL_RG_INTEGER,
                                                   GL_UNSIGNED_INT,       8,         layout::SURFACE_UNIT,
                                                   layout::SURFACE_OUTPUT};
inline constexpr GBufferWordTexture shadowTexture{"G-buffer shadow",    GL_R32UI, GL_RED_INTEGER,
                                                  GL_UNSIGNED_INT,      4,        layout::SHADOW_UNIT,
                                                  layout::SHADOW_OUTPUT};
inline constexpr GBufferWordTexture occlusionTexture{
    "G-buffer occlusion",    GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1, layout::ENVIRONMENT_VISIBILITY_UNIT,
    layout::OCCLUSION_OUTPUT};

inline constexpr GBufferWordTexture lobesTexture{"G-buffer lobes",    GL_RGBA32UI, GL_RGBA_INTEGER,
                                                 GL_UNSIGNED_INT,     16,          layout::LOBES_UNIT,
                                                 layout::LOBES_OUTPUT};
inline constexpr GBufferWordTexture diffuseTransmissionTexture{"G-buffer diffuse transmission",
                                                               GL_R32UI,
                                                               GL_RED_INTEGER,
                                                               GL_UNSIGNED_INT,
                                                               4,
                                                               layout::DIFFUSE_TRANSMISSION_UNIT,
                                                               layout::DIFFUSE_TRANSMISSION_OUTPUT};
inline constexpr GBufferWordTexture layerTexture{
    "G-buffer layer", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4, layout::LAYER_UNIT, layout::LAYER_OUTPUT};
inline constexpr GBufferWordTexture refractionTexture{
    "G-buffer refraction",    GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT, 8, layout::REFRACTION_UNIT,
    layout::REFRACTION_OUTPUT};

/// What a G-buffer has besides the surface texture. Each part is for the frames that need it and costs others
/// nothing: targets and the programs of the geometry pass exist once for each set of parts in use.
/// docs/gbuffer.md says how to add one.
struct GBufferParts {
    bool shadowWord = false;  ///< Where rays start: frames whose pixels trace rays. SHADOWS in shaders.
    /// R of occlusion textures with their strength: scenes with an environment. OCCLUSION in shaders.
    bool occlusion = false;
    /// What `ExtendedLobes` holds, in two textures: views with materials of more lobes. LOBES in shaders.
    bool lobes = false;
    bool layer = false;       ///< Coverage: layers of transparent surfaces. LAYER in shaders.
    bool refraction = false;  ///< Layers of which a surface in view transmits. REFRACTION in shaders.

    auto operator<=>(const GBufferParts&) const = default;
};

/// The textures of a G-buffer. Targets, clears, bindings and readback follow it; in shaders lib/gbuffer.glsl,
/// lib/gbuffer_input.glsl and lib/gbuffer_output.glsl do.
std::vector<GBufferWordTexture> layoutOf(const GBufferParts& parts);
/// With which the programs of the geometry pass are compiled.
std::vector<std::string> definitionsOf(const GBufferParts& parts);

/// How a pass finds a target that it writes.
enum class LoadOp {
    load,      ///< With the content that earlier passes have left.
    clear,     ///< Cleared.
    dontCare,  ///< With undefined content: the pass, or a later one, writes every pixel.
};

/// The G-buffer of one picture size, and the radiance target that goes with it.
struct GBufferTargets {
    /// Words and depth are in memory of `device` where there is such a device and the driver takes it; they
    /// are the driver's else.
    GBufferTargets(int width, int height, const GBufferParts& parts = {},
                   const gl::ExternalMemoryDevice* device = nullptr);

    /// Whether new targets are to take their place, in memory of a device that may be null.
    bool movesTo(const gl::ExternalMemoryDevice* other) const {
        return other != nullptr && other != memoryDevice && !isHandedOut;
    }
    /// The index in `layout` and `words` of the texture that `output` writes. It is there.
    std::size_t indexOf(int output) const;
    void clearSurfaces() const;  ///< Words and depth: to the background.
    void clearRadiance() const;  ///< To black.
    /// Binds the word textures and the depth for reading by shaders.
    void bind() const;
    /// The radiance of the frame, after its lighting: writes it first where it is only in memory.
    const gl::Texture& litRadiance() const;
    /// The same for a pass that draws over it: what is in memory is out of date then.
    const gl::Texture& takeLitRadiance() const;

    int width, height;
    GBufferParts parts;
    const gl::ExternalMemoryDevice* memoryDevice;  ///< As given, also where the driver refused its memory.
    std::vector<GBufferWordTexture> layout;
    std::vector<gl::TextureMapping> wordMappings;  ///< One for each of `words`.
    gl::TextureMapping depthMapping;
    std::vector<gl::Texture> words;  ///< One for each of `layout`.
    gl::Texture depth;               ///< 32-bit float, reversed.
    /// RGBA32F: emission, then the sum of all light. A is the coverage of the layers.
    gl::Texture radiance;
    gl::Framebuffer surfaces;             ///< Words and depth.
    gl::Framebuffer surfacesAndEmission;  ///< Words, radiance and depth.
    gl::Framebuffer lit;                  ///< Radiance alone.
    gl::Framebuffer litWithDepth;         ///< Radiance and depth.
    /// What a technique on the CPU has left in its own memory: the lit radiance, RGBA, and the depth, rows
    /// from the bottom, both defined in a rectangle. Empty where only `radiance` holds it.
    struct Memory {
        std::span<const float> radiance, depth;
        gl::PixelRectangle rectangle;
        bool isUploaded = false;  ///< `radiance` holds it too.
    };
    mutable Memory memory;
    /// A host has the names of the textures, which are kept then.
    mutable bool isHandedOut = false;
};

}  // namespace candela
