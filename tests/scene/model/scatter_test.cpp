// Lights scattered over the surfaces of a scene.

#include <candela/error.h>
#include <candela/scene.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace candela {
namespace {

/// A box of half sides `half` whose normals point outwards, or inwards for a room.
Mesh boxMesh(const glm::vec3& half, float outwards) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = half[(axis + 1) % 3];
            v[(axis + 2) % 3] = side * half[(axis + 2) % 3];
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const glm::vec3& corner : {-u - v, u - v, u + v, -u + v}) {
                mesh.positions.push_back(normal * half + corner);
                mesh.normals.push_back(outwards * normal);
            }
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                mesh.indices.push_back(first + corner);
        }
    }
    return mesh;
}

constexpr glm::vec3 half{2.0f, 1.0f, 3.0f};

Scene sceneOf(Mesh mesh, const glm::mat4& world = glm::mat4(1.0f)) {
    Scene scene;
    scene.meshes.push_back(std::move(mesh));
    Node node;
    node.transform = world;
    node.mesh = 0;
    scene.nodes.push_back(node);
    return scene;
}

std::vector<Light> scattered(Scene scene, const LightScatter& scatter) {
    scatterLights(scene, scatter);
    return scene.lights;
}

LightScatter many(std::uint32_t count, float range) {
    return {.count = count, .range = range, .candela = 1.0f};
}

TEST(ScatterLights, HaveTheGivenParameters) {
    Scene scene = sceneOf(boxMesh(half, 1.0f));
    scene.lights.resize(1);
    scatterLights(scene, {.count = 1000, .range = 2.5f, .candela = 8.0f});
    ASSERT_EQ(scene.lights.size(), 1001u);
    EXPECT_FALSE(scene.lights[0].range) << "a light that was there has changed";
    for (std::size_t i = 1; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        EXPECT_EQ(light.type, LightType::point);
        EXPECT_EQ(light.range, 2.5f);
        EXPECT_EQ(light.intensity, 8.0f);
        EXPECT_TRUE(light.castsShadow);
        EXPECT_EQ(light.radius, 0.0f);
        EXPECT_EQ(std::max({light.color.x, light.color.y, light.color.z}), 1.0f);
        EXPECT_EQ(std::min({light.color.x, light.color.y, light.color.z}), 0.0f);
    }
    validate(scene);
}

/// The distance to a face of the box, over 0 outside.
float distanceToBox(const glm::vec3& position) {
    const glm::vec3 beyond = glm::abs(position) - half;
    return std::max({beyond.x, beyond.y, beyond.z});
}

TEST(ScatterLights, LightAConvexObjectFromOutside) {
    for (const Light& light : scattered(sceneOf(boxMesh(half, 1.0f)), many(1000, 1.0f))) {
        EXPECT_GE(distanceToBox(light.position), 0.125f - 1e-5f);
        EXPECT_LE(distanceToBox(light.position), 0.5f + 1e-5f);
    }
}

TEST(ScatterLights, LightARoomFromInside) {
    for (const Light& light : scattered(sceneOf(boxMesh(half, -1.0f)), many(1000, 1.0f)))
        EXPECT_LE(distanceToBox(light.position), 0.0f);
}

TEST(ScatterLights, KeepTheirSideOfAMirroredObject) {
    const glm::mat4 mirror = glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f));
    for (const Light& light : scattered(sceneOf(boxMesh(half, 1.0f), mirror), many(100, 1.0f)))
        EXPECT_GE(distanceToBox(light.position), 0.125f - 1e-5f);
}

TEST(ScatterLights, StayNearASmallObject) {
    // The diagonal of 0.02 m is far below the range.
    const Scene scene = sceneOf(boxMesh(glm::vec3(0.01f), 1.0f));
    for (const Light& light : scattered(scene, many(100, 50.0f)))
        EXPECT_LT(glm::length(light.position), 0.05f);
}

TEST(ScatterLights, FallEvenlyByArea) {
    const std::vector<Light> lights = scattered(sceneOf(boxMesh(half, 1.0f)), many(44'000, 0.01f));
    int along[3] = {};
    for (const Light& light : lights) {
        for (int axis = 0; axis < 3; ++axis) along[axis] += std::abs(light.position[axis]) > half[axis];
    }
    // The faces across x have 2 × (2 × 6) of 88 square metres, across y 2 × (4 × 6), across z 2 × (4 × 2):
    // five sigma of a fair draw are below 525.
    EXPECT_NEAR(along[0], 12'000, 525);
    EXPECT_NEAR(along[1], 24'000, 525);
    EXPECT_NEAR(along[2], 8'000, 525);
}

TEST(ScatterLights, FirstLightsAreTheSameForEveryCount) {
    const Scene scene = sceneOf(boxMesh(half, 1.0f));
    const std::vector<Light> few = scattered(scene, many(100, 1.0f)),
                             more = scattered(scene, many(5000, 1.0f));
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(few[i].position, more[i].position);
        EXPECT_EQ(few[i].color, more[i].color);
    }
}

TEST(ScatterLights, SeedsGiveOtherLights) {
    const Scene scene = sceneOf(boxMesh(half, 1.0f));
    LightScatter other = many(100, 1.0f);
    other.seed = 2;
    const std::vector<Light> one = scattered(scene, many(100, 1.0f)), two = scattered(scene, other);
    int equal = 0;
    for (std::size_t i = 0; i < one.size(); ++i) equal += one[i].position == two[i].position ? 1 : 0;
    EXPECT_EQ(equal, 0);
}

TEST(ScatterLights, TheRangeFollowsTheirSpacing) {
    const std::vector<Light> lights =
        scattered(sceneOf(boxMesh(half, 1.0f)), {.count = 22, .range = {}, .candela = {}});
    // 88 square metres for 22 lights are 2 m between them.
    EXPECT_NEAR(*lights[0].range, 4.0f, 1e-5f);
    EXPECT_NEAR(lights[0].intensity, 1.6f, 1e-5f);
}

// Frozen values: every machine and every version has to scatter the same lights, bit for bit.
TEST(ScatterLights, AreFrozen) {
    std::uint64_t digest = 0xcbf29ce484222325u;  // FNV-1a over the bits.
    const auto add = [&digest](float value) {
        digest = (digest ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001b3u;
    };
    for (const Light& light : scattered(sceneOf(boxMesh(half, 1.0f)), many(1000, 1.0f))) {
        for (int i = 0; i < 3; ++i) {
            add(light.position[i]);
            add(light.color[i]);
        }
    }
    EXPECT_EQ(digest, 3918844064774869435u);
}

TEST(ScatterLights, RefuseInvalidParameters) {
    Scene scene = sceneOf(boxMesh(half, 1.0f));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto refused = [&](std::optional<float> range, std::optional<float> candela) {
        EXPECT_THROW(scatterLights(scene, {.count = 1, .range = range, .candela = candela}), Error);
    };
    refused(0.0f, 1.0f);
    refused(nan, 1.0f);
    refused(1.0f, -1.0f);
    refused(1.0f, 1e21f);
    EXPECT_TRUE(scene.lights.empty());
    Scene empty;
    EXPECT_THROW(scatterLights(empty, {.count = 1, .range = {}, .candela = {}}), Error);
    // Triangles without an area are no surface.
    Scene flat = sceneOf(boxMesh(glm::vec3(0.0f), 1.0f));
    EXPECT_THROW(scatterLights(flat, {.count = 1, .range = {}, .candela = {}}), Error);
}

TEST(ScatterLights, AMillionAreValidAndPlaced) {
    Scene scene = sceneOf(boxMesh(half, 1.0f));
    scatterLights(scene, {.count = 1'000'000, .range = {}, .candela = {}});
    validate(scene);
    EXPECT_EQ(worldLights(scene, worldTransforms(scene)).size(), 1'000'000u);
}

}  // namespace
}  // namespace candela
