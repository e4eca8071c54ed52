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
}

TEST(WorldLights, ASingularNodeGivesAUnitDirection) {
    Scene scene = sceneWithNode(glm::scale(glm::mat4(1.0f), glm::vec3(0.0f)));
    scene.lights.push_back(spotAt(0));
    EXPECT_NEAR(glm::length(worldLights(scene, worldTransforms(scene))[0].direction), 1.0f, rounding);
}

const Bounds hall{{-10.0f, 0.0f, 5.0f}, {10.0f, 3.0f, 6.0f}};

TEST(ScatterLights, StayInTheBoxWithTheGivenParameters) {
    std::vector<Light> lights(1);
    scatterLights(lights, hall, 1000, 2.5f, 8.0f);
    ASSERT_EQ(lights.size(), 1001u);
    EXPECT_FALSE(lights[0].range) << "an existing light has changed";
    for (std::size_t i = 1; i < lights.size(); ++i) {
        const Light& light = lights[i];
        EXPECT_EQ(light.type, LightType::point);
        EXPECT_EQ(light.range, 2.5f);
        EXPECT_EQ(light.intensity, 8.0f);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(light.position[axis], hall.min[axis]);
            EXPECT_LE(light.position[axis], hall.max[axis]);
        }
        EXPECT_EQ(std::max({light.color.x, light.color.y, light.color.z}), 1.0f);
        EXPECT_EQ(std::min({light.color.x, light.color.y, light.color.z}), 0.0f);
    }
}

TEST(ScatterLights, FirstLightsAreTheSameForEveryCount) {
    std::vector<Light> few, many;
    scatterLights(few, hall, 100, 1.0f, 1.0f);
    scatterLights(many, hall, 5000, 1.0f, 1.0f);
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(few[i].position, many[i].position);
        EXPECT_EQ(few[i].color, many[i].color);
    }
}

TEST(ScatterLights, SeedsGiveOtherLights) {
    std::vector<Light> one, two;
    scatterLights(one, hall, 100, 1.0f, 1.0f, 1);
    scatterLights(two, hall, 100, 1.0f, 1.0f, 2);
    int equal = 0;
    for (std::size_t i = 0; i < one.size(); ++i) equal += one[i].position == two[i].position ? 1 : 0;
    EXPECT_EQ(equal, 0);
}

TEST(ScatterLights, FillTheBoxUniformly) {
    std::vector<Light> lights;
    constexpr std::uint32_t count = 64000;
    scatterLights(lights, hall, count, 1.0f, 1.0f);
    int cells[4][4][4] = {};
    glm::dvec3 color(0.0);
    for (const Light& light : lights) {
        const glm::vec3 at = (light.position - hall.min) / (hall.max - hall.min) * 4.0f;
        const auto cell = [](float x) { return std::min(static_cast<int>(x), 3); };
        ++cells[cell(at.x)][cell(at.y)][cell(at.z)];
        color += glm::dvec3(light.color);
    }
    // 1000 per cell; a uniform distribution deviates by more than 5 sigma (158) in one cell of 64 once in
    // 27,000 seeds.
    for (const auto& plane : cells) {
        for (const auto& row : plane) {
            for (const int n : row) EXPECT_NEAR(n, 1000, 158);
        }
    }
    // The mean over all hues is 1/2 per channel; sigma is below 0.5 / sqrt(64000) = 0.002.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i] / count, 0.5, 0.01);
}

// Every machine and every version scatters the same lights, bit for bit.
TEST(ScatterLights, AreTheSameInEveryVersion) {
    std::vector<Light> lights;
    scatterLights(lights, hall, 1000, 1.0f, 1.0f);
    std::uint64_t digest = 0xcbf29ce484222325u;  // FNV-1a over the bits.
    const auto add = [&digest](float value) {
        digest = (digest ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3u;
    };
    for (const Light& light : lights) {
        for (int i = 0; i < 3; ++i) {
            add(light.position[i]);
            add(light.color[i]);
        }
    }
    EXPECT_EQ(digest, 17640061409630307592u);
}

TEST(ScatterLights, RefuseInvalidParameters) {
    std::vector<Light> lights;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(scatterLights(lights, {}, 1, 1.0f, 1.0f), Error);
    EXPECT_THROW(scatterLights(lights, {glm::vec3(0.0f), glm::vec3(INFINITY)}, 1, 1.0f, 1.0f), Error);
    EXPECT_THROW(scatterLights(lights, hall, 1, 0.0f, 1.0f), Error);
    EXPECT_THROW(scatterLights(lights, hall, 1, nan, 1.0f), Error);
    EXPECT_THROW(scatterLights(lights, hall, 1, 1.0f, -1.0f), Error);
    EXPECT_THROW(scatterLights(lights, hall, 1, 1.0f, 1e21f), Error);
    EXPECT_TRUE(lights.empty());
}

TEST(ScatterLights, AMillionAreValid) {
    Scene scene;
    scatterLights(scene.lights, hall, 1'000'000, 1.0f, 1.0f);
    validate(scene);
    EXPECT_EQ(worldLights(scene, worldTransforms(scene)).size(), 1'000'000u);
}

}  // namespace
}  // namespace candela
