#include <candela/brdf.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

/// The merged form of docs/lighting.md, which the shaders use, in single precision and written here a second
/// time, against the textbook form in double precision.
namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

double alphaOf(double roughness) {
    return std::max(roughness * roughness, minAlpha);
}

/// f_s for F = 1, without compensation.
template <typename Real>
Real mergedLobe(BrdfModel model, Real roughness, const glm::vec<3, Real>& n, const glm::vec<3, Real>& l,
                const glm::vec<3, Real>& v) {
    const Real alpha = std::max(roughness * roughness, Real(minAlpha));
    const Real alpha2 = alpha * alpha;
    const Real nDotL = glm::dot(n, l), nDotV = std::max(glm::dot(n, v), Real(minNDotV));
    const glm::vec<3, Real> t = l + v;
    const Real nDotT = nDotL + glm::dot(n, v);
    const glm::vec<3, Real> tangential = t - n * nDotT;
    const Real tangential2 = glm::dot(tangential, tangential);
    const Real t2 = tangential2 + nDotT * nDotT;
    const Real q = tangential2 + alpha2 * nDotT * nDotT;
    if (model == BrdfModel::course) {
        const Real k = (roughness + 1) * (roughness + 1) / 8;
        const Real masking = (nDotL * (1 - k) + k) * (nDotV * (1 - k) + k);
        return alpha2 * t2 * t2 / (4 * std::numbers::pi_v<Real> * q * q * masking);
    }
    const auto root = [alpha2](Real nDotW) { return std::sqrt(alpha2 + (1 - alpha2) * nDotW * nDotW); };
    const Real masking = nDotL * root(nDotV) + nDotV * root(nDotL);
    return alpha2 * t2 * t2 / (2 * std::numbers::pi_v<Real> * q * q * masking);
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
/// steep; in any frame of the world.
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
    double merged = 0.0;    ///< Of the merged form, for what it was given.
    double textbook = 0.0;  ///< Of the textbook form, for what it was given.
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
        const float merged = mergedLobe<float>(model, float(roughness), single[0], single[1], single[2]);
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
                EXPECT_NEAR(mergedLobe<double>(model, roughness, n, l, v) / exact, 1.0, 1.0e-8);
            }
}

// The table of docs/lighting.md.
TEST(BrdfMerged, singlePrecisionBearsTheLeastAlpha) {
    for (BrdfModel model : models)
        for (double minCosine : {0.01, 0.1, 0.5})
            for (double roughness : {0.0, 0.05, 0.1, 0.3, 1.0}) {
                const Errors errors = maxErrors(model, roughness, minCosine);
                std::printf("%s, cosines from %.2f, roughness %.2f: merged %.0e textbook %.0e rounded %.0e\n",
                            toString(model), minCosine, roughness, errors.merged, errors.textbook,
                            errors.rounded);
                // Tangentially t is held to 2⁻²⁴ = 6e-8, the lobe is alpha (n·t) wide there, and q is
                // squared.
                EXPECT_LT(errors.merged, 1.5e-7 / (alphaOf(roughness) * minCosine) + 2.0e-6);
                EXPECT_LT(errors.rounded, 1.5e-7 / (alphaOf(roughness) * minCosine) + 2.0e-6);
            }
}

}  // namespace
}  // namespace candela
