// The scene of many small lights: it is the same on every machine, and its lights reach the shell.
#include "procedural_scene.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela {
namespace {

Scene cloud(const std::string& count) {
    return importProcedural("cloud:" + count).scene;
}

TEST(Cloud, IsTheSameOnEveryMachine) {
    const Scene scene = cloud("1000");
    EXPECT_EQ(scene.lights.size(), 1000u);
    EXPECT_EQ(geometryHash(scene), 0xFE6EA7166B1C94EDu) << std::hex << geometryHash(scene);
    EXPECT_EQ(lightHash(scene.lights), 0x15325FA747973124u) << std::hex << lightHash(scene.lights);
}

TEST(Cloud, LightsLieEvenlyOnTheSphere) {
    const Scene scene = cloud("10000");
    int upper = 0, octant = 0;
    for (const Light& light : scene.lights) {
        EXPECT_EQ(light.type, LightType::point);
        EXPECT_EQ(light.range, 0.3f);
        // The numbers lie on a grid of 2^-20 of the radius, three of which make 9e-5 m at most.
        EXPECT_NEAR(glm::length(light.position), 50.0f, 2e-4f);
        upper += light.position.y > 0.0f;
        octant += glm::all(glm::greaterThan(light.position, glm::vec3(0.0f)));
    }
    EXPECT_EQ(upper, 5000) << "the heights are equal steps";
    // An octant has 1250 lights on average; a spiral is more uniform than random points, whose standard
    // deviation is 33.
    EXPECT_NEAR(octant, 1250, 33);
}

TEST(Cloud, LightsKeepAMinimumDistance) {
    const Scene scene = cloud("1000");
    float minDistance = 1.0e9f;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            minDistance =
                std::min(minDistance, glm::length(scene.lights[i].position - scene.lights[j].position));
    // Each light has an area of 4 pi 50² / 1000 = 31.4 m², a square of 5.6 m.
    EXPECT_GT(minDistance, 0.5f * 5.6f);
}

// Points of the shell near a light are within the light's range, and the light is in front of the shell.
TEST(Cloud, TheShellIsJustOutsideAndFacesInwards) {
    const Scene scene = cloud("0");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& shell = scene.meshes[0];
    for (std::size_t i = 0; i < shell.indices.size(); i += 3) {
        const glm::vec3 a = shell.positions[shell.indices[i]], b = shell.positions[shell.indices[i + 1]],
                        c = shell.positions[shell.indices[i + 2]];
        const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
        const float distance = -glm::dot(normal, a);
        ASSERT_GT(distance, 50.1f) << "triangle " << i / 3;
        ASSERT_LT(distance, 50.16f) << "triangle " << i / 3;
        ASSERT_LT(glm::dot(shell.normals[shell.indices[i]], a), -50.0f) << "triangle " << i / 3;
    }
}

TEST(Cloud, TheCameraIsAtTheCenter) {
    const Scene scene = cloud("0");
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(cameraView(scene, 0, worldTransforms(scene)).eye(), glm::vec3(0.0f));
}

TEST(Cloud, InvalidCountsAreErrors) {
    try {
        cloud("many");
        ADD_FAILURE() << "cloud:many was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_STREQ(error.what(),
                     "cloud:many: number of lights: 'many' is not a whole number from 0 to 16000000, as in "
                     "cloud:100000");
    }
}

}  // namespace
}  // namespace candela
