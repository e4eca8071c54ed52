#pragma once

#include <candela/brdf.h>
#include <candela/export.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// How the samples of a channel become one value, unless a host decides otherwise (`AovFilter`).
enum class SampleFilter {
    average,  ///< Their mean: where a value between those of two surfaces has a meaning.
    first,    ///< The first sample: where it has none.
};

/// A channel of a frame: a quantity that AOVs and debug views show.
struct GBufferChannel {
    const char* name = "";        ///< The AOV's, such as "base_color".
    const char* components = "";  ///< A letter for each, such as "RGB" or "XYZ"; empty for a scalar.
    const char* meaning = "";     ///< With unit.
    const char* encoding = "";    ///< How the G-buffer stores it.
    const char* format = "";      ///< The bits it takes there.
    SampleFilter filter = SampleFilter::average;
};

/// The channel table, in the order of EXR files. AOVs, debug views and docs/gbuffer.md follow it.
CANDELA_API std::span<const GBufferChannel> gbufferChannels();

/// The channel's names in an EXR file, such as "base_color.R", "base_color.G", "base_color.B".
CANDELA_API std::vector<std::string> exrChannelNames(const GBufferChannel& channel);

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
