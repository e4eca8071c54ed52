#pragma once

#include "measure.h"

#include <memory>

/// How a textbook brings lights to pixels.
enum class TextbookLighting {
    fullscreen,  ///< One full-screen loop over all lights.
    volumes,     ///< One instanced sphere a light, added up by blending.
};

/// A deferred renderer in its textbook form: a G-buffer of position (RGBA16F), normal (RGBA16F) and colour
/// (RGBA8), lighting into RGBA16F. Point lights and untextured materials only: throws `candela::Error`
/// (unsupported) for a scene with others.
std::unique_ptr<Program> makeTextbookBaseline(const candela::Context& context, const BenchScene& scene,
                                              const BenchOptions& options, TextbookLighting lighting);

/// May the full-screen loop run over so many lights? Software rasterisers end it at 65,535 turns without a
/// word.
bool fitsTextbookLoop(const BenchScene& scene);
