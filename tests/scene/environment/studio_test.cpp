#include "environment/picture_samples.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <numbers>

namespace candela {
namespace {

Scene sceneOf(const Environment& environment) {
    Scene scene;
    scene.environment = environment;
    return scene;
}

TEST(Studio, LightsAWhiteSurfaceFromMiddleGreyToBright) {
    const Environment studio = studioEnvironment();
    EXPECT_NO_THROW(validate(sceneOf(studio)));
    EXPECT_FALSE(studio.isBackground);
    for (const glm::dvec3& normal : someNormals()) {
        const double white = luminance(irradiance(studio.picture, normal)) / std::numbers::pi;
        EXPECT_GT(white, 0.3) << normal.x << " " << normal.y << " " << normal.z;
        EXPECT_LT(white, 1.0) << normal.x << " " << normal.y << " " << normal.z;
    }
    // What the header says.
    EXPECT_NEAR(luminance(irradiance(studio.picture, {0, 0, 1})) / std::numbers::pi, 0.77, 0.01);
}

TEST(Studio, IsNeutralAndAlwaysTheSame) {
    const Environment studio = studioEnvironment();
    for (std::size_t i = 0; i < std::size_t{studio.picture.width} * studio.picture.height; ++i) {
        const glm::vec3 color = texelOf(studio.picture, i);
        ASSERT_EQ(color.r, color.g);
        ASSERT_EQ(color.r, color.b);
    }
    EXPECT_EQ(studio.picture.pixels, studioEnvironment().picture.pixels);
}

TEST(Studio, HasNoSun) {
    Environment studio = studioEnvironment();
    EXPECT_FALSE(takeSun(studio));
    EXPECT_EQ(studio.picture.pixels, studioEnvironment().picture.pixels);
}

}  // namespace
}  // namespace candela
