#include <candela/scene.h>

#include "scene/model/animation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

// Values of channels are computed in double precision from floats such as 0.7071068.
constexpr double rounding = 1e-6;

void expectNear(const glm::dvec4& actual, const glm::dvec4& expected) {
    EXPECT_LE(glm::distance(actual, expected), rounding)
        << actual.x << ' ' << actual.y << ' ' << actual.z << ' ' << actual.w << " is not " << expected.x
        << ' ' << expected.y << ' ' << expected.z << ' ' << expected.w;
}

AnimationChannel translations(Interpolation interpolation, std::vector<float> values) {
    AnimationChannel channel;
    channel.interpolation = interpolation;
    channel.times = {1.0f, 3.0f};
    channel.values = std::move(values);
    return channel;
}

AnimationChannel rotations(Interpolation interpolation, std::vector<float> values) {
    AnimationChannel channel = translations(interpolation, std::move(values));
    channel.path = AnimationPath::rotation;
    return channel;
}

glm::dvec4 aroundZ(double angle) {
    return {0.0, 0.0, std::sin(angle / 2.0), std::cos(angle / 2.0)};
}

void append(std::vector<float>& values, const glm::dvec4& quaternion) {
    for (int i = 0; i < 4; ++i) values.push_back(static_cast<float>(quaternion[i]));
}

TEST(SampleChannel, IsClampedToTheFirstAndTheLastValue) {
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::step}) {
        const AnimationChannel channel = translations(interpolation, {1, 2, 3, 5, 6, 7});
        expectNear(sampleChannel(channel, -100.0), {1, 2, 3, 0});
        expectNear(sampleChannel(channel, 1.0), {1, 2, 3, 0});
        expectNear(sampleChannel(channel, 3.0), {5, 6, 7, 0});
        expectNear(sampleChannel(channel, 1e30), {5, 6, 7, 0});
    }
}

TEST(SampleChannel, LinearAndStep) {
    expectNear(sampleChannel(translations(Interpolation::linear, {0, 0, 0, 4, 8, -2}), 1.5), {1, 2, -0.5, 0});
    expectNear(sampleChannel(translations(Interpolation::step, {0, 0, 0, 4, 8, -2}), 2.999), {0, 0, 0, 0});
}

TEST(SampleChannel, FindsTheKeysOfATime) {
    AnimationChannel channel;
    for (int i = 0; i < 1000; ++i) {
        channel.times.push_back(static_cast<float>(i) * 0.5f);
        channel.values.insert(channel.values.end(), {static_cast<float>(i * i), 0.0f, 0.0f});
    }
    for (const int i : {0, 1, 499, 998}) {
        expectNear(sampleChannel(channel, i * 0.5 + 0.125), {i * i + 0.25 * (2 * i + 1), 0, 0, 0});
    }
}

TEST(SampleChannel, CubicSplineHasTheHermiteForm) {
    // Key 0: value 1, out-tangent 2 a second; key 1: in-tangent -1 a second, value 3. In-tangent of the first
    // and out-tangent of the last key (99) must not matter. Halfway, t = 1/2, over 2 seconds:
    // 1/2 × 1 + 2 × 1/8 × 2 + 1/2 × 3 + 2 × (-1/8) × (-1) = 0.5 + 0.5 + 1.5 + 0.25 = 2.75
    const AnimationChannel channel =
        translations(Interpolation::cubicSpline, {99, 0, 0, 1, 0, 0, 2, 0, 0, -1, 0, 0, 3, 0, 0, 99, 0, 0});
    expectNear(sampleChannel(channel, 2.0), {2.75, 0, 0, 0});
    expectNear(sampleChannel(channel, 1.0), {1, 0, 0, 0});
    expectNear(sampleChannel(channel, 3.0), {3, 0, 0, 0});
    // t = 1/4: 0.84375 × 1 + 2 × 0.140625 × 2 + 0.15625 × 3 + 2 × (-0.046875) × (-1) = 1.96875
    expectNear(sampleChannel(channel, 1.5), {1.96875, 0, 0, 0});
}

TEST(SampleChannel, RotatesAtConstantAngularVelocity) {
    std::vector<float> values;
    append(values, aroundZ(0.0));
    append(values, aroundZ(2.0));
    const AnimationChannel channel = rotations(Interpolation::linear, values);
    for (const double t : {0.1, 0.25, 0.5, 0.9})
        expectNear(sampleChannel(channel, 1.0 + 2.0 * t), aroundZ(2.0 * t));
}

TEST(SampleChannel, RotatesAlongTheShorterArc) {
    std::vector<float> values;
    append(values, aroundZ(0.2));
    append(values, -aroundZ(1.2));
    expectNear(sampleChannel(rotations(Interpolation::linear, values), 2.0), aroundZ(0.7));
}

TEST(SampleChannel, EqualAndNearlyEqualRotations) {
    for (const double step : {0.0, 1e-7, 1e-4, 2.1e-4}) {
        std::vector<float> values;
        append(values, aroundZ(1.0));
        append(values, aroundZ(1.0 + step));
        expectNear(sampleChannel(rotations(Interpolation::linear, values), 2.0), aroundZ(1.0 + step / 2.0));
    }
}

TEST(SampleChannel, RightAngleBetweenQuaternions) {
    // A rotation by 180 degrees: the cosine between the quaternions is 0, and both arcs are equally long.
    const AnimationChannel channel = rotations(Interpolation::linear, {0, 0, 0, 1, 0, 0, 1, 0});
    expectNear(sampleChannel(channel, 2.0), aroundZ(std::numbers::pi / 2.0));
}

TEST(SampleChannel, RotationsAreUnitQuaternions) {
    expectNear(sampleChannel(rotations(Interpolation::step, {0, 0, 3, 4, 0, 0, 0, 1}), 2.0),
               {0, 0, 0.6, 0.8});
    // Tangents 0: the mean of the keys, (0, 0, 0.5, 0.5), before it is normalised.
    const AnimationChannel cubic = rotations(
        Interpolation::cubicSpline, {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    expectNear(sampleChannel(cubic, 2.0), {0, 0, std::sqrt(0.5), std::sqrt(0.5)});
}

TEST(SampleChannel, ASplineThroughZeroHasThePreviousKey) {
    const AnimationChannel cubic =
        rotations(Interpolation::cubicSpline,
                  {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0});
    expectNear(sampleChannel(cubic, 2.0), {0, 0, 0, 1});
}

TEST(SampleChannel, OneKey) {
    AnimationChannel channel;
    channel.times = {2.0f};
    channel.values = {1, 2, 3};
    for (const double time : {0.0, 2.0, 5.0}) expectNear(sampleChannel(channel, time), {1, 2, 3, 0});
}

Animation linearAnimation(std::uint32_t node, AnimationPath path, std::vector<float> from,
                          const std::vector<float>& to) {
    AnimationChannel channel;
    channel.node = node;
    channel.path = path;
    channel.times = {0.0f, 1.0f};
    channel.values = std::move(from);
    channel.values.insert(channel.values.end(), to.begin(), to.end());
    return {{}, {channel}};
}

TEST(WorldTransforms, EveryAnimationPlaysAndMovesChildNodes) {
    Scene scene;
    scene.nodes.resize(4);
    Transform rest;
    rest.translation = {0.0f, 5.0f, 0.0f};
    for (Node& node : scene.nodes) node.transform = rest;
    scene.nodes[2].parent = 1;
    scene.animations.push_back(linearAnimation(1, AnimationPath::translation, {0, 0, 0}, {2, 0, 0}));
    scene.animations.push_back(linearAnimation(1, AnimationPath::scale, {1, 1, 1}, {1, 3, 1}));
    const std::vector<glm::mat4> world = worldTransforms(scene, 0.5);
    EXPECT_EQ(glm::vec3(world[0][3]), glm::vec3(0, 5, 0));
    EXPECT_EQ(glm::vec3(world[1][3]), glm::vec3(1, 0, 0));
    EXPECT_EQ(glm::vec3(world[2][3]), glm::vec3(1, 10, 0)) << "the parent is scaled by 2 in y";
    EXPECT_EQ(glm::vec3(world[3][3]), glm::vec3(0, 5, 0));
}

TEST(WorldTransforms, TheLaterAnimationOfAPropertyApplies) {
    Scene scene;
    scene.nodes.resize(1);
    scene.animations.push_back(linearAnimation(0, AnimationPath::translation, {0, 0, 0}, {2, 0, 0}));
    scene.animations.push_back(linearAnimation(0, AnimationPath::translation, {0, 0, 0}, {0, 8, 0}));
    EXPECT_EQ(glm::vec3(worldTransforms(scene, 1.0)[0][3]), glm::vec3(0, 8, 0));
    scene.animations[1].plays = false;
    EXPECT_EQ(glm::vec3(worldTransforms(scene, 1.0)[0][3]), glm::vec3(2, 0, 0));
    scene.animations[0].plays = false;
    EXPECT_EQ(glm::vec3(worldTransforms(scene, 1.0)[0][3]), glm::vec3(0, 0, 0)) << "as the scene places it";
}

}  // namespace
}  // namespace candela
