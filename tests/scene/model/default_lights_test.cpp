// Lights for scenes that bring none.

#include <candela/brdf.h>
#include <candela/default_lights.h>
#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace candela {
namespace {

constexpr double midGrey = 0.18;

/// What a grey Lambert surface of normal `normal` reflects.
double lambert(const std::array<WorldLight, 3>& lights, const glm::vec3& normal) {
    double irradiance = 0.0;
    for (const WorldLight& light : lights)
        irradiance += light.intensity.g * std::max(glm::dot(normal, -light.direction), 0.0f);
    return midGrey / std::numbers::pi * irradiance;
}

TEST(DefaultLights, AGreySurfaceThatFacesTheCameraShowsAsItself) {
    const CameraView view = lookAt({3, 2, 1}, {0, 0, 0}, 0.8f);
    const glm::vec3 towardsCamera(view.worldFromCamera[2]);
    for (const double exposure : {-3.0, 0.0, 2.0}) {
        EXPECT_NEAR(lambert(defaultLights(view, exposure), towardsCamera), midGrey * std::exp2(-exposure),
                    1e-5 * midGrey * std::exp2(-exposure));
    }
}

TEST(DefaultLights, NoSideIsBlack) {
    const CameraView view = lookAt({3, 2, 1}, {0, 0, 0}, 0.8f);
    const glm::mat3 axes(view.worldFromCamera);
    // What the camera sees of a sphere, but for its rim.
    for (float x = -0.8f; x <= 0.8f; x += 0.1f) {
        for (float y = -0.8f; y <= 0.8f; y += 0.1f) {
            const float z2 = 1.0f - x * x - y * y;
            if (z2 < 0.2f) continue;
            EXPECT_GT(lambert(defaultLights(view), axes * glm::vec3(x, y, std::sqrt(z2))), 0.02 * midGrey);
        }
    }
}

TEST(DefaultLights, AreAttachedToTheCamera) {
    const CameraView a = lookAt({0, 0, 5}, {0, 0, 0}, 0.8f), b = lookAt({5, 0, 0}, {0, 0, 0}, 0.8f);
    const auto lightsOfA = defaultLights(a), lightsOfB = defaultLights(b);
    const glm::mat3 fromAToB = glm::mat3(b.worldFromCamera) * glm::transpose(glm::mat3(a.worldFromCamera));
    for (std::size_t i = 0; i < lightsOfA.size(); ++i) {
        EXPECT_EQ(lightsOfA[i].type, LightType::directional);
        EXPECT_LT(glm::distance(fromAToB * lightsOfA[i].direction, lightsOfB[i].direction), 1e-5f);
        EXPECT_NEAR(glm::length(lightsOfB[i].direction), 1.0f, 1e-5f);
    }
}

TEST(DefaultLights, CastNoShadows) {
    for (const WorldLight& light : defaultLights(lookAt({3, 2, 1}, {0, 0, 0}, 0.8f)))
        EXPECT_FALSE(light.castsShadow);
}

TEST(DefaultLights, RefuseInvalidArguments) {
    CameraView view;
    EXPECT_THROW(defaultLights(view, 101.0), Error);
    EXPECT_THROW(defaultLights(view, std::numeric_limits<double>::quiet_NaN()), Error);
    view.worldFromCamera[0][0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(defaultLights(view), Error);
}

/// A node that shows one triangle of one material.
Scene sceneOf(const Material& material) {
    Scene scene;
    scene.materials.push_back(material);
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, {0, 0, 1});
    mesh.indices = {0, 1, 2};
    mesh.submeshes.push_back({0, 3, 0});
    scene.meshes.push_back(mesh);
    scene.nodes.resize(1);
    scene.nodes[0].mesh = 0;
    return scene;
}

Material emitting() {
    Material material;
    material.emission = {0.0f, 1.0f, 0.0f};
    return material;
}

/// An image whose first `bright` of 16 texels are over black.
Image emissionImage(PixelFormat format, int bright) {
    const std::size_t texel = texelSize(format);
    Image image{"glow", 4, 4, format, std::vector<std::byte>(16 * texel)};
    for (int i = 0; i < 16; ++i) {
        std::byte* const texels = image.pixels.data() + static_cast<std::size_t>(i) * texel;
        texels[texel - 1] = std::byte{255};  // Alpha is no light.
        if (i < bright) texels[texel / 4 * 2 - 1] = std::byte{1};
    }
    return image;
}

TEST(HasLight, ByLights) {
    Scene scene = sceneOf({});
    EXPECT_FALSE(hasLight(scene));
    scene.lights.resize(1);
    EXPECT_TRUE(hasLight(scene));
    scene.lights[0].intensity = 0.0f;
    EXPECT_FALSE(hasLight(scene));
    scene.lights[0].intensity = 1.0f;
    scene.lights[0].color = glm::vec3(0.0f);
    EXPECT_FALSE(hasLight(scene));
}

TEST(HasLight, ByAnEnvironment) {
    Scene scene = sceneOf({});
    scene.environment = studioEnvironment();
    EXPECT_TRUE(hasLight(scene));
    scene.environment->intensity = 0.0f;
    EXPECT_FALSE(hasLight(scene));
}

TEST(HasLight, ByMaterialsThatAreShown) {
    EXPECT_TRUE(hasLight(sceneOf(emitting())));
    Material unlit;
    unlit.unlit = true;
    Scene scene = sceneOf(unlit);
    EXPECT_TRUE(hasLight(scene));
    scene.nodes[0].mesh.reset();
    EXPECT_FALSE(hasLight(scene)) << "no node shows it";
}

TEST(HasLight, ByEmissionTexturesThatAreMostlyOverBlack) {
    Material material = emitting();
    material.emissionTexture = Texture{};
    for (const PixelFormat format : {PixelFormat::rgba8, PixelFormat::rgba16, PixelFormat::rgba32f}) {
        Scene scene = sceneOf(material);
        scene.images = {emissionImage(format, 8)};
        EXPECT_FALSE(hasLight(scene)) << "a few lamps";
        scene.images = {emissionImage(format, 9)};
        EXPECT_TRUE(hasLight(scene));
    }
}

TEST(Headlight, LightsWhatFacesTheCamera) {
    const CameraView view = lookAt({3, 2, 1}, {0, 0, 0}, 0.8f);
    for (const double exposure : {-3.0, 0.0, 2.0}) {
        const WorldLight light = headlight(view, exposure);
        EXPECT_EQ(light.type, LightType::directional);
        EXPECT_FALSE(light.castsShadow);
        EXPECT_LT(glm::distance(light.direction, glm::normalize(glm::vec3(-3, -2, -1))), 1e-6f);
        EXPECT_NEAR(midGrey / std::numbers::pi * light.intensity.g, midGrey * std::exp2(-exposure),
                    1e-5 * midGrey * std::exp2(-exposure));
    }
    EXPECT_THROW(headlight(view, 200.0), Error);
}

}  // namespace
}  // namespace candela
