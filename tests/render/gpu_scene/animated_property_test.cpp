// Animated materials, lights and visibility: a picture at a time is, bit for bit, that of a scene that has
// the values of that time and no animation, whatever was drawn before.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "gl/state_guard.h"
#include "scene/geometry/tangents.h"

#include <candela/accumulator.h>
#include <candela/sampling.h>

#include <glm/gtc/matrix_transform.hpp>

#include <functional>
#include <string>

namespace candela::test {
namespace {

const FrameRequest inputs{64, 48, lookAt({0.5f, 1.0f, 5}, {0, 0, 0}, 0.8f), BrdfModel::gltf,
                          Technique::tiles};

using P = AnimatedProperty;

PropertyChannel channel(P property, std::uint32_t element, std::vector<float> from,
                        const std::vector<float>& to, Interpolation interpolation = Interpolation::linear) {
    from.insert(from.end(), to.begin(), to.end());
    return {property, element, TextureSlot::baseColor, interpolation, {0.0f, 2.0f}, std::move(from)};
}

glm::mat4 at(float x, float y = 0.0f, float z = 0.0f) {
    return glm::translate(glm::mat4(1.0f), {x, y, z});
}

/// A sphere of material 0, whose normals a texture varies, a cage of material 1 and a floor; a point light
/// with a range, a spot light, one without a range, all on node 3, and a directional light.
Scene scene() {
    Scene scene;
    scene.images = {makeImage(8, 8,
                              [](std::uint32_t x, std::uint32_t y) {
                                  return glm::u8vec4(30 * x + 20, 25 * y + 40, 200 - 20 * x, 255 - 20 * y);
                              }),
                    makeImage(4, 4, [](std::uint32_t x, std::uint32_t y) {
                        return glm::u8vec4(100 + 18 * x, 100 + 18 * y, 250, 255);
                    })};
    Material surface;
    surface.baseColorTexture = Texture{};
    surface.normalTexture = Texture{};
    surface.normalTexture->image = 1;
    surface.roughness = 0.4f;
    Mesh sphere = makeSphere(0.9f);
    generateTangents(sphere, 0);
    place(scene, sphere, surface, at(-1.1f));
    Material other;
    other.baseColor = {0.8f, 0.4f, 0.2f, 1.0f};
    placeCage(scene, makeCubeCage(0.9f), other, at(1.1f));
    scene.cages[0].faceMaterials.assign(6, 1u);
    place(scene, makeQuad(4.0f), Material{}, at(0, 0, -1.5f));
    scene.nodes.emplace_back().transform = at(0, 2, 3);
    scene.lights.resize(4);
    for (Light& light : scene.lights) {
        light.intensity = 20.0f;
        light.node = 3;
    }
    scene.lights[0].range = 9.0f;
    scene.lights[0].position = {-2, 0, 0};
    scene.lights[1].type = LightType::spot;
    scene.lights[1].range = 20.0f;
    scene.lights[1].innerConeAngle = 0.1f;
    scene.lights[1].outerConeAngle = 0.3f;
    scene.lights[2].position = {2, 0, 0};
    scene.lights[3].type = LightType::directional;
    scene.lights[3].intensity = 0.5f;
    scene.lights[3].node.reset();
    return scene;
}

struct Motion {
    const char* name;
    std::vector<PropertyChannel> channels;
    std::function<void(Scene&)> prepare = [](Scene&) {};
};

void setMask(Scene& scene) {
    scene.materials[0].alphaMode = AlphaMode::mask;
}
void setBlend(Scene& scene) {
    scene.materials[0].alphaMode = AlphaMode::blend;
}

std::vector<Motion> motions() {
    PropertyChannel normalOffset = channel(P::textureOffset, 0, {0, 0}, {1, 0.5f});
    normalOffset.texture = TextureSlot::normal;
    PropertyChannel blink = channel(P::visibility, 0, {1}, {0}, Interpolation::step);
    PropertyChannel lamp = channel(P::visibility, 3, {0}, {1}, Interpolation::step);
    const auto one = [](P property, float from, float to) {
        return std::vector{channel(property, 0, {from}, {to})};
    };
    return {
        {"base colour", {channel(P::baseColor, 0, {1, 0, 0, 1}, {0, 1, 0, 1})}},
        {"metallic and roughness", {channel(P::metallic, 0, {0}, {1}), channel(P::roughness, 0, {1}, {0})}},
        {"of a cage", {channel(P::baseColor, 1, {1, 0, 0, 1}, {0, 1, 0, 1})}},
        {"emission",
         {channel(P::emission, 0, {0, 0, 0}, {0, 1, 2}), channel(P::emissionStrength, 0, {1}, {3})}},
        {"normal scale", one(P::normalScale, 0, 2)},
        {"a mask", {channel(P::baseColor, 0, {1, 1, 1, 1}, {1, 1, 1, 0.3f})}, setMask},
        {"its cutoff", one(P::alphaCutoff, 0, 0.9f), setMask},
        {"alpha", {channel(P::baseColor, 0, {1, 1, 1, 1}, {1, 1, 1, 0})}, setBlend},
        {"texture transforms",
         {channel(P::textureScale, 0, {1, 1}, {3, 2}), channel(P::textureRotation, 0, {0}, {1}),
          normalOffset}},
        {"index of refraction", one(P::ior, 1.5f, 2.5f)},
        {"specular",
         {channel(P::specularFactor, 0, {1}, {0}), channel(P::specularColor, 0, {1, 1, 1}, {2, 1, 0})}},
        {"clearcoat",
         {channel(P::clearcoatFactor, 0, {0}, {1}), channel(P::clearcoatRoughness, 0, {0}, {0.5f})}},
        {"sheen",
         {channel(P::sheenColor, 0, {0, 0, 0}, {1, 0.5f, 0}), channel(P::sheenRoughness, 0, {1}, {0.3f})}},
        {"anisotropy",
         {channel(P::anisotropyStrength, 0, {0}, {1}), channel(P::anisotropyRotation, 0, {0}, {2})}},
        {"iridescence",
         {channel(P::iridescenceFactor, 0, {0}, {1}), channel(P::iridescenceMaxThickness, 0, {100}, {900})}},
        {"transmission",
         {channel(P::transmissionFactor, 0, {0}, {1}), channel(P::thickness, 0, {0}, {1}),
          channel(P::attenuationColor, 0, {1, 1, 1}, {0, 1, 0}),
          channel(P::attenuationDistance, 0, {9}, {0.5f})}},
        {"diffuse transmission", one(P::diffuseTransmissionFactor, 0, 1)},
        {"colour of a light", {channel(P::lightColor, 0, {1, 0, 0}, {0, 1, 0})}},
        {"intensities",
         {channel(P::lightIntensity, 0, {0}, {30}), channel(P::lightIntensity, 2, {50}, {0}),
          channel(P::lightIntensity, 3, {0}, {3})}},
        {"range", one(P::lightRange, 1, 9)},
        {"position", {channel(P::lightPosition, 0, {-2, 0, 0}, {1, 1, -1})}},
        {"cone", {channel(P::innerConeAngle, 1, {0}, {0.4f}), channel(P::outerConeAngle, 1, {0.2f}, {0.5f})}},
        {"visibility of a mesh", {blink}},
        {"of a cage", {channel(P::visibility, 1, {0}, {1}, Interpolation::step)}},
        {"of lights", {lamp}},
    };
}

class AnimatedPropertyTest : public DrawingTest {
  protected:
    static GpuScene uploaded(const Scene& scene) { return {context(), scene, subdividing(2)}; }
    static GpuScene::State::UpdateCounts updated(GpuScene& scene) {
        const gl::StateGuard guard(*context().state().binding, "a test");
        scene.state().update();
        return scene.state().lastUpdate;
    }
    static Scene posed(Scene scene, double time) {
        poseProperties(scene, time);
        scene.animations.clear();
        return scene;
    }
    static void expectPicturesOfPosedScenes(const Scene& animated, const FrameRequest& request) {
        GpuScene playing = uploaded(animated);
        HdrImage last;
        for (const double time : {0.0, 0.5, 2.0, 1.3, 0.5, 0.0}) {
            playing.setTime(time);
            const HdrImage picture = drawn(playing, request);
            EXPECT_EQ(picture.rgba, drawn(uploaded(posed(animated, time)), request).rgba) << time;
            last = picture;
        }
        playing.setTime(2.0);
        EXPECT_NE(drawn(playing, request).rgba, last.rgba) << "the motion shows";
    }
};

TEST_F(AnimatedPropertyTest, APictureIsThatOfTheValuesOfItsTime) {
    for (const Motion& motion : motions()) {
        SCOPED_TRACE(motion.name);
        Scene animated = scene();
        motion.prepare(animated);
        animated.animations.emplace_back().properties = motion.channels;
        validate(animated);
        expectPicturesOfPosedScenes(animated, inputs);
    }
}

TEST_F(AnimatedPropertyTest, AllAtOnceInEveryTechniqueWithShadows) {
    Scene animated = scene();
    setBlend(animated);
    for (const Motion& motion : motions())
        for (const PropertyChannel& one : motion.channels)
            animated.animations.emplace_back().properties.push_back(one);
    for (const Form& form : forms) {
        SCOPED_TRACE(form.name);
        FrameRequest request = inputs;
        request.technique = form.technique;
        request.tileBackend = form.backend;
        request.shadows = Shadows::on;
        expectPicturesOfPosedScenes(animated, request);
    }
}

TEST_F(AnimatedPropertyTest, CostsWhatChanges) {
    Scene animated = scene();
    for (int i = 0; i < 20; ++i) animated.lights.push_back(animated.lights[0]);
    animated.animations.emplace_back().properties = {channel(P::metallic, 1, {0}, {1}),
                                                     channel(P::lightIntensity, 0, {0}, {5})};
    GpuScene playing = uploaded(animated);
    EXPECT_EQ(updated(playing).materials, 0u) << "the upload poses";
    playing.setTime(1.0);
    GpuScene::State::UpdateCounts counts = updated(playing);
    EXPECT_EQ(counts.materials, 1u);
    EXPECT_EQ(counts.lights, 1u);
    EXPECT_EQ(counts.nodes + counts.instances + counts.draws, 0u);
    playing.setTime(2.0);
    updated(playing);
    playing.setTime(7.0);
    counts = updated(playing);
    EXPECT_EQ(counts.materials + counts.lights, 0u) << "both have ended";
}

TEST_F(AnimatedPropertyTest, AnimationsThatDoNotPlayLeaveTheValuesOfTheScene) {
    Scene animated = scene();
    animated.animations.resize(2);
    animated.animations[0].properties = {channel(P::baseColor, 0, {1, 0, 0, 1}, {0, 1, 0, 1}),
                                         channel(P::lightIntensity, 0, {0}, {5})};
    animated.animations[1].properties = {channel(P::visibility, 0, {0}, {0}, Interpolation::step)};
    GpuScene playing = uploaded(animated);
    playing.setTime(1.0);
    const std::vector<std::vector<std::uint32_t>> selections{{1}, {}, {0}, {0, 1}};
    for (const std::vector<std::uint32_t>& selection : selections) {
        playing.playAnimations(selection);
        Scene expected = animated;
        for (Animation& animation : expected.animations) animation.plays = false;
        for (const std::uint32_t index : selection) expected.animations[index].plays = true;
        EXPECT_EQ(drawn(playing, inputs).rgba, drawn(uploaded(posed(expected, 1.0)), inputs).rgba);
    }
}

TEST_F(AnimatedPropertyTest, TheHostsMaterialsAndLightsStay) {
    Scene animated = scene();
    animated.animations.emplace_back().properties = {channel(P::baseColor, 0, {1, 0, 0, 1}, {0, 1, 0, 1}),
                                                     channel(P::lightIntensity, 0, {0}, {5})};
    GpuScene playing = uploaded(animated);
    Material blue;
    blue.baseColor = {0, 0, 1, 1};
    playing.setMaterial(0, blue);
    const WorldLight light = pointLight({0, 3, 5}, 30.0f, glm::vec3(20.0f));
    playing.setLights({&light, 1});
    const HdrImage before = drawn(playing, inputs);
    playing.setTime(2.0);
    EXPECT_EQ(drawn(playing, inputs).rgba, before.rgba);
}

TEST_F(AnimatedPropertyTest, ANodeIsDrawnWhereBothSceneAndHostShowIt) {
    Scene animated = scene();
    animated.nodes[0].visible = false;
    Scene without = scene();
    without.nodes[0].mesh.reset();
    GpuScene hidden = uploaded(animated);
    const HdrImage nothing = drawn(uploaded(without), inputs);
    EXPECT_EQ(drawn(hidden, inputs).rgba, nothing.rgba);
    hidden.setVisibility(0, GpuScene::Visibility::shown);
    EXPECT_EQ(drawn(hidden, inputs).rgba, nothing.rgba);

    animated.animations.emplace_back().properties = {
        channel(P::visibility, 0, {0}, {1}, Interpolation::step)};
    GpuScene blinking = uploaded(animated);
    blinking.setTime(2.0);
    EXPECT_EQ(drawn(blinking, inputs).rgba, drawn(uploaded(scene()), inputs).rgba);
    blinking.setVisibility(0, GpuScene::Visibility::hidden);
    EXPECT_EQ(drawn(blinking, inputs).rgba, nothing.rgba);
    blinking.setTime(0.0);
    blinking.setVisibility(0, GpuScene::Visibility::shown);
    EXPECT_EQ(drawn(blinking, inputs).rgba, nothing.rgba);
}

TEST_F(AnimatedPropertyTest, AHiddenNodeHidesWhatIsBelowIt) {
    Scene family = scene();
    family.nodes[1].parent = 0;
    family.nodes[3].parent = 1;
    family.lights[3].node = 3;
    family.animations.emplace_back().properties = {channel(P::visibility, 0, {1}, {0}, Interpolation::step)};
    GpuScene playing = uploaded(family);
    playing.setTime(2.0);
    const HdrImage dark = drawn(playing, inputs);
    for (std::size_t i = 0; i < dark.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        ASSERT_EQ(dark.rgba[i], 0.0f) << "only the floor is left, and no light";
    }
    playing.setTime(0.0);
    EXPECT_NE(drawn(playing, inputs).rgba, dark.rgba);
}

TEST_F(AnimatedPropertyTest, AHiddenSurfaceCastsNoShadow) {
    Scene animated = scene();
    animated.animations.emplace_back().properties = {
        channel(P::visibility, 0, {1}, {0}, Interpolation::step)};
    FrameRequest request = inputs;
    request.shadows = Shadows::on;
    expectPicturesOfPosedScenes(animated, request);
}

TEST_F(AnimatedPropertyTest, AnOpenShutterTakesTheMeanOverItsTime) {
    // An unlit square whose colour goes from 0 to 1 in two seconds fills the picture.
    Material unlit;
    unlit.unlit = true;
    Scene animated = sceneOf(makeQuad(50.0f), unlit);
    animated.animations.emplace_back().properties = {channel(P::baseColor, 0, {0, 0, 0, 1}, {1, 1, 1, 1})};
    GpuScene playing = upload(animated);
    const SamplingSettings sampling{.count = 64, .shutter = 1.0, .framesPerSecond = 2.0};
    Accumulator mean(context());
    for (std::uint32_t i = 0; i < sampling.count; ++i) {
        playing.setTime(sampleTime(0.75, sampling, i));
        FrameSettings settings = inputs.settings();
        settings.sample = i;
        mean.add(renderer().render(playing, sampleView(inputs.view, sampling, 64, 48, i), settings));
    }
    // From 0.5 s to 1 s the colour goes from 0.25 to 0.5: 0.375 in the middle. A sample is up to a code of
    // the G-buffer's 8-bit sRGB off, 1 / 255 × 0.8 there, in both directions; the times of 64 samples are
    // evenly spread to 1 / 64 of the interval, 0.004.
    EXPECT_NEAR(pixelOf(mean.radiance(), 32, 24).g, 0.375f, 0.004f);
}

}  // namespace
}  // namespace candela::test
