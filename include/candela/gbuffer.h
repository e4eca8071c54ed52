#pragma once

#include <candela/brdf.h>
#include <candela/export.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace candela {

/// One channel that a picture of the G-buffer has, as files and debug views name it.
struct GBufferChannel {
    const char*
        name;  ///< Such as "base_color"; the name in `--aov` and, before ".R" or ".X", in an EXR file.
    const char* meaning;                       ///< With unit.
    const char* encoding;                      ///< How the G-buffer holds it.
    const char* format;                        ///< The bits it takes there.
    std::span<const char* const> exrChannels;  ///< Such as "base_color.R", "base_color.G", "base_color.B".
};

/// The channel table: the one place that says what the G-buffer holds. Documentation, debug views and AOV
/// output read it.
CANDELA_API std::span<const GBufferChannel> gbufferChannels();

/// What the G-buffer stores of a surface, unpacked.
struct GBufferSurface {
    glm::vec3 normal{0.0f, 0.0f, 1.0f};  ///< Unit length, world space.
    SurfaceLobes<float> lobes = {};
};

/// The two words of a pixel: x holds base colour and metallic, y normal and roughness. y is 0 where no light
/// falls: the background and unlit materials.
struct GBufferTexel {
    std::uint32_t x = 0, y = 0;
};

/// Packs a surface. The shaders pack with the same source (shaders/shared/gbuffer_encoding.h), up to the
/// rounding of their arithmetic. Numbers beyond their range are clamped; a normal without length packs as
/// one.
CANDELA_API GBufferTexel packSurface(const GBufferSurface& surface);

/// Unpacks a texel. Throws `Error` (badInput) where `texel.y` is 0.
CANDELA_API GBufferSurface unpackSurface(GBufferTexel texel);

}  // namespace candela
