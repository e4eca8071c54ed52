#pragma once

#include "measure.h"

#include <candela/candela.h>

#include <cstdint>
#include <memory>

/// How candela draws.
struct CandelaDrawing {
    candela::Technique technique;
    candela::Shadows shadows;  ///< `on` or `off`.
    std::uint32_t samples;     ///< A pixel.
    candela::TileBackend tileBackend = candela::TileBackend::automatic;
};

/// candela itself.
std::unique_ptr<Program> makeCandelaProgram(const candela::Context& context, const BenchScene& scene,
                                            const BenchOptions& options, const CandelaDrawing& drawing);

/// How a textbook renderer applies lights to pixels.
enum class TextbookLighting {
    fullscreen,  ///< One full-screen loop over all lights.
    volumes,     ///< One instanced sphere a light, accumulated by additive blending.
};

/// A deferred renderer in its textbook form: a G-buffer of position (RGBA16F), normal (RGBA16F) and colour
/// (RGBA8), lighting into RGBA16F. Throws `candela::Error` (unsupported) for a scene that it cannot draw:
/// with lights other than point lights with a range, with textured or unlit materials, or with more lights
/// than the full-screen loop takes (65,535: software rasterisers end a loop there and report nothing).
std::unique_ptr<Program> makeTextbookProgram(const candela::Context& context, const BenchScene& scene,
                                             const BenchOptions& options, TextbookLighting lighting);

/// A program that clears and draws the geometry with depth and one RGBA8 target, without culling, lighting or
/// read-back: a lower bound of a frame.
std::unique_ptr<Program> makeBareProgram(const candela::Context& context, const BenchScene& scene,
                                         const BenchOptions& options);

/// Draws the cube shadow maps of the lights in view, one after the other, as a textbook renderer does before
/// it lights a frame: 256 x 256 depths a face, of the meshes in range of the light and in view of the face.
/// Stops after a minute. Throws `candela::Error` (unsupported) for a scene with lights other than point
/// lights with a range, or without a light in view.
Result measureShadowMaps(const candela::Context& context, const BenchScene& scene,
                         const BenchOptions& options);
