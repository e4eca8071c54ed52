#include "light_values.h"

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using candela::WorldLight;

std::vector<WorldLight> someLights() {
    std::vector<WorldLight> lights(5);
    for (std::size_t i = 0; i < lights.size(); ++i) lights[i].position = glm::vec3(static_cast<float>(i));
    lights[1].type = candela::LightType::spot;
    lights[2].type = candela::LightType::directional;
    return lights;
}

std::vector<WorldLight> movedTo(double seconds, const LightMotion& motion) {
    std::vector<WorldLight> moved;
    moveLights(someLights(), motion, seconds, moved);
    return moved;
}

TEST(LightMotion, DoesNotMoveLightsByDefault) {
    const std::vector<WorldLight> resting = someLights(), moved = movedTo(3.0, {});
    ASSERT_EQ(moved.size(), resting.size());
    for (std::size_t i = 0; i < moved.size(); ++i) EXPECT_EQ(moved[i].position, resting[i].position);
}

TEST(LightMotion, CirclesTheRestPosition) {
    const std::vector<WorldLight> resting = someLights();
    for (double seconds : {0.0, 0.3, 1.0, 1.0e6}) {
        const std::vector<WorldLight> moved =
            movedTo(seconds, {.moving = true, .radius = 2.0f, .speed = 0.5f});
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const float radius = resting[i].type == candela::LightType::directional ? 0.0f : 2.0f;
            // Rounding in single precision.
            EXPECT_NEAR(glm::distance(moved[i].position, resting[i].position), radius, 1.0e-5f);
            EXPECT_EQ(moved[i].position.y, resting[i].position.y);
        }
    }
}

TEST(LightMotion, ReturnsAfterAPeriod) {
    const LightMotion motion{.moving = true, .radius = 1.0f, .speed = 0.25f};
    const std::vector<WorldLight> start = movedTo(1.5, motion), later = movedTo(5.5, motion),
                                  half = movedTo(3.5, motion);
    for (const std::size_t i : {0u, 1u, 3u, 4u}) {
        EXPECT_LT(glm::distance(start[i].position, later[i].position), 1.0e-5f);  // rounding
        EXPECT_NEAR(glm::distance(start[i].position, half[i].position), 2.0f, 1.0e-5f);
    }
}

TEST(LightMotion, HasADifferentPhaseForEachLight) {
    const std::vector<WorldLight> resting = someLights(),
                                  moved = movedTo(0.7, {.moving = true, .radius = 1.0f, .speed = 1.0f});
    for (const std::size_t i : {1u, 3u, 4u})
        EXPECT_GT(
            glm::distance(moved[i].position - resting[i].position, moved[0].position - resting[0].position),
            0.1f);
}

}  // namespace
