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

/// The clearcoat over a surface, seen from `v`.
struct Coat {
    BrdfModel model;
    const ExtendedLobes<double>& lobes;
    glm::dvec3 normal;
    double nDotV;
    double factor = 0.0;  ///< Energy compensation.
    double below = 1.0;   ///< What the clearcoat leaves of the light.

    Coat(BrdfModel ofModel, const ExtendedLobes<double>& ofLobes, const glm::dvec3& v)
        : model(ofModel),
          lobes(ofLobes),
          normal(seenCoatNormal(ofLobes, v)),
          nDotV(std::max(glm::dot(normal, v), minNDotV)) {
        if (lobes.clearcoat == 0.0) return;
        const glm::dvec3 f0(DIELECTRIC_F0);
        factor = compensation(model, f0, directionalAlbedo(model, nDotV, lobes.clearcoatRoughness)).x;
        below = 1.0 - lobes.clearcoat * specularAlbedo(model, f0, nDotV, lobes.clearcoatRoughness).x;
    }

    /// Times the cosine of its normal.
    double reflection(const glm::dvec3& l, const glm::dvec3& v, const glm::dvec3& h) const {
        const double nDotL = glm::dot(normal, l);
        if (lobes.clearcoat == 0.0 || nDotL <= minNDotL || h == glm::dvec3(0.0)) return 0.0;
        const double alpha = alphaOf(lobes.clearcoatRoughness);
        const double geometry = model == BrdfModel::course
                                    ? geometrySchlickSmith(nDotL, nDotV, lobes.clearcoatRoughness)
                                    : geometrySmithCorrelated(nDotL, nDotV, alpha);
        const double fresnel = fresnelSchlick(glm::dvec3(DIELECTRIC_F0), glm::dot(v, h)).x;
        const double distribution = distributionGgx(glm::dot(normal, h), alpha);
        return lobes.clearcoat * factor * fresnel * geometry * distribution / (4.0 * nDotV);
    }
};

/// What leaves a surface towards one direction.
struct Reflection {
    const SurfacePoint& surface;
    const ExtendedLobes<double>& lobes;
    Frame frame;
    glm::dvec3 v, localV;
    Base base;
    Coat coat;
    double sheen = 0.0;   ///< Directional albedo.
    double belowSheen;    ///< The share of the light that arrives below sheen and clearcoat.
    glm::dvec3 entering;  ///< The share that the diffuse lobes take, over pi.

    Reflection(BrdfModel model, const SurfacePoint& of, const glm::dvec3& towards)
        : surface(of),
          lobes(*of.extended),
          frame(of),
          v(towards),
          localV(aboveHorizon(frame.local(towards))),
          base(model, of, localV),
          coat(model, lobes, towards) {
        if (maxChannel(lobes.sheenColor) > 0.0) sheen = sheenAlbedo(localV.z, lobes.sheenRoughness);
        belowSheen = coat.below * (1.0 - maxChannel(lobes.sheenColor) * std::min(sheen, 1.0));
        entering = glm::max(1.0 - base.reflected(), 0.0) * (1.0 - surface.lobes.metallic) *
                   (1.0 - lobes.transmission) * belowSheen / std::numbers::pi;
    }

    static glm::dvec3 aboveHorizon(const glm::dvec3& w) { return {w.x, w.y, std::max(w.z, minNDotV)}; }

    glm::dvec3 from(const glm::dvec3& l) const {
        const glm::dvec3 localL = frame.local(l), h = halfVector(l, v);
        glm::dvec3 sum(coat.reflection(l, v, h));
        if (localL.z < 0.0) {
            return sum +
                   entering * lobes.diffuseTransmission * lobes.diffuseTransmissionColor * std::abs(localL.z);
        }
        sum += entering * (1.0 - lobes.diffuseTransmission) * surface.lobes.baseColor * localL.z;
        if (h == glm::dvec3(0.0) || localL.z <= minNDotL) return sum;
        const glm::dvec3 localH = frame.local(h);
        sum += base.specular(localL, localV, localH, glm::dot(v, h)) * belowSheen * localL.z;
        if (maxChannel(lobes.sheenColor) == 0.0) return sum;
        const double cloth =
            distributionCharlie(localH.z, lobes.sheenRoughness) * visibilityNeubelt(localL.z, localV.z);
        return sum + lobes.sheenColor * (cloth / std::max(sheen, 1.0) * coat.below * localL.z);
    }
};

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
    return Reflection(model, surface, v).from(l);
}

std::function<glm::dvec3(const glm::dvec3& l)> extendedReflectionTowards(BrdfModel model,
                                                                         const SurfacePoint& surface,
                                                                         const glm::dvec3& v) {
    return [reflection = Reflection(model, surface, v)](const glm::dvec3& l) { return reflection.from(l); };
}

}  // namespace candela
