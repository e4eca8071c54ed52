#include <candela/error.h>
#include <candela/light.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
// A few roundings of single precision on numbers near 1.
constexpr float rounding = 1e-6f;

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance = rounding) {
    EXPECT_LE(glm::distance(actual, expected), tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " is not " << expected.x << ' ' << expected.y
        << ' ' << expected.z;
}

TEST(Units, LumenOverTheSphere) {
    EXPECT_FLOAT_EQ(candelaFromLumen(4.0f * pi), 1.0f);
    EXPECT_FLOAT_EQ(candelaFromLumen(800.0f), 63.661977f);
}

TEST(Units, LumenInACone) {
    // A cone of half angle pi is the sphere, one of pi / 2 the half of it.
    EXPECT_FLOAT_EQ(candelaFromLumen(800.0f, pi), candelaFromLumen(800.0f));
    EXPECT_FLOAT_EQ(candelaFromLumen(800.0f, pi / 2.0f), 2.0f * candelaFromLumen(800.0f));
    // Half angle 60 degrees: 2 pi (1 - 1/2) = pi steradian.
    EXPECT_FLOAT_EQ(candelaFromLumen(pi, pi / 3.0f), 1.0f);
    // A narrow cone's solid angle is pi a²; 1 - cos(a) in single precision would be 0 here.
    EXPECT_FLOAT_EQ(candelaFromLumen(pi, 1e-4f), 1e8f);
}

TEST(Units, LumenFromWatt) {
    EXPECT_FLOAT_EQ(lumenFromWatt(2.0f), 1366.0f);
}

Scene sceneWithNode(const std::variant<Transform, glm::mat4>& transform) {
    Scene scene;
    scene.nodes.resize(1);
    scene.nodes[0].transform = transform;
    return scene;
}

Light spotAt(std::optional<std::uint32_t> node) {
    Light light;
    light.type = LightType::spot;
    light.color = {0.5f, 1.0f, 2.0f};
    light.intensity = 10.0f;
    light.range = 4.0f;
    light.innerConeAngle = 0.25f;
    light.outerConeAngle = 0.5f;
    light.position = {0.0f, 1.0f, 0.0f};
    light.castsShadow = false;
    light.radius = 0.125f;
    light.node = node;
    return light;
}

TEST(WorldLights, ANodeMovesAndRotatesALightButDoesNotScaleIt) {
    Transform trs;
    trs.translation = {10.0f, 0.0f, 0.0f};
    trs.rotation = glm::angleAxis(-pi / 2.0f, glm::vec3(1.0f, 0.0f, 0.0f));  // -Z to -Y, Y to -Z.
    trs.scale = {1.0f, 3.0f, 7.0f};
    Scene scene = sceneWithNode(trs);
    scene.lights.push_back(spotAt(0));
    const std::vector<WorldLight> placed = worldLights(scene, worldTransforms(scene));
    ASSERT_EQ(placed.size(), 1u);
    EXPECT_EQ(placed[0].type, LightType::spot);
    expectNear(placed[0].position, {10.0f, 0.0f, -3.0f}, 3.0f * rounding);
    expectNear(placed[0].direction, {0.0f, -1.0f, 0.0f});
    EXPECT_EQ(placed[0].intensity, glm::vec3(5.0f, 10.0f, 20.0f));
    EXPECT_EQ(placed[0].range, 4.0f);
    EXPECT_EQ(placed[0].innerConeAngle, 0.25f);
    EXPECT_EQ(placed[0].outerConeAngle, 0.5f);
    EXPECT_FALSE(placed[0].castsShadow);
    EXPECT_EQ(placed[0].radius, 0.125f);
}

TEST(WorldLights, ScaleDoesNotRotateADirection) {
    Transform trs;
    trs.rotation = glm::angleAxis(0.7f, glm::normalize(glm::vec3(1.0f, 2.0f, 3.0f)));
    trs.scale = {9.0f, 1.0f, 0.1f};
    Scene scene = sceneWithNode(trs);
    Light light = spotAt(0);
    light.type = LightType::directional;
    light.direction = glm::normalize(glm::vec3(1.0f, 1.0f, -1.0f));
    scene.lights.push_back(light);
    expectNear(worldLights(scene, worldTransforms(scene))[0].direction, trs.rotation * light.direction);
}

TEST(WorldLights, MirrorReversesADirection) {
    Scene scene = sceneWithNode(glm::scale(glm::mat4(1.0f), glm::vec3(-2.0f, 1.0f, 1.0f)));
    Light light = spotAt(0);
    light.direction = {1.0f, 0.0f, 0.0f};
    scene.lights.push_back(light);
    expectNear(worldLights(scene, worldTransforms(scene))[0].direction, {-1.0f, 0.0f, 0.0f});
}

TEST(WorldLights, WithoutNodeOrRange) {
    Scene scene;
    Light light;
    light.position = {1.0f, 2.0f, 3.0f};
    scene.lights.push_back(light);
    const WorldLight placed = worldLights(scene, {})[0];
    EXPECT_EQ(placed.type, LightType::point);
    EXPECT_EQ(placed.position, light.position);
    EXPECT_EQ(placed.range, 0.0f);
    EXPECT_EQ(placed.intensity, glm::vec3(1.0f));
    EXPECT_TRUE(placed.castsShadow);
    EXPECT_EQ(placed.radius, 0.0f);
}

TEST(WorldLights, ASingularNodeGivesAUnitDirection) {
    Scene scene = sceneWithNode(glm::scale(glm::mat4(1.0f), glm::vec3(0.0f)));
    scene.lights.push_back(spotAt(0));
    EXPECT_NEAR(glm::length(worldLights(scene, worldTransforms(scene))[0].direction), 1.0f, rounding);
}

TEST(WorldLights, OfOneLightBelowAMatrix) {
    Light light;
    light.type = LightType::spot;
    light.position = {1, 0, 0};
    light.intensity = 3.0f;
    light.color = {1, 0.5f, 0};
    light.range = 7.0f;
    light.node = 12;
    const glm::mat4 turned = glm::scale(
        glm::rotate(glm::translate(glm::mat4(1.0f), {0, 5, 0}), pi / 2.0f, {0, 1, 0}), glm::vec3(2.0f));
    const WorldLight placed = worldLight(light, turned);
    // A quarter turn about +Y takes +X to -Z and -Z to -X; the scale moves the position alone.
    expectNear(placed.position, {0, 5, -2});
    expectNear(placed.direction, {-1, 0, 0});
    expectNear(placed.intensity, {3, 1.5f, 0});
    EXPECT_EQ(placed.range, 7.0f);
    expectNear(worldLight(light).position, {1, 0, 0});
    light.intensity = -1.0f;
    EXPECT_THROW(worldLight(light), Error);
    light.intensity = 1.0f;
    glm::mat4 projective(1.0f);
    projective[0][3] = 1.0f;
    EXPECT_THROW(worldLight(light, projective), Error);
    EXPECT_THROW(worldLight(light, glm::mat4(std::numeric_limits<float>::infinity())), Error);
}

}  // namespace
}  // namespace candela
