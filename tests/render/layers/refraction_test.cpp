// Surfaces that transmit, against rays that the test traces through the same model: one interface, and a
// volume of the thickness behind it.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"
#include "support/skies.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace candela::test {
namespace {

constexpr int width = 96, height = 64;
constexpr double halfHeight = 0.4;  // of the picture, one metre deep

/// Along -Z from the origin.
CameraView ahead() {
    return lookAt({0, 0, 0}, {0, 0, -1}, 2.0f * float(std::atan(halfHeight)));
}

glm::mat4 at(const glm::vec3& position) {
    return glm::translate(glm::mat4(1.0f), position);
}

/// The pixel of a position, not rounded; y from the top.
glm::dvec2 pixelOf(const glm::dvec3& position) {
    const glm::dvec2 place = glm::dvec2(position) / -position.z / halfHeight;
    return {0.5 * (width + place.x * height), 0.5 * height * (1.0 - place.y)};
}

/// Through the middle of a pixel.
glm::dvec3 rayThrough(int x, int y) {
    return glm::normalize(glm::dvec3((2.0 * (x + 0.5) - width) / height * halfHeight,
                                     (1.0 - 2.0 * (y + 0.5) / height) * halfHeight, -1.0));
}

constexpr double backdropZ = -8.0;

/// The colour of the backdrop at a place on it, or of the pixel that shows the place.
glm::dvec3 backdropAt(const glm::dvec2& place) {
    return {0.5 + 0.05 * place.x, 0.5 + 0.08 * place.y, 0.4 - 0.03 * place.x + 0.03 * place.y};
}
glm::dvec3 backdropOfPixel(const glm::dvec2& pixel) {
    return backdropAt(glm::dvec2(2.0 * pixel.x - width, height - 2.0 * pixel.y) / double(height) *
                      halfHeight * -backdropZ);
}

/// An unlit square that fills the picture, of a colour that is linear in x and y.
Scene backdrop() {
    Mesh mesh = makeQuad(5.5f);
    for (const glm::vec3& position : mesh.positions)
        mesh.colors.emplace_back(glm::vec3(backdropAt(glm::dvec2(position))), 1.0f);
    Material material;
    material.unlit = true;
    return sceneOf(mesh, material, at({0, 0, float(backdropZ)}));
}

Material glass(float ior = 1.5f) {
    Material material;
    material.roughness = 0.0f;
    material.ior = ior;
    material.transmission.factor = 1.0f;
    return material;
}

/// What `material` shows of the backdrop at a point whose normal faces the eye; `path` is metres in its
/// volume.
glm::dvec3 throughSurface(const Material& material, const glm::dvec3& point, const glm::dvec3& normal,
                          double path) {
    const glm::dvec3 toEye = glm::normalize(-point);
    const auto placeOf = [&](double ior) {
        return pixelOf(point + path * glm::refract(-toEye, normal, 1.0 / ior));
    };
    const double ior = double(material.ior),
                 spread = (ior - 1.0) * 0.025 * double(material.volume.dispersion);
    const double root = (ior - 1.0) / (ior + 1.0);
    const glm::dvec3 reflected =
        specularAlbedo(BrdfModel::course, glm::dvec3(root * root), glm::dot(normal, toEye), 0.0);
    glm::dvec3 result =
        (1.0 - reflected) * glm::dvec3(material.baseColor) * double(material.transmission.factor);
    for (int c = 0; c < 3; ++c) {
        result[c] *= backdropOfPixel(placeOf(ior + (c - 1) * spread))[c];
        if (!std::isinf(material.volume.attenuationDistance))
            result[c] *= std::pow(double(material.volume.attenuationColor[c]),
                                  path / double(material.volume.attenuationDistance));
    }
    return result;
}

class RefractionTest : public DrawingTest {
  protected:
    static FrameRequest request(const Form& form = cpuTiles) {
        FrameRequest request{width, height, ahead(), BrdfModel::course, form.technique};
        request.tileBackend = form.backend;
        // The reflectance of a curved surface is that of its roughness.
        request.specularAntialiasing = false;
        return request;
    }
    static HdrImage pictureOf(const Scene& scene, const Form& form = cpuTiles) {
        return drawn(upload(scene), request(form));
    }
    static glm::dvec3 colorAt(const HdrImage& picture, int x, int y) {
        return glm::dvec3(test::pixelOf(picture, x, y));
    }
    static void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance,
                           const std::string& what) {
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(actual[c], expected[c], tolerance) << what << ", channel " << c;
    }
};

/// Roots of the transmittance have 10 bits, base colours in sRGB and the reflectance at normal incidence 8:
/// together 0.4 % of colours up to 1.
constexpr double codes = 0.004;

TEST_F(RefractionTest, AThinWallTintsWhatIsBehindIt) {
    Material material = glass();
    material.baseColor = {0.9f, 0.5f, 0.2f, 1.0f};
    for (const float factor : {1.0f, 0.4f}) {
        material.transmission.factor = factor;
        Scene scene = backdrop();
        place(scene, makeQuad(6.0f), material, at({0, 0, -5}));
        for (const Form& form : forms) {
            const HdrImage picture = pictureOf(scene, form);
            EXPECT_EQ(picture.rgba[3], 1.0f);
            for (int y = 3; y < height; y += 9) {
                for (int x = 2; x < width; x += 9) {
                    const glm::dvec3 ray = rayThrough(x, y), point = ray * (-5.0 / ray.z);
                    expectNear(colorAt(picture, x, y), throughSurface(material, point, {0, 0, 1}, 0.0), codes,
                               form.name);
                }
            }
        }
    }
}

TEST_F(RefractionTest, ASlabShiftsAbsorbsAndDisperses) {
    Material material = glass(1.8f);
    material.volume = {.thickness = 0.5f,
                       .attenuationDistance = 0.8f,
                       .attenuationColor = {0.9f, 0.6f, 0.3f},
                       .dispersion = 4.0f,
                       .thicknessTexture = {}};
    // The mesh is a quarter of its size in the scene, and so is its thickness.
    const glm::mat4 turned = glm::scale(glm::rotate(at({0, 0, -4}), 0.6f, {0, 1, 0}), glm::vec3(4.0f));
    Scene scene = backdrop();
    place(scene, makeQuad(1.5f), material, turned);
    const HdrImage picture = pictureOf(scene);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(turned[2]));
    for (int y = 3; y < height; y += 4) {
        for (int x = 10; x < width - 10; x += 4) {
            const glm::dvec3 ray = rayThrough(x, y);
            const glm::dvec3 point = ray * (glm::dot(glm::dvec3(0, 0, -4), normal) / glm::dot(ray, normal));
            // The spread has 8 bits: 0.1 % of an offset of some 20 pixels, which change colours by 0.005
            // each.
            expectNear(colorAt(picture, x, y), throughSurface(material, point, normal, 2.0), 1.5 * codes,
                       "pixel " + std::to_string(x) + ", " + std::to_string(y));
        }
    }
}

TEST_F(RefractionTest, ASphereShowsWhatItsRaysMeet) {
    Material material = glass();
    material.volume = {.thickness = 1.2f,
                       .attenuationDistance = 2.0f,
                       .attenuationColor = {0.5f, 0.8f, 0.9f},
                       .thicknessTexture = {}};
    Scene scene = backdrop();
    place(scene, makeSphere(1.0f, 256, 128), material, at({0.3f, -0.1f, -4}));
    const glm::dvec3 center(0.3f, -0.1f, -4);
    for (const Form& form : forms) {
        const HdrImage picture = pictureOf(scene, form);
        int count = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const glm::dvec3 ray = rayThrough(x, y);
                const double along = glm::dot(ray, center),
                             reach = along * along - glm::dot(center, center) + 1.0;
                if (reach < 0.0) continue;
                const glm::dvec3 point = ray * (along - std::sqrt(reach)), normal = point - center;
                // Towards the silhouette a pixel holds many directions.
                if (glm::dot(normal, -ray) < 0.25) continue;
                ++count;
                // Facets of 1.4 degrees lie up to 0.0003 m inside of the sphere.
                expectNear(
                    colorAt(picture, x, y), throughSurface(material, point, normal, 1.2), 1.5 * codes,
                    std::string(form.name) + ", pixel " + std::to_string(x) + ", " + std::to_string(y));
            }
        }
        EXPECT_GT(count, 900);
    }
}

TEST_F(RefractionTest, RoughGlassBlursAndKeepsTheLight) {
    Scene scene;
    for (const float x : {-6.0f, 6.0f}) {
        Material material;
        material.unlit = true;
        material.baseColor = glm::vec4(glm::vec3(x < 0.0f ? 0.2f : 0.8f), 1.0f);
        place(scene, makeQuad(6.0f), material, at({x, 0, float(backdropZ)}));
    }
    Material material = glass();
    place(scene, makeQuad(6.0f), material, at({0, 0, -5}));
    const auto material2 = static_cast<std::uint32_t>(scene.materials.size() - 1);
    GpuScene uploaded = upload(scene);
    double steepest = 1.0;
    for (const float roughness : {0.0f, 0.3f, 0.5f, 0.7f}) {
        material.roughness = roughness;
        uploaded.setMaterial(material2, material);
        const HdrImage picture = drawn(uploaded, request());
        double sum = 0.0, step = 0.0;
        for (int x = 0; x < width; ++x) {
            const double value = test::pixelOf(picture, x, height / 2).g;
            sum += value / width;
            if (x > 0) {
                const double before = test::pixelOf(picture, x - 1, height / 2).g;
                EXPECT_GE(value, before - 1.0e-3) << "roughness " << roughness << ", column " << x;
                step = std::max(step, value - before);
            }
        }
        const double nDotV = -rayThrough(width / 2, height / 2).z;
        const double reflected =
            specularAlbedo(BrdfModel::course, glm::dvec3(0.04), nDotV, double(roughness)).g;
        EXPECT_NEAR(sum, 0.5 * (1.0 - reflected), 0.01) << roughness;
        EXPECT_LT(step, roughness == 0.0f ? 0.6 : 0.6 * steepest) << roughness;
        steepest = step;
    }
}

TEST_F(RefractionTest, LayersAreSeenThroughEachOther) {
    Material pane;
    pane.unlit = true;
    pane.alphaMode = AlphaMode::blend;
    pane.baseColor = {1.0f, 0.0f, 0.0f, 0.25f};
    Material tinted = glass();
    tinted.baseColor = {0.5f, 0.8f, 1.0f, 1.0f};
    Scene scene = backdrop();
    place(scene, makeQuad(6.0f), tinted, at({0, 0, -3}));
    place(scene, makeQuad(6.0f), pane, at({0, 0, -4}));
    place(scene, makeQuad(6.0f), tinted, at({0, 0, -5}));
    GpuScene uploaded = upload(scene);
    const Frame& frame = render(uploaded, request());
    EXPECT_EQ(frame.layerCounts().layers, 3u);
    const HdrImage picture = frame.radiance();
    const glm::dvec3 ray = rayThrough(40, 30), tint(0.5, 0.8, 1.0);
    const double kept = 1.0 - specularAlbedo(BrdfModel::course, glm::dvec3(0.04), -ray.z, 0.0).g;
    const glm::dvec3 far = kept * tint * backdropOfPixel({40.5, 30.5});
    expectNear(colorAt(picture, 40, 30), kept * tint * (0.75 * far + 0.25 * glm::dvec3(1, 0, 0)), 2.0 * codes,
               "stack");
    // A transmitting surface counts as one of alpha 1.
    EXPECT_NEAR(AovReader(frame.aovs({"Z"}), width).scalar("Z", 40, 30), 3.0f, 1.0e-5f);
    EXPECT_EQ(frame.probe(40, 30)->node, 1u);
}

TEST_F(RefractionTest, WhatIsInFrontOfAVolumeIsNotSeenInIt) {
    Scene scene = backdrop();
    Material red;
    red.unlit = true;
    red.baseColor = {1, 0, 0, 1};
    place(scene, makeQuad(0.3f), red, at({0, 0, -2}));
    Material material = glass();
    material.volume.thickness = 2.0f;
    place(scene, makeQuad(6.0f), material, glm::rotate(at({0, 0, -4}), 0.7f, {0, 1, 0}));
    const HdrImage picture = pictureOf(scene);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::dvec3 hit = rayThrough(x, y) * (-2.0 / rayThrough(x, y).z);
            // Between pixels, half of one.
            if (std::max(std::abs(hit.x), std::abs(hit.y)) < 0.33) continue;
            EXPECT_GT(colorAt(picture, x, y).b, 0.1) << x << ", " << y;
        }
    }
}

TEST_F(RefractionTest, ADoubleSidedVolumeShowsItsBack) {
    Material material = glass();
    material.volume.thickness = 1.0f;
    Scene scene = sceneOf(makeSphere(1.0f), material, at({0, 0, -4}));
    GpuScene uploaded = upload(scene);
    EXPECT_EQ(render(uploaded, request()).layerCounts().layers, 1u);
    material.doubleSided = true;
    uploaded.setMaterial(0, material);
    EXPECT_EQ(render(uploaded, request()).layerCounts().layers, 2u);
}

TEST_F(RefractionTest, LightPassesThroughGlass) {
    if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    Material floor;
    Scene scene = sceneOf(makeQuad(8.0f), floor, at({0, 0, -8}));
    Material material = glass();
    material.baseColor = {0.9f, 0.6f, 0.3f, 1.0f};
    material.transmission.factor = 0.5f;
    material.doubleSided = true;
    // Between the light and the middle of the floor, beside what the camera sees.
    place(scene, makeQuad(3.0f), material,
          glm::rotate(at({12, 0, -6.8f}), 0.5f * std::numbers::pi_v<float>, {0, 1, 0}));
    GpuScene uploaded =
        upload(scene, std::vector{directionalLight(glm::normalize(glm::vec3(-10, 0, -1)), glm::vec3(3.0f))});
    const auto glassIndex = static_cast<std::uint32_t>(scene.materials.size() - 1);
    const auto expectShare = [&](const Form& form, float share, const std::string& what) {
        FrameRequest lit = request(form);
        const float without = test::pixelOf(drawn(uploaded, lit), 48, 32).g;
        lit.shadows = Shadows::on;
        EXPECT_NEAR(test::pixelOf(drawn(uploaded, lit), 48, 32).g / without, share, 1.0e-5f)
            << form.name << ", " << what;
    };
    for (const Form& form : forms) {
        uploaded.setMaterial(glassIndex, material);
        expectShare(form, 0.5f * 0.6f, "glass");
        Material masked = material;
        masked.alphaMode = AlphaMode::mask;
        uploaded.setMaterial(glassIndex, masked);
        expectShare(form, 0.5f * 0.6f, "where a mask covers");
        masked.baseColor.a = 0.4f;
        uploaded.setMaterial(glassIndex, masked);
        expectShare(form, 1.0f, "where a mask does not cover");
    }
}

// What lights the scene and is not shown behind it is seen through glass, whose alpha is its coverage.
TEST_F(RefractionTest, GlassOverNothingShowsTheEnvironmentThatLightsIt) {
    Material pane;
    pane.unlit = true;
    pane.alphaMode = AlphaMode::blend;
    pane.baseColor = {0.8f, 0.1f, 0.2f, 0.25f};
    Material material = glass();
    material.volume.thickness = 0.3f;
    Scene scene = sceneOf(makeSphere(1.0f), material, at({-0.5f, 0.2f, -4}));
    material.roughness = 0.3f;
    place(scene, makeQuad(1.0f), material, at({0.8f, -0.2f, -5}));
    material.roughness = 0.0f;
    material.baseColor.a = 0.5f;
    material.alphaMode = AlphaMode::blend;
    place(scene, makeQuad(0.5f), material, at({0.9f, 0.9f, -3}));
    place(scene, makeQuad(2.0f), pane, at({0.3f, 0, -7}));
    Environment environment;
    environment.picture =
        makeSky(64, [](const glm::dvec3& d) { return glm::vec3(0.3 + 0.2 * d.x, 0.4, 0.5 + 0.3 * d.y); });
    environment.isBackground = true;
    scene.environment = environment;
    GpuScene shown = upload(scene);
    scene.environment->isBackground = false;
    GpuScene hidden = upload(scene);
    for (const Form& form : forms) {
        const HdrImage behind = drawn(shown, request(form)), over = drawn(hidden, request(form));
        int covered = 0, empty = 0;
        for (std::size_t i = 0; i < over.rgba.size(); i += 4) {
            EXPECT_EQ(over.rgba[i + 3], behind.rgba[i + 3]) << "alpha is coverage in both";
            if (over.rgba[i + 3] == 1.0f) {
                ++covered;
                // Blending rounds in another order.
                for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(over.rgba[i + c], behind.rgba[i + c], 2.0e-6);
            }
            if (over.rgba[i + 3] > 0.0f) continue;
            ++empty;
            for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(over.rgba[i + c], 0.0f);
        }
        EXPECT_GT(covered, 500) << form.name;
        EXPECT_GT(empty, 500) << form.name;
        // The half of the light that the pane of alpha 0.5 leaves is associated with its alpha, of 16 bits.
        const std::size_t at = 4 * (std::size_t(8) * width + 70);
        EXPECT_NEAR(over.rgba[at + 3], 0.5f, 1.0e-4f);
        EXPECT_NEAR(over.rgba[at + 1] + 0.5f * 0.4f, behind.rgba[at + 1], 0.4f * 0.55f / 65535.0f);
    }
}

}  // namespace
}  // namespace candela::test
