#include <candela/brdf.h>

#include "shading/argument_checks.h"
#include "shading/directional_albedo.h"
#include "shading/extended_brdf.h"

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

/// Keeps (n·l) in the denominator from underflowing; far below any angle that a picture can show.
constexpr double minNDotL = 1.0e-30;

/// Shorter vectors have no direction.
constexpr double minLength = 1.0e-150;

void requireSurface(const SurfacePoint& surface) {
    require(isFinite(surface.position), "the surface's position", "finite");
    require(isUnit(surface.normal), "the surface's normal", "of unit length");
    require(isNonNegative(surface.lobes.baseColor), "the surface's base colour", "finite and 0 or more");
    requireUnitRange(surface.lobes.metallic, "the surface's metallic");
    requireUnitRange(surface.lobes.roughness, "the surface's roughness");
    requireExtendedLobes(surface);
}

void requireCone(double innerConeAngle, double outerConeAngle) {
    // pi / 2 in single precision is more than pi / 2.
    require(innerConeAngle >= 0.0 && innerConeAngle <= outerConeAngle && outerConeAngle <= 1.5708,
            "the pair of cone angles", "0 <= inner <= outer <= pi / 2");
}

void requireLight(const WorldLight& light) {
    require(isNonNegative(glm::dvec3(light.intensity)), "the light's intensity", "finite and 0 or more");
    if (light.type != LightType::point)
        require(isUnit(glm::dvec3(light.direction)), "the light's direction", "of unit length");
    if (light.type == LightType::directional) return;
    require(isFinite(glm::dvec3(light.position)), "the light's position", "finite");
    require(light.range >= 0.0f, "the light's range", "over 0 metres, or 0 for none");
    if (light.type == LightType::spot) requireCone(light.innerConeAngle, light.outerConeAngle);
}

double clampAlpha(double alpha) {
    return std::max(alpha, minAlpha);
}

/// G D / (4 (n·l) (n·v)).
double specularLobe(BrdfModel model, double roughness, double nDotL, double nDotV, double nDotH) {
    const double alpha = clampAlpha(roughness * roughness);
    const double geometry = model == BrdfModel::course ? geometrySchlickSmith(nDotL, nDotV, roughness)
                                                       : geometrySmithCorrelated(nDotL, nDotV, alpha);
    return geometry * distributionGgx(nDotH, alpha) / (4.0 * nDotL * nDotV);
}

/// Source: Turquin, "Practical multiple scattering compensation for microfacet models", 2019.
glm::dvec3 compensation(BrdfModel model, const glm::dvec3& f0, double albedo) {
    if (model == BrdfModel::course) return glm::dvec3(1.0);
    return 1.0 + f0 * (1.0 - albedo) / albedo;
}

/// The specular lobe's dependence on the direction of view alone.
struct LobeEnergy {
    glm::dvec3 compensation, albedo;  ///< `albedo` is E_s.
};

LobeEnergy lobeEnergy(BrdfModel model, const glm::dvec3& f0, double nDotV, double roughness) {
    const LobeAlbedo lobe = lobeAlbedo(model, nDotV, roughness);
    const glm::dvec3 factor = compensation(model, f0, lobe.albedo);
    const glm::dvec3 fresnel = f0 * (1.0 - lobe.fresnelWeight) + lobe.fresnelWeight;
    return {factor, factor * fresnel * lobe.albedo};
}

/// Unit vector from `from` to `to`; zero where they are the same point.
glm::dvec3 directionBetween(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 offset = to - from;
    const double length = glm::length(offset);
    return length < minLength ? glm::dvec3(0.0) : offset / length;
}

/// L_i of a point or spot light, as the lighting equation takes it: candela / pi over the squared distance.
glm::dvec3 incidentRadiance(const WorldLight& light, const glm::dvec3& l, double distance) {
    const double clampedDistance = std::max(distance, minDistance);
    const double window = light.range > 0.0f ? rangeWindow(distance, light.range) : 1.0;
    double factor = window / (clampedDistance * clampedDistance);
    if (light.type == LightType::spot) {
        const double cosAngle = glm::dot(glm::dvec3(light.direction), -l);
        factor *= spotFactor(cosAngle, light.innerConeAngle, light.outerConeAngle);
    }
    return glm::dvec3(light.intensity) / std::numbers::pi * factor;
}

/// `evaluateBrdf` for arguments that are checked.
glm::dvec3 textbookBrdf(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                        const glm::dvec3& v) {
    const SurfaceLobes<double>& lobes = surface.lobes;
    // A normal that is of unit length only to single precision would change D at the minimum alpha by a
    // tenth.
    const glm::dvec3 n = glm::normalize(surface.normal);
    if (glm::dot(n, l) <= 0.0) return glm::dvec3(0.0);
    const double nDotL = std::max(glm::dot(n, l), minNDotL);
    const double nDotV = std::max(glm::dot(n, v), minNDotV);
    const glm::dvec3 f0 = glm::mix(glm::dvec3(DIELECTRIC_F0), lobes.baseColor, lobes.metallic);
    const LobeEnergy energy = lobeEnergy(model, f0, nDotV, lobes.roughness);
    const glm::dvec3 transmitted = glm::max(1.0 - energy.albedo, 0.0);
    const glm::dvec3 diffuse = transmitted * (1.0 - lobes.metallic) * lobes.baseColor / std::numbers::pi;
    const glm::dvec3 h = directionBetween(-v, l);
    // Opposite directions have no half vector: the lobe is taken as 0.
    if (h == glm::dvec3(0.0)) return diffuse;
    const double lobe = specularLobe(model, lobes.roughness, nDotL, nDotV, glm::dot(n, h));
    return diffuse + fresnelSchlick(f0, glm::dot(v, h)) * lobe * energy.compensation;
}

/// `evaluateReflection` for arguments that are checked.
glm::dvec3 reflection(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                      const glm::dvec3& v) {
    if (surface.extended) return extendedReflection(model, surface, l, v);
    const double nDotL = glm::dot(surface.normal, l);
    return nDotL <= 0.0 ? glm::dvec3(0.0) : textbookBrdf(model, surface, l, v) * nDotL;
}

}  // namespace

const double minAlpha = MIN_ALPHA;
const double minNDotV = MIN_N_DOT_V;
const double minDistance = MIN_DISTANCE;

const char* toString(BrdfModel model) {
    return model == BrdfModel::course ? "course" : "gltf";
}

// Without Walter's step function: n·h is below 0 only where a normal map has turned the normal away from the
// eye, and there a step would draw an edge.
double distributionGgx(double nDotH, double alpha) {
    requireCosine(nDotH, "n·h");
    requireUnitRange(alpha, "alpha");
    const double alphaSquared = clampAlpha(alpha) * clampAlpha(alpha);
    const double cosineSquared = std::min(nDotH * nDotH, 1.0);
    const double denominator = cosineSquared * (alphaSquared - 1.0) + 1.0;
    return alphaSquared / (std::numbers::pi * denominator * denominator);
}

double geometrySchlickSmith(double nDotL, double nDotV, double roughness) {
    requireCosine(nDotL, "n·l");
    requireCosine(nDotV, "n·v");
    requireUnitRange(roughness, "roughness");
    const double k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    const auto side = [k](double nDotW) { return nDotW / (nDotW * (1.0 - k) + k); };
    return side(nDotL) * side(nDotV);
}

double geometrySmithCorrelated(double nDotL, double nDotV, double alpha) {
    requireCosine(nDotL, "n·l");
    requireCosine(nDotV, "n·v");
    requireUnitRange(alpha, "alpha");
    const double alphaSquared = clampAlpha(alpha) * clampAlpha(alpha);
    const auto root = [alphaSquared](double nDotW) {
        return std::sqrt(alphaSquared + (1.0 - alphaSquared) * nDotW * nDotW);
    };
    nDotV = std::max(nDotV, minNDotV);
    return 2.0 * nDotL * nDotV / (nDotL * root(nDotV) + nDotV * root(nDotL));
}

glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double vDotH) {
    require(isNonNegative(f0), "F0", "finite and 0 or more");
    requireCosine(vDotH, "v·h");
    const double sine = 1.0 - std::clamp(vDotH, 0.0, 1.0);
    return f0 + (1.0 - f0) * std::pow(sine, 5.0);
}

double directionalAlbedo(BrdfModel model, double nDotV, double roughness) {
    requireCosine(nDotV, "n·v");
    requireUnitRange(roughness, "roughness");
    return lobeAlbedo(model, nDotV, roughness).albedo;
}

glm::dvec3 specularAlbedo(BrdfModel model, const glm::dvec3& f0, double nDotV, double roughness) {
    require(isNonNegative(f0), "F0", "finite and 0 or more");
    requireCosine(nDotV, "n·v");
    requireUnitRange(roughness, "roughness");
    return lobeEnergy(model, f0, nDotV, roughness).albedo;
}

glm::dvec3 evaluateBrdf(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                        const glm::dvec3& v) {
    requireSurface(surface);
    require(isUnit(l), "the direction to the light", "of unit length");
    require(isUnit(v), "the direction to the eye", "of unit length");
    return textbookBrdf(model, surface, l, v);
}

glm::dvec3 evaluateReflection(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                              const glm::dvec3& v) {
    requireSurface(surface);
    require(isUnit(l), "the direction to the light", "of unit length");
    require(isUnit(v), "the direction to the eye", "of unit length");
    return reflection(model, surface, l, v);
}

double rangeWindow(double distance, double range) {
    require(std::isfinite(distance) && distance >= 0.0, "the distance", "finite and 0 or more metres");
    require(range > 0.0, "the range", "over 0 metres");
    return std::max(0.0, 1.0 - std::pow(distance / range, 4.0));
}

double spotFactor(double cosAngle, double innerConeAngle, double outerConeAngle) {
    requireCosine(cosAngle, "the cosine of the angle");
    requireCone(innerConeAngle, outerConeAngle);
    const double cosOuter = std::cos(outerConeAngle);
    // The minimum width of the ramp is that of the extension.
    const double width = std::max(0.001, std::cos(innerConeAngle) - cosOuter);
    const double ramp = std::clamp((cosAngle - cosOuter) / width, 0.0, 1.0);
    return ramp * ramp;
}

glm::dvec3 reflectedRadiance(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& eye,
                             const WorldLight& light) {
    requireSurface(surface);
    require(isFinite(eye), "the eye", "finite");
    requireLight(light);
    const glm::dvec3 v = directionBetween(surface.position, eye);
    const bool directional = light.type == LightType::directional;
    const glm::dvec3 l = directional ? -glm::dvec3(light.direction)
                                     : directionBetween(surface.position, glm::dvec3(light.position));
    if (l == glm::dvec3(0.0)) return glm::dvec3(0.0);
    const glm::dvec3 incident =
        directional ? glm::dvec3(light.intensity) / std::numbers::pi
                    : incidentRadiance(light, l, glm::distance(surface.position, glm::dvec3(light.position)));
    return std::numbers::pi * reflection(model, surface, l, v) * incident;
}

}  // namespace candela
