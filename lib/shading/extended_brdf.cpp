#include "shading/extended_brdf.h"

#include "shading/anisotropic_albedo.h"
#include "shading/argument_checks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

using namespace arguments;

namespace {

using Scalar = double;
#include "shared/shading_constants.h"

constexpr double minNDotL = 1.0e-30;

double alphaOf(double roughness) {
    return std::max(roughness * roughness, minAlpha);
}

double maxChannel(const glm::dvec3& color) {
    return std::max({color.x, color.y, color.z});
}

/// Of l and v; zero where they are opposite.
glm::dvec3 halfVector(const glm::dvec3& l, const glm::dvec3& v) {
    const double length = glm::length(l + v);
    return length < 1.0e-150 ? glm::dvec3(0.0) : (l + v) / length;
}

/// Source: Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
glm::dvec3 compensation(BrdfModel model, const glm::dvec3& f0, double albedo) {
    return model == BrdfModel::course ? glm::dvec3(1.0) : 1.0 + f0 * (1.0 - albedo) / albedo;
}

struct Frame {
    glm::dvec3 tangent, bitangent, normal;

    explicit Frame(const SurfacePoint& surface) : normal(glm::normalize(surface.normal)) {
        const glm::dvec3& direction = surface.extended->anisotropyDirection;
        tangent = glm::normalize(direction - normal * glm::dot(normal, direction));
        bitangent = glm::cross(normal, tangent);
    }
    glm::dvec3 local(const glm::dvec3& w) const {
        return {glm::dot(w, tangent), glm::dot(w, bitangent), glm::dot(w, normal)};
    }
};

/// The specular lobe below sheen and clearcoat, seen from `v`.
struct Base {
    BrdfModel model;
    const ExtendedLobes<double>& lobes;
    double roughness, tangentAlpha, bitangentAlpha, maskingRoughness;
    LobeAlbedo albedo;
    glm::dvec3 factor;  ///< Energy compensation.

    /// `v` is local, with v.z over 0.
    Base(BrdfModel ofModel, const SurfacePoint& surface, const glm::dvec3& v)
        : model(ofModel), lobes(*surface.extended), roughness(surface.lobes.roughness) {
        bitangentAlpha = alphaOf(roughness);
        tangentAlpha = glm::mix(bitangentAlpha, 1.0, lobes.anisotropy * lobes.anisotropy);
        if (lobes.anisotropy > 0.0) {
            // Isotropic masking, by alpha of the cut along v; of both along the normal.
            const double alpha2 = v.x * v.x * tangentAlpha * tangentAlpha +
                                  v.y * v.y * bitangentAlpha * bitangentAlpha +
                                  v.z * v.z * tangentAlpha * bitangentAlpha;
            maskingRoughness = std::pow(std::min(alpha2, 1.0), 0.25);
            albedo = anisotropicAlbedo(model, v, tangentAlpha, bitangentAlpha, maskingRoughness);
        } else {
            maskingRoughness = roughness;
            albedo = lobeAlbedo(model, v.z, roughness);
        }
        factor = compensation(model, lobes.f0, albedo.albedo);
    }

    /// The reflectance does not fall towards grazing angles.
    glm::dvec3 f90() const { return glm::max(glm::dvec3(lobes.f90), lobes.f0); }

    /// E_s.
    glm::dvec3 reflected() const {
        const double a = albedo.albedo * (1.0 - albedo.fresnelWeight),
                     b = albedo.albedo * albedo.fresnelWeight;
        return factor * (lobes.f0 * a + f90() * b);
    }

    /// F G D / (4 (n·l) (n·v)); directions are local, l.z and v.z over 0. `h` is that of the true v.
    glm::dvec3 specular(const glm::dvec3& l, const glm::dvec3& v, const glm::dvec3& h, double vDotH) const {
        const double geometry = model == BrdfModel::course
                                    ? geometrySchlickSmith(l.z, v.z, maskingRoughness)
                                    : geometrySmithAnisotropic(l, v, tangentAlpha, bitangentAlpha);
        const double distribution = distributionGgxAnisotropic(h, tangentAlpha, bitangentAlpha);
        const glm::dvec3 fresnel =
            lobes.f0 + (f90() - lobes.f0) * std::pow(1.0 - std::clamp(vDotH, 0.0, 1.0), 5.0);
        return factor * fresnel * geometry * distribution / (4.0 * l.z * v.z);
    }
};

/// The clearcoat's normal, turned to be perpendicular to v where it points away from it.
glm::dvec3 seenCoatNormal(const ExtendedLobes<double>& lobes, const glm::dvec3& v) {
    const glm::dvec3 n = glm::normalize(lobes.clearcoatNormal);
    const glm::dvec3 turned = n + v * std::max(-glm::dot(n, v), 0.0);
    return turned / std::max(glm::length(turned), 1.0e-6);
}

/// The clearcoat times the cosine of its normal, without its factor.
double coatReflection(BrdfModel model, const ExtendedLobes<double>& lobes, const glm::dvec3& l,
                      const glm::dvec3& v) {
    const glm::dvec3 n = seenCoatNormal(lobes, v);
    const double nDotL = glm::dot(n, l), nDotV = std::max(glm::dot(n, v), minNDotV);
    const glm::dvec3 h = halfVector(l, v);
    if (nDotL <= minNDotL || h == glm::dvec3(0.0)) return 0.0;
    const glm::dvec3 f0(DIELECTRIC_F0);
    const double alpha = alphaOf(lobes.clearcoatRoughness);
    const double geometry = model == BrdfModel::course
                                ? geometrySchlickSmith(nDotL, nDotV, lobes.clearcoatRoughness)
                                : geometrySmithCorrelated(nDotL, nDotV, alpha);
    const double fresnel = fresnelSchlick(f0, glm::dot(v, h)).x;
    const double factor =
        compensation(model, f0, directionalAlbedo(model, nDotV, lobes.clearcoatRoughness)).x;
    return factor * fresnel * geometry * distributionGgx(glm::dot(n, h), alpha) / (4.0 * nDotV);
}

/// What the clearcoat leaves of the light.
double belowCoat(BrdfModel model, const ExtendedLobes<double>& lobes, const glm::dvec3& v) {
    const double nDotV = std::max(glm::dot(seenCoatNormal(lobes, v), v), minNDotV);
    const double albedo = specularAlbedo(model, glm::dvec3(DIELECTRIC_F0), nDotV, lobes.clearcoatRoughness).x;
    return 1.0 - lobes.clearcoat * albedo;
}

}  // namespace

double distributionGgxAnisotropic(const glm::dvec3& h, double tangentAlpha, double bitangentAlpha) {
    require(isUnit(h), "the half vector", "of unit length");
    requireUnitRange(tangentAlpha, "alpha along the tangent");
    requireUnitRange(bitangentAlpha, "alpha along the bitangent");
    const double t = std::max(tangentAlpha, minAlpha), b = std::max(bitangentAlpha, minAlpha);
    const double sum = (h.x / t) * (h.x / t) + (h.y / b) * (h.y / b) + h.z * h.z;
    return 1.0 / (std::numbers::pi * t * b * sum * sum);
}

double geometrySmithAnisotropic(const glm::dvec3& l, const glm::dvec3& v, double tangentAlpha,
                                double bitangentAlpha) {
    requireCosine(l.z, "n·l");
    requireCosine(v.z, "n·v");
    requireUnitRange(tangentAlpha, "alpha along the tangent");
    requireUnitRange(bitangentAlpha, "alpha along the bitangent");
    const glm::dvec3 scale(std::max(tangentAlpha, minAlpha), std::max(bitangentAlpha, minAlpha), 1.0);
    return 2.0 * l.z * v.z / (l.z * glm::length(v * scale) + v.z * glm::length(l * scale));
}

void requireExtendedLobes(const SurfacePoint& surface) {
    if (!surface.extended) return;
    const ExtendedLobes<double>& lobes = *surface.extended;
    requireUnitRange(lobes.f0, "F0");
    requireUnitRange(lobes.f90, "F90");
    requireUnitRange(lobes.anisotropy, "the anisotropy");
    require(isUnit(lobes.anisotropyDirection), "the direction of anisotropy", "of unit length");
    require(std::abs(glm::dot(lobes.anisotropyDirection, surface.normal)) <= 0.1,
            "the direction of anisotropy", "perpendicular to the normal");
    requireUnitRange(lobes.sheenColor, "the sheen's colour");
    requireUnitRange(lobes.sheenRoughness, "the sheen's roughness");
    requireUnitRange(lobes.clearcoat, "the clearcoat");
    requireUnitRange(lobes.clearcoatRoughness, "the clearcoat's roughness");
    require(isUnit(lobes.clearcoatNormal), "the clearcoat's normal", "of unit length");
    requireUnitRange(lobes.transmission, "the transmission");
    requireUnitRange(lobes.diffuseTransmission, "the diffuse transmission");
    requireUnitRange(lobes.diffuseTransmissionColor, "the diffuse transmission's colour");
}

glm::dvec3 extendedReflection(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                              const glm::dvec3& v) {
    const ExtendedLobes<double>& lobes = *surface.extended;
    const Frame frame(surface);
    const glm::dvec3 localL = frame.local(l), trueV = frame.local(v), h = halfVector(l, v);
    const glm::dvec3 localV(trueV.x, trueV.y, std::max(trueV.z, minNDotV));
    const Base base(model, surface, localV);
    const double sheen = sheenAlbedo(localV.z, lobes.sheenRoughness);
    const double coat = belowCoat(model, lobes, v);
    const double belowSheen = coat * (1.0 - maxChannel(lobes.sheenColor) * std::min(sheen, 1.0));
    const glm::dvec3 entering = glm::max(1.0 - base.reflected(), 0.0) * (1.0 - surface.lobes.metallic) *
                                (1.0 - lobes.transmission) * belowSheen / std::numbers::pi;
    glm::dvec3 sum = glm::dvec3(lobes.clearcoat * coatReflection(model, lobes, l, v));
    if (localL.z < 0.0) {
        return sum +
               entering * lobes.diffuseTransmission * lobes.diffuseTransmissionColor * std::abs(localL.z);
    }
    sum += entering * (1.0 - lobes.diffuseTransmission) * surface.lobes.baseColor * localL.z;
    if (h == glm::dvec3(0.0) || localL.z <= minNDotL) return sum;
    const glm::dvec3 localH = frame.local(h);
    sum += base.specular(localL, localV, localH, glm::dot(v, h)) * belowSheen * localL.z;
    const double cloth =
        distributionCharlie(localH.z, lobes.sheenRoughness) * visibilityNeubelt(localL.z, localV.z);
    return sum + lobes.sheenColor * (cloth / std::max(sheen, 1.0) * coat * localL.z);
}

}  // namespace candela
