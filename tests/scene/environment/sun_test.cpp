#include "environment/picture_samples.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace candela {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// A blue sky over grey ground, with a disc of a radius in degrees.
Environment skyWithDisc(const glm::dvec3& towards, double radius, const glm::vec3& color,
                        std::uint32_t height = 512) {
    return pictureOf(2 * height, height, [&](const glm::dvec3& direction) {
        if (glm::dot(direction, towards) >= std::cos(radius * degree)) return color;
        return direction.y > 0.0 ? glm::vec3(0.2f, 0.35f, 0.7f) : glm::vec3(0.1f);
    });
}

glm::dvec3 sunlight(const Light& sun, const glm::dvec3& normal) {
    return glm::dvec3(sun.color) * double{sun.intensity} *
           std::max(glm::dot(-glm::dvec3(sun.direction), normal), 0.0);
}

/// Both lights together give what the picture gave, to normals that have the whole disc above or below their
/// horizon: exactly but for the directions of the channels, of which the light has one, and single precision.
void expectConserved(const Image& before, const Image& after, const Light& sun) {
    const double horizon = std::sin(4.5 * degree);
    for (const glm::dvec3& normal : someNormals()) {
        if (std::abs(glm::dot(normal, glm::dvec3(sun.direction))) < horizon) continue;
        const glm::dvec3 was = irradiance(before, normal);
        const glm::dvec3 is = irradiance(after, normal) + sunlight(sun, normal);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(is[i] / was[i], 1.0, 1e-4) << "channel " << i;
    }
}

TEST(TakeSun, ConservesTheLight) {
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.4, 0.7, -0.6));
    for (const double radius : {0.3, 1.0, 3.0}) {
        const Environment before = skyWithDisc(towards, radius, {3e4f, 2.5e4f, 2e4f});
        Environment after = before;
        const auto sun = takeSun(after);
        ASSERT_TRUE(sun) << radius;
        EXPECT_EQ(sun->type, LightType::directional);
        EXPECT_TRUE(sun->castsShadow);
        EXPECT_GT(glm::dot(-glm::dvec3(sun->direction), towards), std::cos(0.3 * degree));
        expectConserved(before.picture, after.picture, *sun);
        // No texel is brighter than the sky.
        for (std::size_t i = 0; i < std::size_t{1024} * 512; ++i)
            ASSERT_LE(texelOf(after.picture, i).b, 0.71f);
    }
}

TEST(TakeSun, FindsItAtThePolesAndAtThePicturesBorder) {
    for (const glm::dvec3& towards :
         {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(0.01, 0.0, 1.0), glm::dvec3(0, 0, 1)}) {
        const Environment before = skyWithDisc(glm::normalize(towards), 1.0, glm::vec3(1e4f), 256);
        Environment after = before;
        const auto sun = takeSun(after);
        ASSERT_TRUE(sun);
        EXPECT_GT(glm::dot(-glm::dvec3(sun->direction), glm::normalize(towards)), std::cos(0.6 * degree));
        expectConserved(before.picture, after.picture, *sun);
    }
}

TEST(TakeSun, TurnsAndScalesItWithTheEnvironment) {
    const glm::dvec3 towards(0, 0, -1);
    Environment plain = skyWithDisc(towards, 1.0, glm::vec3(1e4f), 256), turned = plain;
    turned.rotation = rotationAboutUp(90.0);
    turned.intensity = 4.0f;
    const auto sun = takeSun(plain), turnedSun = takeSun(turned);
    ASSERT_TRUE(sun && turnedSun);
    EXPECT_NEAR(turnedSun->intensity / sun->intensity, 4.0f, 1e-5f);
    EXPECT_NEAR(turnedSun->direction.x, 1.0f, 1e-4f);  // from -X
    EXPECT_EQ(plain.picture.pixels, turned.picture.pixels);
}

TEST(TakeSun, LeavesAPictureWithoutASun) {
    const glm::dvec3 towards(0, 1, 0);
    std::vector<Environment> pictures{skyWithDisc(towards, 10.0, glm::vec3(100.0f), 256),  // a lamp
                                      skyWithDisc(towards, 1.0, glm::vec3(5.0f), 256),     // no contrast
                                      skyWithDisc(towards, 0.5, glm::vec3(50.0f), 256),    // too little light
                                      pictureOf(128, 64, [](const glm::dvec3&) { return glm::vec3(1.0f); }),
                                      pictureOf(128, 64, [](const glm::dvec3&) { return glm::vec3(0.0f); }),
                                      pictureOf(1, 1, [](const glm::dvec3&) { return glm::vec3(1.0f); }),
                                      skyWithDisc(towards, 3.0, glm::vec3(1e4f), 32)};
    pictures.push_back(skyWithDisc(towards, 1.0, glm::vec3(1e4f), 256));
    pictures.back().intensity = 0.0f;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        Environment after = pictures[i];
        EXPECT_FALSE(takeSun(after)) << i;
        EXPECT_EQ(after.picture.pixels, pictures[i].picture.pixels) << i;
    }
}

TEST(TakeSun, RefusesABrokenEnvironment) {
    Environment empty;
    EXPECT_THROW(takeSun(empty), Error);
}

TEST(RotationAboutUp, IsCounterClockwiseFromAbove) {
    const glm::vec3 front(0, 0, -1);
    const auto at = [&](double degrees) { return rotationAboutUp(degrees) * front; };
    EXPECT_LT(glm::distance(at(0.0), front), 1e-6f);
    EXPECT_LT(glm::distance(at(90.0), {-1, 0, 0}), 1e-6f);
    EXPECT_LT(glm::distance(at(-90.0), {1, 0, 0}), 1e-6f);
    EXPECT_LT(glm::distance(at(180.0), {0, 0, 1}), 1e-6f);
    EXPECT_LT(glm::distance(at(3690.0), {-1, 0, 0}), 1e-6f);
    EXPECT_THROW(rotationAboutUp(std::numeric_limits<double>::infinity()), Error);
}

}  // namespace
}  // namespace candela
