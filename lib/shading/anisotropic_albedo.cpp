#include "shading/anisotropic_albedo.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {
namespace {

using Scalar = double;
#include "shared/shading_constants.h"

constexpr int heights = 8, azimuths = 8;

struct Lobe {
    BrdfModel model;
    glm::dvec3 alphas;  ///< Along tangent and bitangent; 1 along the normal.
    double maskingRoughness;

    /// Smith's Lambda of a direction. Source: Heitz 2014, equations 72 and 80.
    double lambda(const glm::dvec3& w) const { return 0.5 * (glm::length(alphas * w) / w.z - 1.0); }

    /// f_s (n·l) for F = 1 over the density of the reflections of visible normals, D G1(v) / (4 n·v).
    double weight(const glm::dvec3& l, const glm::dvec3& v) const {
        const double inverseMasking = 1.0 + lambda(v);
        if (model == BrdfModel::gltf) return inverseMasking / (inverseMasking + lambda(l));
        return geometrySchlickSmith(l.z, v.z, maskingRoughness) * inverseMasking;
    }
};

/// A normal visible from v, by a point of a spherical cap. Source: Dupuy and Benyoub, "Sampling visible GGX
/// normals with spherical caps", 2023.
glm::dvec3 visibleNormal(const glm::dvec3& v, const glm::dvec3& alphas, double height, double azimuth) {
    const glm::dvec3 stretched = glm::normalize(alphas * v);
    const double z = height * (1.0 + stretched.z) - stretched.z;
    const double radius = std::sqrt(std::max(0.0, 1.0 - z * z));
    const glm::dvec3 half = stretched + glm::dvec3(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
    return glm::normalize(alphas * half);
}

}  // namespace

LobeAlbedo anisotropicAlbedo(BrdfModel model, const glm::dvec3& v, double tangentAlpha, double bitangentAlpha,
                             double maskingRoughness) {
    const Lobe lobe{model, glm::dvec3(tangentAlpha, bitangentAlpha, 1.0), maskingRoughness};
    double sum = 0.0, grazing = 0.0;
    for (int i = 0; i < heights; ++i) {
        const double place = (i + 0.5) / heights;
        for (int j = 0; j < azimuths; ++j) {
            const double turn = (j + 1 + (i % 2 == 1 ? 0.25 : 0.75)) / azimuths;
            const glm::dvec3 h =
                visibleNormal(v, lobe.alphas, std::pow(place, 1.5), 2.0 * std::numbers::pi * turn);
            const double vDotH = glm::dot(v, h);
            const glm::dvec3 l = 2.0 * vDotH * h - v;
            if (l.z <= 0.0) continue;
            const double weight = 1.5 * std::sqrt(place) * lobe.weight(l, v) / (heights * azimuths);
            sum += weight;
            grazing += weight * std::pow(std::max(1.0 - vDotH, 0.0), 5.0);
        }
    }
    const double meanWeight = grazing / std::max(sum, 1.0e-6);
    return {std::min(sum * (1.0 + ANISOTROPIC_BIAS), 1.0),
            std::min(meanWeight * (1.0 + ANISOTROPIC_BIAS) + ANISOTROPIC_FRESNEL_BIAS, 1.0)};
}

}  // namespace candela
