// The light of environments on surfaces, and environments behind them.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"
#include "support/skies.h"
#include "support/tile_implementations.h"

#include <candela/error.h>
#include <candela/exposure.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numbers>

namespace candela::test {
namespace {

constexpr int width = 96, height = 64;
constexpr double pi = std::numbers::pi;
const std::vector<float> roughnesses{0.0f, 0.25f, 0.4f, 0.6f, 0.8f, 1.0f};
const CameraView front = lookAt({0, 0, 9}, {0, 0, 0}, 0.7f);

Material materialOf(float roughness, float metallic, const glm::vec3& color = glm::vec3(1.0f)) {
    Material material;
    material.baseColor = glm::vec4(color, 1.0f);
    material.roughness = roughness;
    material.metallic = metallic;
    return material;
}

/// A column of spheres for each roughness, a row for each share of metal.
Scene sphereGrid(const std::vector<float>& metallics, const glm::vec3& color = glm::vec3(1.0f)) {
    Scene scene;
    for (std::size_t column = 0; column < roughnesses.size(); ++column) {
        for (std::size_t row = 0; row < metallics.size(); ++row) {
            const glm::vec3 center(
                1.5f * (static_cast<float>(column) - 2.5f),
                1.5f * (static_cast<float>(row) - 0.5f * static_cast<float>(metallics.size() - 1)), 0.0f);
            place(scene, makeSphere(0.7f, 64, 32), materialOf(roughnesses[column], metallics[row], color),
                  glm::translate(glm::mat4(1.0f), center));
        }
    }
    return scene;
}

Environment environmentOf(Image picture) {
    return {.picture = std::move(picture)};
}

/// Small errors of sums and of the table of albedos in single precision.
constexpr float rounding = 1.0e-5f;

/// A pixel's surface, from AOVs.
struct Surface {
    SurfacePoint point;
    glm::dvec3 v;
    double nDotV;

    glm::dvec3 f0() const { return glm::mix(glm::dvec3(0.04), point.lobes.baseColor, point.lobes.metallic); }
    glm::dvec3 albedo(BrdfModel model) const {
        return specularAlbedo(model, f0(), std::max(nDotV, 0.0), point.lobes.roughness);
    }
    glm::dvec3 diffuse(BrdfModel model) const {
        return (1.0 - albedo(model)) * (1.0 - point.lobes.metallic) * point.lobes.baseColor / pi;
    }
};

Surface surfaceAt(const AovReader& aovs, int x, int y, const CameraView& view) {
    Surface surface;
    surface.point.position = aovs.vector("P", x, y);
    surface.point.normal = glm::normalize(glm::dvec3(aovs.vector("N", x, y)));
    surface.point.lobes = {glm::dvec3(aovs.vector("base_color", x, y)), aovs.scalar("metallic", x, y),
                           aovs.scalar("roughness", x, y)};
    surface.v = glm::normalize(glm::dvec3(view.eye()) - surface.point.position);
    surface.nDotV = glm::dot(surface.v, surface.point.normal);
    return surface;
}

/// What the surface reflects of a sky by its specular lobe, and what light arrives.
struct Integrals {
    glm::dvec3 specular{0.0}, irradiance{0.0};
};

Integrals integrate(BrdfModel model, const Surface& surface, const std::vector<SkyTexel>& texels) {
    Integrals sum;
    const glm::dvec3 diffuse = surface.diffuse(model);
    for (const SkyTexel& texel : texels) {
        const double cosine = glm::dot(surface.point.normal, texel.direction);
        if (cosine <= 0.0) continue;
        const glm::dvec3 arriving = texel.radiance * (texel.solidAngle * cosine);
        sum.irradiance += arriving;
        sum.specular += arriving * (evaluateBrdf(model, surface.point, texel.direction, surface.v) - diffuse);
    }
    return sum;
}

/// Relative errors of a column of spheres.
struct Errors {
    double sum = 0.0, largest = 0.0;
    int count = 0;

    void add(double error) { sum += error, largest = std::max(largest, error), ++count; }
    double mean() const { return count > 0 ? sum / count : 0.0; }
};

double largestOf(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

class EnvironmentLightTest : public DrawingTest {
  protected:
    static FrameRequest request(BrdfModel model = BrdfModel::gltf, Technique technique = Technique::tiles) {
        FrameRequest request{width, height, front, model, technique};
        // The spheres of a column have one roughness, also at their silhouettes.
        request.specularAntialiasing = false;
        return request;
    }

    static AovReader environmentAovs() {
        return {lastFrame().aovs({"N", "P", "base_color", "metallic", "roughness", "environment",
                                  "environment_diffuse", "environment_specular", "Z"}),
                width};
    }

    template <typename Visit>
    static void forEachSurface(const AovReader& aovs, int step, const Visit& visit) {
        for (int y = step / 2; y < height; y += step) {
            for (int x = step / 2; x < width; x += step) {
                if (aovs.scalar("Z", x, y) > 0.0f) visit(x, y);
            }
        }
    }

    static void expectIntegrated(const NamedSky& sky, BrdfModel model) {
        Scene scene = sphereGrid({0.0f, 1.0f}, {0.9f, 0.7f, 0.4f});
        scene.environment = environmentOf(sky.picture);
        GpuScene uploaded = upload(scene);
        render(uploaded, request(model));
        const AovReader aovs = environmentAovs();
        const std::vector<SkyTexel> texels = texelsOf(sky.picture);
        std::vector<Errors> specular(roughnesses.size());
        Errors diffuse;
        double mean = 0.0;
        for (const SkyTexel& texel : texels) mean += texel.radiance.g * texel.solidAngle / (4.0 * pi);
        forEachSurface(aovs, 5, [&](int x, int y) {
            const Surface surface = surfaceAt(aovs, x, y, front);
            const auto column = static_cast<std::size_t>(
                std::ranges::min_element(
                    roughnesses, {},
                    [&](float roughness) { return std::abs(roughness - surface.point.lobes.roughness); }) -
                roughnesses.begin());
            const Integrals expected = integrate(model, surface, texels);
            const glm::dvec3 byDiffuse = surface.diffuse(model) * expected.irradiance;
            if (surface.point.lobes.metallic < 0.5)
                diffuse.add(largestOf((glm::dvec3(aovs.vector("environment_diffuse", x, y)) - byDiffuse) /
                                      byDiffuse));
            // Narrower lobes than the texels are not integrated; grazing pixels are not of the sphere's
            // model.
            if (column == 0) return;
            specular[column].add(
                largestOf(glm::dvec3(aovs.vector("environment_specular", x, y)) - expected.specular) /
                (largestOf(expected.specular) + 0.05 * mean * largestOf(surface.albedo(model))));
        });
        std::printf("%-12s %-7s diffuse %.4f |", sky.name.c_str(), toString(model), diffuse.largest);
        for (std::size_t i = 1; i < specular.size(); ++i)
            std::printf(" r %.2f: mean %.3f max %.2f |", static_cast<double>(roughnesses[i]),
                        specular[i].mean(), specular[i].largest);
        std::printf("\n");
        // The split sum of docs/environment.md, with a fifth more.
        constexpr std::array bounds{0.0, 0.20, 0.13, 0.17, 0.16, 0.10};
        for (std::size_t i = 1; i < specular.size(); ++i)
            EXPECT_LT(specular[i].mean(), bounds[i]) << sky.name << ", roughness " << roughnesses[i];
        // The texels of the sum are points, those of the maps are interpolated: environment_map_test holds 1
        // % with smaller ones.
        EXPECT_LT(diffuse.largest, 0.02) << sky.name;
    }
};

TEST_F(EnvironmentLightTest, isThatOfIntegration) {
    std::vector<NamedSky> all = skies(512);
    for (const NamedSky& sky : all) {
        for (const BrdfModel model : models) expectIntegrated(sky, model);
    }
}

TEST_F(EnvironmentLightTest, furnaceReturnsNoMoreThanItSends) {
    for (const float metallic : {0.0f, 0.5f, 1.0f}) {
        Scene scene = sphereGrid({metallic});
        scene.environment = environmentOf(makeSky(16, [](const glm::dvec3&) { return glm::vec3(1.0f); }));
        GpuScene uploaded = upload(scene);
        for (const BrdfModel model : models) {
            for (const Technique technique : {Technique::tiles, Technique::fullscreen}) {
                const HdrImage picture = drawn(uploaded, request(model, technique));
                const AovReader aovs = environmentAovs();
                float least = 2.0f, most = 0.0f;
                forEachSurface(aovs, 1, [&](int x, int y) {
                    const glm::vec3 pixel = pixelOf(picture, x, y);
                    least = std::min({least, pixel.r, pixel.g, pixel.b});
                    most = std::max({most, pixel.r, pixel.g, pixel.b});
                });
                std::printf("furnace: metallic %.1f %s %s: %.5f to %.6f\n", static_cast<double>(metallic),
                            toString(model), toString(technique), static_cast<double>(least),
                            static_cast<double>(most));
                EXPECT_LE(most, 1.0f + rounding);
                if (metallic == 0.0f || (model == BrdfModel::gltf && metallic == 1.0f)) {
                    EXPECT_GE(least, 0.99f - rounding);
                }
            }
        }
    }
}

/// The largest difference, of a pixel over the mean.
double difference(const std::vector<float>& a, const std::vector<float>& b) {
    double mean = 0.0, worst = 0.0;
    for (const float value : b) mean += static_cast<double>(value) / static_cast<double>(b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])) /
                                    (mean + static_cast<double>(b[i])));
    return worst;
}

TEST_F(EnvironmentLightTest, lobesReturnNoMoreThanAWhiteSkySends) {
    LitScene lit = manyLobes();
    for (Material& material : lit.scene.materials) material.baseColor = glm::vec4(1.0f);
    lit.scene.environment = environmentOf(makeSky(16, [](const glm::dvec3&) { return glm::vec3(1.0f); }));
    GpuScene uploaded = upload(lit.scene);
    for (const BrdfModel model : models) {
        FrameRequest frame = request(model, Technique::fullscreen);
        frame.view = lit.view;
        const HdrImage reference = drawn(uploaded, frame);
        EXPECT_LE(*std::ranges::max_element(reference.rgba), 1.0f + rounding);
        for (const Form& form : forms) {
            frame.technique = form.technique;
            frame.tileBackend = form.backend;
            EXPECT_LT(difference(drawn(uploaded, frame).rgba, reference.rgba), 4.0e-4) << form.name;
        }
    }
}

/// A sky that is black but for a spot.
Image spotSky(const glm::dvec3& towards) {
    return makeSky(512, [&](const glm::dvec3& d) {
        return glm::vec3(glm::dot(d, glm::normalize(towards)) > std::cos(0.04) ? 100.0f : 0.0f);
    });
}

glm::ivec2 brightestPixel(const HdrImage& picture) {
    std::size_t brightest = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        if (picture.rgba[i] > picture.rgba[brightest]) brightest = i;
    const int index = static_cast<int>(brightest / 4);
    return {index % picture.width, index / picture.width};
}

TEST_F(EnvironmentLightTest, isReflectedWhereTheMirrorDirectionSays) {
    const glm::quat rotation = rotationAboutUp(70.0);
    for (const glm::dvec3 towards :
         {glm::dvec3(1.0, 0.3, 0.2), glm::dvec3(-0.4, 0.8, 1.0), glm::dvec3(0.3, -0.7, 0.5)}) {
        Scene scene = sceneOf(makeSphere(2.0f, 128, 64), materialOf(0.0f, 1.0f));
        // In the world, the spot lies towards `towards`.
        scene.environment = environmentOf(spotSky(glm::inverse(glm::dquat(rotation)) * towards));
        scene.environment->rotation = rotation;
        scene.environment->isBackground = false;
        GpuScene uploaded = upload(scene);
        for (const Technique technique : techniques) {
            const glm::ivec2 at = brightestPixel(drawn(uploaded, request(BrdfModel::gltf, technique)));
            const AovReader aovs = environmentAovs();
            const Surface surface = surfaceAt(aovs, at.x, at.y, front);
            const glm::dvec3 mirrored = 2.0 * surface.nDotV * surface.point.normal - surface.v;
            // The spot, and the pixel's share of the sphere.
            EXPECT_GT(glm::dot(mirrored, glm::normalize(towards)), std::cos(0.12)) << toString(technique);
        }
    }
}

TEST_F(EnvironmentLightTest, backgroundIsSeenWhereTheCameraLooks) {
    const glm::quat rotation = rotationAboutUp(-130.0);
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.15, -0.1, -1.0));
    Scene scene;
    scene.environment = environmentOf(spotSky(glm::inverse(glm::dquat(rotation)) * towards));
    scene.environment->rotation = rotation;
    GpuScene uploaded = upload(scene);
    for (const Technique technique : techniques) {
        const HdrImage picture = drawn(uploaded, request(BrdfModel::gltf, technique));
        glm::dvec2 sum(0.0);
        double weight = 0.0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double value = pixelOf(picture, x, y).g;
                sum += glm::dvec2(x + 0.5, y + 0.5) * value;
                weight += value;
            }
        }
        const double perMetre = height / (2.0 * std::tan(0.35));
        const glm::dvec2 expected(0.5 * width + towards.x / -towards.z * perMetre,
                                  0.5 * height - towards.y / -towards.z * perMetre);
        EXPECT_LT(glm::distance(sum / weight, expected), 0.5) << toString(technique);
        for (std::size_t i = 3; i < picture.rgba.size(); i += 4) ASSERT_EQ(picture.rgba[i], 0.0f);
        EXPECT_EQ(countExposure(picture, glm::vec3(1.0f / 3.0f), 0.0).surfaces, 0u);
    }
    scene.environment->isBackground = false;
    const HdrImage hidden = drawn(upload(scene), request());
    EXPECT_EQ(*std::ranges::max_element(hidden.rgba), 0.0f);
}

/// Scene and lights of all kinds under a checkered sky with a sun.
Scene litScene() {
    Scene scene = sphereGrid({0.0f, 1.0f}, {0.8f, 0.6f, 0.5f});
    scene.environment = environmentOf(skies(256)[2].picture);
    scene.environment->rotation = rotationAboutUp(25.0);
    scene.environment->intensity = 0.7f;
    return scene;
}

const std::vector<WorldLight> lights{pointLight({0, 2, 3}, 6.0f, {4, 3, 2}),
                                     directionalLight({0.2f, -0.5f, -1}, {0.3f, 0.3f, 0.2f})};

TEST_F(EnvironmentLightTest, allTechniquesAndKernelsAgree) {
    const Scene scene = litScene();
    for (const BrdfModel model : models) {
        // With one model without lights, with the other one under lights.
        const auto shown =
            model == BrdfModel::gltf ? std::span<const WorldLight>(lights) : std::span<const WorldLight>();
        const TileTestFrame frame{scene, shown, front, width, height, model};
        const std::vector<float> reference = radianceOf(context(), fullscreenImplementation(), frame);
        for (const TileImplementation& implementation : tileImplementations())
            EXPECT_LT(difference(radianceOf(context(), implementation, frame), reference), 1.0e-4)
                << implementation.name;
        GpuScene uploaded = upload(scene, shown);
        const HdrImage picture = drawn(uploaded, request(model, Technique::fullscreen));
        for (const Technique technique : techniques)
            EXPECT_LT(difference(drawn(uploaded, request(model, technique)).rgba, picture.rgba), 1.0e-4)
                << toString(technique);
    }
}

TEST_F(EnvironmentLightTest, lobesAgreeToo) {
    LitScene lit = manyLobes();
    lit.scene.environment = litScene().environment;
    const TileTestFrame frame{lit.scene, lights, lit.view, width, height, BrdfModel::gltf};
    const std::vector<float> reference = radianceOf(context(), fullscreenImplementation(), frame);
    for (const TileImplementation& implementation : tileImplementations())
        EXPECT_LT(difference(radianceOf(context(), implementation, frame), reference), 4.0e-4)
            << implementation.name;
}

TEST_F(EnvironmentLightTest, visibilityDims) {
    const Scene scene = litScene();
    std::vector<std::uint8_t> visibility(std::size_t{width} * height, 255);
    TileTestFrame frame{scene, {}, front, width, height, BrdfModel::gltf};
    const std::vector<float> open = radianceOf(context(), fullscreenImplementation(), frame);
    frame.environmentVisibility = visibility.data();
    EXPECT_LT(difference(radianceOf(context(), fullscreenImplementation(), frame), open), 1.0e-6);
    for (std::size_t i = 0; i < visibility.size(); ++i) visibility[i] = static_cast<std::uint8_t>(i % 256);
    const std::vector<float> reference = radianceOf(context(), fullscreenImplementation(), frame);
    for (const TileImplementation& implementation : tileImplementations())
        EXPECT_LT(difference(radianceOf(context(), implementation, frame), reference), 1.0e-4)
            << implementation.name;
    for (std::size_t i = 0; i < reference.size(); i += 4) {
        EXPECT_LE(reference[i], open[i] * (1.0f + rounding));
        EXPECT_TRUE(visibility[i / 4] > 0 || reference[i] == 0.0f);
    }
}

TEST_F(EnvironmentLightTest, aovsAddUpToThePicture) {
    GpuScene uploaded = upload(litScene());
    const HdrImage picture = drawn(uploaded, request());
    const AovReader aovs = environmentAovs();
    forEachSurface(aovs, 1, [&](int x, int y) {
        const glm::vec3 whole = aovs.vector("environment", x, y);
        const glm::vec3 parts =
            aovs.vector("environment_diffuse", x, y) + aovs.vector("environment_specular", x, y);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(parts[i], whole[i], 1.0e-5f * (1.0f + whole[i]));
            EXPECT_NEAR(pixelOf(picture, x, y)[i], whole[i], 1.0e-4f * (1.0f + whole[i]));
        }
    });
}

TEST_F(EnvironmentLightTest, settingsAreThoseOfANewEnvironment) {
    Scene scene = litScene();
    GpuScene changed = upload(scene);
    const EnvironmentSettings settings{rotationAboutUp(200.0), 2.5f, false};
    changed.setEnvironmentSettings(settings);
    const HdrImage picture = drawn(changed, request());
    scene.environment->rotation = settings.rotation;
    scene.environment->intensity = settings.intensity;
    scene.environment->isBackground = settings.isBackground;
    EXPECT_EQ(picture.rgba, drawn(upload(scene), request()).rgba);
    changed.setEnvironment(std::nullopt);
    scene.environment.reset();
    EXPECT_EQ(drawn(changed, request()).rgba, drawn(upload(scene), request()).rgba);
}

TEST_F(EnvironmentLightTest, refusesWhatEnvironmentsDoNotState) {
    GpuScene with = upload(litScene()), without = upload(sphereGrid({0.0f}));
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(without.setEnvironmentSettings({}), Error);
    for (const float intensity : {-1.0f, nan, 1.0e20f})
        EXPECT_THROW(with.setEnvironmentSettings({.intensity = intensity}), Error);
    EXPECT_THROW(with.setEnvironmentSettings({.rotation = {2.0f, 0.0f, 0.0f, 0.0f}}), Error);
    EXPECT_THROW(with.setEnvironmentSettings({.occlusionDistance = 0.0f}), Error);
    EXPECT_THROW(with.setEnvironment(Environment{}), Error);
    const HdrImage picture = drawn(with, request());
    EXPECT_EQ(picture.rgba, drawn(upload(litScene()), request()).rgba) << "nothing changes with an error";
}

}  // namespace
}  // namespace candela::test
