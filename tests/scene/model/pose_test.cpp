#include <candela/scene.h>

#include "scene/model/animation.h"
#include "scene/model/deformation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
// A few roundings of single precision on numbers below 30.
constexpr float rounding = 1e-5f;

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_LE(glm::distance(actual, expected), rounding)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " is not " << expected.x << ' ' << expected.y
        << ' ' << expected.z;
}

// A triangle with two morph targets, on a node at (0, 0, 7).
Scene morphed(std::vector<float> weights) {
    Scene scene;
    Cage cage;
    cage.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
    cage.faceSizes = {3};
    cage.faceVertices = {0, 1, 2};
    cage.morphTargets.push_back({{{1, 0, 0}, {0, 0, 0}, {0, 0, 8}}});
    cage.morphTargets.push_back({{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    scene.cages.push_back(cage);
    scene.nodes.resize(1);
    scene.nodes[0].transform = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, 7.0f));
    scene.nodes[0].cage = 0;
    scene.nodes[0].morphWeights = std::move(weights);
    return scene;
}

PosedPoints posedAt(const Scene& scene, double time) {
    validate(scene);
    return poseCage(scene, 0, worldTransforms(scene, time), time);
}

void expectPoints(const PosedPoints& posed, const std::vector<glm::vec3>& points) {
    ASSERT_EQ(posed.points.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) expectNear(posed.points[i], points[i]);
}

Animation weightsOverTime(Interpolation interpolation, std::vector<float> values) {
    AnimationChannel channel;
    channel.path = AnimationPath::morphWeights;
    channel.interpolation = interpolation;
    channel.times = {1.0f, 3.0f};
    channel.values = std::move(values);
    return {{}, {channel}};
}

TEST(PoseCage, AtRestIsTheCageAtItsNode) {
    for (const std::vector<float>& weights : {std::vector<float>{}, std::vector<float>{0.0f, 0.0f}}) {
        const Scene scene = morphed(weights);
        const PosedPoints posed = posedAt(scene, 0.0);
        EXPECT_EQ(posed.points, scene.cages[0].positions);
        EXPECT_EQ(posed.worldFromPoints, std::get<glm::mat4>(scene.nodes[0].transform));
    }
}

TEST(PoseCage, AddsMorphTargetsByTheirWeights) {
    const PosedPoints posed = posedAt(morphed({0.5f, -2.0f}), 0.0);
    // 0.5 × (1, 0, 0); -2 × (0, 1, 0); 0.5 × (0, 0, 8) - 2 × (0, 0, 1).
    expectPoints(posed, {{0.5, 0, 0}, {2, -2, 0}, {0, 4, 2}});
    EXPECT_EQ(posed.worldFromPoints[3].z, 7.0f);
}

TEST(PoseCage, AnimatedWeightsReplaceThoseOfTheNode) {
    Scene scene = morphed({100.0f, 100.0f});
    scene.animations.push_back(weightsOverTime(Interpolation::linear, {0, 1, 1, -1}));
    expectPoints(posedAt(scene, 0.0), {{0, 0, 0}, {2, 1, 0}, {0, 4, 1}});
    // A quarter of the way: 0.25 and 0.5.
    expectPoints(posedAt(scene, 1.5), {{0.25, 0, 0}, {2, 0.5, 0}, {0, 4, 2.5}});
    expectPoints(posedAt(scene, 9.0), {{1, 0, 0}, {2, -1, 0}, {0, 4, 7}});
    scene.animations[0].channels[0].interpolation = Interpolation::step;
    expectPoints(posedAt(scene, 2.999), {{0, 0, 0}, {2, 1, 0}, {0, 4, 1}});
    scene.animations.push_back(weightsOverTime(Interpolation::step, {3, 0, 0, 0}));
    expectPoints(posedAt(scene, 2.0), {{3, 0, 0}, {2, 0, 0}, {0, 4, 24}});
}

TEST(PoseCage, AnimationsOfOtherNodesDoNotAffectIt) {
    Scene scene = morphed({0.0f, 0.0f});
    scene.nodes.push_back(scene.nodes[0]);
    scene.animations.push_back(weightsOverTime(Interpolation::step, {1, 1, 1, 1}));
    scene.animations[0].channels[0].node = 1;
    EXPECT_EQ(posedAt(scene, 0.0).points, scene.cages[0].positions);
    expectPoints(poseCage(scene, 1, worldTransforms(scene)), {{1, 0, 0}, {2, 1, 0}, {0, 4, 9}});
}

TEST(PoseCage, CubicWeights) {
    // A key holds all in-tangents, then all values, then all out-tangents (glTF 2.0, 3.11).
    const std::vector<float> values{9, 9, 1, 0, 2, 0, 0, 4, 3, -1, 9, 9};
    AnimationChannel channel = weightsOverTime(Interpolation::cubicSpline, values).channels[0];
    const auto expectWeights = [&](double time, float first, float second) {
        std::vector<float> weights;
        applyMorphWeights(channel, time, weights);
        ASSERT_EQ(weights.size(), 2u);
        EXPECT_NEAR(weights[0], first, rounding);
        EXPECT_NEAR(weights[1], second, rounding);
    };
    expectWeights(0.0, 1.0f, 0.0f);
    expectWeights(3.0, 3.0f, -1.0f);
    // Half way the basis is 0.5, 0.125, 0.5, -0.125, and the keys lie 2 s apart:
    // 0.5 × 1 + 0.125 × 2 × 2 + 0.5 × 3, and 0.5 × -1 - 0.125 × 2 × 4.
    expectWeights(2.0, 2.5f, -1.5f);
    // A quarter of the way it is 0.84375, 0.140625, 0.15625, -0.046875.
    expectWeights(1.5, 1.875f, -0.53125f);

    Scene scene = morphed({});
    scene.animations.push_back({{}, {channel}});
    expectPoints(posedAt(scene, 2.0), {{2.5, 0, 0}, {2, -1.5, 0}, {0, 4, 18.5}});
}

TEST(PoseCage, OneWeightOverManyKeys) {
    AnimationChannel channel;
    channel.path = AnimationPath::morphWeights;
    channel.times = {0.0f, 1.0f, 2.0f, 4.0f};
    channel.values = {0, 1, 3, 7};
    std::vector<float> weights;
    applyMorphWeights(channel, 3.0, weights);
    EXPECT_EQ(weights, std::vector<float>{5.0f});
    applyMorphWeights(channel, 0.5, weights);
    EXPECT_EQ(weights, std::vector<float>{0.5f});
}

TEST(PoseCage, AChannelOfOneTargetLeavesTheOtherWeights) {
    Scene scene = morphed({2.0f, 3.0f});
    Animation one = weightsOverTime(Interpolation::step, {1, 5});
    one.channels[0].morphTarget = 1;
    scene.animations.push_back(one);
    EXPECT_EQ(morphWeightsAt(scene, 0, 2.0), (std::vector<float>{2.0f, 1.0f}));
    EXPECT_EQ(morphWeightsAt(scene, 0, 3.0), (std::vector<float>{2.0f, 5.0f}));
    // Channels of later animations apply after it.
    scene.animations.push_back(weightsOverTime(Interpolation::step, {7, 8, 9, 10}));
    EXPECT_EQ(morphWeightsAt(scene, 0, 3.0), (std::vector<float>{9.0f, 10.0f}));
    std::swap(scene.animations[0], scene.animations[1]);
    EXPECT_EQ(morphWeightsAt(scene, 0, 3.0), (std::vector<float>{9.0f, 5.0f}));
    // Without weights of the node the others are 0.
    scene.nodes[0].morphWeights.clear();
    scene.animations.erase(scene.animations.begin());
    EXPECT_EQ(morphWeightsAt(scene, 0, 3.0), (std::vector<float>{0.0f, 5.0f}));
}

// An arm along x: a joint at the origin and one at (2, 0, 0). The vertex at x = 1 follows the first, that at
// x = 3 both equally, and that at x = 4 the second.
Scene arm() {
    Scene scene;
    Cage cage;
    cage.positions = {{1, 0, 0}, {3, 0, 0}, {4, 0, 0}};
    cage.faceSizes = {3};
    cage.faceVertices = {0, 1, 2};
    cage.influenceCount = 2;
    cage.joints = {0, 1, 0, 1, 1, 0};
    cage.jointWeights = {1.0f, 0.0f, 0.5f, 0.5f, 1.0f, 0.0f};
    scene.cages.push_back(cage);
    scene.nodes.resize(3);
    scene.nodes[0].cage = 0;
    scene.nodes[0].skin = 0;
    scene.nodes[0].transform = glm::scale(glm::mat4(1.0f), glm::vec3(50.0f));
    scene.nodes[2].parent = 1;
    Transform elbow;
    elbow.translation = {2.0f, 0.0f, 0.0f};
    scene.nodes[2].transform = elbow;
    const glm::mat4 toElbow = glm::translate(glm::mat4(1.0f), glm::vec3(-2.0f, 0.0f, 0.0f));
    scene.skins.push_back({"arm", {1, 2}, {glm::mat4(1.0f), toElbow}});
    return scene;
}

void rotateElbow(Scene& scene) {
    std::get<Transform>(scene.nodes[2].transform).rotation =
        glm::angleAxis(pi / 2.0f, glm::vec3(0.0f, 0.0f, 1.0f));  // X to Y.
}

TEST(PoseCage, ASkinAtRestHasNoEffectAndIgnoresTheNode) {
    const Scene scene = arm();
    const PosedPoints posed = posedAt(scene, 0.0);
    expectPoints(posed, scene.cages[0].positions);
    EXPECT_EQ(posed.worldFromPoints, glm::mat4(1.0f));
}

TEST(PoseCage, JointsMoveVerticesByTheirWeights) {
    Scene scene = arm();
    rotateElbow(scene);
    // Rotated about (2, 0, 0), x = 4 moves to (2, 2, 0) and x = 3 to (2, 1, 0), the latter with weight 0.5.
    expectPoints(posedAt(scene, 0.0), {{1, 0, 0}, {2.5, 0.5, 0}, {2, 2, 0}});
    std::get<Transform>(scene.nodes[1].transform).translation = {0.0f, 10.0f, 0.0f};
    expectPoints(posedAt(scene, 0.0), {{1, 10, 0}, {2.5, 10.5, 0}, {2, 12, 0}});
}

TEST(PoseCage, RoundedWeightsAreNormalized) {
    Scene scene = arm();
    for (float& weight : scene.cages[0].jointWeights) weight *= 0.995f;
    std::get<Transform>(scene.nodes[1].transform).translation = {0.0f, 10.0f, 0.0f};
    expectPoints(posedAt(scene, 0.0), {{1, 10, 0}, {3, 10, 0}, {4, 10, 0}});
}

TEST(PoseCage, MorphTargetsApplyBeforeTheSkin) {
    Scene scene = arm();
    rotateElbow(scene);
    scene.cages[0].morphTargets.push_back({{{0, 0, 1}, {0, 0, 1}, {2, 0, 0}}});
    scene.nodes[0].morphWeights = {0.5f};
    // The last vertex moves to x = 5 before it is rotated.
    expectPoints(posedAt(scene, 0.0), {{1, 0, 0.5}, {2.5, 0.5, 0.5}, {2, 3, 0}});
}

TEST(PoseCage, JointsFollowTheirAnimation) {
    Scene scene = arm();
    AnimationChannel rotation;
    rotation.node = 2;
    rotation.path = AnimationPath::rotation;
    rotation.times = {0.0f, 1.0f};
    rotation.values = {0, 0, 0, 1, 0, 0, 1, 0};  // By 180 degrees around z.
    scene.animations.push_back({{}, {rotation}});
    expectPoints(posedAt(scene, 0.0), scene.cages[0].positions);
    expectPoints(posedAt(scene, 0.5), {{1, 0, 0}, {2.5, 0.5, 0}, {2, 2, 0}});
    expectPoints(posedAt(scene, 1.0), {{1, 0, 0}, {2, 0, 0}, {0, 0, 0}});
}

TEST(WorldBounds, EnclosePosedPointss) {
    Scene scene = morphed({});
    scene.animations.push_back(weightsOverTime(Interpolation::step, {0, 0, 1, 0}));
    const Bounds before = worldBounds(scene, worldTransforms(scene, 0.0), 0.0);
    expectNear(before.min, {0, 0, 7});
    expectNear(before.max, {2, 4, 7});
    const Bounds after = worldBounds(scene, worldTransforms(scene, 3.0), 3.0);
    expectNear(after.min, {0, 0, 7});
    expectNear(after.max, {2, 4, 15});

    Scene rotated = arm();
    rotateElbow(rotated);
    const Bounds box = worldBounds(rotated, worldTransforms(rotated));
    expectNear(box.min, {1, 0, 0});
    expectNear(box.max, {2.5, 2, 0});
}

TEST(TriangleCount, ExcludesCages) {
    EXPECT_EQ(triangleCount(arm()), 0u);
}

}  // namespace
}  // namespace candela
