// Lights and nodes that cast no shadows give the image of a frame without shadows, bit for bit.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/default_lights.h>

#include <glm/gtc/matrix_transform.hpp>

namespace candela::test {
namespace {

constexpr int size = 64, middle = size / 2;
const CameraView front = lookAt({0, 0, 3}, {0, 0, 0}, 0.8f);

enum Index : std::uint32_t { ground, group, blocker };

/// A ground that the camera faces, and between its middle and the light a small square. The square's parent
/// shows another one off to the side.
Scene groundBehindASquare() {
    Scene scene = sceneOf(makeQuad(1.0f), Material{});
    place(scene, makeQuad(0.05f), Material{}, glm::translate(glm::mat4(1.0f), {0.4f, 0.8f, 0.5f}));
    place(scene, makeQuad(0.1f), Material{}, glm::translate(glm::mat4(1.0f), {0.0f, -0.8f, 0.0f}));
    scene.nodes[blocker].parent = group;
    Light light;
    light.position = {0.8f, 0.0f, 1.0f};
    light.intensity = 10.0f;
    scene.lights.push_back(light);
    return scene;
}

class ShadowFlagsTest : public DrawingTest {
  protected:
    static HdrImage drawnWith(Shadows shadows, GpuScene& scene) {
        FrameSettings settings{size, size, BrdfModel::course, Technique::tiles};
        settings.tileBackend = TileBackend::cpu;
        settings.shadows = shadows;
        return renderer().render(scene, front, settings).radiance();
    }
    static GpuScene uploaded(const Scene& scene) { return GpuScene(context(), scene, subdividing(1)); }

    static void expectNoShadow(GpuScene& scene) {
        EXPECT_EQ(drawnWith(Shadows::on, scene).rgba, drawnWith(Shadows::off, scene).rgba);
    }
    static void expectShadow(GpuScene& scene) {
        EXPECT_EQ(pixelOf(drawnWith(Shadows::on, scene), middle, middle), glm::vec3(0.0f));
        EXPECT_GT(pixelOf(drawnWith(Shadows::off, scene), middle, middle).g, 0.0f);
    }
};

TEST_F(ShadowFlagsTest, byDefaultLightsAndNodesCastShadows) {
    GpuScene scene = uploaded(groundBehindASquare());
    expectShadow(scene);
}

TEST_F(ShadowFlagsTest, lightWithoutShadows) {
    Scene description = groundBehindASquare();
    description.lights[0].castsShadow = false;
    GpuScene scene = uploaded(description);
    expectNoShadow(scene);
    WorldLight light = pointLight(description.lights[0].position, 5.0f, glm::vec3(10.0f));
    scene.setLights({&light, 1});
    expectShadow(scene);
    light.castsShadow = false;
    scene.setLights({&light, 1});
    expectNoShadow(scene);
}

/// Around the middle, of all types; sums of many round at each step.
std::vector<WorldLight> manyLights() {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 60; ++i) {
        const glm::vec3 position = 1.5f * hashedDirection(1, i), intensity(hashed(3, i), hashed(4, i), 1.0f);
        lights.push_back(pointLight(position, 4.0f, intensity));
        lights.push_back(spotLight(position, {0, 0, 0}, 4.0f, intensity, 0.1f, 0.9f));
        lights.push_back(directionalLight(-glm::normalize(position), intensity));
    }
    return lights;
}

TEST_F(ShadowFlagsTest, manyLightsOfAllTypesWithoutShadows) {
    GpuScene scene = uploaded(groundBehindASquare());
    std::vector<WorldLight> lights = manyLights();
    for (WorldLight& light : lights) light.castsShadow = false;
    scene.setLights(lights);
    expectNoShadow(scene);
}

TEST_F(ShadowFlagsTest, hiddenNodesCastNone) {
    GpuScene scene = uploaded(groundBehindASquare());
    scene.setVisibility(blocker, GpuScene::Visibility::hidden);
    expectNoShadow(scene);
    scene.setVisibility(group, GpuScene::Visibility::hidden);
    scene.setLights(manyLights());
    expectNoShadow(scene);
}

TEST_F(ShadowFlagsTest, onlyTheLightThatIsMeant) {
    Scene description = groundBehindASquare();
    description.lights.push_back(description.lights[0]);
    description.lights[0].castsShadow = false;
    GpuScene both = uploaded(description);
    description.lights.pop_back();
    GpuScene one = uploaded(description);
    EXPECT_EQ(pixelOf(drawnWith(Shadows::on, both), middle, middle),
              pixelOf(drawnWith(Shadows::on, one), middle, middle));
}

TEST_F(ShadowFlagsTest, nodeWithoutShadows) {
    Scene description = groundBehindASquare();
    description.nodes[blocker].castsShadow = false;
    GpuScene scene = uploaded(description);
    expectNoShadow(scene);
    scene.setCastsShadow(blocker, GpuScene::ShadowCasting::on);
    expectShadow(scene);
    scene.setCastsShadow(blocker, GpuScene::ShadowCasting::off);
    expectNoShadow(scene);
}

TEST_F(ShadowFlagsTest, aNodeDoesNotSpeakForItsChildren) {
    Scene description = groundBehindASquare();
    description.nodes[group].castsShadow = false;
    GpuScene scene = uploaded(description);
    expectShadow(scene);
    scene.setCastsShadow(group, GpuScene::ShadowCasting::on);
    scene.setCastsShadow(blocker, GpuScene::ShadowCasting::off);
    expectNoShadow(scene);
}

TEST_F(ShadowFlagsTest, nodeThatShowsACage) {
    Scene description = groundBehindASquare();
    description.nodes[blocker].mesh.reset();
    description.cages.push_back(makeSheetCage(0.1f, 2));
    description.cages[0].faceMaterials.assign(description.cages[0].faceSizes.size(), 0u);
    description.nodes[blocker].cage = 0;
    GpuScene scene = uploaded(description);
    expectShadow(scene);
    scene.setCastsShadow(blocker, GpuScene::ShadowCasting::off);
    expectNoShadow(scene);
}

TEST_F(ShadowFlagsTest, defaultLightsCastNone) {
    GpuScene scene = uploaded(groundBehindASquare());
    scene.setLights(defaultLights(front));
    expectNoShadow(scene);
}

}  // namespace
}  // namespace candela::test
