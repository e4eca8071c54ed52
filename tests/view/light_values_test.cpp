#include "light_values.h"
#include "panels/color_values.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace {

constexpr float pi = std::numbers::pi_v<float>;

TEST(SplitColor, IsInvertedByJoining) {
    const SplitColor split = splitColor({3.0f, 12.0f, 6.0f});
    EXPECT_EQ(split.strength, 12.0f);
    EXPECT_EQ(split.hue, glm::vec3(0.25f, 1.0f, 0.5f));
    EXPECT_EQ(split.joined(), glm::vec3(3.0f, 12.0f, 6.0f));
}

TEST(SplitColor, BlackKeepsTheGivenHue) {
    const SplitColor split = splitColor(glm::vec3(0.0f), {1.0f, 0.5f, 0.0f});
    EXPECT_EQ(split.strength, 0.0f);
    EXPECT_EQ(split.hue, glm::vec3(1.0f, 0.5f, 0.0f));
    EXPECT_EQ(split.joined(), glm::vec3(0.0f));
}

TEST(Lumen, FillTheSphereOfAPointLight) {
    const candela::WorldLight point;
    // Rounding of a few operations in single precision.
    EXPECT_NEAR(lumenOf(point, 10.0f), 40.0f * pi, 1.0e-4f);
    EXPECT_NEAR(candelaOf(point, lumenOf(point, 7.0f)), 7.0f, 1.0e-5f);
}

TEST(Lumen, FillTheConeOfASpotLight) {
    candela::WorldLight spot;
    spot.type = candela::LightType::spot;
    spot.outerConeAngle = pi / 3.0f;
    // The cone's solid angle is 2 pi (1 - cos 60 degrees) = pi.
    EXPECT_NEAR(lumenOf(spot, 10.0f), 10.0f * pi, 1.0e-4f);
    EXPECT_NEAR(candelaOf(spot, lumenOf(spot, 7.0f)), 7.0f, 1.0e-5f);
}

TEST(Lumen, StayFiniteForAConeWithoutWidth) {
    candela::WorldLight spot;
    spot.type = candela::LightType::spot;
    spot.outerConeAngle = 0.0f;
    EXPECT_GT(lumenOf(spot, 1.0f), 0.0f);
    EXPECT_LT(candelaOf(spot, 1.0f), 1.0e7f);
}

TEST(DirectionAngles, RoundTrip) {
    for (const glm::vec3& direction :
         {glm::vec3(0.0f, 0.0f, -1.0f), glm::vec3(1.0f, 0.0f, 0.0f), glm::vec3(0.6f, -0.8f, 0.0f),
          glm::normalize(glm::vec3(-1.0f, 2.0f, 3.0f)), glm::vec3(0.0f, -1.0f, 0.0f)}) {
        // Angles in degrees have a rounding of 1e-5, a radian's 2e-7.
        EXPECT_LT(glm::distance(directionOf(anglesOf(direction)), direction), 1.0e-6f);
    }
}

TEST(DirectionAngles, CountFromMinusZTowardsX) {
    // Rounding of an arc tangent in degrees.
    EXPECT_NEAR(anglesOf({0.0f, 0.0f, -1.0f}).heading, 0.0f, 1.0e-4f);
    EXPECT_NEAR(anglesOf({1.0f, 0.0f, 0.0f}).heading, 90.0f, 1.0e-4f);
    EXPECT_NEAR(anglesOf({0.0f, -1.0f, 0.0f}).height, -90.0f, 1.0e-4f);
}

TEST(Cones, KeepTheInnerWithinTheOuter) {
    candela::WorldLight light;
    light.innerConeAngle = 1.0f;
    light.outerConeAngle = 0.5f;
    orderCones(light);
    EXPECT_LT(light.innerConeAngle, light.outerConeAngle);
    EXPECT_GT(light.innerConeAngle, 0.49f);
    light.innerConeAngle = 0.2f;
    orderCones(light);
    EXPECT_EQ(light.innerConeAngle, 0.2f);
}

candela::WorldLight scatteredLight() {
    candela::WorldLight light;
    light.range = 3.5f;
    light.intensity = {0.0f, 1.25f, 0.5f};
    return light;
}

TEST(CompletedScatterOptions, OmitTrailingValues) {
    const candela::LightScatter options =
        completed({.count = 10, .range = {}, .candela = {}}, scatteredLight());
    EXPECT_FALSE(options.range);
    EXPECT_FALSE(options.candela);
    const candela::LightScatter ranged =
        completed({.count = 10, .range = 2.0f, .candela = {}}, scatteredLight());
    EXPECT_EQ(ranged.range, 2.0f);
    EXPECT_FALSE(ranged.candela);
}

TEST(CompletedScatterOptions, HaveARangeBeforeAnIntensity) {
    const candela::LightScatter options =
        completed({.count = 10, .range = {}, .candela = 8.0f}, scatteredLight());
    EXPECT_EQ(options.range, 3.5f);
    EXPECT_EQ(options.candela, 8.0f);
}

TEST(CompletedScatterOptions, HaveBothBeforeASeed) {
    const candela::LightScatter options =
        completed({.count = 10, .range = {}, .candela = {}, .seed = 7}, scatteredLight());
    EXPECT_EQ(options.range, 3.5f);
    EXPECT_EQ(options.candela, 1.25f);
    EXPECT_EQ(options.seed, 7u);
}

}  // namespace
