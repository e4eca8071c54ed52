// The light of an environment in frames: dimmed by occlusion textures and by what rays find.

#include "support/drawing_test.h"
#include "support/occluder_scenes.h"
#include "support/procedural_scene.h"

#include <candela/environment.h>
#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace candela::test {
namespace {

constexpr int width = 64, height = 36;

const Material white = doubleSided(1.0f);

/// Of radiance 1.
Environment furnace(std::optional<float> occlusionDistance = {}) {
    Environment environment;
    environment.picture.width = 64;
    environment.picture.height = 32;
    environment.picture.format = PixelFormat::rgba32f;
    const std::vector<float> ones(4 * 64 * 32, 1.0f);
    environment.picture.pixels.resize(ones.size() * sizeof(float));
    std::memcpy(environment.picture.pixels.data(), ones.data(), environment.picture.pixels.size());
    environment.occlusionDistance = occlusionDistance;
    return environment;
}

class EnvironmentFrameTest : public DrawingTest {
  protected:
    void SetUp() override {
        if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    }

    static FrameRequest requestOf(const CameraView& view, const Form& form, Shadows shadows) {
        FrameRequest request{width, height, view, BrdfModel::gltf, form.technique};
        request.tileBackend = form.backend;
        request.shadows = shadows;
        request.environmentOcclusion.rays = 4;
        return request;
    }

    static AovReader environmentOf(GpuScene& scene, const CameraView& view, const Form& form,
                                   Shadows shadows) {
        render(scene, requestOf(view, form, shadows));
        return {lastFrame().aovs({"P", "Z", "environment", "environment_diffuse"}), width};
    }

    static bool hasPass(const std::string& name) {
        return std::ranges::any_of(lastFrame().passTimes(),
                                   [&](const PassTime& pass) { return pass.name == name; });
    }
};

const CameraView atTheCorner = lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f);

TEST_F(EnvironmentFrameTest, ASealedRoomGetsNothing) {
    Scene scene = closedRoom(white);
    scene.environment = furnace();
    GpuScene uploaded = upload(scene);
    const CameraView inside = lookAt({0.2f, 0.1f, 0.3f}, {-1, -0.8f, -1}, 1.2f);
    for (const Form& form : forms) {
        const AovReader open = environmentOf(uploaded, inside, form, Shadows::off);
        EXPECT_GT(open.vector("environment", width / 2, height / 2).g, 0.5f) << form.name;
        const AovReader dark = environmentOf(uploaded, inside, form, Shadows::on);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x)
                ASSERT_EQ(dark.vector("environment", x, y), glm::vec3(0.0f)) << form.name << x << ", " << y;
        }
        const HdrImage picture = drawn(uploaded, requestOf(inside, form, Shadows::on));
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            ASSERT_EQ(picture.rgba[i], 0.0f) << form.name;
    }
}

TEST_F(EnvironmentFrameTest, DiffuseLightIsThatOfTheFreeShare) {
    Scene scene = floorAndWall(white);
    constexpr float distance = 1.5f;
    scene.environment = furnace(distance);
    GpuScene uploaded = upload(scene);
    for (const Form& form : forms) {
        const AovReader open = environmentOf(uploaded, atTheCorner, form, Shadows::off),
                        with = environmentOf(uploaded, atTheCorner, form, Shadows::on);
        double sum = 0.0;
        int count = 0;
        // Where the window of the filter is whole.
        for (int y = 2; y < height - 2; ++y) {
            for (int x = 2; x < width - 2; ++x) {
                const glm::vec3 p = with.vector("P", x, y);
                const float d = std::max(p.x, p.y);
                if (with.scalar("Z", x, y) == 0.0f || d < 0.15f || d > 8.0f || std::abs(p.z) > 3.4f) continue;
                const float full = open.vector("environment_diffuse", x, y).g;
                const double share = double(with.vector("environment_diffuse", x, y).g) / full;
                // As in environment_occlusion_test.cpp.
                ASSERT_NEAR(share, freeBesideAWall(d, distance), 0.08) << form.name << ", " << x << ", " << y;
                sum += share - freeBesideAWall(d, distance);
                ++count;
            }
        }
        EXPECT_GT(count, 1000);
        EXPECT_LT(std::abs(sum), 0.01 * count) << form.name;
    }
}

TEST_F(EnvironmentFrameTest, WhatNothingHidesIsLitBitForBitAsWithoutRays) {
    Material metal = white;
    metal.metallic = 1.0f;
    metal.roughness = 0.4f;
    for (const Material& material : {metal, white}) {
        Scene scene = sceneOf(makeSphere(1.0f, 16, 8), material);
        scene.environment = furnace();
        GpuScene uploaded = upload(scene);
        for (const Form& form : forms) {
            const CameraView view = lookAt({1.4f, 1.6f, 2.7f}, {0, 0, 0}, 0.8f);
            EXPECT_EQ(drawn(uploaded, requestOf(view, form, Shadows::on)).rgba,
                      drawn(uploaded, requestOf(view, form, Shadows::off)).rgba)
                << form.name;
        }
    }
}

TEST_F(EnvironmentFrameTest, MovedNodesHideAsInAFreshScene) {
    Scene scene = floorAndWall(white);
    for (std::uint32_t i = 0; i < 8; ++i) {
        place(scene, makeSphere(0.15f), white,
              glm::translate(glm::mat4(1.0f), {0.3f + 0.1f * float(i), 0.4f, 0.3f * float(i) - 1.2f}));
    }
    scene.environment = furnace();
    GpuScene moving = upload(scene);
    for (std::uint32_t step = 0; step < 4; ++step) {
        for (std::uint32_t node = 2 + step % 2; node < scene.nodes.size(); node += 2) {
            glm::mat4& transform = std::get<glm::mat4>(scene.nodes[node].transform);
            transform[3] += glm::vec4(0.1f * hashed(step, node), 0.1f * hashed(9, node), 0.05f, 0.0f);
            moving.setTransform(node, transform);
        }
        GpuScene fresh = upload(scene);
        for (const Form& form : forms) {
            EXPECT_EQ(drawn(moving, requestOf(atTheCorner, form, Shadows::on)).rgba,
                      drawn(fresh, requestOf(atTheCorner, form, Shadows::on)).rgba)
                << form.name << ", step " << step;
        }
    }
}

TEST_F(EnvironmentFrameTest, OcclusionTexturesActWithoutRays) {
    Material material = white;
    material.occlusionTexture = Texture{};
    material.occlusionStrength = 0.5f;
    Scene scene = sceneOf(makeQuad(50.0f), material);
    scene.images.push_back(
        makeImage(1, 1, [](std::uint32_t, std::uint32_t) { return glm::u8vec4(51, 0, 0, 255); }));
    const CameraView view = lookAt({0, 0, 5}, {0, 0, 0}, 0.8f);
    GpuScene uploaded = upload(scene);
    for (const Form& form : forms) {
        uploaded.setEnvironment(furnace());
        uploaded.setMaterial(0, material);
        const float dimmed =
            environmentOf(uploaded, view, form, Shadows::off).vector("environment_diffuse", 9, 9).g;
        Material plain = material;
        plain.occlusionTexture.reset();
        uploaded.setMaterial(0, plain);
        const float full =
            environmentOf(uploaded, view, form, Shadows::off).vector("environment_diffuse", 9, 9).g;
        // 1 + strength × (R - 1), in a byte.
        EXPECT_NEAR(dimmed / full, 1.0f + 0.5f * (51.0f / 255.0f - 1.0f), 0.003f) << form.name;
        uploaded.setEnvironment(std::nullopt);
    }
}

TEST_F(EnvironmentFrameTest, NothingIsTracedWithoutAnEnvironment) {
    Scene scene = floorAndWall(white);
    GpuScene uploaded = upload(scene);
    for (const Form& form : forms) {
        render(uploaded, requestOf(atTheCorner, form, Shadows::on));
        EXPECT_FALSE(hasPass("ambient occlusion")) << form.name;
        EXPECT_EQ(uploaded.occlusionReport().bytes, 0u) << form.name;
    }
    uploaded.setEnvironment(furnace());
    for (const Form& form : forms) {
        render(uploaded, requestOf(atTheCorner, form, Shadows::off));
        EXPECT_FALSE(hasPass("ambient occlusion")) << form.name;
        EXPECT_EQ(uploaded.occlusionReport().bytes, 0u) << form.name;
    }
    for (const Form& form : forms) {
        render(uploaded, requestOf(atTheCorner, form, Shadows::on));
        EXPECT_TRUE(hasPass("ambient occlusion")) << form.name;
        EXPECT_GT(uploaded.occlusionReport().bytes, 0u) << form.name;
        EXPECT_EQ(lastFrame().shadowCounts().raysAsked, 0u) << form.name;
    }
}

TEST_F(EnvironmentFrameTest, NumbersOfRaysOutOfRangeAreErrors) {
    GpuScene scene = upload(floorAndWall(white));
    for (const std::uint32_t rays : {0u, 4097u}) {
        FrameSettings settings = requestOf(atTheCorner, forms[0], Shadows::on).settings();
        settings.environmentOcclusion.rays = rays;
        try {
            renderer().render(scene, atTheCorner, settings);
            ADD_FAILURE() << rays;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_NE(std::string(error.what()).find("expected 1 to 4096"), std::string::npos)
                << error.what();
        }
    }
}

}  // namespace
}  // namespace candela::test
