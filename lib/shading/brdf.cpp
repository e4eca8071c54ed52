#include <candela/brdf.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace candela {
namespace {

/// Keeps (n·l) in the denominator from underflowing; far below any angle that a picture can show.
constexpr double minNDotL = 1.0e-30;

/// Shorter vectors have no direction.
constexpr double minLength = 1.0e-150;

double clampAlpha(double alpha) {
    return std::max(alpha, minAlpha);
}

/// The share of light that the compensated lobe adds, per unit of F0: (1 - E) / E. Source: Turquin,
/// "Practical multiple scattering compensation for microfacet models", 2019.
double missingShare(double nDotV, double alpha) {
    const double albedo = directionalAlbedo(nDotV, alpha);
    return (1.0 - albedo) / albedo;
}

/// G D / (4 (n·l) (n·v)).
double specularLobe(BrdfModel model, double roughness, double nDotL, double nDotV, double nDotH) {
    const double alpha = clampAlpha(roughness * roughness);
    const double geometry = model == BrdfModel::course ? geometrySchlickSmith(nDotL, nDotV, roughness)
                                                       : geometrySmithCorrelated(nDotL, nDotV, alpha);
    return geometry * distributionGgx(nDotH, alpha) / (4.0 * nDotL * nDotV);
}

glm::dvec3 compensation(BrdfModel model, const glm::dvec3& f0, double nDotV, double alpha) {
    if (model == BrdfModel::course) return glm::dvec3(1.0);
    return 1.0 + f0 * missingShare(nDotV, alpha);
}

/// Unit vector from `from` to `to`; zero where they are the same point.
glm::dvec3 directionBetween(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    return length < minLength ? glm::dvec3(0.0) : way / length;
}

/// L_i of a point or spot light, as the lighting equation takes it: candela / pi over the squared distance.
glm::dvec3 incidentRadiance(const WorldLight& light, const glm::dvec3& l, double distance) {
    const double reach = std::max(distance, minDistance);
    double factor = rangeWindow(distance, light.range) / (reach * reach);
    if (light.type == LightType::spot) {
        const double cosAngle = glm::dot(glm::dvec3(light.direction), -l);
        factor *= spotFactor(cosAngle, light.innerConeAngle, light.outerConeAngle);
    }
    return glm::dvec3(light.intensity) / std::numbers::pi * factor;
}

}  // namespace

const char* toString(BrdfModel model) {
    return model == BrdfModel::course ? "course" : "gltf";
}

// Without Walter's step function: n·h is below 0 only where a normal map has turned the normal away from the
// eye, and there a step would draw an edge.
double distributionGgx(double nDotH, double alpha) {
    const double alphaSquared = clampAlpha(alpha) * clampAlpha(alpha);
    const double cosineSquared = std::min(nDotH * nDotH, 1.0);
    const double denominator = cosineSquared * (alphaSquared - 1.0) + 1.0;
    return alphaSquared / (std::numbers::pi * denominator * denominator);
}

double geometrySchlickSmith(double nDotL, double nDotV, double roughness) {
    const double k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    const auto side = [k](double nDotW) { return nDotW / (nDotW * (1.0 - k) + k); };
    return side(nDotL) * side(nDotV);
}

double geometrySmithCorrelated(double nDotL, double nDotV, double alpha) {
    const double alphaSquared = clampAlpha(alpha) * clampAlpha(alpha);
    const auto root = [alphaSquared](double nDotW) {
        return std::sqrt(alphaSquared + (1.0 - alphaSquared) * nDotW * nDotW);
    };
    nDotV = std::max(nDotV, minNDotV);
    return 2.0 * nDotL * nDotV / (nDotL * root(nDotV) + nDotV * root(nDotL));
}

glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double vDotH) {
    const double sine = 1.0 - std::clamp(vDotH, 0.0, 1.0);
    return f0 + (1.0 - f0) * std::pow(sine, 5.0);
}

glm::dvec3 evaluateBrdf(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& l,
                        const glm::dvec3& v) {
    // A normal that is of unit length only to single precision would spoil D at the least alpha by a tenth.
    const glm::dvec3 n = glm::normalize(surface.normal);
    if (glm::dot(n, l) <= 0.0) return glm::dvec3(0.0);
    const double nDotL = std::max(glm::dot(n, l), minNDotL);
    const double nDotV = std::max(glm::dot(n, v), minNDotV);
    const glm::dvec3 h = directionBetween(-v, l);
    // Opposite directions have no half vector: F is 1 there, which leaves no diffuse part, and no lobe is.
    if (h == glm::dvec3(0.0)) return glm::dvec3(0.0);
    const double alpha = clampAlpha(surface.roughness * surface.roughness);

    const glm::dvec3 f0 = glm::mix(glm::dvec3(0.04), surface.baseColor, surface.metallic);
    const glm::dvec3 fresnel = fresnelSchlick(f0, glm::dot(v, h));
    const double lobe = specularLobe(model, surface.roughness, nDotL, nDotV, glm::dot(n, h));
    const glm::dvec3 specular = fresnel * lobe * compensation(model, f0, nDotV, alpha);
    const glm::dvec3 diffuse =
        (1.0 - fresnel) * (1.0 - surface.metallic) * surface.baseColor / std::numbers::pi;
    return diffuse + specular;
}

double rangeWindow(double distance, double range) {
    assert(range > 0.0);
    return std::max(0.0, 1.0 - std::pow(distance / range, 4.0));
}

double spotFactor(double cosAngle, double innerConeAngle, double outerConeAngle) {
    const double cosOuter = std::cos(outerConeAngle);
    // The least width of the ramp is the extension's own.
    const double width = std::max(0.001, std::cos(innerConeAngle) - cosOuter);
    const double ramp = std::clamp((cosAngle - cosOuter) / width, 0.0, 1.0);
    return ramp * ramp;
}

glm::dvec3 reflectedRadiance(BrdfModel model, const SurfacePoint& surface, const glm::dvec3& eye,
                             const WorldLight& light) {
    const glm::dvec3 v = directionBetween(surface.position, eye);
    const bool directional = light.type == LightType::directional;
    const glm::dvec3 l = directional ? -glm::dvec3(light.direction)
                                     : directionBetween(surface.position, glm::dvec3(light.position));
    const double nDotL = glm::dot(surface.normal, l);
    if (nDotL <= 0.0) return glm::dvec3(0.0);
    const glm::dvec3 incident =
        directional ? glm::dvec3(light.intensity) / std::numbers::pi
                    : incidentRadiance(light, l, glm::distance(surface.position, glm::dvec3(light.position)));
    return std::numbers::pi * evaluateBrdf(model, surface, l, v) * incident * nDotL;
}

}  // namespace candela
