#include "environment/picture_samples.h"

#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <numbers>

namespace candela {
namespace {

constexpr double pi = std::numbers::pi;

double sunlight(const Sky& sky, const glm::dvec3& normal) {
    const glm::dvec3 color(sky.sun.color);
    return luminance(color) * sky.sun.intensity *
           std::max(glm::dot(-glm::dvec3(sky.sun.direction), normal), 0.0);
}

/// The texel that looks along a direction.
glm::vec3 along(const Image& picture, const glm::dvec3& direction) {
    std::size_t nearest = 0;
    double best = -2.0;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const double cosine = glm::dot(directionOf(picture, x, y), direction);
            if (cosine <= best) continue;
            best = cosine;
            nearest = std::size_t{y} * picture.width + x;
        }
    }
    return texelOf(picture, nearest);
}

TEST(Sky, LightsAHorizontalWhiteSurfaceToOne) {
    for (const double elevation : {pi / 60.0, 0.3, 0.7, pi / 2.0}) {
        for (const double turbidity : {2.0, 3.0, 8.0}) {
            const Sky sky = skyEnvironment({elevation, 1.0, turbidity});
            Scene scene;
            scene.environment = sky.environment;
            scene.lights = {sky.sun};
            EXPECT_NO_THROW(validate(scene));
            const double total =
                luminance(irradiance(sky.environment.picture, {0, 1, 0})) + sunlight(sky, {0, 1, 0});
            EXPECT_NEAR(total / pi, 1.0, 1e-4) << elevation << " " << turbidity;
        }
    }
}

TEST(Sky, IsBlueAboveAndHasASunThatIsWarmerAndStronger) {
    const Sky sky = skyEnvironment();
    const glm::vec3 zenith = along(sky.environment.picture, {0, 1, 0});
    EXPECT_GT(zenith.b, 1.3f * zenith.r);
    EXPECT_GT(sky.sun.color.r, 1.2f * sky.sun.color.b);
    EXPECT_TRUE(sky.sun.castsShadow);
    // Clear days: the sun gives two thirds to nine tenths of the light.
    const double fromSky = luminance(irradiance(sky.environment.picture, {0, 1, 0}));
    const double share = sunlight(sky, {0, 1, 0}) / (fromSky + sunlight(sky, {0, 1, 0}));
    EXPECT_GT(share, 0.6);
    EXPECT_LT(share, 0.9);
}

TEST(Sky, IsThatOfThePaperAtItsZenith) {
    // The chromaticity at the zenith for a turbidity of 3 and a sun at 45 degrees, by hand from appendix A.2.
    const double s = pi / 4.0, t = 3.0;
    const double x = t * t * (0.00166 * s * s * s - 0.00375 * s * s + 0.00209 * s) +
                     t * (-0.02903 * s * s * s + 0.06377 * s * s - 0.03202 * s + 0.00394) +
                     (0.11693 * s * s * s - 0.21196 * s * s + 0.06052 * s + 0.25886);
    const glm::dvec3 zenith(along(skyEnvironment({s, 0.0, t}).environment.picture, {0, 1, 0}));
    const double sumX = 0.4124564 * zenith.r + 0.3575761 * zenith.g + 0.1804375 * zenith.b;
    const double sumY = 0.2126729 * zenith.r + 0.7151522 * zenith.g + 0.0721750 * zenith.b;
    const double sumZ = 0.0193339 * zenith.r + 0.1191920 * zenith.g + 0.9503041 * zenith.b;
    // The nearest texel is 0.35 degrees from the zenith.
    EXPECT_NEAR(sumX / (sumX + sumY + sumZ), x, 5e-4);
}

TEST(Sky, IsBrightestAroundItsSun) {
    const double azimuth = -1.2, elevation = 0.6;
    const Sky sky = skyEnvironment({elevation, azimuth, 3.0});
    const glm::dvec3 towards{std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                             -std::cos(elevation) * std::cos(azimuth)};
    EXPECT_NEAR(glm::dot(-glm::dvec3(sky.sun.direction), towards), 1.0, 1e-6);
    double brightest = 0.0;
    glm::dvec3 found(0.0);
    for (std::uint32_t y = 0; y < sky.environment.picture.height; ++y) {
        for (std::uint32_t x = 0; x < sky.environment.picture.width; ++x) {
            const double here = luminance(
                texelOf(sky.environment.picture, std::size_t{y} * sky.environment.picture.width + x));
            if (here <= brightest) continue;
            brightest = here;
            found = directionOf(sky.environment.picture, x, y);
        }
    }
    // The gradation towards the horizon moves the maximum a little.
    EXPECT_GT(glm::dot(found, towards), std::cos(2.0 * pi / 180.0));
}

TEST(Sky, HasNoSunLeft) {
    for (const double elevation : {0.1, 0.7, 1.4}) {
        Sky sky = skyEnvironment({elevation, 0.0, 2.0});
        const std::vector<std::byte> before = sky.environment.picture.pixels;
        EXPECT_FALSE(takeSun(sky.environment)) << elevation;
        EXPECT_EQ(sky.environment.picture.pixels, before);
    }
}

TEST(Sky, RefusesWhatTheModelHasNoAnswerFor) {
    EXPECT_THROW(skyEnvironment({0.0, 0.0, 3.0}), Error);
    EXPECT_THROW(skyEnvironment({1.0, 4.0, 3.0}), Error);
    EXPECT_THROW(skyEnvironment({1.0, 0.0, 1.0}), Error);
    try {
        skyEnvironment({1.0, 0.0, 9.0});
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "sky: its turbidity is 9, but 2 to 8 was expected");
    }
}

}  // namespace
}  // namespace candela
