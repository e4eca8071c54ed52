// What the host accepts and refuses of animated properties and visibility.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include "import/abi_import.h"

#include <candela/scene.h>

#include <gtest/gtest.h>

#include <functional>

namespace candela {
namespace {

constexpr float times[] = {0.0f, 1.0f};
constexpr float values[] = {0.25f, 0.5f, 0.125f, 0.75f, 0.25f, 0.5f, 0.125f, 0.75f};
constexpr float beyond[] = {0.0f, 1.5f};

candela_property_channel channelOf(candela_animated_property property) {
    candela_property_channel channel{};
    channel.property = property;
    channel.key_count = 2;
    channel.times = times;
    channel.values = values;
    if (property == CANDELA_PROPERTY_VISIBILITY) channel.interpolation = CANDELA_INTERPOLATE_STEP;
    return channel;
}

candela_animation animationOf(const candela_property_channel& channel) {
    candela_animation animation{};
    animation.struct_size = sizeof animation;
    animation.name = "glow";
    animation.property_count = 1;
    animation.properties = &channel;
    return animation;
}

/// A node with a mesh of two morph targets, a material, a spot light and a camera; and the animation.
Scene sceneWith(const candela_animation& animation) {
    return importedScene([&](const candela_host& host) {
        const candela_image image = samples::image();
        host.add_image(host.self, &image);
        const candela_material material = modified(
            samples::material(), [](candela_material& m) { m.base_color_texture = samples::texture(0); });
        host.add_material(host.self, &material);
        add(host, modified(samples::mesh(), [](candela_mesh& m) {
                m.morph_target_count = 2;
                m.morph_offsets = samples::morphOffsets.data();
            }));
        add(host, modified(samples::node(), [](candela_node& n) { n.mesh = 0; }));
        const candela_light light =
            modified(samples::light(), [](candela_light& l) { l.type = CANDELA_LIGHT_SPOT; });
        host.add_light(host.self, &light);
        const candela_camera camera = samples::camera();
        host.add_camera(host.self, &camera);
        add(host, animation);
    });
}

Scene sceneWith(const candela_property_channel& channel) {
    return sceneWith(animationOf(channel));
}

TEST(HostProperties, AreTaken) {
    const Scene scene = sceneWith(channelOf(CANDELA_PROPERTY_BASE_COLOR));
    const PropertyChannel& channel = scene.animations.at(0).properties.at(0);
    EXPECT_EQ(channel.property, AnimatedProperty::baseColor);
    EXPECT_EQ(channel.element, 0u);
    EXPECT_EQ(channel.times, (std::vector<float>{0, 1}));
    EXPECT_EQ(channel.values, std::vector<float>(std::begin(values), std::end(values)));
    EXPECT_EQ(channel.interpolation, Interpolation::linear);
    EXPECT_TRUE(scene.animations[0].channels.empty());
}

TEST(HostProperties, HaveTheNumbersOfTheAbi) {
    // Those that the samples' light and camera have.
    const std::pair<candela_animated_property, AnimatedProperty> pairs[] = {
        {CANDELA_PROPERTY_VISIBILITY, AnimatedProperty::visibility},
        {CANDELA_PROPERTY_EMISSION_STRENGTH, AnimatedProperty::emissionStrength},
        {CANDELA_PROPERTY_SHEEN_ROUGHNESS, AnimatedProperty::sheenRoughness},
        {CANDELA_PROPERTY_DIFFUSE_TRANSMISSION_COLOR, AnimatedProperty::diffuseTransmissionColor},
        {CANDELA_PROPERTY_TEXTURE_SCALE, AnimatedProperty::textureScale},
        {CANDELA_PROPERTY_LIGHT_INTENSITY, AnimatedProperty::lightIntensity},
        {CANDELA_PROPERTY_OUTER_CONE_ANGLE, AnimatedProperty::outerConeAngle},
        {CANDELA_PROPERTY_LIGHT_POSITION, AnimatedProperty::lightPosition},
        {CANDELA_PROPERTY_VERTICAL_FOV, AnimatedProperty::verticalFov},
    };
    for (const auto& [abi, property] : pairs)
        EXPECT_EQ(sceneWith(channelOf(abi)).animations.at(0).properties.at(0).property, property);
}

TEST(HostProperties, AMorphWeightIsAChannelOfOneTarget) {
    candela_property_channel weight = channelOf(CANDELA_PROPERTY_MORPH_WEIGHT);
    weight.part = 1;
    const Scene scene = sceneWith(weight);
    const AnimationChannel& channel = scene.animations.at(0).channels.at(0);
    EXPECT_EQ(channel.path, AnimationPath::morphWeights);
    EXPECT_EQ(channel.morphTarget, 1u);
    EXPECT_EQ(channel.values, (std::vector<float>{0.25f, 0.5f}));
    weight.part = 2;
    EXPECT_EQ(expectError([&] { sceneWith(weight); }, ErrorKind::badInput, ""),
              "test: animation 0 'glow': property channel 0: part is 2, but there are 2 targets");
}

TEST(HostProperties, OfAnOlderStructAreNotRead) {
    candela_animation older = animationOf(channelOf(CANDELA_PROPERTY_METALLIC));
    older.struct_size = offsetof(candela_animation, property_count);
    EXPECT_TRUE(sceneWith(older).animations.at(0).properties.empty());
}

TEST(HostProperties, RefusesWhatIsWrong) {
    const auto expectRefused = [](candela_animated_property property,
                                  const std::function<void(candela_property_channel&)>& modify,
                                  const std::string& text) {
        EXPECT_EQ(
            expectError([&] { sceneWith(modified(channelOf(property), modify)); }, ErrorKind::badInput, ""),
            "test: animation 0 'glow': property channel 0: " + text);
    };
    constexpr auto metallic = CANDELA_PROPERTY_METALLIC;
    expectRefused(
        metallic, [](auto& c) { c.property = candela_animated_property(44); },
        "property is 44, but 0 to 43 was expected");
    expectRefused(
        metallic, [](auto& c) { c.element = 1; }, "element is 1, but 1 were added so far and -1 is none");
    expectRefused(
        metallic, [](auto& c) { c.element = -1; }, "element is -1, but a material was expected");
    expectRefused(
        CANDELA_PROPERTY_TEXTURE_OFFSET, [](auto& c) { c.part = 19; },
        "part is 19, but 0 to 18 was expected");
    expectRefused(
        CANDELA_PROPERTY_TEXTURE_OFFSET, [](auto& c) { c.part = CANDELA_SLOT_SHEEN_COLOR; },
        "material 0 has no texture offset to animate");
    expectRefused(
        metallic, [](auto& c) { c.key_count = 0; }, "key_count is 0, but 1 or more was expected");
    expectRefused(
        metallic, [](auto& c) { c.values = nullptr; }, "value is NULL, but 2 elements were expected");
    expectRefused(
        metallic, [](auto& c) { c.values = beyond; },
        "a value of its metallic factor is 1.5, but 0 to 1 was expected");
    expectRefused(
        CANDELA_PROPERTY_VISIBILITY, [](auto& c) { c.interpolation = CANDELA_INTERPOLATE_LINEAR; },
        "the interpolation of visibility must be step");
    expectRefused(
        CANDELA_PROPERTY_ORTHOGRAPHIC_HEIGHT, [](auto&) {}, "camera 0 has no orthographic height to animate");
    EXPECT_EQ(expectError(
                  [] {
                      candela_animation animation = animationOf(channelOf(metallic));
                      animation.properties = nullptr;
                      sceneWith(animation);
                  },
                  ErrorKind::badInput, ""),
              "test: animation 0 'glow': properties is NULL, but property_count is 1");
}

TEST(HostProperties, NodesAreHiddenAndMaterialsHaveAStrength) {
    const float strength = 3.0f;
    const Scene scene = importedScene([&](const candela_host& host) {
        add(host, modified(samples::node(), [](candela_node& n) { n.is_hidden = 1; }));
        add(host, modified(samples::node(), [](candela_node& n) {
                n.is_hidden = 1;
                n.struct_size = offsetof(candela_node, is_hidden);  // 1.4
            }));
        const candela_material plain = samples::material();
        host.add_material(host.self, &plain);
        const candela_material strong =
            modified(plain, [&](candela_material& m) { m.emission_strength = &strength; });
        host.add_material(host.self, &strong);
    });
    EXPECT_FALSE(scene.nodes.at(0).visible);
    EXPECT_TRUE(scene.nodes.at(1).visible);
    EXPECT_EQ(scene.materials.at(0).emissionStrength, 1.0f);
    EXPECT_EQ(scene.materials.at(1).emissionStrength, 3.0f);
}

TEST(HostProperties, AnAnimatedAnisotropyGetsTangents) {
    const candela_property_channel channel = channelOf(CANDELA_PROPERTY_ANISOTROPY_STRENGTH);
    Scene scene = importedScene([&](const candela_host& host) {
        const candela_material material = samples::material();
        host.add_material(host.self, &material);
        const candela_submesh submesh{0, 6, 0};
        add(host, modified(samples::mesh(), [&](candela_mesh& m) {
                m.submeshes = &submesh;
                m.submesh_count = 1;
                m.uv0 = samples::uvs.data();
            }));
        add(host, animationOf(channel));
    });
    NoteList notes;
    addMissingAttributes(scene, notes);
    EXPECT_EQ(scene.meshes.at(0).tangents.size(), 4u);
}

}  // namespace
}  // namespace candela
