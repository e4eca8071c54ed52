#pragma once

#include "shading/directional_albedo.h"

#include <span>

namespace candela {

/// What the texels are too high by, in proportion: more than the errors of interpolation and integration
/// together.
constexpr double sheenAlbedoBias = 1.035;

/// The directional albedo of the sheen lobe of colour 1, Charlie's distribution with the visibility of
/// Neubelt and Pettineo: of light that comes equally from everywhere, the fraction that it reflects towards
/// n·v, without an upper bound. In the layout of `directionalAlbedoTable`: albedoTableSize texels along each
/// side, two floats each, of which the second is 0. Texel (i, j) lies at
///
///     x = √(n·v)        y = (roughness - 0.07) / (1 - 0.07)
///
/// Computed at the first call (some 30 milliseconds, thread-safe).
std::span<const float> sheenAlbedoTable();

}  // namespace candela
