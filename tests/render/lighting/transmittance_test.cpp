// Blended surfaces let 1 - alpha of each light through.

#include "occlusion/shadow_fixture.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"
#include "support/shadow_reference.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace candela::test {
namespace {

class TransmittanceTest : public DrawingTest {
  protected:
    static constexpr int width = 96, height = 54;

    void SetUp() override {
        if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    }

    static FrameRequest requestOf(const CameraView& view, const Form& form, Shadows shadows) {
        FrameRequest request{width, height, view, BrdfModel::gltf, form.technique};
        request.tileBackend = form.backend;
        request.shadows = shadows;
        return request;
    }

    /// At every pixel that is lit without shadows and shows no layer: with them over without.
    template <typename Expected>
    static void expectShares(GpuScene& scene, const CameraView& view, const Form& form,
                             const std::string& what, double tolerance, const Expected& expected) {
        FrameRequest opaque = requestOf(view, form, Shadows::off);
        opaque.layers = 0;
        const HdrImage alone = drawn(scene, opaque);
        const HdrImage without = drawn(scene, requestOf(view, form, Shadows::off));
        const HdrImage with = drawn(scene, requestOf(view, form, Shadows::on));
        const AovReader aovs(lastFrame().aovs({"P"}), width);
        int count = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const float full = pixelOf(without, x, y).g;
                if (pixelOf(alone, x, y) != pixelOf(without, x, y)) continue;
                const double share = full > 0.0f ? expected(glm::dvec3(aovs.vector("P", x, y))) : -1.0;
                if (share < 0.0) continue;
                ++count;
                ASSERT_NEAR(pixelOf(with, x, y).g / full, share, tolerance)
                    << what << ", " << form.name << ", pixel " << x << ", " << y;
            }
        }
        EXPECT_GT(count, 1000) << what << ", " << form.name;
    }
};

Material tinted(float alpha) {
    Material material = grey();
    material.baseColor = {0.9f, 0.2f, 0.1f, alpha};
    material.alphaMode = AlphaMode::blend;
    material.doubleSided = true;
    return material;
}

/// A horizontal square that faces up.
glm::mat4 flatAt(const glm::vec3& position) {
    return glm::rotate(at(position), glm::radians(-90.0f), {1, 0, 0});
}

Scene floorScene() {
    return sceneOf(makeQuad(3.0f), grey(), flatAt({0, 0, 0}));
}

/// From the side, below what hangs over the floor.
const CameraView fromTheSide = lookAt({0.2f, 0.7f, 4.0f}, {0, 0, 0}, 0.7f);

std::vector<std::pair<std::string, WorldLight>> lightsAbove() {
    return {{"directional", directionalLight(glm::normalize(glm::vec3(0.1f, -1, 0.2f)), glm::vec3(2.0f))},
            {"point", pointLight({0.3f, 6.0f, 0.2f}, 30.0f, glm::vec3(40.0f))},
            {"spot", spotLight({0, 6.0f, 0}, {0, 0, 0}, 30.0f, glm::vec3(40.0f), 0.8f, 1.0f)}};
}

TEST_F(TransmittanceTest, StacksInAnyOrderAreAProduct) {
    for (std::uint32_t count = 1; count <= 6; ++count) {
        for (std::uint32_t order = 0; order < 2; ++order) {
            Scene scene = floorScene();
            double product = 1.0;
            for (std::uint32_t i = 0; i < count; ++i) {
                const std::uint32_t level = order == 0 ? i : count - 1 - i;
                const float alpha = 0.05f + 0.9f * hashed(count, i);
                product *= 1.0 - double(alpha);
                // Meshes of their own, or one behind a transform that mirrors and scales it.
                glm::mat4 place = flatAt({0, 1.5f + 0.2f * float(level), 0});
                if (i % 2 == 1) place = glm::scale(place, {-1e-3f, 1e-3f, 1e-3f});
                test::place(scene, makeQuad(i % 2 == 1 ? 8000.0f : 8.0f), tinted(alpha), place);
            }
            GpuScene uploaded = upload(scene);
            for (const auto& [name, light] : lightsAbove()) {
                uploaded.setLights(std::array{light});
                for (const Form& form : forms) {
                    const std::string what = name + ", " + std::to_string(count) + " surfaces";
                    expectShares(uploaded, fromTheSide, form, what, 1e-5,
                                 [&](const glm::dvec3&) { return product; });
                }
            }
        }
    }
}

TEST_F(TransmittanceTest, SomethingOpaqueEndsTheRay) {
    for (const float place : {1.2f, 2.0f, 2.8f}) {
        Scene scene = floorScene();
        for (int i = 0; i < 3; ++i)
            test::place(scene, makeQuad(8.0f), tinted(0.2f), flatAt({0, 1.5f + 0.5f * float(i), 0}));
        Material opaque = grey();
        opaque.doubleSided = true;
        test::place(scene, makeQuad(8.0f), opaque, flatAt({0, place, 0}));
        GpuScene uploaded = upload(scene);
        for (const auto& [name, light] : lightsAbove()) {
            uploaded.setLights(std::array{light});
            for (const Form& form : forms)
                expectShares(uploaded, fromTheSide, form, name, 0.0, [](const glm::dvec3&) { return 0.0; });
        }
    }
}

TEST_F(TransmittanceTest, ATexturesRampFadesTheLight) {
    Scene scene = floorScene();
    constexpr std::uint32_t texels = 64;
    scene.images.push_back(makeImage(
        texels, 2, [](std::uint32_t x, std::uint32_t) { return glm::u8vec4(255, 255, 255, 4 * x); }));
    Material ramp = tinted(0.8f);
    ramp.baseColorTexture = Texture{};
    ramp.baseColorTexture->wrapS = ramp.baseColorTexture->wrapT = Wrap::clampToEdge;
    place(scene, makeQuad(2.0f), ramp, flatAt({0, 1.5f, 0}));
    GpuScene uploaded = upload(scene, std::array{directionalLight({0, -1, 0}, glm::vec3(2.0f))});
    for (const Form& form : forms) {
        expectShares(uploaded, fromTheSide, form, "ramp", 2e-5, [&](const glm::dvec3& p) {
            if (std::abs(p.x) > 1.99 || std::abs(p.z) > 1.99 || p.y > 0.01) return -1.0;
            const double texel = (p.x + 2.0) / 4.0 * texels - 0.5;
            return 1.0 - 0.8 * 4.0 * std::clamp(texel, 0.0, texels - 1.0) / 255.0;
        });
    }
}

TEST_F(TransmittanceTest, BlendedAndOpaqueBoxesAgreeWithAllTriangles) {
    Scene scene = boxesOnAFloor();
    for (std::uint32_t i = 1; i < scene.materials.size(); ++i) {
        if (i % 3 != 0) scene.materials[i] = tinted(0.1f + 0.8f * hashed(61, i));
    }
    const std::vector<Triangle> triangles = trianglesOf(scene);
    GpuScene uploaded = upload(scene);
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    const glm::dvec3 eye(view.worldFromCamera[3]);
    const std::vector<WorldLight> lights = scatteredLights(4, 62);
    int partial = 0;
    for (const WorldLight& light : lights) {
        uploaded.setLights(std::array{light});
        for (const Form& form : forms) {
            // Differences of the pixel's position in a ratio of sums that are rounded.
            expectShares(uploaded, view, form, "boxes", 2e-5, [&](const glm::dvec3& p) {
                const Transmittance expected = transmittanceOf(
                    triangles, {glm::dvec3(light.position), p, eye, marginAt(p, view, height)});
                partial += expected.share > 0.0 && expected.share < 1.0;
                return expected.grazing ? -1.0 : expected.share;
            });
        }
    }
    EXPECT_GT(partial, 2000);
}

TEST_F(TransmittanceTest, AnAlphaOf1IsLitAndDrawnAsAMask) {
    Scene blended = sceneOf(makeQuad(2.0f), tinted(1.0f), flatAt({0, 0, 0}));
    Scene masked = blended;
    masked.materials[0].alphaMode = AlphaMode::mask;
    const std::vector<WorldLight> lights{lightsAbove()[1].second};
    GpuScene first = upload(blended, lights), second = upload(masked, lights);
    const CameraView above = lookAt({0, 2, 3}, {0, 0, 0}, 0.7f);
    for (const Form& form : forms) {
        for (const Shadows shadows : {Shadows::off, Shadows::on}) {
            const HdrImage picture = drawn(first, requestOf(above, form, shadows));
            EXPECT_EQ(picture.rgba, drawn(second, requestOf(above, form, shadows)).rgba) << form.name;
            EXPECT_GT(pixelOf(picture, width / 2, height / 2).r, 0.0f);
        }
    }
}

TEST_F(TransmittanceTest, MaterialsThatChangeChangeWhatPasses) {
    Scene scene = floorScene();
    Material material = tinted(0.25f);
    place(scene, makeQuad(8.0f), material, flatAt({0, 1.5f, 0}));
    GpuScene uploaded = upload(scene, std::array{lightsAbove()[0].second});
    const auto expectShare = [&](double share) {
        for (const Form& form : forms)
            expectShares(uploaded, fromTheSide, form, "changed", 1e-6,
                         [&](const glm::dvec3&) { return share; });
    };
    expectShare(0.75);
    material.baseColor.a = 0.5f;
    uploaded.setMaterial(1, material);
    expectShare(0.5);
    material.alphaMode = AlphaMode::opaque;
    uploaded.setMaterial(1, material);
    expectShare(0.0);
    material.alphaMode = AlphaMode::blend;
    material.baseColor.a = 0.0f;
    uploaded.setMaterial(1, material);
    expectShare(1.0);
}

TEST_F(TransmittanceTest, ShadowedCountIsOfLightsThatAreHiddenWhole) {
    Scene scene = floorScene();
    place(scene, makeQuad(8.0f), tinted(0.9f), flatAt({0, 1.5f, 0}));
    GpuScene uploaded = upload(scene, std::array{lightsAbove()[0].second});
    for (const float alpha : {0.9f, 1.0f}) {
        uploaded.setMaterial(1, tinted(alpha));
        render(uploaded, requestOf(fromTheSide, forms[0], Shadows::on));
        const AovReader aovs(lastFrame().aovs({"shadowed_count"}), width);
        EXPECT_EQ(aovs.scalar("shadowed_count", width / 2, height - 10), alpha == 1.0f ? 1.0f : 0.0f);
    }
}

TEST_F(TransmittanceTest, AmbientOcclusionTakesTheShare) {
    Scene scene = floorScene();
    place(scene, makeQuad(5000.0f), tinted(0.25f), flatAt({0, 1.5f, 0}));
    GpuScene uploaded = upload(scene);
    FrameRequest request = requestOf(fromTheSide, forms[0], Shadows::off);
    request.ambientOcclusion = {.distance = 1e6f, .rays = 64};
    render(uploaded, request);
    const AovReader aovs(lastFrame().aovs({"ambient_occlusion"}), width);
    EXPECT_EQ(aovs.scalar("ambient_occlusion", width / 2, height - 10), 0.75f);
}

}  // namespace
}  // namespace candela::test
