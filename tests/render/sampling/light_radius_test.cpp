// Lights with a radius: each sample of a picture sees them at another point of their sphere.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include "render/gpu_scene/gpu_scene_state.h"
#include "render/sampling/sample_sequence.h"

#include <candela/accumulator.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace candela::test {
namespace {

constexpr int width = 96, height = 8;

/// Fully rough and not metallic: its radiance is the irradiance times a constant, up to a faint highlight.
Material matte() {
    Material material;
    material.baseColor = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
    material.roughness = 1.0f;
    return material;
}

class LightRadiusTest : public DrawingTest {
  protected:
    static FrameSettings settingsOf(Shadows shadows, Technique technique = Technique::automatic) {
        FrameSettings settings;
        settings.width = width;
        settings.height = height;
        settings.shadows = shadows;
        settings.technique = technique;
        return settings;
    }
    /// The mean over `count` samples of the lights alone: the view stays.
    static HdrImage mean(GpuScene& scene, const CameraView& view, FrameSettings settings,
                         std::uint32_t count) {
        Accumulator accumulator(context());
        for (settings.sample = 0; settings.sample < count; ++settings.sample)
            accumulator.add(renderer().render(scene, view, settings));
        return accumulator.radiance();
    }
    static WorldLight ball(const glm::vec3& position, float radius) {
        WorldLight light = pointLight(position, 1000.0f, glm::vec3(100));
        light.radius = radius;
        return light;
    }
};

/// From above, x to the right, 4 m wide.
CameraView fromAbove() {
    CameraView view;
    view.worldFromCamera[3] = {0, 0, 3, 1};
    view.orthographicHeight = 4.0f * height / width;
    return view;
}

TEST_F(LightRadiusTest, penumbraBehindAnEdgeIsThatOfADisc) {
    if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    // A floor at z = 0, a light 20 m above it, and halfway a screen that covers x < 0.
    constexpr float lightHeight = 20.0f, screenHeight = 10.0f, radius = 0.5f;
    Scene floor = sceneOf(makeQuad(5.0f), matte());
    place(floor, makeQuad(5.0f), matte(), glm::translate(glm::mat4(1.0f), {-5, 0, screenHeight}));
    GpuScene scene = upload(floor, std::vector{ball({0, 0, lightHeight}, radius)});
    const CameraView view = fromAbove();
    const HdrImage open = mean(scene, view, settingsOf(Shadows::off), 256);
    for (const Technique technique : techniques) {
        const HdrImage shaded = mean(scene, view, settingsOf(Shadows::on, technique), 256);
        int partly = 0;
        for (int x = 0; x < width; ++x) {
            // Seen from the floor, the screen's edge lies before this place of the light.
            const double at = 4.0 * ((x + 0.5) / width - 0.5);
            const double edge = std::clamp(at * (1.0 - lightHeight / screenHeight) / radius, -1.0, 1.0);
            const double hidden =
                0.5 + (edge * std::sqrt(1.0 - edge * edge) + std::asin(edge)) / std::numbers::pi;
            const double visible = pixelOf(shaded, x, 4).g / pixelOf(open, x, 4).g;
            // The light's nearest point is 2.5 % nearer than its centre.
            EXPECT_NEAR(visible, 1.0 - hidden, 0.02) << at << ", " << toString(technique);
            partly += visible > 0.05 && visible < 0.95;
        }
        EXPECT_GT(partly, 15);
    }
}

TEST_F(LightRadiusTest, spheresGiveTheLightOfAPoint) {
    // As near as 1.5 radii: the shell theorem holds wherever the sphere is outside.
    const CameraView view = fromAbove();
    GpuScene scene = upload(sceneOf(makeQuad(5.0f), matte()));
    scene.setLights(std::vector{ball({0.3f, 0.2f, 1.5f}, 1.0f)});
    const HdrImage sphere = mean(scene, view, settingsOf(Shadows::off), 4096);
    scene.setLights(std::vector{ball({0.3f, 0.2f, 1.5f}, 0.0f)});
    const HdrImage point = mean(scene, view, settingsOf(Shadows::off), 1);
    // Of the specular lobe at roughness 1, which is no part of the irradiance, some per cent are left.
    for (int x = 0; x < width; ++x)
        EXPECT_NEAR(pixelOf(sphere, x, 4).g / pixelOf(point, x, 4).g, 1.0, 0.03) << x;
}

TEST_F(LightRadiusTest, sampleZeroIsThePointInTheMiddle) {
    const LitScene lit = spheresOnAFloor();
    std::vector<WorldLight> spheres = lit.lights;
    for (WorldLight& light : spheres) light.radius = 0.3f;
    GpuScene scene = upload(lit.scene, spheres), points = upload(lit.scene, lit.lights);
    FrameSettings settings = settingsOf(Shadows::automatic);
    const HdrImage expected = renderer().render(points, lit.view, settings).radiance();
    EXPECT_EQ(renderer().render(scene, lit.view, settings).radiance().rgba, expected.rgba);
    settings.sample = 3;
    EXPECT_NE(renderer().render(scene, lit.view, settings).radiance().rgba, expected.rgba);
    EXPECT_EQ(renderer().render(points, lit.view, settings).radiance().rgba, expected.rgba)
        << "lights without a radius stay";
    EXPECT_EQ(points.state().lastUpdate.lights, 0u) << "and are not uploaded again";
    settings.sample = 0;
    EXPECT_EQ(renderer().render(scene, lit.view, settings).radiance().rgba, expected.rgba);
}

TEST_F(LightRadiusTest, lightsThatNodesMoveKeepTheirPlaceInTheSphere) {
    Scene moving = sceneOf(makeQuad(5.0f), matte());
    moving.nodes.emplace_back().name = "lamp";
    const auto addLight = [&](LightType type, float radius, std::optional<std::uint32_t> node,
                              std::optional<float> range) {
        Light& light = moving.lights.emplace_back();
        light.type = type;
        light.radius = radius;
        light.node = node;
        light.range = range;
        light.intensity = 50.0f;
    };
    addLight(LightType::point, 0.5f, 1, {});
    addLight(LightType::directional, 9.0f, {}, {});
    addLight(LightType::point, 2.0f, 1, 3.0f);
    GpuScene scene(context(), moving);
    FrameSettings settings = settingsOf(Shadows::off);
    const auto at = [&](const glm::vec3& place, std::uint32_t sample) {
        scene.setTransform(1, glm::translate(glm::mat4(1.0f), place));
        settings.sample = sample;
        renderer().render(scene, fromAbove(), settings);
        const LightReaches& reaches = scene.state().lights.reaches();
        return std::pair(reaches.position(0) - place, reaches.position(1) - place);
    };
    for (const std::uint32_t sample : {0u, 5u, 6u, 0u, 7u}) {
        for (const glm::vec3& place : {glm::vec3(0, 0, 4), glm::vec3(1, -1, 5)}) {
            const auto [first, second] = at(place, sample);
            EXPECT_LT(glm::distance(first, 0.5f * glm::vec3(lightPoint(sample, 0))), 1e-5f);
            EXPECT_LT(glm::distance(second, 2.0f * glm::vec3(lightPoint(sample, 2))), 1e-5f);
        }
    }
    EXPECT_GT(glm::distance(lightPoint(5, 0), lightPoint(5, 2)), 0.05) << "each light has its own points";
    const float range = scene.lightReport().maxRange;
    at({1, -1, 5}, 0);
    EXPECT_EQ(scene.lightReport().maxRange, range) << "ranges are those of the centres";
}

}  // namespace
}  // namespace candela::test
