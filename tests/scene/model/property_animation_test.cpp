// Animated properties: values in closed form, for every property and every interpolation.

#include "scene/model/property_animation.h"

#include "sample_scene.h"
#include "scene/model/material_textures.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
// Values are computed in double precision of floats and become floats: half a step, relative.
constexpr float rounding = 1.2e-7f;

/// A scene in which every element has every property: all textures, a range, both lenses, both planes.
Scene sceneOfEverything() {
    Scene scene;
    scene.images.push_back({"texel", 1, 1, PixelFormat::rgba8, std::vector<std::byte>(4)});
    scene.materials.resize(2);
    for (std::size_t slot = 0; slot < materialTextures().size(); ++slot)
        textureOf(scene.materials[1], TextureSlot(slot)) = Texture{};
    scene.nodes.resize(3);
    scene.nodes[1].parent = 0;
    scene.nodes[2].parent = 1;
    scene.lights.resize(2);
    scene.lights[1].type = LightType::spot;
    scene.lights[1].range = 9.0f;
    scene.lights[1].node = 2;
    scene.cameras.resize(2);
    scene.cameras[0].nearPlane = 0.5f;
    scene.cameras[0].farPlane = 50.0f;
    scene.cameras[1].orthographicHeight = 3.0f;
    return scene;
}

struct PropertyCase {
    AnimatedProperty property;
    std::uint32_t element;
    std::vector<float> from, to;  ///< Two values within the range.
    std::function<std::vector<float>(const Scene&)> read;
};

std::vector<float> listed(float number) {
    return {number};
}
std::vector<float> listed(const glm::vec2& v) {
    return {v.x, v.y};
}
std::vector<float> listed(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
std::vector<float> listed(const glm::vec4& v) {
    return {v.x, v.y, v.z, v.w};
}

std::vector<PropertyCase> allProperties() {
    using P = AnimatedProperty;
    using S = const Scene&;
    const std::vector<float> red{1, 0, 0}, dim{0.25f, 0.5f, 0.75f};
    return {
        {P::visibility, 1, {1}, {0}, [](S s) { return listed(s.nodes[1].visible ? 1.0f : 0.0f); }},
        {P::baseColor,
         1,
         {1, 0, 0.5f, 1},
         {0, 1, 0.25f, 0.5f},
         [](S s) { return listed(s.materials[1].baseColor); }},
        {P::metallic, 1, {0}, {1}, [](S s) { return listed(s.materials[1].metallic); }},
        {P::roughness, 1, {0.25f}, {0.5f}, [](S s) { return listed(s.materials[1].roughness); }},
        {P::emission, 1, {0, 10, 0}, {3, 1e6f, 1}, [](S s) { return listed(s.materials[1].emission); }},
        {P::emissionStrength, 1, {0}, {100}, [](S s) { return listed(s.materials[1].emissionStrength); }},
        {P::normalScale, 1, {-1}, {2}, [](S s) { return listed(s.materials[1].normalScale); }},
        {P::occlusionStrength, 1, {0}, {1}, [](S s) { return listed(s.materials[1].occlusionStrength); }},
        {P::alphaCutoff, 1, {0}, {1.5f}, [](S s) { return listed(s.materials[1].alphaCutoff); }},
        {P::ior, 1, {1}, {2.5f}, [](S s) { return listed(s.materials[1].ior); }},
        {P::specularFactor, 1, {0}, {1}, [](S s) { return listed(s.materials[1].specular.factor); }},
        {P::specularColor, 1, red, {4, 2, 1}, [](S s) { return listed(s.materials[1].specular.color); }},
        {P::clearcoatFactor, 1, {0}, {1}, [](S s) { return listed(s.materials[1].clearcoat.factor); }},
        {P::clearcoatRoughness, 1, {0}, {1}, [](S s) { return listed(s.materials[1].clearcoat.roughness); }},
        {P::clearcoatNormalScale,
         1,
         {0},
         {3},
         [](S s) { return listed(s.materials[1].clearcoat.normalScale); }},
        {P::sheenColor, 1, red, dim, [](S s) { return listed(s.materials[1].sheen.color); }},
        {P::sheenRoughness, 1, {0}, {1}, [](S s) { return listed(s.materials[1].sheen.roughness); }},
        {P::anisotropyStrength, 1, {0}, {1}, [](S s) { return listed(s.materials[1].anisotropy.strength); }},
        {P::anisotropyRotation, 1, {-7}, {7}, [](S s) { return listed(s.materials[1].anisotropy.rotation); }},
        {P::iridescenceFactor, 1, {0}, {1}, [](S s) { return listed(s.materials[1].iridescence.factor); }},
        {P::iridescenceIor, 1, {1}, {2}, [](S s) { return listed(s.materials[1].iridescence.ior); }},
        {P::iridescenceMinThickness,
         1,
         {0},
         {200},
         [](S s) { return listed(s.materials[1].iridescence.minThickness); }},
        {P::iridescenceMaxThickness,
         1,
         {50},
         {800},
         [](S s) { return listed(s.materials[1].iridescence.maxThickness); }},
        {P::transmissionFactor, 1, {0}, {1}, [](S s) { return listed(s.materials[1].transmission.factor); }},
        {P::thickness, 1, {0}, {4}, [](S s) { return listed(s.materials[1].volume.thickness); }},
        {P::attenuationDistance,
         1,
         {1},
         {3},
         [](S s) { return listed(s.materials[1].volume.attenuationDistance); }},
        {P::attenuationColor, 1, red, dim,
         [](S s) { return listed(s.materials[1].volume.attenuationColor); }},
        {P::dispersion, 1, {0}, {2}, [](S s) { return listed(s.materials[1].volume.dispersion); }},
        {P::diffuseTransmissionFactor,
         1,
         {0},
         {1},
         [](S s) { return listed(s.materials[1].diffuseTransmission.factor); }},
        {P::diffuseTransmissionColor, 1, red, dim,
         [](S s) { return listed(s.materials[1].diffuseTransmission.color); }},
        {P::textureOffset,
         1,
         {0, 1},
         {-2, 3},
         [](S s) { return listed(s.materials[1].baseColorTexture->offset); }},
        {P::textureRotation,
         1,
         {0},
         {2 * pi},
         [](S s) { return listed(s.materials[1].baseColorTexture->rotation); }},
        {P::textureScale,
         1,
         {1, 1},
         {-2, 0},
         [](S s) { return listed(s.materials[1].baseColorTexture->scale); }},
        {P::lightColor, 1, red, {0, 2, 4}, [](S s) { return listed(s.lights[1].color); }},
        {P::lightIntensity, 1, {0}, {1000}, [](S s) { return listed(s.lights[1].intensity); }},
        {P::lightRange, 1, {1}, {10}, [](S s) { return listed(*s.lights[1].range); }},
        {P::innerConeAngle, 1, {0}, {0.5f}, [](S s) { return listed(s.lights[1].innerConeAngle); }},
        {P::outerConeAngle, 1, {0.5f}, {1.5f}, [](S s) { return listed(s.lights[1].outerConeAngle); }},
        {P::lightPosition, 1, {0, 1, 2}, {4, -3, 8}, [](S s) { return listed(s.lights[1].position); }},
        {P::verticalFov, 0, {0.5f}, {2}, [](S s) { return listed(s.cameras[0].verticalFov); }},
        {P::orthographicHeight, 1, {1}, {8}, [](S s) { return listed(*s.cameras[1].orthographicHeight); }},
        {P::nearPlane, 0, {0.125f}, {1}, [](S s) { return listed(*s.cameras[0].nearPlane); }},
        {P::farPlane, 0, {20}, {60}, [](S s) { return listed(*s.cameras[0].farPlane); }},
    };
}

PropertyChannel channelOf(const PropertyCase& property, Interpolation interpolation,
                          std::vector<float> values) {
    PropertyChannel channel;
    channel.property = property.property;
    channel.element = property.element;
    channel.interpolation = interpolation;
    channel.times = {1.0f, 3.0f};
    channel.values = std::move(values);
    return channel;
}

Scene animated(const PropertyChannel& channel) {
    Scene scene = sceneOfEverything();
    scene.animations.emplace_back().properties.push_back(channel);
    validate(scene);
    return scene;
}

/// Poses one scene at one time after another: what it was before must not count.
void expectValue(Scene& scene, const PropertyCase& property, double time, const std::vector<float>& value) {
    poseProperties(scene, time);
    EXPECT_NO_THROW(validate(scene)) << "what is posed is valid";
    const std::vector<float> actual = property.read(scene);
    ASSERT_EQ(actual.size(), value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
        EXPECT_NEAR(actual[i], value[i], rounding * std::abs(value[i]))
            << "property " << static_cast<int>(property.property) << ", number " << i << ", time " << time;
}

TEST(PropertyAnimation, TheCasesAreAllProperties) {
    const std::vector<PropertyCase> cases = allProperties();
    ASSERT_EQ(cases.size(), static_cast<std::size_t>(AnimatedProperty::farPlane) + 1);
    for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(static_cast<std::size_t>(cases[i].property), i);
    EXPECT_THROW(elementOf(AnimatedProperty(cases.size())), Error);
}

TEST(PropertyAnimation, LinearValuesOfEveryProperty) {
    for (const PropertyCase& property : allProperties()) {
        if (property.property == AnimatedProperty::visibility) continue;  // It has steps alone.
        std::vector<float> values(property.from), quarter;
        values.insert(values.end(), property.to.begin(), property.to.end());
        for (std::size_t i = 0; i < property.from.size(); ++i)
            quarter.push_back(0.75f * property.from[i] + 0.25f * property.to[i]);
        Scene scene = animated(channelOf(property, Interpolation::linear, values));
        expectValue(scene, property, 9.0, property.to);
        expectValue(scene, property, 1.5, quarter);
        expectValue(scene, property, 0.0, property.from);
    }
}

TEST(PropertyAnimation, StepsOfEveryProperty) {
    for (const PropertyCase& property : allProperties()) {
        std::vector<float> values(property.from);
        values.insert(values.end(), property.to.begin(), property.to.end());
        Scene scene = animated(channelOf(property, Interpolation::step, values));
        expectValue(scene, property, 2.999, property.from);
        expectValue(scene, property, 3.0, property.to);
        expectValue(scene, property, -5.0, property.from);
    }
}

TEST(PropertyAnimation, SplinesOfEveryPropertyStayInRange) {
    for (const PropertyCase& property : allProperties()) {
        if (property.property == AnimatedProperty::visibility) continue;
        // Tangents 0 give the mean of the keys half way.
        const std::vector<float> zero(property.from.size(), 0.0f);
        std::vector<float> values, mean;
        for (const std::vector<float>& part : {zero, property.from, zero, zero, property.to, zero})
            values.insert(values.end(), part.begin(), part.end());
        for (std::size_t i = 0; i < property.from.size(); ++i)
            mean.push_back(0.5f * property.from[i] + 0.5f * property.to[i]);
        Scene scene = animated(channelOf(property, Interpolation::cubicSpline, values));
        expectValue(scene, property, 2.0, mean);
        // Far out of any range in between: what is posed is valid, which `expectValue` checks.
        for (const float slope : {1e30f, -1e30f}) {
            std::vector<float> wild = values;
            for (std::size_t i = 0; i < property.from.size(); ++i) wild[2 * property.from.size() + i] = slope;
            Scene overshooting = animated(channelOf(property, Interpolation::cubicSpline, wild));
            poseProperties(overshooting, 2.0);
            EXPECT_NO_THROW(validate(overshooting)) << static_cast<int>(property.property);
        }
    }
}

TEST(PropertyAnimation, ASplineIsClampedToTheRange) {
    // The Hermite form half way over two seconds: 0.5 × 1 + 0.125 × 2 × 4 + 0.5 × 1 = 2, clamped to 1.
    PropertyChannel channel;
    channel.property = AnimatedProperty::roughness;
    channel.interpolation = Interpolation::cubicSpline;
    channel.times = {1.0f, 3.0f};
    channel.values = {0, 1, 4, 0, 1, 0};
    EXPECT_EQ(sampleProperty(channel, 2.0).x, 1.0f);
    channel.property = AnimatedProperty::ior;  // 1 or more
    EXPECT_EQ(sampleProperty(channel, 2.0).x, 2.0f);
    channel.values[2] = -8.0f;
    EXPECT_EQ(sampleProperty(channel, 2.0).x, 1.0f);
    channel.property = AnimatedProperty::lightRange;  // over 0
    EXPECT_EQ(sampleProperty(channel, 2.0).x, 1e-6f);
}

TEST(PropertyAnimation, TexturesOfEverySlot) {
    for (std::size_t slot = 0; slot < materialTextures().size(); ++slot) {
        PropertyChannel channel;
        channel.property = AnimatedProperty::textureRotation;
        channel.element = 1;
        channel.texture = TextureSlot(slot);
        channel.times = {0.0f};
        channel.values = {2.5f};
        Scene scene = animated(channel);
        poseProperties(scene, 1.0);
        for (std::size_t other = 0; other < materialTextures().size(); ++other)
            EXPECT_EQ(textureOf(scene.materials[1], TextureSlot(other))->rotation,
                      other == slot ? 2.5f : 0.0f);
    }
}

TEST(PropertyAnimation, LaterChannelsApplyAndThoseThatRestDoNot) {
    const PropertyCase roughness = allProperties()[static_cast<std::size_t>(AnimatedProperty::roughness)];
    Scene scene = animated(channelOf(roughness, Interpolation::step, {0.25f, 0.5f}));
    scene.animations.push_back(scene.animations[0]);
    scene.animations[1].properties[0].values = {0.75f, 1.0f};
    expectValue(scene, roughness, 0.0, {0.75f});
    scene.animations[1].plays = false;
    expectValue(scene, roughness, 0.0, {0.25f});
    scene.animations[0].plays = false;
    scene.materials[1].roughness = 0.1f;
    expectValue(scene, roughness, 3.0, {0.1f});
}

TEST(PropertyAnimation, ProductsAndPairsStayValid) {
    Scene scene = sceneOfEverything();
    const auto add = [&](AnimatedProperty property, std::uint32_t element, std::vector<float> value) {
        PropertyChannel channel{property, element, {}, Interpolation::linear, {0.0f}, std::move(value)};
        scene.animations.resize(1);
        scene.animations[0].properties.push_back(channel);
    };
    add(AnimatedProperty::emission, 1, {1e20f, 1, 1});
    add(AnimatedProperty::emissionStrength, 1, {1e20f});
    add(AnimatedProperty::lightColor, 1, {4, 1, 1});
    add(AnimatedProperty::lightIntensity, 1, {1e20f});
    add(AnimatedProperty::innerConeAngle, 1, {1});
    add(AnimatedProperty::outerConeAngle, 1, {0.5f});
    add(AnimatedProperty::nearPlane, 0, {0});
    add(AnimatedProperty::farPlane, 0, {1e-6f});
    validate(scene);
    poseProperties(scene, 0.0);
    EXPECT_NO_THROW(validate(scene));
    EXPECT_EQ(scene.materials[1].emissionStrength, 1.0f);
    EXPECT_EQ(scene.lights[1].intensity, 2.5e19f);
    EXPECT_EQ(scene.lights[1].innerConeAngle, std::nextafter(0.5f, 0.0f));
    EXPECT_EQ(scene.cameras[0].nearPlane, 1e-6f);
    EXPECT_EQ(scene.cameras[0].farPlane, std::nextafter(1e-6f, 1.0f));
}

TEST(VisibleNodes, ANodeHidesWhatIsBelowIt) {
    Scene scene = sceneOfEverything();
    EXPECT_EQ(visibleNodes(scene, 0.0), (std::vector<bool>{true, true, true}));
    scene.nodes[1].visible = false;
    EXPECT_EQ(visibleNodes(scene, 0.0), (std::vector<bool>{true, false, false}));
    PropertyChannel channel;
    channel.property = AnimatedProperty::visibility;
    channel.interpolation = Interpolation::step;
    channel.times = {0.0f, 1.0f, 2.0f};
    channel.element = 1;
    channel.values = {1, 0, 7};
    scene.animations.emplace_back().properties.push_back(channel);
    EXPECT_EQ(visibleNodes(scene, 0.5), (std::vector<bool>{true, true, true}));
    EXPECT_EQ(visibleNodes(scene, 1.0), (std::vector<bool>{true, false, false}));
    EXPECT_EQ(visibleNodes(scene, 2.0), (std::vector<bool>{true, true, true}));
    scene.nodes[0].visible = false;
    EXPECT_EQ(visibleNodes(scene, 2.0), (std::vector<bool>{false, false, false}));
}

TEST(VisibleNodes, LightsOfInvisibleNodesDoNotLight) {
    Scene scene = sceneOfEverything();
    const auto intensities = [&] {
        std::vector<float> result;
        for (const WorldLight& light : worldLights(scene, worldTransforms(scene)))
            result.push_back(light.intensity.r);
        return result;
    };
    EXPECT_EQ(intensities(), (std::vector<float>{1, 1}));
    scene.nodes[0].visible = false;  // above the node of the second light
    EXPECT_EQ(intensities(), (std::vector<float>{1, 0}));
}

TEST(WorldLights, AreThoseOfTheTime) {
    const PropertyCase intensity =
        allProperties()[static_cast<std::size_t>(AnimatedProperty::lightIntensity)];
    const Scene scene = animated(channelOf(intensity, Interpolation::linear, {10, 30}));
    const auto at = [&](double time) {
        return worldLights(scene, worldTransforms(scene, time), time).at(1).intensity.g;
    };
    EXPECT_EQ(at(0.0), 10.0f);
    EXPECT_EQ(at(2.0), 20.0f);
    EXPECT_EQ(at(7.0), 30.0f);
}

TEST(CameraView, IsThatOfTheTime) {
    const PropertyCase fov = allProperties()[static_cast<std::size_t>(AnimatedProperty::verticalFov)];
    const Scene perspective = animated(channelOf(fov, Interpolation::linear, {0.5f, 1.5f}));
    EXPECT_EQ(cameraView(perspective, 0, {3, glm::mat4(1.0f)}, 2.0).verticalFov, 1.0f);
    const PropertyCase height =
        allProperties()[static_cast<std::size_t>(AnimatedProperty::orthographicHeight)];
    const Scene orthographic = animated(channelOf(height, Interpolation::linear, {2, 6}));
    EXPECT_EQ(cameraView(orthographic, 1, {3, glm::mat4(1.0f)}, 1.5).orthographicHeight, 3.0f);
    EXPECT_THROW(cameraView(orthographic, 1, {3, glm::mat4(1.0f)}, std::numeric_limits<double>::infinity()),
                 Error);
}

}  // namespace
}  // namespace candela
