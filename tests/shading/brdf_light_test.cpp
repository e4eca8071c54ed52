#include <candela/brdf.h>

#include "furnace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

using furnace::surface;

constexpr BrdfModel models[] = {BrdfModel::course, BrdfModel::gltf};
constexpr glm::dvec3 eye(3.0, 0.0, 4.0);

/// Directions and intensities of lights are single precision: 2⁻²⁴, a few times over.
constexpr double singleRounding = 1.0e-6;

/// The window of this range is 1 to the last bit at the distances tested here.
constexpr float farRange = 1.0e6f;

WorldLight pointLight(double distance, float range = farRange) {
    WorldLight light;
    light.position = glm::vec3(0.0f, 0.0f, float(distance));
    light.range = range;
    return light;
}

double radiance(const WorldLight& light, BrdfModel model = BrdfModel::course) {
    return reflectedRadiance(model, surface(1.0, 0.0, 1.0), eye, light).x;
}

TEST(BrdfLight, oneCandelaAtOneMetreMatchesTheClosedForm) {
    // f at normal incidence is (1 - E_s + 0.04 / 4) / pi; L = pi f (1 cd / pi) / 1 m².
    const double albedo = specularAlbedo(BrdfModel::course, glm::dvec3(0.04), 1.0, 1.0).x;
    SurfacePoint point = surface(1.0, 0.0, 1.0);
    const glm::dvec3 result =
        reflectedRadiance(BrdfModel::course, point, glm::dvec3(0.0, 0.0, 5.0), pointLight(1.0));
    EXPECT_NEAR(result.x, (1.01 - albedo) / std::numbers::pi, singleRounding);
}

TEST(BrdfLight, fallsWithTheSquareOfTheDistance) {
    for (BrdfModel model : models)
        for (double distance : {0.01, 0.5, 3.0, 100.0})
            EXPECT_NEAR(radiance(pointLight(distance), model) * distance * distance,
                        radiance(pointLight(1.0), model), singleRounding);
}

TEST(BrdfLight, isClampedBelowTheMinimumDistance) {
    EXPECT_NEAR(radiance(pointLight(1.0e-5)), radiance(pointLight(minDistance)), 1.0);
    EXPECT_NEAR(radiance(pointLight(minDistance)) / radiance(pointLight(1.0)), 1.0e6, 1.0);
}

TEST(BrdfLight, isProportionalToTheCosine) {
    WorldLight light = pointLight(1.0);
    light.position = {0.8f, 0.0f, 0.6f};
    const glm::dvec3 l(0.8, 0.0, 0.6), v(0.6, 0.0, 0.8);
    const double expected = evaluateBrdf(BrdfModel::course, surface(1.0, 0.0, 1.0), l, v).x * 0.6;
    EXPECT_NEAR(radiance(light), expected, singleRounding);
}

TEST(BrdfLight, isLinearInTheIntensityPerChannel) {
    WorldLight light = pointLight(2.0);
    light.intensity = {2.0f, 0.0f, 8.0f};
    const glm::dvec3 result = reflectedRadiance(BrdfModel::gltf, surface(1.0, 0.0, 0.4), eye, light);
    EXPECT_DOUBLE_EQ(result.x * 4.0, result.z);
    EXPECT_EQ(result.y, 0.0);
}

TEST(BrdfLight, rangeWindowMatchesClosedForms) {
    EXPECT_EQ(rangeWindow(0.0, 2.0), 1.0);
    EXPECT_EQ(rangeWindow(1.0, 2.0), 15.0 / 16.0);
    EXPECT_EQ(rangeWindow(2.0, 2.0), 0.0);
    EXPECT_EQ(rangeWindow(1.0e200, 1.0e-200), 0.0);
    EXPECT_EQ(rangeWindow(5.0, INFINITY), 1.0);
}

TEST(BrdfLight, theRangeWindowUsesTheUnclampedDistance) {
    EXPECT_NEAR(radiance(pointLight(1.0, 2.0f)) / radiance(pointLight(1.0)), 15.0 / 16.0, singleRounding);
    EXPECT_EQ(radiance(pointLight(2.0, 2.0f)), 0.0);
    EXPECT_EQ(radiance(pointLight(3.0, 2.0f)), 0.0);
    // A range below the minimum distance still cuts the light off.
    EXPECT_EQ(radiance(pointLight(0.9e-3, 0.5e-3f)), 0.0);
}

TEST(BrdfLight, spotFactorMatchesClosedForms) {
    const double inner = 0.3, outer = 0.8;
    const double middle = 0.5 * (std::cos(inner) + std::cos(outer));
    EXPECT_EQ(spotFactor(1.0, inner, outer), 1.0);
    EXPECT_NEAR(spotFactor(std::cos(inner), inner, outer), 1.0, 1.0e-12);
    EXPECT_NEAR(spotFactor(middle, inner, outer), 0.25, 1.0e-12);
    EXPECT_NEAR(spotFactor(std::cos(outer), inner, outer), 0.0, 1.0e-12);
    EXPECT_EQ(spotFactor(-1.0, inner, outer), 0.0);
    // A sharp cone: the ramp is 0.001 of the cosine wide, so it is in full just inside it.
    EXPECT_EQ(spotFactor(std::cos(0.5) + 0.0011, 0.5, 0.5), 1.0);
    EXPECT_EQ(spotFactor(std::cos(0.5) - 1.0e-9, 0.5, 0.5), 0.0);
}

TEST(BrdfLight, aSpotIsAPointLightTimesItsFactor) {
    WorldLight spot = pointLight(2.0);
    spot.type = LightType::spot;
    spot.innerConeAngle = 0.2f;
    spot.outerConeAngle = 0.6f;
    spot.direction = glm::vec3(0.0f, 0.0f, -1.0f);
    EXPECT_DOUBLE_EQ(radiance(spot), radiance(pointLight(2.0)));
    spot.direction = glm::vec3(std::sin(0.4f), 0.0f, -std::cos(0.4f));
    const double factor = spotFactor(std::cos(0.4), 0.2, 0.6);
    EXPECT_NEAR(radiance(spot), radiance(pointLight(2.0)) * factor, singleRounding);
    spot.direction = glm::vec3(0.0f, 0.0f, 1.0f);
    EXPECT_EQ(radiance(spot), 0.0);
}

TEST(BrdfLight, aDirectionalLightIsTheSameEverywhere) {
    WorldLight light;
    light.type = LightType::directional;
    light.direction = {-0.6f, 0.0f, -0.8f};
    light.position = {1.0e9f, 5.0f, -3.0f};  // Ignored, and so is the range of 0.
    light.intensity = glm::vec3(10.0f);
    const SurfacePoint point = surface(0.5, 0.0, 0.5);
    const glm::dvec3 v(0.6, 0.0, 0.8);
    const double expected = evaluateBrdf(BrdfModel::gltf, point, {0.6, 0.0, 0.8}, v).x * 10.0 * 0.8;
    EXPECT_NEAR(reflectedRadiance(BrdfModel::gltf, point, eye, light).x, expected, 10.0 * singleRounding);

    SurfacePoint elsewhere = point;
    elsewhere.position = {100.0, -20.0, 7.0};
    EXPECT_NEAR(reflectedRadiance(BrdfModel::gltf, elsewhere, elsewhere.position + eye, light).x, expected,
                10.0 * singleRounding);
    light.direction = -light.direction;
    EXPECT_EQ(reflectedRadiance(BrdfModel::gltf, point, eye, light), glm::dvec3(0.0));
}

TEST(BrdfLight, edgeCasesAreFinite) {
    for (BrdfModel model : models)
        for (double roughness : {0.0, 1.0})
            for (LightType type : {LightType::point, LightType::spot, LightType::directional})
                for (float distance : {0.0f, 1.0e-42f, 1.0e-20f, 1.0e-3f, 1.0f, 1.0e18f})
                    for (const glm::dvec3& from : {eye, glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0), -eye}) {
                        WorldLight light = pointLight(distance, 1.0e20f);
                        light.type = type;
                        light.intensity = glm::vec3(1.0e20f);
                        const glm::dvec3 result =
                            reflectedRadiance(model, surface(1.0, 1.0, roughness), from, light);
                        EXPECT_TRUE(std::isfinite(result.x)) << toString(model) << " at " << distance;
                        EXPECT_GE(result.x, 0.0);
                    }
}

TEST(BrdfLight, aLightAtTheSurfacePointContributesNothing) {
    for (BrdfModel model : models) EXPECT_EQ(radiance(pointLight(0.0), model), 0.0);
}

}  // namespace
}  // namespace candela
