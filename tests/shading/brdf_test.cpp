#include <candela/brdf.h>
#include <candela/error.h>

#include "furnace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace candela {
namespace {

using furnace::surface;

constexpr BrdfModel models[] = {BrdfModel::course, BrdfModel::gltf};

/// Both sides are double arithmetic of a few dozen operations; at alpha = minAlpha D magnifies their
/// rounding by 1 / alpha².
constexpr double rounding = 1.0e-9;

bool isFinite(const glm::dvec3& value) {
    return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

glm::dvec3 randomDirection(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform;
    const double z = uniform(random), azimuth = 2.0 * std::numbers::pi * uniform(random);
    const double radius = std::sqrt(1.0 - z * z);
    return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

TEST(Brdf, modelsHaveTheNamesOfTheCommandLine) {
    EXPECT_STREQ(toString(BrdfModel::course), "course");
    EXPECT_STREQ(toString(BrdfModel::gltf), "gltf");
}

TEST(Brdf, distributionIsNormalised) {
    for (double alpha : {minAlpha, 0.01, 0.1, 0.5, 1.0}) {
        // 2 pi ∫ D cos sin dθ = pi ∫ D du with u = cos², with samples denser at the peak (u = 1 - s⁴).
        constexpr int samples = 20'000;
        double sum = 0.0;
        for (int i = 0; i < samples; ++i) {
            const double s = (i + 0.5) / samples;
            sum += distributionGgx(std::sqrt(1.0 - std::pow(s, 4.0)), alpha) * 4.0 * s * s * s;
        }
        // The midpoint rule's own error: it falls by 4 when `samples` doubles, and is below 1e-6 here.
        EXPECT_NEAR(std::numbers::pi * sum / samples, 1.0, 1.0e-5) << "alpha " << alpha;
    }
}

TEST(Brdf, distributionMatchesClosedForms) {
    EXPECT_DOUBLE_EQ(distributionGgx(0.3, 1.0), 1.0 / std::numbers::pi);
    EXPECT_NEAR(distributionGgx(1.0, 0.25), 16.0 / std::numbers::pi, rounding);
    EXPECT_EQ(distributionGgx(0.9, 0.0), distributionGgx(0.9, minAlpha));
}

TEST(Brdf, geometryTermsMatchClosedForms) {
    EXPECT_DOUBLE_EQ(geometrySchlickSmith(1.0, 1.0, 0.3), 1.0);
    // k = 1/2 at roughness 1: 0.5 / (0.25 + 0.5) = 2/3 per side.
    EXPECT_DOUBLE_EQ(geometrySchlickSmith(0.5, 0.5, 1.0), 4.0 / 9.0);
    // k = 1/8 at roughness 0: 0.5 / (0.4375 + 0.125) = 8/9.
    EXPECT_DOUBLE_EQ(geometrySchlickSmith(1.0, 0.5, 0.0), 8.0 / 9.0);
    EXPECT_DOUBLE_EQ(geometrySmithCorrelated(1.0, 1.0, 0.3), 1.0);
    // alpha = 1: 2 l v / (l + v).
    EXPECT_DOUBLE_EQ(geometrySmithCorrelated(0.5, 0.25, 1.0), 1.0 / 3.0);
}

TEST(Brdf, fresnelGoesFromF0ToOne) {
    const glm::dvec3 f0(0.04, 0.5, 1.0);
    EXPECT_EQ(fresnelSchlick(f0, 1.0), f0);
    EXPECT_EQ(fresnelSchlick(f0, 0.0), glm::dvec3(1.0));
    EXPECT_DOUBLE_EQ(fresnelSchlick(f0, 0.5).x, 0.04 + 0.96 / 32.0);
}

// l = v = n on a white dielectric of roughness 1: F = 0.04, D = 1/pi, G = 1.
// What the lobe reflects is the split sum of the table.
TEST(Brdf, normalIncidenceMatchesTheClosedForm) {
    const glm::dvec3 n(0.0, 0.0, 1.0);
    const auto diffuse = [](BrdfModel model) {
        return (1.0 - specularAlbedo(model, glm::dvec3(0.04), 1.0, 1.0).x) / std::numbers::pi;
    };
    const double lobe = 0.04 / (4.0 * std::numbers::pi);
    EXPECT_NEAR(evaluateBrdf(BrdfModel::course, surface(1.0, 0.0, 1.0), n, n).x,
                diffuse(BrdfModel::course) + lobe, rounding);
    const double albedo = directionalAlbedo(BrdfModel::gltf, 1.0, 1.0);
    EXPECT_NEAR(evaluateBrdf(BrdfModel::gltf, surface(1.0, 0.0, 1.0), n, n).x,
                diffuse(BrdfModel::gltf) + lobe * (1.0 + 0.04 * (1.0 - albedo) / albedo), rounding);
}

TEST(Brdf, colourActsPerChannelAndMetalHasNoDiffusePart) {
    SurfacePoint metal = surface(0.0, 1.0, 0.5);
    metal.lobes.baseColor = {0.0, 0.5, 1.0};
    const glm::dvec3 l(0.6, 0.0, 0.8), v(-0.6, 0.0, 0.8);
    const glm::dvec3 f = evaluateBrdf(BrdfModel::course, metal, l, v);
    // The mirror direction with v·h = 0.8; the lobe is shared, F is not.
    const glm::dvec3 fresnel = fresnelSchlick(metal.lobes.baseColor, 0.8);
    EXPECT_NEAR(f.x / f.z, fresnel.x / fresnel.z, rounding);
    EXPECT_NEAR(f.y / f.z, fresnel.y / fresnel.z, rounding);
}

TEST(Brdf, isZeroBelowTheHorizon) {
    const glm::dvec3 v(0.0, 0.6, 0.8);
    for (BrdfModel model : models) {
        EXPECT_EQ(evaluateBrdf(model, surface(1.0, 0.0, 0.5), {0.8, 0.0, -0.6}, v), glm::dvec3(0.0));
        EXPECT_EQ(evaluateBrdf(model, surface(1.0, 0.0, 0.5), {1.0, 0.0, 0.0}, v), glm::dvec3(0.0));
    }
}

TEST(Brdf, roughnessBelowTheMinimumAlphaChangesNothingInTheGltfModel) {
    const glm::dvec3 l(0.6, 0.0, 0.8), v = glm::normalize(glm::dvec3(-0.6, 0.001, 0.8));
    EXPECT_EQ(evaluateBrdf(BrdfModel::gltf, surface(1.0, 1.0, 0.0), l, v),
              evaluateBrdf(BrdfModel::gltf, surface(1.0, 1.0, 0.03), l, v));
}

/// The largest relative difference of f(l, v) and f(v, l).
double asymmetry(BrdfModel model, const SurfacePoint& point) {
    std::mt19937 random(7);
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 l = randomDirection(random), v = randomDirection(random);
        if (l.z < minNDotV || v.z < minNDotV) continue;
        const double forward = evaluateBrdf(model, point, l, v).x,
                     reverse = evaluateBrdf(model, point, v, l).x;
        largest = std::max(largest, std::abs(forward - reverse) / std::max(forward, reverse));
    }
    return largest;
}

TEST(BrdfReciprocity, theLobeOfCourseIsReciprocal) {
    for (double roughness : {0.0, 0.2, 0.5, 1.0})
        EXPECT_LT(asymmetry(BrdfModel::course, surface(0.7, 1.0, roughness)), rounding);
}

// f_d(l, v) / f_d(v, l) is (1 - E_s(n·v)) / (1 - E_s(n·l)). Light along the normal, seen at grazing angle,
// against the reverse: the numbers of docs/lighting.md.
TEST(BrdfReciprocity, theDiffusePartDeviatesByWhatTheLobeReflects) {
    const glm::dvec3 n(0.0, 0.0, 1.0), grazing = furnace::viewDirection(0.1);
    for (BrdfModel model : models)
        for (double roughness : {0.0, 0.2, 0.5, 1.0}) {
            const auto transmitted = [&](double nDotV) {
                return 1.0 - specularAlbedo(model, glm::dvec3(0.04), nDotV, roughness).x;
            };
            const auto diffuse = [&](const glm::dvec3& l, const glm::dvec3& v) {
                return evaluateBrdf(model, surface(1.0, 0.0, roughness), l, v).x -
                       evaluateBrdf(model, surface(0.04, 1.0, roughness), l, v).x;
            };
            const double ratio = diffuse(n, grazing) / diffuse(grazing, n);
            EXPECT_NEAR(ratio, transmitted(0.1) / transmitted(1.0), rounding);
            EXPECT_LT(ratio, 1.0);
            std::printf("%s roughness %.1f: f_d at n·v 0.1 over the reverse %.3f\n", toString(model),
                        roughness, ratio);
        }
}

// With F0 = 0 the compensation is 1 and what is left is the lobe itself.
TEST(BrdfReciprocity, gltfIsReciprocalWithoutItsCompensation) {
    for (double roughness : {0.0, 0.2, 0.5, 1.0})
        EXPECT_LT(asymmetry(BrdfModel::gltf, surface(0.0, 1.0, roughness)), rounding);
}

// The factor 1 + F0 (1 - E)/E depends on v alone, so f(l, v) / f(v, l) is the quotient of two such factors.
// They lie between 1 and their value at alpha = 1, n·v = 1, where E = 1 - ln 2.
TEST(BrdfReciprocity, gltfDeviatesFromReciprocityByItsCompensation) {
    const double minAlbedo = 1.0 - std::numbers::ln2;
    for (double f0 : {0.04, 0.5, 1.0}) {
        const double bound = 1.0 + f0 * (1.0 - minAlbedo) / minAlbedo;
        for (double roughness : {0.2, 0.5, 1.0}) {
            const double largest = asymmetry(BrdfModel::gltf, surface(f0, 1.0, roughness));
            EXPECT_GT(largest, 0.0);
            EXPECT_LT(largest, 1.0 - 1.0 / bound) << "F0 " << f0 << " roughness " << roughness;
        }
    }
    // The bound is nearly reached: f differs by up to 3.2 times for a rough white metal.
    EXPECT_GT(asymmetry(BrdfModel::gltf, surface(1.0, 1.0, 1.0)), 0.6);
}

std::vector<glm::dvec3> edgeCaseDirections() {
    std::vector<glm::dvec3> directions;
    for (double z : {1.0, 0.5, 1.0e-4, 1.0e-9, 1.0e-160, 1.0e-310, 0.0, -1.0e-9, -0.5, -1.0})
        for (double sign : {-1.0, 1.0})
            directions.emplace_back(sign * std::sqrt(std::max(0.0, 1.0 - z * z)), 0.0, z);
    return directions;
}

TEST(BrdfFinite, everyPairOfEdgeCaseDirections) {
    for (BrdfModel model : models)
        for (double roughness : {0.0, 1.0e-8, 0.03, 0.5, 1.0})
            for (double metallic : {0.0, 1.0})
                for (const glm::dvec3& l : edgeCaseDirections())
                    for (const glm::dvec3& v : edgeCaseDirections()) {
                        const glm::dvec3 f = evaluateBrdf(model, surface(1.0, metallic, roughness), l, v);
                        EXPECT_TRUE(isFinite(f)) << toString(model) << " l.z " << l.z << " v.z " << v.z;
                        EXPECT_GE(f.x, 0.0);
                    }
}

TEST(BrdfFinite, oppositeDirections) {
    const glm::dvec3 v(-0.8, 0.0, -0.6);
    for (BrdfModel model : models) {
        const double diffuse =
            (1.0 - specularAlbedo(model, glm::dvec3(0.04), minNDotV, 0.0).x) / std::numbers::pi;
        EXPECT_EQ(evaluateBrdf(model, surface(1.0, 0.0, 0.0), -v, v), glm::dvec3(diffuse));
    }
}

TEST(BrdfFinite, functionsOfTheTerms) {
    for (double cosine : {-1.0, 0.0, 1.0e-320, 0.5, 1.0, 1.0 + 1.0e-12})
        for (double roughness : {0.0, 1.0e-200, 1.0}) {
            EXPECT_TRUE(std::isfinite(distributionGgx(cosine, roughness)));
            for (BrdfModel model : models)
                EXPECT_TRUE(std::isfinite(specularAlbedo(model, glm::dvec3(0.5), cosine, roughness).x));
            if (cosine < 0.0) continue;
            EXPECT_TRUE(std::isfinite(geometrySchlickSmith(cosine, cosine, roughness)));
            EXPECT_TRUE(std::isfinite(geometrySmithCorrelated(cosine, cosine, roughness)));
        }
}

template <typename Call>
std::string errorOf(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        return error.what();
    }
    return "no error";
}

TEST(BrdfArguments, outOfRangeThrows) {
    const glm::dvec3 n(0.0, 0.0, 1.0);
    for (const double bad :
         {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_NE(errorOf([&] { distributionGgx(0.5, bad); }).find("alpha"), std::string::npos);
        EXPECT_NE(errorOf([&] { geometrySchlickSmith(0.5, 0.5, bad); }).find("roughness"), std::string::npos);
        EXPECT_NE(errorOf([&] { geometrySmithCorrelated(0.5, 0.5, bad); }).find("alpha"), std::string::npos);
        EXPECT_NE(errorOf([&] { directionalAlbedo(BrdfModel::gltf, 0.5, bad); }).find("roughness"),
                  std::string::npos);
        EXPECT_NE(
            errorOf([&] { specularAlbedo(BrdfModel::course, glm::dvec3(0.5), 0.5, bad); }).find("roughness"),
            std::string::npos);
        EXPECT_NE(errorOf([&] { evaluateBrdf(BrdfModel::gltf, surface(1.0, 0.0, bad), n, n); }).find("rough"),
                  std::string::npos);
        EXPECT_NE(errorOf([&] { evaluateBrdf(BrdfModel::gltf, surface(1.0, bad, 0.5), n, n); }).find("metal"),
                  std::string::npos);
    }
    for (const double bad : {-1.1, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_NE(errorOf([&] { distributionGgx(bad, 0.5); }).find("n·h"), std::string::npos);
        EXPECT_NE(errorOf([&] { geometrySchlickSmith(bad, 0.5, 0.5); }).find("n·l"), std::string::npos);
        EXPECT_NE(errorOf([&] { geometrySmithCorrelated(0.5, bad, 0.5); }).find("n·v"), std::string::npos);
        EXPECT_NE(errorOf([&] { directionalAlbedo(BrdfModel::gltf, bad, 0.5); }).find("n·v"),
                  std::string::npos);
        EXPECT_NE(errorOf([&] { specularAlbedo(BrdfModel::course, glm::dvec3(0.5), bad, 0.5); }).find("n·v"),
                  std::string::npos);
        EXPECT_NE(errorOf([&] { fresnelSchlick(glm::dvec3(0.5), bad); }).find("v·h"), std::string::npos);
        EXPECT_NE(errorOf([&] { spotFactor(bad, 0.1, 0.2); }).find("cosine"), std::string::npos);
        const glm::dvec3 notUnit(0.0, 0.0, bad);
        EXPECT_NE(
            errorOf([&] { evaluateBrdf(BrdfModel::course, surface(1, 0, 1), notUnit, n); }).find("unit"),
            std::string::npos);
        EXPECT_NE(
            errorOf([&] { evaluateBrdf(BrdfModel::course, surface(1, 0, 1), n, notUnit); }).find("unit"),
            std::string::npos);
    }
    EXPECT_NE(errorOf([&] { fresnelSchlick(glm::dvec3(-0.5), 0.5); }).find("F0"), std::string::npos);
    EXPECT_NE(errorOf([&] { specularAlbedo(BrdfModel::gltf, glm::dvec3(-0.5), 0.5, 0.5); }).find("F0"),
              std::string::npos);
    EXPECT_NE(errorOf([&] { spotFactor(0.5, 0.3, 0.2); }).find("cone"), std::string::npos);
    EXPECT_NE(errorOf([&] { rangeWindow(-1.0, 2.0); }).find("distance"), std::string::npos);
    EXPECT_NE(errorOf([&] { rangeWindow(1.0, 0.0); }).find("range"), std::string::npos);
}

TEST(BrdfArguments, reflectedRadianceNamesTheElement) {
    const glm::dvec3 eye(0.0, 0.0, 2.0);
    WorldLight light;
    light.position = {0.0f, 0.0f, 1.0f};
    light.range = 5.0f;
    const auto radiance = [&](const SurfacePoint& point, const WorldLight& of) {
        return errorOf([&] { reflectedRadiance(BrdfModel::course, point, eye, of); });
    };
    EXPECT_EQ(radiance(surface(1, 0, 1), light), "no error");
    WorldLight bad = light;
    bad.range = -1.0f;
    EXPECT_NE(radiance(surface(1, 0, 1), bad).find("range"), std::string::npos);
    bad = light;
    bad.intensity.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(radiance(surface(1, 0, 1), bad).find("intensity"), std::string::npos);
    bad = light;
    bad.type = LightType::spot;
    bad.direction = {0.0f, 0.0f, 0.0f};
    EXPECT_NE(radiance(surface(1, 0, 1), bad).find("direction"), std::string::npos);
    SurfacePoint point = surface(1, 0, 1);
    point.normal = glm::dvec3(0.0);
    EXPECT_NE(radiance(point, light).find("normal"), std::string::npos);
}

}  // namespace
}  // namespace candela
