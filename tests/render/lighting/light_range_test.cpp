// Lights without a range: what the ranges that the renderer assigns to them take from pictures.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace candela::test {
namespace {

constexpr int size = 33;
constexpr float pi = std::numbers::pi_v<float>;
/// Looks down the Z axis from 3 m on the square of 2 m; the middle pixel looks along the axis.
CameraView front() {
    return lookAt({0, 0, 3}, {0, 0, 0}, 2.0f * std::atan(1.0f / 3.0f));
}

Material white(float roughness = 1.0f) {
    Material material;
    material.roughness = roughness;
    return material;
}

/// f(n, n) of a white dielectric of roughness 1: 1 - E_s over pi, and a lobe of 0.04 / (4 pi) for D = 1 / pi.
const float normalIncidence =
    (1.01f - float(specularAlbedo(BrdfModel::course, glm::dvec3(0.04), 1.0, 1.0).x)) / pi;

/// The radiance of a white square, which faces the lights, with the renderer's ranges and with none.
struct WithAndWithoutRanges {
    double assigned = 0.0, unlimited = 0.0;
};

class RangeTest : public DrawingTest {
  protected:
    static float middleOf(const HdrImage& picture) { return pixelOf(picture, size / 2, size / 2).g; }
    static WithAndWithoutRanges drawnBoth(std::vector<WorldLight> lights,
                                          const GpuSceneOptions& options = {}) {
        const Scene scene = sceneOf(makeQuad(1.0f), white());
        const FrameRequest inputs{size, size, front(), BrdfModel::course, Technique::fullscreen};
        GpuScene uploaded(context(), scene, options);
        uploaded.setLights(lights);
        const double assigned = middleOf(drawn(uploaded, inputs));
        for (WorldLight& light : lights) light.range = 1e9f;
        uploaded.setLights(lights);
        return {assigned, middleOf(drawn(uploaded, inputs))};
    }
};

TEST_F(RangeTest, ManyDimLightsLoseNoMoreThanTheShare) {
    // Each gives 0.0022 lux, which is next to nothing; together they give 22.
    const std::vector<WorldLight> lights(10'000, pointLight({0, 0, 3}, 0.0f, glm::vec3(0.02f)));
    const WithAndWithoutRanges radiance = drawnBoth(lights);
    EXPECT_NEAR(radiance.unlimited, normalIncidence * 10'000 * 0.02 / 9.0, 0.01);
    EXPECT_LE(radiance.assigned, radiance.unlimited);
    EXPECT_GE(radiance.assigned, 0.99 * radiance.unlimited);
}

TEST_F(RangeTest, LightsOfAnyStrengthLoseNoMoreThanTheShare) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 50; ++i)
        lights.push_back(pointLight({0, 0, 1.0f + 60.0f * hashed(97, i)}, 0.0f,
                                    glm::vec3(std::pow(10.0f, 6.0f * hashed(98, i) - 3.0f))));
    for (const float share : {0.001f, 0.01f, 0.1f, 0.5f}) {
        GpuSceneOptions options;
        options.rangeLoss = share;
        const WithAndWithoutRanges radiance = drawnBoth(lights, options);
        // Single precision sums 50 lights.
        EXPECT_GE(radiance.assigned, (1.0 - share - 1e-5) * radiance.unlimited) << share;
        EXPECT_LE(radiance.assigned, (1.0 + 1e-5) * radiance.unlimited) << share;
    }
}

TEST_F(RangeTest, ALightBesideAMuchStrongerOneEnds) {
    // 1e-4 of the other's light at the square is far below the share.
    std::vector<WorldLight> lights(2, pointLight({0, 0, 10}, 0.0f, glm::vec3(1e4f)));
    lights[1] = pointLight({0, 0, 10}, 0.0f, glm::vec3(1.0f));
    const GpuScene scene = upload(sceneOf(makeQuad(1.0f), white()), lights);
    EXPECT_LT(scene.lightReport().minRange, 10.0f);
    EXPECT_GT(scene.lightReport().maxRange, 20.0f);
}

TEST_F(RangeTest, AHighlightCountsWithTheHeightOfItsLobe) {
    // The dim light adds 1/1000 to a diffuse surface. The lobe of the metal is 89 times as high as white.
    std::vector<WorldLight> lights(2, pointLight({0, 0, 10}, 0.0f, glm::vec3(1e4f)));
    lights[1] = pointLight({0, 0, 10}, 0.0f, glm::vec3(10.0f));
    Material metal = white();
    metal.metallic = 1.0f;
    metal.roughness = 0.23f;
    GpuScene scene = upload(sceneOf(makeQuad(1.0f), metal), lights);
    EXPECT_GT(scene.lightReport().minRange, 20.0f);
    scene.setMaterial(0, white());
    render(scene, {size, size, front(), BrdfModel::course, Technique::fullscreen});
    EXPECT_LT(scene.lightReport().minRange, 10.0f) << "without the metal";
}

TEST_F(RangeTest, RangesFollowWhatMoves) {
    GpuScene scene =
        upload(sceneOf(makeQuad(1.0f), white()), std::vector{pointLight({0, 0, 2}, 0.0f, glm::vec3(1.0f))});
    const float before = scene.lightReport().minRange;
    scene.setTransform(0, glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, -1000)));
    render(scene, {size, size, front(), BrdfModel::course, Technique::fullscreen});
    EXPECT_GT(scene.lightReport().minRange, 100.0f * before);
}

TEST_F(RangeTest, ReportTellsTheRanges) {
    GpuScene scene = upload(sceneOf(makeQuad(1.0f), white()));
    EXPECT_EQ(scene.lightReport().lights, 0u);
    std::vector<WorldLight> lights(10, pointLight({0, 0, 1}, 3.0f, glm::vec3(5)));
    lights.push_back(directionalLight({0, 0, -1}, glm::vec3(5)));
    scene.setLights(lights);
    EXPECT_EQ(scene.lightReport().lights, 11u);
    EXPECT_EQ(scene.lightReport().rangesAssigned, 0u);
    EXPECT_EQ(scene.lightReport().rangeIrradiance, 0.0);
    for (int i = 0; i < 4; ++i) lights[std::size_t(2 * i)].range = 0.0f;
    lights[1].type = LightType::spot;
    lights[1].range = 0.0f;
    lights[1].intensity = glm::vec3(20);
    scene.setLights(lights);
    const LightReport report = scene.lightReport();
    EXPECT_EQ(report.rangesAssigned, 5u);
    EXPECT_NEAR(report.minRange, std::sqrt(5.0 / report.rangeIrradiance), 1e-5 * report.minRange);
    EXPECT_NEAR(report.maxRange, 2.0f * report.minRange, 1e-5f * report.maxRange);
    lights.assign(3, pointLight({0, 0, 1}, 0.0f, glm::vec3(0)));
    scene.setLights(lights);
    EXPECT_EQ(scene.lightReport().rangeIrradiance, 0.0) << "lights that give nothing lose nothing";
}

TEST_F(RangeTest, TheShareLiesBetweenZeroAndOne) {
    for (const float share : {0.0f, -1.0f, 1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        GpuSceneOptions options;
        options.rangeLoss = share;
        EXPECT_THROW(GpuScene(context(), Scene{}, options), Error);
    }
}

}  // namespace
}  // namespace candela::test
