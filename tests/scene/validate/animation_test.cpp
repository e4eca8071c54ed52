#include <candela/error.h>
#include <candela/scene.h>

#include "sample_scene.h"
#include "validate/broken_rule.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

namespace candela {
namespace {

const float nan_ = std::numeric_limits<float>::quiet_NaN();

void expectMessages(const std::vector<BrokenRule>& rules) {
    expectMessages(sampleScene(), rules);
}

TEST(Validate, Animations) {
    expectMessages({
        {"animation 0 'walk': refers to node 3, but the scene has 3 (counted from 0)",
         [](Scene& s) { s.animations[0].channels[0].node = 3; }},
        {"animation 0 'walk': channel 0: its node has a matrix, which cannot be animated",
         [](Scene& s) { s.animations[0].channels[0].node = 2; }},
        {"animation 0 'walk': channel 1: its path must be translation, rotation, scale or morph weights",
         [](Scene& s) { s.animations[0].channels[1].path = unknown<AnimationPath>(); }},
        {"animation 0 'walk': channel 1: its interpolation must be linear, step or cubic spline",
         [](Scene& s) { s.animations[0].channels[1].interpolation = unknown<Interpolation>(); }},
        {"animation 0 'walk': channel 2: it must have at least one key",
         [](Scene& s) { s.animations[0].channels[2].times.clear(); }},
        {"animation 0 'walk': channel 0: its times must be strictly increasing",
         [](Scene& s) {
             s.animations[0].channels[0].times = {1.0f, 1.0f};
         }},
        {"animation 0 'walk': channel 0: its times must be finite numbers",
         [](Scene& s) { s.animations[0].channels[0].times[1] = nan_; }},
        {"animation 0 'walk': channel 0: the number of its values does not fit the number of its keys",
         [](Scene& s) { s.animations[0].channels[0].values.pop_back(); }},
        {"animation 0 'walk': channel 2: the number of its values does not fit the number of its keys",
         [](Scene& s) { s.animations[0].channels[2].interpolation = Interpolation::linear; }},
        {"animation 0 'walk': channel 0: its values must be finite numbers of at most 1e9",
         [](Scene& s) { s.animations[0].channels[0].values[3] = nan_; }},
        {"animation 0 'walk': channel 0: its values must be finite numbers of at most 1e9",
         [](Scene& s) { s.animations[0].channels[0].values[3] = -2e9f; }},
        {"animation 0 'walk': channel 1: a rotation must be a quaternion that is not 0",
         [](Scene& s) { s.animations[0].channels[1].values[3] = 0.0f; }},
    });
}

/// The sample scene with a channel of the intensity of its light 1.
Scene withProperty() {
    Scene scene = sampleScene();
    PropertyChannel channel;
    channel.property = AnimatedProperty::lightIntensity;
    channel.element = 1;
    channel.times = {0, 1};
    channel.values = {0, 5};
    scene.animations[0].properties.push_back(channel);
    return scene;
}

TEST(Validate, AnimatedProperties) {
    EXPECT_NO_THROW(validate(withProperty()));
    using P = AnimatedProperty;
    const auto of = [](Scene& s) -> PropertyChannel& { return s.animations[0].properties[0]; };
    const auto refers = [&](P property, std::uint32_t element) {
        return [=](Scene& s) {
            of(s).property = property;
            of(s).element = element;
        };
    };
    const std::string channel = "animation 0 'walk': property channel 0: ";
    const auto rule = [&](const char* text) { return channel + text; };
    const std::vector<std::pair<std::string, std::function<void(Scene&)>>> rules{
        {rule("its property is unknown"), refers(P(1000), 0)},
        {"animation 0 'walk': refers to node 3, but the scene has 3 (counted from 0)",
         refers(P::visibility, 3)},
        {"animation 0 'walk': refers to material 1, but the scene has 1 (counted from 0)",
         refers(P::metallic, 1)},
        {"animation 0 'walk': refers to light 3, but the scene has 3 (counted from 0)",
         refers(P::lightColor, 3)},
        {"animation 0 'walk': refers to camera 1, but the scene has 1 (counted from 0)",
         refers(P::verticalFov, 1)},
        {rule("light 1 has no range to animate"), refers(P::lightRange, 1)},
        {rule("light 0 has no inner cone angle to animate"), refers(P::innerConeAngle, 0)},
        {rule("camera 0 has no far plane to animate"), refers(P::farPlane, 0)},
        {rule("camera 0 has no orthographic height to animate"), refers(P::orthographicHeight, 0)},
        {rule("material 0 has no texture offset to animate"),
         [&](Scene& s) {
             refers(P::textureOffset, 0)(s);
             of(s).texture = TextureSlot::normal;
         }},
        {rule("its texture is unknown"), [&](Scene& s) { of(s).texture = TextureSlot(19); }},
        {rule("the interpolation of visibility must be step"), refers(P::visibility, 0)},
        {rule("its interpolation must be linear, step or cubic spline"),
         [&](Scene& s) { of(s).interpolation = unknown<Interpolation>(); }},
        {rule("it must have at least one key"), [&](Scene& s) { of(s).times.clear(); }},
        {rule("its times must be strictly increasing"),
         [&](Scene& s) {
             of(s).times = {1, 1};
         }},
        {rule("its times must be finite numbers"), [&](Scene& s) { of(s).times[1] = nan_; }},
        {rule("the number of its values does not fit the number of its keys"),
         [&](Scene& s) { of(s).property = P::lightColor; }},
        {rule("its values must be finite numbers"), [&](Scene& s) { of(s).values[1] = nan_; }},
        {rule("a value of its intensity is -1, but 0 to 1e+20 was expected"),
         [&](Scene& s) { of(s).values[0] = -1.0f; }},
    };
    for (const auto& [message, breakRule] : rules)
        expectMessages(withProperty(), {{message.c_str(), breakRule}});
    // Tangents have no range.
    Scene spline = withProperty();
    of(spline).interpolation = Interpolation::cubicSpline;
    of(spline).values = {-9, 1, -9, -9, 2, -9};
    EXPECT_NO_THROW(validate(spline));
    of(spline).values[4] = -2;
    EXPECT_THROW(validate(spline), Error);
}

TEST(Validate, ChannelsOfOneMorphTarget) {
    Scene scene = sampleScene();
    scene.meshes[0].morphTargets.resize(2);
    for (MorphTarget& target : scene.meshes[0].morphTargets) target.offsets.resize(4);
    AnimationChannel channel;
    channel.path = AnimationPath::morphWeights;
    channel.times = {0.0f};
    channel.values = {1.0f};
    channel.morphTarget = 1;
    scene.animations[0].channels.push_back(channel);
    EXPECT_NO_THROW(validate(scene));
    expectMessages(scene,
                   {{"animation 0 'walk': channel 3: what its node shows does not have the morph target",
                     [](Scene& s) { s.animations[0].channels[3].morphTarget = 2; }}});
}

}  // namespace
}  // namespace candela
