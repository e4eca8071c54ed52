// Pixels against the double-precision evaluator of candela/brdf.h, fed with the AOVs of the same frame.

#include "support/drawing_test.h"
#include "support/evaluated_image.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include <algorithm>
#include <cstdio>

namespace candela::test {
namespace {

constexpr int width = 96, height = 54;

/// The largest errors of a comparison.
struct Worst {
    double ofTolerance = 0.0;  ///< Error over the pixel's tolerance.
    double relative = 0.0;  ///< Error relative to the pixel; of pixels brighter than a millionth of the mean.
    int x = 0, y = 0, litPixels = 0;
};

Worst compare(const HdrImage& picture, const std::vector<ExpectedPixel>& expected) {
    Worst worst;
    double mean = 0.0;
    for (const ExpectedPixel& pixel : expected) mean += pixel.radiance.g / double(expected.size());
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const ExpectedPixel& pixel =
                expected[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
            const glm::dvec3 actual(pixelOf(picture, x, y));
            worst.litPixels += actual.g > 0.0;
            for (int c = 0; c < 3; ++c) {
                const double error = std::abs(actual[c] - pixel.radiance[c]);
                // The smallest normal number of single precision, times a million: below it, floats lose
                // digits.
                const double ratio = error / (pixel.tolerance[c] + 1.0e-32);
                if (pixel.radiance[c] > 1.0e-6 * mean)
                    worst.relative = std::max(worst.relative, error / pixel.radiance[c]);
                if (ratio <= worst.ofTolerance) continue;
                worst.ofTolerance = ratio;
                worst.x = x;
                worst.y = y;
            }
        }
    }
    return worst;
}

class EvaluatorTest : public DrawingTest {
  protected:
    static void expectEvaluatedPixels(const LitScene& lit, BrdfModel model) {
        GpuScene scene = upload(lit.scene, lit.lights);
        FrameRequest inputs{width, height, lit.view, model, Technique::fullscreen};
        render(scene, inputs);
        const std::vector<ExpectedPixel> expected = evaluatedImage(
            model, aovs(width), width, height, lit.view, withRanges(lit.lights, scene.lightReport()));
        for (const Technique technique : techniques) {
            inputs.technique = technique;
            const Worst worst = compare(drawn(scene, inputs), expected);
            std::printf("%-18s %-7s %-11s largest relative error %.1e, at most %.2f of the tolerance\n",
                        lit.name.c_str(), toString(model), toString(technique), worst.relative,
                        worst.ofTolerance);
            EXPECT_LE(worst.ofTolerance, 1.0)
                << lit.name << ", " << toString(model) << ", " << toString(technique) << ", pixel " << worst.x
                << ", " << worst.y;
            EXPECT_GT(worst.litPixels, width * height / 3) << "the scene has to be lit";
        }
    }
};

TEST_F(EvaluatorTest, everyPixelOfEverySceneAgrees) {
    for (const LitScene& lit : litScenes()) {
        for (const BrdfModel model : models) expectEvaluatedPixels(lit, model);
    }
}

TEST_F(EvaluatorTest, everyPixelWithMoreLobesAgrees) {
    const LitScene lit = manyLobes();
    GpuScene scene = upload(lit.scene, lit.lights);
    const LobePixels lobes(context(), scene, lit.view, width, height);
    EXPECT_GT(lobes.count(), width * height / 6);
    for (const BrdfModel model : models) {
        FrameRequest request{width, height, lit.view, model, Technique::fullscreen};
        request.specularAntialiasing = false;
        render(scene, request);
        const auto expected = evaluatedImage(model, aovs(width), width, height, lit.view,
                                             withRanges(lit.lights, scene.lightReport()), &lobes);
        for (const Form& form : forms) {
            request.technique = form.technique;
            request.tileBackend = form.backend;
            const Worst worst = compare(drawn(scene, request), expected);
            std::printf("%s, %s, %s: largest relative error %.1e, at most %.2f of the tolerance\n",
                        lit.name.c_str(), toString(model), form.name, worst.relative, worst.ofTolerance);
            EXPECT_LE(worst.ofTolerance, 1.0)
                << toString(model) << ", " << form.name << ", pixel " << worst.x << ", " << worst.y;
        }
    }
}

TEST_F(EvaluatorTest, comparisonDetectsALightThatIsOnePerMilleTooBright) {
    LitScene lit = spheresOnAFloor();
    GpuScene scene = upload(lit.scene, lit.lights);
    render(scene, {width, height, lit.view, BrdfModel::course, Technique::fullscreen});
    for (WorldLight& light : lit.lights) light.intensity *= 1.001f;
    const auto expected = evaluatedImage(BrdfModel::course, aovs(width), width, height, lit.view, lit.lights);
    EXPECT_GT(compare(lastFrame().radiance(), expected).ofTolerance, 1.0);
}

/// Draws with every technique and model, and expects finite, non-negative pixels.
class FinitePixelsTest : public DrawingTest {
  protected:
    static void expectFinite(const Scene& scene, std::span<const WorldLight> lights, const CameraView& view) {
        GpuScene uploaded = upload(scene, lights);
        for (const BrdfModel model : models) {
            for (const Technique technique : techniques) {
                const HdrImage picture = drawn(uploaded, {33, 33, view, model, technique});
                EXPECT_TRUE(allFinite(picture)) << toString(model) << ", " << toString(technique);
                EXPECT_GE(*std::ranges::min_element(picture.rgba), 0.0f);
            }
        }
    }
};

const std::vector<float> roughnesses{0.0f, 0.02f, 0.5f, 1.0f};

Material materialOf(float roughness, float metallic) {
    Material material;
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

TEST_F(FinitePixelsTest, lightExactlyOnTheSurface) {
    const CameraView view = lookAt({0, 0, 2}, {0, 0, 0}, 0.8f);
    for (const float roughness : roughnesses) {
        const Scene scene = sceneOf(makeQuad(1.0f), materialOf(roughness, 0.5f));
        // The picture's middle pixel looks at the origin; the other lights are at and behind the plane.
        expectFinite(scene,
                     std::vector{pointLight({0, 0, 0}, 1.0f, glm::vec3(5)),
                                 pointLight({0.3f, 0.1f, 0}, 2.0f, glm::vec3(1)),
                                 pointLight({0, 0, -1e-7f}, 0.0f, glm::vec3(1)),
                                 spotLight({0, 0, 0}, {0, 0, -1}, 1.0f, glm::vec3(5), 0.0f, 0.3f)},
                     view);
    }
}

TEST_F(FinitePixelsTest, hugeIntensity) {
    const CameraView view = lookAt({0, 0, 2}, {0, 0, 0}, 0.8f);
    for (const float roughness : roughnesses) {
        const Scene scene = sceneOf(makeQuad(1.0f), materialOf(roughness, 1.0f));
        expectFinite(scene,
                     std::vector{pointLight({0, 0, 1e-4f}, 0.0f, glm::vec3(1e20f)),
                                 pointLight({0, 0, 2}, 0.0f, glm::vec3(1e20f)),
                                 spotLight({0.2f, 0, 0.1f}, {0, 0, 0}, 0.0f, glm::vec3(1e20f), 0.0f, 0.5f),
                                 directionalLight({0, 0, -1}, glm::vec3(1e20f))},
                     view);
    }
}

TEST_F(FinitePixelsTest, grazingEyeAndLight) {
    for (const float roughness : roughnesses) {
        const Scene scene = sceneOf(makeQuad(10.0f), materialOf(roughness, 0.5f));
        expectFinite(scene,
                     std::vector{pointLight({0, 5, 1e-7f}, 20.0f, glm::vec3(5)),
                                 pointLight({0, 3, 1e-3f}, 20.0f, glm::vec3(5)),
                                 directionalLight({0, -1, -1e-6f}, glm::vec3(5)),
                                 directionalLight({0, -1, 0}, glm::vec3(5))},
                     lookAt({0, -9, 1e-3f}, {0, 9, 0}, 0.3f));
    }
}

TEST_F(FinitePixelsTest, lightOppositeToTheEye) {
    // The normal map rotates the normal until the light behind the surface, seen straight through it, is
    // above its horizon: there l = -v, which has no half vector.
    Scene scene;
    scene.images = {
        makeImage(1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(255, 128, 90, 255); })};
    for (const float roughness : roughnesses) {
        Material material = materialOf(roughness, 0.5f);
        material.normalTexture = Texture{};
        scene.meshes.clear();
        scene.nodes.clear();
        scene.materials.clear();
        place(scene, makeQuad(1.0f), material);
        expectFinite(scene,
                     std::vector{pointLight({0, 0, -2}, 9.0f, glm::vec3(5)),
                                 pointLight({0, 0, -1e-6f}, 9.0f, glm::vec3(5)),
                                 directionalLight({0, 0, 1}, glm::vec3(5))},
                     lookAt({0, 0, 2}, {0, 0, 0}, 0.8f));
    }
}

TEST_F(FinitePixelsTest, sceneFarFromTheOrigin) {
    // 1e6 m away single precision knows positions to 6 cm: the image is imprecise, but finite.
    const glm::vec3 away(1.0e6f, 0.0f, -1.0e6f);
    glm::mat4 there(1.0f);
    there[3] = glm::vec4(away, 1.0f);
    expectFinite(sceneOf(makeQuad(1.0f), materialOf(0.0f, 0.5f), there),
                 std::vector{pointLight(away + glm::vec3(0, 0, 1), 3.0f, glm::vec3(5))},
                 lookAt(away + glm::vec3(0, 0, 2), away, 0.8f));
}

}  // namespace
}  // namespace candela::test
