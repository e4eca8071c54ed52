#pragma once

#include <candela/export.h>
#include <candela/light.h>

#include <glm/vec3.hpp>

#include <optional>

namespace candela {

/// The reflection models. Both are f = f_d + f_s with f_s = F G D / (4 (n·l)(n·v)), f_d = (1 - E_s)(1 -
/// metallic) colour / pi, E_s = `specularAlbedo` and F0 = mix(0.04, colour, metallic); see docs/lighting.md.
/// The functions of this header are the textbook form in double precision. They share no code with the
/// shaders and kernels, whose pixels the tests compare with them.
enum class BrdfModel {
    course,  ///< GGX, Schlick-Smith G with k = (roughness + 1)² / 8, Schlick F.
    gltf,    ///< GGX, height-correlated Smith, Schlick F, with energy compensation after Turquin (2019).
};

/// The model's name on the command line: "course" or "gltf".
CANDELA_API const char* toString(BrdfModel model);

/// What the reflection models read of a material. A lobe's parameters travel through this struct, and the one
/// of the same name in shaders/shared/surface_lobes.h, from the G-buffer to the light equation.
template <typename Real>
struct SurfaceLobes {
    glm::vec<3, Real> baseColor{Real(1)};  ///< Linear, in the working space, 0 to 1.
    Real metallic = Real(0);               ///< 0 to 1.
    Real roughness = Real(1);              ///< Perceptual roughness, 0 to 1.
};

/// What the reflection models read of a material with more lobes (shaders/shared/surface_lobes.h has the same
/// struct). Colours are linear, in the working space.
template <typename Real>
struct ExtendedLobes {
    glm::vec<3, Real> f0{Real(0.04)};  ///< Reflectance at normal incidence, 0 to 1, in place of F0 above.
    Real f90 = Real(1);                ///< Reflectance at grazing angles, 0 to 1; no channel falls below F0.
    Real anisotropy = Real(0);         ///< Strength, 0 to 1.
    /// The direction of the surface along which the specular lobe is wide: unit length, world space,
    /// perpendicular to the normal.
    glm::vec<3, Real> anisotropyDirection{Real(1), Real(0), Real(0)};
    glm::vec<3, Real> sheenColor{Real(0)};                         ///< 0 to 1.
    Real sheenRoughness = Real(0);                                 ///< Perceptual roughness, 0 to 1.
    Real clearcoat = Real(0);                                      ///< 0 to 1.
    Real clearcoatRoughness = Real(0);                             ///< Perceptual roughness, 0 to 1.
    glm::vec<3, Real> clearcoatNormal{Real(0), Real(0), Real(1)};  ///< Unit length, world space.
    /// The share of the light below the specular lobe that is refracted, and lost to diffuse reflection; 0 to
    /// 1.
    Real transmission = Real(0);
    Real diffuseTransmission = Real(0);  ///< The share of the diffuse reflection that passes; 0 to 1.
    glm::vec<3, Real> diffuseTransmissionColor{Real(1)};  ///< 0 to 1.
};

/// A point of a surface, in double precision.
struct SurfacePoint {
    glm::dvec3 position{0.0};          ///< Metres.
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< Unit length.
    SurfaceLobes<double> lobes = {};
    std::optional<ExtendedLobes<double>> extended = {};  ///< None: metallic and roughness are all.
};

// The functions below throw `Error` (badInput) where an argument is not finite or not in its range. Cosines
// are -1 to 1, up to rounding.

/// The minimum alpha (= roughness²) that shading uses, in every implementation: below it, single precision
/// can not represent the width of the lobe's peak. 0.001; see docs/lighting.md.
CANDELA_API extern const double minAlpha;

/// The minimum n·v that shading uses (a normal map can tilt a normal away from the eye). 0.0001.
CANDELA_API extern const double minNDotV;

/// The minimum distance to a light, in metres, that shading uses: the inverse square is clamped there. 0.001.
CANDELA_API extern const double minDistance;

/// The GGX distribution of half vectors, normalised so that the integral of D (n·h) over the hemisphere is 1.
/// `alpha` is 0 to 1. Source: Walter et al., "Microfacet models for refraction through rough surfaces", 2007,
/// equation 33.
CANDELA_API double distributionGgx(double nDotH, double alpha);

/// Schlick-Smith shadowing and masking with k = (roughness + 1)² / 8; `roughness` is 0 to 1. Sources:
/// Schlick, "An inexpensive BRDF model for physically-based rendering", 1994; k after Karis, "Real shading in
/// Unreal Engine 4", 2013.
CANDELA_API double geometrySchlickSmith(double nDotL, double nDotV, double roughness);

/// Height-correlated Smith shadowing and masking for GGX. Source: Heitz, "Understanding the masking-shadowing
/// function in microfacet-based BRDFs", 2014, equation 99.
CANDELA_API double geometrySmithCorrelated(double nDotL, double nDotV, double alpha);

/// Schlick's Fresnel term; `f0` is 0 or more. Source: Schlick, 1994.
CANDELA_API glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double vDotH);

/// F0 of a dielectric in air whose index of refraction is `ior` (1 or more, or infinity), with the factors of
/// KHR_materials_specular: `specular`, 0 to 1, which is F90 too, and `specularColor`, 0 or more. 0 to 1.
CANDELA_API glm::dvec3 dielectricF0(double ior, double specular, const glm::dvec3& specularColor);

/// The F0 with which Schlick's Fresnel term gives, at n·v, the reflectance of a thin film of index `filmIor`
/// (1 or more) on a base of `f0` (0 to 1, linear Rec.709). Source: Belcour and Barla, "A practical extension
/// to microfacet theory for the modeling of varying iridescence", 2017, in the form of
/// KHR_materials_iridescence: two orders of interference. 0 to 1.
CANDELA_API glm::dvec3 iridescentF0(double nDotV, const glm::dvec3& f0, double filmIor,
                                    double thicknessNanometres);

/// The directional albedo of the specular lobe for F = 1, without energy compensation: of light that comes
/// equally from everywhere, the fraction that the lobe reflects towards n·v. `roughness` is 0 to 1.
/// Interpolated in the same table that the shaders read; up to 0.8 % too high, so that no surface returns
/// more than it receives.
CANDELA_API double directionalAlbedo(BrdfModel model, double nDotV, double roughness);

/// E_s, the same with the Fresnel term and, in the `gltf` model, energy compensation: F0 A + B of the split
/// sum, for each channel. `f0` is 0 or more. Source: Karis, "Real shading in Unreal Engine 4", 2013.
CANDELA_API glm::dvec3 specularAlbedo(BrdfModel model, const glm::dvec3& f0, double nDotV, double roughness);

/// f(l, v) per channel, in 1/sr, of the metallic-roughness surface; `l` and `v` are unit vectors (to 0.001)
/// away from the surface. Zero when l is below the horizon. `surface.extended` is not read.
CANDELA_API glm::dvec3 evaluateBrdf(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                                    const glm::dvec3& v);

/// GGX with two alphas, 0 to 1 each; `h` is the half vector in the frame of tangent, bitangent and normal, of
/// unit length. Source: Burley, "Physically based shading at Disney", 2012, equation 13.
CANDELA_API double distributionGgxAnisotropic(const glm::dvec3& h, double tangentAlpha,
                                              double bitangentAlpha);

/// Height-correlated Smith shadowing and masking for it; `l` and `v` in the same frame. Source: Heitz 2014,
/// equations 86 and 99.
CANDELA_API double geometrySmithAnisotropic(const glm::dvec3& l, const glm::dvec3& v, double tangentAlpha,
                                            double bitangentAlpha);

/// The distribution of the half vectors of cloth. `roughness` is perceptual, 0 to 1, and at least 0.07 in
/// shading. Source: Estevez and Kulla, "Production friendly microfacet sheen BRDF", 2017.
CANDELA_API double distributionCharlie(double nDotH, double roughness);

/// Shadowing and masking of cloth over 4 (n·l) (n·v). Source: Neubelt and Pettineo, "Crafting a next-gen
/// material pipeline for The Order: 1886", 2013.
CANDELA_API double visibilityNeubelt(double nDotL, double nDotV);

/// The directional albedo of the lobe that the last two make, 0 or more: at grazing angles of smooth cloth it
/// is over 1, where shading divides the lobe by it. Interpolated in the same table that the shaders read; up
/// to 4 % too high.
CANDELA_API double sheenAlbedo(double nDotV, double roughness);

/// f(l, v) times the cosine between l and the normal, in 1/sr: of `evaluateBrdf`, or of all lobes of
/// `surface.extended`, whose clearcoat has a normal of its own and whose diffuse transmission scatters light
/// from below the horizon.
CANDELA_API glm::dvec3 evaluateReflection(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                                          const glm::dvec3& v);

/// KHR_lights_punctual's window on the inverse square: max(0, 1 - (distance / range)^4); 0 at the range and
/// beyond it. Metres; `distance` is 0 or more, `range` is over 0.
CANDELA_API double rangeWindow(double distance, double range);

/// KHR_lights_punctual's spot factor, squared ramp between the cosines of the outer and the inner angle
/// (radians, 0 <= inner <= outer <= pi / 2; equal angles give a ramp of 0.001 in the cosine).
CANDELA_API double spotFactor(double cosAngle, double innerConeAngle, double outerConeAngle);

/// The radiance that leaves `surface` towards `eye` by `light`: pi f L_i (n·l), of all lobes, with L_i =
/// intensity / (pi d²) × window × spot factor; for a directional light, pi f (intensity / pi) (n·l). The
/// light's intensity is in the working space. A range of 0 is none: the window is 1 (where a light has none,
/// the renderer assigns one: `LightReport`).
CANDELA_API glm::dvec3 reflectedRadiance(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& eye,
                                         const WorldLight& light);

}  // namespace candela
