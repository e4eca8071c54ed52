#pragma once

#include <candela/brdf.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

/// White furnace integrals of `candela::evaluateBrdf` over all light directions, for one view
/// direction.
namespace candela::furnace {

/// A surface with normal +Z at the origin.
inline SurfacePoint surface(double color, double metallic, double roughness) {
    SurfacePoint point;
    point.lobes.baseColor = glm::dvec3(color);
    point.lobes.metallic = metallic;
    point.lobes.roughness = roughness;
    return point;
}

inline glm::dvec3 viewDirection(double nDotV) {
    return glm::dvec3(std::sqrt(1.0 - nDotV * nDotV), 0.0, nDotV);
}

/// The midpoint rule over `azimuth` (0 to pi, since isotropic lobes are mirror-symmetric) and
/// s in 0 to 1.
template <typename Integrand>
double mean(int samples, const Integrand& integrand) {
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double azimuth = std::numbers::pi * (i + 0.5) / samples;
        for (int j = 0; j < samples; ++j) sum += integrand(azimuth, (j + 0.5) / samples);
    }
    return sum / (double(samples) * samples);
}

/// A normal visible from `v`, after Dupuy and Benyoub, "Sampling visible GGX normals with spherical caps",
/// 2023; `height` is 0 to 1.
inline glm::dvec3 visibleNormal(const glm::dvec3& v, double alpha, double azimuth, double height) {
    const glm::dvec3 stretched = glm::normalize(glm::dvec3(alpha * v.x, alpha * v.y, v.z));
    const double halfZ = height * (1.0 + stretched.z);
    const double z = halfZ - stretched.z;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double x = stretched.x + radius * std::cos(azimuth), y = radius * std::sin(azimuth);
    return glm::normalize(glm::dvec3(alpha * x, alpha * y, halfZ));
}

/// The fraction of light that the specular lobe alone, with `f0` for F0, reflects towards n·v. Samples follow
/// the density of visible GGX normals; whatever model is integrated, f (n·l) / density is then bounded.
inline double specularAlbedo(BrdfModel model, double f0, double roughness, double nDotV, int samples) {
    const SurfacePoint metal = surface(f0, 1.0, roughness);
    const double alpha = std::max(roughness * roughness, minAlpha);
    const glm::dvec3 v = viewDirection(nDotV);
    const double tangentSquared = 1.0 / (nDotV * nDotV) - 1.0;
    const double masking = 2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * tangentSquared));
    return mean(samples, [&](double azimuth, double s) {
        // Squared, so that samples are dense where h is far from n and the integrand steep.
        const glm::dvec3 h = visibleNormal(v, alpha, azimuth, s * s);
        const glm::dvec3 l = glm::normalize(2.0 * glm::dot(v, h) * h - v);
        if (l.z <= 0.0) return 0.0;
        const double density = distributionGgx(h.z, alpha) * masking / (4.0 * nDotV);
        return 2.0 * s * evaluateBrdf(model, metal, l, v).x * l.z / density;
    });
}

/// The fraction of light that the diffuse part of a white dielectric reflects towards n·v. It is what a black
/// metal of the same F0, which has the same lobe, lacks. Samples follow the cosine.
inline double diffuseAlbedo(BrdfModel model, double roughness, double nDotV, int samples) {
    const SurfacePoint dielectric = surface(1.0, 0.0, roughness);
    const SurfacePoint lobe = surface(0.04, 1.0, roughness);
    const glm::dvec3 v = viewDirection(nDotV);
    return mean(samples, [&](double azimuth, double s) {
        const double sine = std::sqrt(1.0 - s);
        const glm::dvec3 l(sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(s));
        const double both = evaluateBrdf(model, dielectric, l, v).x;
        return std::numbers::pi * (both - evaluateBrdf(model, lobe, l, v).x);
    });
}

inline double whiteMetal(BrdfModel model, double roughness, double nDotV, int samples) {
    return specularAlbedo(model, 1.0, roughness, nDotV, samples);
}

inline double whiteDielectric(BrdfModel model, double roughness, double nDotV, int samples) {
    return specularAlbedo(model, 0.04, roughness, nDotV, samples) +
           diffuseAlbedo(model, roughness, nDotV, samples);
}

}  // namespace candela::furnace
