#pragma once

#include <candela/brdf.h>

#include <span>

namespace candela {

/// The texels along each side of a directional albedo table.
constexpr int albedoTableSize = 32;

/// The texels of the albedo are too high by this, and those of the cosine too low: more than the errors of
/// interpolation and integration together, so that what the lobe reflects is never underestimated and the
/// diffuse part takes no more than the rest.
struct AlbedoBias {
    double factor, offset;  ///< Of the albedo, which stays at most 1 in the `gltf` model.
    double cosineFactor;
};
constexpr AlbedoBias courseAlbedoBias{1.0045, 1.0e-4, 0.995}, gltfAlbedoBias{1.0, 1.5e-3, 0.995};

/// The model's table of the specular lobe: of light that comes equally from everywhere, E(n·v, roughness) is
/// the fraction that the lobe reflects towards n·v if F is 1, without energy compensation. W is the mean of
/// Schlick's weight (1 - v·h)^5 over that light, so that the lobe of any F0 reflects E (F0 + (1 - F0) W).
/// These are A = E (1 - W) and B = E W of the split sum: Karis, "Real shading in Unreal Engine 4", 2013.
///
/// 2 albedoTableSize² floats, rows from y = 0, two for each texel. Texel (i, j) lies at
/// x = i / (albedoTableSize - 1), y = j / (albedoTableSize - 1) where, with alpha = roughness² or the
/// minimum,
///
///     x = n·v (1 + alpha) / (n·v + alpha)
///     y = roughness
///
/// so texels lie on the corners of the cells, the outer ones on the borders of the domain. Near grazing the
/// lobe depends on n·v / alpha alone: along x the table keeps its shape when alpha goes to 0. What is stored
/// goes to a constant where n·v is much more than alpha, as in the mirror:
///
///     albedo = E in the `gltf` model, E / g² in `course`      g = m / (m (1 - k) + k), k = (roughness + 1)²
///     / 8 cosine = (1 - W^(1/5)) / m                              m = n·v + alpha
///
/// Computed at the first call for the model (some 15 milliseconds, thread-safe), the same in every run on a
/// machine.
std::span<const float> directionalAlbedoTable(BrdfModel model);

/// E and W of above.
struct LobeAlbedo {
    double albedo, fresnelWeight;
};

/// From the table. n·v is clamped to at least `minNDotV`; roughness is 0 to 1.
LobeAlbedo lobeAlbedo(BrdfModel model, double nDotV, double roughness);

}  // namespace candela
