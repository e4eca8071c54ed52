#include "merged_form.h"

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <span>

// The merged form of shaders/shared/shading.h, over float and double, against the textbook form.

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

double alphaOf(double roughness) {
    return std::max(roughness * roughness, minAlpha);
}

/// A metal of base colour 1 has F0 = 1, hence F = 1, and no diffuse part.
template <typename Lobes>
Lobes whiteMetal(double roughness) {
    Lobes lobes;
    lobes.baseColor = decltype(lobes.baseColor)(1);
    lobes.metallic = 1;
    lobes.roughness = static_cast<decltype(lobes.roughness)>(roughness);
    return lobes;
}

/// f_s for F = 1, without compensation. The surface is at the origin and the eye at `v`.
double mergedLobe(BrdfModel model, double roughness, const glm::dvec3& n, const glm::dvec3& l,
                  const glm::dvec3& v) {
    const int brdf = static_cast<int>(model);
    exact::ShadingPoint point = exact::shadingPoint(brdf, whiteMetal<exact::SurfaceLobes>(roughness), n,
                                                    glm::dvec3(0.0), v, directionalAlbedoTable(model));
    point.fresnelBase = glm::dvec3(1.0);
    return exact::evaluateBrdf(brdf, point, l, glm::dot(n, l)).x;
}

float mergedLobe(BrdfModel model, float roughness, const glm::vec3& n, const glm::vec3& l,
                 const glm::vec3& v) {
    const int brdf = static_cast<int>(model);
    single::ShadingPoint point = single::shadingPoint(brdf, whiteMetal<single::SurfaceLobes>(roughness), n,
                                                      glm::vec3(0.0f), v, directionalAlbedoTable(model));
    point.toEye = v;  // As it was given: the error of normalising it is not that of the merged form.
    point.nDotV = glm::dot(n, v);
    point.fresnelBase = glm::vec3(1.0f);
    return single::evaluateBrdf(brdf, point, l, glm::dot(n, l)).x;
}

/// The same by the public functions, in double precision.
double textbookLobe(BrdfModel model, double roughness, const glm::dvec3& n, const glm::dvec3& l,
                    const glm::dvec3& v) {
    const double nDotL = glm::dot(n, l), nDotV = std::max(glm::dot(n, v), minNDotV);
    const double alpha = alphaOf(roughness);
    const double geometry = model == BrdfModel::course ? geometrySchlickSmith(nDotL, nDotV, roughness)
                                                       : geometrySmithCorrelated(nDotL, nDotV, alpha);
    return distributionGgx(glm::dot(n, glm::normalize(l + v)), alpha) * geometry / (4.0 * nDotL * nDotV);
}

/// The textbook form as a shader would have it in single precision.
float textbookLobeSingle(BrdfModel model, float roughness, const glm::vec3& n, const glm::vec3& l,
                         const glm::vec3& v) {
    const float alpha2 = std::pow(std::max(roughness * roughness, float(minAlpha)), 2.0f);
    const float nDotL = glm::dot(n, l), nDotV = std::max(glm::dot(n, v), float(minNDotV));
    const float nDotH = std::min(glm::dot(n, glm::normalize(l + v)), 1.0f);
    const float denominator = nDotH * nDotH * (alpha2 - 1.0f) + 1.0f;
    const float d = alpha2 / (pi * denominator * denominator);
    if (model == BrdfModel::course) {
        const float k = (roughness + 1.0f) * (roughness + 1.0f) / 8.0f;
        return d / (4.0f * (nDotL * (1.0f - k) + k) * (nDotV * (1.0f - k) + k));
    }
    const auto root = [alpha2](float nDotW) { return std::sqrt(alpha2 + (1.0f - alpha2) * nDotW * nDotW); };
    return d / (2.0f * (nDotL * root(nDotV) + nDotV * root(nDotL)));
}

struct Directions {
    glm::dvec3 n, l, v;
};

glm::dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
}

/// A view and a light that reflects into it from a normal at most three alpha away from n, where the lobe is
/// steep; in any orientation.
Directions nearTheLobe(std::mt19937& random, double alpha, double minCosine) {
    std::uniform_real_distribution<double> uniform;
    for (;;) {
        const glm::dvec3 n = randomDirection(random), v = randomDirection(random);
        const glm::dvec3 away = glm::cross(n, randomDirection(random));
        const glm::dvec3 h = glm::normalize(n + away * (3.0 * alpha * uniform(random)));
        const glm::dvec3 l = glm::normalize(2.0 * glm::dot(v, h) * h - v);
        if (glm::dot(n, v) >= minCosine && glm::dot(n, l) >= minCosine) return {n, l, v};
    }
}

struct Errors {
    double merged = 0.0;    ///< Of the merged form, for rounded directions.
    double textbook = 0.0;  ///< Of the textbook form, for rounded directions.
    double rounded = 0.0;   ///< Of the exact value, because directions are rounded to single precision.
};

/// The largest relative errors over many directions whose n·l and n·v are at least `minCosine`.
Errors maxErrors(BrdfModel model, double roughness, double minCosine) {
    std::mt19937 random(11);
    Errors errors;
    for (int i = 0; i < 20'000; ++i) {
        const auto [n, l, v] = nearTheLobe(random, alphaOf(roughness), minCosine);
        const glm::vec3 single[] = {glm::vec3(n), glm::vec3(l), glm::vec3(v)};
        const auto error = [](double value, double expected) {
            return std::abs(value - expected) / expected;
        };

        const double given = textbookLobe(model, roughness, glm::normalize(glm::dvec3(single[0])),
                                          glm::dvec3(single[1]), glm::dvec3(single[2]));
        const float merged = mergedLobe(model, float(roughness), single[0], single[1], single[2]);
        const float textbook = textbookLobeSingle(model, float(roughness), single[0], single[1], single[2]);
        errors.merged = std::max(errors.merged, error(merged, given));
        errors.textbook = std::max(errors.textbook, error(textbook, given));
        errors.rounded = std::max(errors.rounded, error(given, textbookLobe(model, roughness, n, l, v)));
    }
    return errors;
}

constexpr BrdfModel models[] = {BrdfModel::course, BrdfModel::gltf};

TEST(BrdfMerged, isTheTextbookForm) {
    std::mt19937 random(3);
    for (BrdfModel model : models)
        for (double roughness : {0.0, 0.1, 0.4, 1.0})
            for (int i = 0; i < 2000; ++i) {
                const auto [n, l, v] = nearTheLobe(random, alphaOf(roughness), 1.0e-4);
                const double exact = textbookLobe(model, roughness, n, l, v);
                // The textbook form's own rounding: 1e-16 of (n·h)² over alpha² = 1e-6, a few times.
                EXPECT_NEAR(mergedLobe(model, roughness, n, l, v) / exact, 1.0, 1.0e-8);
            }
}

TEST(BrdfMerged, wholeEquationIsThatOfTheEvaluator) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    for (BrdfModel model : models)
        for (int i = 0; i < 2000; ++i) {
            const auto [n, l, v] = nearTheLobe(random, 0.3, 0.05);
            SurfacePoint surface;
            surface.normal = n;
            surface.lobes = {glm::dvec3(uniform(random), uniform(random), uniform(random)), uniform(random),
                             0.1 + 0.9 * uniform(random)};
            const int brdf = static_cast<int>(model);
            const exact::ShadingPoint point = exact::shadingPoint(
                brdf, {surface.lobes.baseColor, surface.lobes.metallic, surface.lobes.roughness}, n,
                glm::dvec3(0.0), v, directionalAlbedoTable(model));
            const glm::dvec3 merged = exact::evaluateBrdf(brdf, point, l, glm::dot(n, l));
            const glm::dvec3 textbook = evaluateBrdf(model, surface, l, v);
            // Rounding of double, magnified by 1 / alpha^2 = 1e4 at most.
            const glm::dvec3 f0 = glm::mix(glm::dvec3(0.04), surface.lobes.baseColor, surface.lobes.metallic);
            const glm::dvec3 albedo =
                specularAlbedo(model, f0, std::max(glm::dot(n, v), minNDotV), surface.lobes.roughness);
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(merged[c] / textbook[c], 1.0, 1.0e-8);
                ASSERT_NEAR(point.specularAlbedo[c], albedo[c], 1.0e-12);
            }
        }
}

// The table of docs/lighting.md.
TEST(BrdfMerged, singlePrecisionRepresentsTheMinimumAlpha) {
    for (BrdfModel model : models)
        for (double minCosine : {0.01, 0.1, 0.5})
            for (double roughness : {0.0, 0.05, 0.1, 0.3, 1.0}) {
                const Errors errors = maxErrors(model, roughness, minCosine);
                std::printf("%s, cosines from %.2f, roughness %.2f: merged %.0e textbook %.0e rounded %.0e\n",
                            toString(model), minCosine, roughness, errors.merged, errors.textbook,
                            errors.rounded);
                // Tangentially t is exact to 2⁻²⁴ = 6e-8, the lobe is alpha (n·t) wide there, and q is
                // squared.
                EXPECT_LT(errors.merged, 1.5e-7 / (alphaOf(roughness) * minCosine) + 2.0e-6);
                EXPECT_LT(errors.rounded, 1.5e-7 / (alphaOf(roughness) * minCosine) + 2.0e-6);
            }
}

}  // namespace
}  // namespace candela
