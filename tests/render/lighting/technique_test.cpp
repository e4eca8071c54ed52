// All techniques give the same image, and their counts agree with reference counts.

#include "support/drawing_test.h"
#include "support/evaluated_image.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace candela::test {
namespace {

class TechniqueTest : public DrawingTest {
  protected:
    /// Pixels of every technique against those of `fullscreen`.
    ///
    /// Tolerance: all follow the same steps on the same texels, so that only the order of the sum and the
    /// rounding of each step differ. A highlight of width alpha magnifies what the half vector's angle has
    /// lost, some four roundings of 2^-24, by 1 / alpha: 1e-4 at the minimum roughness here, 0.05. At the rim
    /// of a range, where 1 - (d / range)^4 cancels, `rimError` is added.
    static constexpr double tolerance = 1.0e-4;

    /// Four roundings of what the brightest light would give at its range, had it no window. Lights of
    /// extreme ranges, which reach no pixel or all alike, are left out.
    static double rimError(std::span<const WorldLight> lights) {
        double brightest = 0.0;
        for (const WorldLight& light : lights) {
            if (light.type == LightType::directional || light.range < 0.1f || light.range > 1.0e6f) continue;
            const float intensity = std::max({light.intensity.r, light.intensity.g, light.intensity.b});
            brightest = std::max(brightest, double(intensity) / (double(light.range) * light.range));
        }
        return 4.0 / 16777216.0 * brightest;
    }

    static void expectSameImages(const Scene& scene, std::span<const WorldLight> lights,
                                 const CameraView& view, const char* what, int width = 96, int height = 54) {
        GpuScene uploaded = upload(scene, lights);
        for (const BrdfModel model : models) {
            FrameRequest inputs{width, height, view, model, Technique::fullscreen};
            const HdrImage reference = drawn(uploaded, inputs);
            ASSERT_TRUE(allFinite(reference)) << what;
            for (const Technique technique : techniques) {
                inputs.technique = technique;
                expectSame(drawn(uploaded, inputs), reference, rimError(lights), what);
                EXPECT_EQ(lastFrame().technique(), technique);
            }
        }
    }

    static void expectSame(const HdrImage& picture, const HdrImage& reference, double absolute,
                           const char* what) {
        ASSERT_EQ(picture.rgba.size(), reference.rgba.size());
        double worst = 0.0;
        for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
            const double expected = reference.rgba[i], error = std::abs(double(picture.rgba[i]) - expected);
            if (error > absolute) worst = std::max(worst, (error - absolute) / expected);
        }
        EXPECT_LE(worst, tolerance) << what << ", " << toString(lastFrame().technique());
        largest_ = std::max(largest_, worst);
    }

    static void TearDownTestSuite() {
        std::printf("techniques: largest relative difference %.1e\n", largest_);
        DrawingTest::TearDownTestSuite();
    }

  private:
    static inline double largest_ = 0.0;
};

Material rough(float roughness) {
    Material material;
    material.roughness = roughness;
    return material;
}

/// A room of spheres around the origin, with a wall behind them.
Scene room() {
    Scene scene = sceneOf(makeQuad(12.0f), rough(0.6f), glm::translate(glm::mat4(1.0f), {0, 0, -6}));
    for (std::uint32_t i = 0; i < 14; ++i) {
        const glm::vec3 center(8 * hashed(40, i) - 4, 6 * hashed(41, i) - 3, 8 * hashed(42, i) - 5);
        place(scene, makeSphere(0.6f), rough(0.05f + 0.06f * float(i)),
              glm::translate(glm::mat4(1.0f), center));
    }
    return scene;
}

std::vector<WorldLight> mixedLights(std::uint32_t count, float range) {
    std::vector<WorldLight> lights = mixedLocalLights(count, range);
    lights.push_back(directionalLight({0.2f, -0.5f, -1}, {0.1f, 0.1f, 0.05f}));
    return lights;
}

const CameraView front = lookAt({0, 0, 9}, {0, 0, 0}, 0.8f);

TEST_F(TechniqueTest, sceneOfTheEvaluatorsTest) {
    for (const LitScene& lit : {spheresOnAFloor(), textured(), grazing(), orthographic(), withFarPlane()})
        expectSameImages(lit.scene, lit.lights, lit.view, lit.name.c_str());
}

TEST_F(TechniqueTest, cameraOutsideInsideAndAcrossVolumes) {
    const std::vector<WorldLight> lights = mixedLights(90, 2.5f);
    expectSameImages(room(), lights, lookAt({0, 1, 30}, {0, 0, 0}, 0.5f), "outside");
    expectSameImages(room(), lights, lookAt({0, 0.5f, 2}, {0.3f, 0, -6}, 1.0f), "among the volumes");
    for (std::uint32_t i = 0; i < 6; ++i) {
        const glm::vec3 eye = lights[i].position;
        expectSameImages(room(), lights, lookAt(eye, eye + glm::vec3(0.3f, 0, -1), 1.2f), "at a centre");
        // On the rim: part of the volume lies before the eye, part behind, and the near plane cuts it.
        const glm::vec3 rim = eye + 2.5f * glm::normalize(glm::vec3(1, 0.2f, 0.5f));
        expectSameImages(room(), lights, lookAt(rim, eye, 1.2f), "on the rim, inwards");
        expectSameImages(room(), lights, lookAt(rim, 2.0f * rim - eye, 1.2f), "on the rim, outwards");
    }
}

TEST_F(TechniqueTest, farNearPlaneCutsVolumes) {
    CameraView view = front;
    for (const float nearPlane : {0.001f, 2.0f, 8.0f, 9.5f}) {
        view.nearPlane = nearPlane;
        expectSameImages(room(), mixedLights(60, 3.0f), view, "near plane");
    }
}

TEST_F(TechniqueTest, orthographicViewsAndFarPlanes) {
    for (const float height : {0.0f, 0.5f, 6.0f, 40.0f}) {
        CameraView view = lookAt({3, 2, 9}, {0, 0, 0}, 0.8f);
        if (height > 0.0f) view.orthographicHeight = height;
        for (const float nearPlane : {1.0f, 7.0f}) {
            view.nearPlane = nearPlane;
            for (const float farPlane : {1.0e6f, 12.0f, 8.0f}) {
                view.farPlane = farPlane;
                expectSameImages(room(), mixedLights(60, 3.0f), view, "far plane");
            }
        }
    }
}

TEST_F(TechniqueTest, lightsBehindTheCameraLightSurfacesInFront) {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 30; ++i) {
        const glm::vec3 position(8 * hashed(51, i) - 4, 8 * hashed(52, i) - 4, 9 + 8 * hashed(53, i));
        lights.push_back(pointLight(position, 4.0f + 20.0f * hashed(54, i), glm::vec3(10)));
    }
    expectSameImages(room(), lights, front, "behind");
    render(upload(room(), lights), {96, 54, front, BrdfModel::course, Technique::volumes});
    const auto rgba = lastFrame().radiance().rgba;
    EXPECT_GT(*std::ranges::max_element(rgba), 0.01f) << "they have to light a surface";
}

TEST_F(TechniqueTest, lightsAtTheNearPlane) {
    CameraView view = front;
    view.nearPlane = 1.0f;
    std::vector<WorldLight> lights;
    for (const float z : {7.0f, 7.9f, 8.0f, 8.1f, 9.0f, 9.5f}) {
        for (const float range : {0.1f, 0.999f, 1.0f, 1.001f, 5.0f})
            lights.push_back(pointLight({0.1f * z - 0.7f, 0.1f, z}, range, glm::vec3(1)));
    }
    expectSameImages(room(), lights, view, "at the near plane");
}

TEST_F(TechniqueTest, hugeAndTinyRanges) {
    std::vector<WorldLight> lights = mixedLights(12, 1.0e9f);
    for (std::uint32_t i = 0; i < 12; ++i) lights[i].range = i % 2 == 0 ? 1.0e12f : 3.0e6f;
    // Just before the wall at z = -6, and smaller than a pixel.
    for (std::uint32_t i = 0; i < 200; ++i) {
        const glm::vec3 position(10 * hashed(55, i) - 5, 6 * hashed(56, i) - 3, -5.999f);
        lights.push_back(pointLight(position, 0.002f + 0.05f * hashed(57, i), glm::vec3(0.01f)));
    }
    lights.push_back(pointLight({1, 1, 1}, 1.0e-12f, glm::vec3(1)));
    lights.push_back(pointLight({0, 0, -6}, 1.0e-20f, glm::vec3(1)));
    lights.push_back(pointLight({0, 0, 1.0e15f}, 3.0e38f, glm::vec3(1.0e20f)));
    lights.push_back(pointLight({3.0e30f, 0, 0}, 1.0f, glm::vec3(1.0e20f)));
    expectSameImages(room(), lights, front, "huge and tiny");
}

TEST_F(TechniqueTest, oddImageSizes) {
    const std::vector<WorldLight> lights = mixedLights(40, 3.0f);
    for (const auto& [width, height] : {std::pair{1, 1}, {17, 9}, {1, 40}, {40, 1}, {65, 33}})
        expectSameImages(room(), lights, front, "odd size", width, height);
}

TEST_F(TechniqueTest, largeOddImageSize) {
    expectSameImages(room(), mixedLights(20, 3.0f), front, "641 by 361", 641, 361);
}

TEST_F(TechniqueTest, thousandsOfOverlappingVolumes) {
    // More overlapping volumes than a stencil batch has.
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const glm::vec3 position(hashed(58, i) - 0.5f, hashed(59, i) - 0.5f, hashed(60, i) - 5.5f);
        lights.push_back(pointLight(position, 2.0f, glm::vec3(0.01f)));
    }
    expectSameImages(room(), lights, front, "3,000 at one place", 48, 27);
}

TEST_F(TechniqueTest, moreLightsThanOneLoopIterates) {
    // llvmpipe ends loops after 65,535 iterations. The radiance of 70,000 lights is the sum of both halves'.
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 70000; ++i) {
        const glm::vec3 position(10 * hashed(61, i) - 5, 6 * hashed(62, i) - 3, 10 * hashed(63, i) - 6);
        lights.push_back(pointLight(position, 0.5f, glm::vec3(0.01f)));
    }
    const Scene scene = room();
    expectSameImages(scene, lights, front, "70,000 lights", 24, 14);
    const std::span all(lights);
    const FrameRequest inputs{24, 14, front, BrdfModel::course, Technique::fullscreen};
    const HdrImage whole = drawn(upload(scene, all), inputs);
    HdrImage sum = drawn(upload(scene, all.first(35000)), inputs);
    const HdrImage second = drawn(upload(scene, all.last(35000)), inputs);
    for (std::size_t i = 0; i < sum.rgba.size(); ++i) sum.rgba[i] += i % 4 == 3 ? 0.0f : second.rgba[i];
    expectSame(whole, sum, rimError(lights), "both halves");
}

TEST_F(TechniqueTest, noLightAtAll) {
    const Scene scene = room();
    expectSameImages(scene, {}, front, "no light");
    const HdrImage picture = drawn(upload(scene), {8, 8, front, BrdfModel::course, Technique::volumes});
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) ASSERT_EQ(picture.rgba[i], 0.0f);
}

TEST_F(TechniqueTest, sceneWithoutSurfaces) {
    expectSameImages(Scene{}, mixedLights(20, 3.0f), front, "no surface");
}

TEST_F(TechniqueTest, volumesAfterAnotherTechniqueAtAnotherSize) {
    // The driver gives the textures of the third frame the names that those of the first had.
    GpuScene scene = upload(room(), mixedLights(40, 3.0f));
    FrameRequest inputs{96, 54, front, BrdfModel::course, Technique::volumes};
    const HdrImage expected = drawn(scene, inputs);
    for (const Technique other : {Technique::tiles, Technique::fullscreen}) {
        drawn(scene, {48, 27, front, BrdfModel::course, other});
        EXPECT_EQ(drawn(scene, inputs).rgba, expected.rgba) << toString(other);
    }
}

TEST_F(TechniqueTest, tileBackendsGiveTheSameImage) {
    const std::vector<WorldLight> lights = mixedLights(60, 3.0f);
    GpuScene scene = upload(room(), lights);
    FrameRequest inputs{96, 54, front, BrdfModel::course, Technique::fullscreen};
    const HdrImage reference = drawn(scene, inputs);
    inputs.technique = Technique::tiles;
    for (const TileBackend backend : {TileBackend::automatic, TileBackend::cpu, TileBackend::compute}) {
        inputs.tileBackend = backend;
        expectSame(drawn(scene, inputs), reference, rimError(lights), toString(backend));
    }
}

TEST_F(TechniqueTest, automaticTileBackendFollowsTheDevice) {
    GpuScene scene = upload(room(), mixedLights(60, 3.0f));
    FrameRequest inputs{96, 54, front, BrdfModel::course, Technique::tiles};
    const std::vector<float> automatic = drawn(scene, inputs).rgba;
    inputs.tileBackend = context().isSoftware() ? TileBackend::cpu : TileBackend::compute;
    EXPECT_EQ(drawn(scene, inputs).rgba, automatic);
}

TEST_F(TechniqueTest, automaticReportsTheTechniqueUsed) {
    render(upload(room()), {16, 9, front, BrdfModel::course, Technique::automatic});
    EXPECT_NE(lastFrame().technique(), Technique::automatic);
}

TEST(TechniqueNames, areThoseOfTheCommandLine) {
    EXPECT_STREQ(toString(Technique::automatic), "auto");
    EXPECT_STREQ(toString(Technique::volumes), "volumes");
    EXPECT_STREQ(toString(Technique::tiles), "tiles");
    EXPECT_STREQ(toString(Technique::fullscreen), "fullscreen");
    EXPECT_STREQ(toString(TileBackend::automatic), "auto");
    EXPECT_STREQ(toString(TileBackend::cpu), "cpu");
    EXPECT_STREQ(toString(TileBackend::compute), "compute");
}

/// A reference count. Where a pixel lies on the rim of a range, single precision may decide either way:
/// `atLeast` counts pairs clearly inside, `atMost` those not clearly outside.
struct ReferenceCount {
    std::uint64_t atLeast = 0, atMost = 0;
};

ReferenceCount litLights(const glm::vec3& position, std::span<const WorldLight> lights) {
    // Positions, differences, squares and the inverse square of the range: ten roundings, doubled twice.
    constexpr double rim = 4.0e-6;
    ReferenceCount count;
    for (const WorldLight& light : lights) {
        const double relative =
            light.type == LightType::directional
                ? 0.0
                : glm::distance(glm::dvec3(light.position), glm::dvec3(position)) / light.range;
        count.atLeast += relative < 1.0 - rim;
        count.atMost += relative < 1.0 + rim;
    }
    return count;
}

class CountTest : public DrawingTest {
  protected:
    static constexpr int width = 80, height = 45;

    static void expectCounts(const Scene& scene, const std::vector<WorldLight>& lights,
                             const CameraView& view) {
        GpuScene uploaded = upload(scene, lights);
        for (const Technique technique : techniques) {
            render(uploaded, {width, height, view, BrdfModel::course, technique});
            const AovReader reader = aovs(width);
            const PairCounts counts = lastFrame().countPairs();
            ReferenceCount pairs, surfaces;
            expectLightCounts(reader, lights, pairs, surfaces);
            EXPECT_GE(counts.pairsLit, pairs.atLeast);
            EXPECT_LE(counts.pairsLit, pairs.atMost);
            EXPECT_GE(counts.pairsEvaluated, counts.pairsLit) << toString(technique);
            EXPECT_LE(counts.pairsEvaluated, surfaces.atMost * lights.size());
            if (technique == Technique::fullscreen) {
                EXPECT_EQ(counts.pairsEvaluated, surfaces.atMost * lights.size());
            }
            EXPECT_EQ(counts.lightsDropped, 0u);
            expectVisible(counts.lightsVisible, lights, view);
        }
    }

  private:
    /// The AOV `light_count`, which has no directional lights, at each pixel.
    static void expectLightCounts(const AovReader& reader, const std::vector<WorldLight>& lights,
                                  ReferenceCount& pairs, ReferenceCount& surfaces) {
        const auto local = [](const WorldLight& light) { return light.type != LightType::directional; };
        std::vector<WorldLight> locals;
        std::ranges::copy_if(lights, std::back_inserter(locals), local);
        const std::uint64_t directionals = lights.size() - locals.size();
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double counted = reader.scalar("light_count", x, y);
                if (reader.vector("N", x, y) == glm::vec3(0.0f)) {
                    ASSERT_EQ(counted, 0.0);
                    continue;
                }
                const ReferenceCount here = litLights(reader.vector("P", x, y), locals);
                ASSERT_GE(counted, double(here.atLeast)) << x << ", " << y;
                ASSERT_LE(counted, double(here.atMost)) << x << ", " << y;
                ++surfaces.atMost;
                pairs.atLeast += here.atLeast + directionals;
                pairs.atMost += here.atMost + directionals;
            }
        }
    }

    /// By the planes of the projection matrix, in double precision: a light is in view unless its sphere lies
    /// wholly beyond one of them.
    static void expectVisible(std::uint64_t counted, const std::vector<WorldLight>& lights,
                              const CameraView& view) {
        const glm::dmat4 clip = glm::dmat4(projection(view, float(width) / float(height))) *
                                glm::inverse(glm::dmat4(view.worldFromCamera));
        const auto row = [&](int i) { return glm::dvec4(clip[0][i], clip[1][i], clip[2][i], clip[3][i]); };
        const std::array planes{row(3) + row(0), row(3) - row(0), row(3) + row(1), row(3) - row(1),
                                row(3) - row(2)};
        std::uint64_t atLeast = 0, atMost = 0;
        for (const WorldLight& light : lights) {
            double nearest = 1.0e30;
            for (const glm::dvec4& plane : planes) {
                const double distance =
                    glm::dot(plane, glm::dvec4(light.position, 1.0)) / glm::length(glm::dvec3(plane));
                nearest = std::min(nearest, distance + light.range);
            }
            const bool everywhere = light.type == LightType::directional;
            atLeast += everywhere || nearest > 1.0e-4;
            atMost += everywhere || nearest > -1.0e-4;
        }
        EXPECT_GE(counted, atLeast);
        EXPECT_LE(counted, atMost);
        EXPECT_LT(atLeast, lights.size()) << "some light has to be out of view";
    }
};

TEST_F(CountTest, agreeWithReferenceCountsFromOutside) {
    expectCounts(room(), mixedLights(120, 1.5f), lookAt({0, 0, 9}, {0, 0, 0}, 0.4f));
}

TEST_F(CountTest, agreeWithReferenceCountsAmongTheLights) {
    expectCounts(room(), mixedLights(150, 2.0f), lookAt({0, 0.5f, 2}, {0.3f, 0, -6}, 1.0f));
}

TEST_F(CountTest, unlitSurfacesAndBackgroundHaveNoPairs) {
    Material unlit;
    unlit.unlit = true;
    GpuScene scene = upload(
        sceneOf(makeSphere(1.0f), unlit),
        std::vector{pointLight({0, 0, 2}, 9.0f, glm::vec3(1)), directionalLight({0, 0, -1}, glm::vec3(1))});
    for (const Technique technique : techniques) {
        render(scene, {32, 32, lookAt({0, 0, 5}, {0, 0, 0}, 0.8f), BrdfModel::course, technique});
        const PairCounts counts = lastFrame().countPairs();
        EXPECT_EQ(counts.pairsLit, 0u);
        EXPECT_EQ(counts.pairsEvaluated, 0u);
        EXPECT_EQ(counts.lightsVisible, 2u);
    }
}

TEST_F(CountTest, volumesEvaluateFarLessThanEveryPair) {
    GpuScene scene = upload(room(), mixedLights(120, 1.5f));
    render(scene, {width, height, front, BrdfModel::course, Technique::fullscreen});
    const std::uint64_t all = lastFrame().countPairs().pairsEvaluated;
    render(scene, {width, height, front, BrdfModel::course, Technique::volumes});
    const PairCounts counts = lastFrame().countPairs();
    // The polyhedron around a sphere has 1.4 times its volume; depth tests cut off the rest.
    EXPECT_LT(counts.pairsEvaluated, all / 4);
    EXPECT_LT(counts.pairsEvaluated, 3 * counts.pairsLit);
}

}  // namespace
}  // namespace candela::test
