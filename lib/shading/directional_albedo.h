#pragma once

#include <span>

namespace candela {

/// The texels along each side of the directional albedo table.
constexpr int albedoTableSize = 32;

/// Added to every texel (clamped to 1): more than the errors of interpolation and integration together, so
/// that the compensated lobe never returns more than it receives.
constexpr double albedoBias = 1.5e-3;

/// E(n·v, alpha): the directional albedo of the `gltf` model's specular lobe for F = 1, the fraction of the
/// light from n·v that single reflection returns. albedoTableSize² floats, rows from y = 0.
///
/// Texel (i, j) holds E at x = i / (albedoTableSize - 1), y = j / (albedoTableSize - 1) where
///
///     x = n·v (1 + alpha) / (n·v + alpha)
///     y = (alpha - minAlpha) / (1 - minAlpha)
///
/// so texels lie on the corners of the cells, the outer ones on the borders of the domain. Near grazing the
/// lobe depends on n·v / alpha alone: along x the table keeps its shape when alpha goes to 0.
///
/// Computed at the first call (a few milliseconds, thread-safe), the same in every run on a machine.
std::span<const float> directionalAlbedoTable();

}  // namespace candela
