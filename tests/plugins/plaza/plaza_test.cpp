// The benchmark scene is the same on every machine and in every version.
#include "procedural_scene.h"

#include <candela/error.h>
#include <candela/import.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace candela {
namespace {

ImportedScene importPlaza(const std::string& count, const ImportProgress& progress = {}) {
    return importProcedural("plaza:" + count, progress);
}

Scene plaza(const std::string& count) {
    return importPlaza(count).scene;
}

TEST(Plaza, CountsAndSizes) {
    const Scene scene = plaza("4096");
    EXPECT_EQ(scene.meshes.size(), 257u);
    EXPECT_EQ(scene.materials.size(), 257u);
    EXPECT_EQ(scene.nodes.size(), 258u);
    EXPECT_EQ(scene.lights.size(), 4096u);
    EXPECT_EQ(scene.cameras.size(), 1u);
    // A sphere of 32 × 16 segments: 14 rings of 32 quads and two caps of 32 triangles.
    EXPECT_EQ(triangleCount(scene), 64u * 64 * 2 + 256u * (14 * 32 * 2 + 2 * 32));
    const Bounds bounds = worldBounds(scene, worldTransforms(scene));
    EXPECT_EQ(bounds.min, glm::vec3(-50, 0, -50));
    // A sphere of radius 0.8 stands on the ground; twice 0.8f is exact.
    EXPECT_EQ(bounds.max, glm::vec3(50, 2 * 0.8f, 50));
}

TEST(Plaza, IsTheSameOnEveryMachine) {
    const Scene scene = plaza("1000");
    EXPECT_EQ(geometryHash(scene), 0x340FB96B54780223u) << std::hex << geometryHash(scene);
    EXPECT_EQ(lightHash(scene.lights), 0x4DC0609493AB975Du) << std::hex << lightHash(scene.lights);
}

TEST(Plaza, FewerLightsAreTheFirstOfMore) {
    const Scene few = plaza("100"), many = plaza("5000");
    EXPECT_EQ(lightHash(few.lights), lightHash({many.lights.begin(), many.lights.begin() + 100}));
    EXPECT_EQ(geometryHash(few), geometryHash(many));
    EXPECT_TRUE(plaza("0").lights.empty());
}

TEST(Plaza, LightsAreUniformlyDistributed) {
    const Scene scene = plaza("20000");
    glm::vec3 sum(0.0f);
    for (const Light& light : scene.lights) {
        EXPECT_EQ(light.type, LightType::point);
        EXPECT_EQ(light.intensity, 8.0f);
        EXPECT_EQ(light.range, 3.0f);
        EXPECT_LE(std::abs(light.position.x), 48.0f);
        EXPECT_LE(std::abs(light.position.z), 48.0f);
        EXPECT_GE(light.position.y, 0.3f);
        EXPECT_LE(light.position.y, 3.0f);
        EXPECT_EQ(std::max({light.color.x, light.color.y, light.color.z}), 1.0f) << "a pure hue";
        EXPECT_EQ(std::min({light.color.x, light.color.y, light.color.z}), 0.0f) << "a pure hue";
        sum += light.position;
    }
    const glm::vec3 mean = sum / 20000.0f;
    // Standard errors of the mean of 20,000 uniform draws: 96 / sqrt(12 × 20000) = 0.196 and 2.7 / sqrt(...)
    // = 0.0055. Four of them.
    EXPECT_NEAR(mean.x, 0.0f, 0.8f);
    EXPECT_NEAR(mean.y, 1.65f, 0.022f);
    EXPECT_NEAR(mean.z, 0.0f, 0.8f);
}

TEST(Plaza, RoughnessAndMetallicVaryAlongTheAxes) {
    const Scene scene = plaza("0");
    for (std::size_t i = 1; i < scene.meshes.size(); ++i) {
        const std::size_t column = (i - 1) % 16, row = (i - 1) / 16;
        const glm::vec3 center = std::get<Transform>(scene.nodes.at(i).transform).translation;
        const auto coordinate = [](std::size_t step) { return -46.875f + 6.25f * static_cast<float>(step); };
        EXPECT_EQ(center, glm::vec3(coordinate(column), 0.8f, coordinate(row)));
        ASSERT_EQ(scene.nodes[i].mesh, i);
        const Material& material = scene.materials.at(*scene.meshes[i].submeshes.at(0).material);
        // The plugin rounds once from double precision; half a unit in the last place of 1 is 6e-8.
        EXPECT_NEAR(material.roughness, 0.05 + 0.95 * static_cast<double>(column) / 15, 6e-8);
        EXPECT_EQ(material.metallic, row % 2 == 0 ? 0.0f : 1.0f);
    }
}

TEST(Plaza, SpheresAreRoundAndFaceOutwards) {
    const Mesh mesh = plaza("0").meshes.at(1);
    EXPECT_EQ(mesh.positions.size(), 2u + 15 * 32);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        // Each number lies on a grid of 2^-20, half a step of which is 5e-7; three of them make 1e-6 at most.
        EXPECT_NEAR(glm::length(mesh.positions[i]), 0.8f, 1e-6f);
        EXPECT_NEAR(glm::length(mesh.normals[i] - mesh.positions[i] / 0.8f), 0.0f, 2e-6f);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), a + b + c), 0.0f) << "triangle " << i / 3;
    }
}

TEST(Plaza, TheGroundFacesUp) {
    const Mesh mesh = plaza("0").meshes.at(0);
    EXPECT_EQ(mesh.positions.size(), 65u * 65);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        EXPECT_GT(glm::cross(b - a, c - a).y, 0.0f);
    }
}

TEST(Plaza, TheCameraLooksAtTheOrigin) {
    const Scene scene = plaza("0");
    const CameraView view = cameraView(scene, 0, worldTransforms(scene));
    EXPECT_EQ(view.eye(), glm::vec3(0, 12, 45));
    EXPECT_FLOAT_EQ(view.verticalFov, 0.785398163f);
    const glm::vec3 forward(-view.worldFromCamera[2]);
    // Single precision through a quaternion and a matrix: a few units in the last place of 1.
    EXPECT_NEAR(glm::length(forward - glm::normalize(glm::vec3(0, -12, -45))), 0.0f, 1e-6f);
    EXPECT_GT(view.worldFromCamera[1].y, 0.9f) << "upright";
}

TEST(Plaza, InvalidCountsAreErrors) {
    for (const char* count :
         {"", "-5", "+5", "4.5", "1e3", "4096 ", "0x10", "many", "16000001", "99999999999999999999999999"}) {
        try {
            plaza(count);
            ADD_FAILURE() << "plaza:" << count << " was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_EQ(error.what(), "plaza:" + std::string(count) + ": number of lights: '" + count +
                                        "' is not a whole number from 0 to 16000000, as in plaza:4096");
        }
    }
}

TEST(Plaza, ReportsProgressAndCanBeCancelled) {
    double last = -1.0;
    importPlaza("10000", [&](double fraction) {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    });
    EXPECT_EQ(last, 1.0);
    try {
        importPlaza("10000", [](double fraction) { return fraction < 0.3; });
        ADD_FAILURE() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
}

}  // namespace
}  // namespace candela
