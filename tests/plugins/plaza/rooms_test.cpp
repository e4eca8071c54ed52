// The scene of rooms: it is the same on every machine, all rooms are connected, and most lights are occluded.
#include "procedural_scene.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela {
namespace {

Scene rooms(const std::string& count) {
    return importProcedural("rooms:" + count).scene;
}

struct Box {
    glm::vec3 low, high;
};

// Each box has 24 consecutive vertices.
std::vector<Box> boxesOf(const Scene& scene) {
    std::vector<Box> boxes;
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.name == "floor" || mesh.name == "ceiling") continue;
        for (std::size_t first = 0; first < mesh.positions.size(); first += 24) {
            Box box{mesh.positions[first], mesh.positions[first]};
            for (std::size_t i = 1; i < 24; ++i) {
                box.low = glm::min(box.low, mesh.positions[first + i]);
                box.high = glm::max(box.high, mesh.positions[first + i]);
            }
            boxes.push_back(box);
        }
    }
    return boxes;
}

bool isBlocked(const std::vector<Box>& boxes, const glm::vec3& point) {
    return std::ranges::any_of(boxes, [&](const Box& box) {
        return glm::all(glm::greaterThan(point, box.low)) && glm::all(glm::lessThan(point, box.high));
    });
}

TEST(Rooms, IsTheSameOnEveryMachine) {
    const Scene scene = rooms("1000");
    EXPECT_EQ(scene.lights.size(), 1000u);
    EXPECT_EQ(geometryHash(scene), 0x27154B4A862ECD09u) << std::hex << geometryHash(scene);
    EXPECT_EQ(lightHash(scene.lights), 0x4D00AEDBFB157BC9u) << std::hex << lightHash(scene.lights);
}

TEST(Rooms, FewerLightsAreTheFirstOfMore) {
    const Scene few = rooms("100"), many = rooms("5000");
    EXPECT_EQ(lightHash(few.lights), lightHash({many.lights.begin(), many.lights.begin() + 100}));
    EXPECT_EQ(geometryHash(few), geometryHash(many));
}

TEST(Rooms, SizesAndLights) {
    const Scene scene = rooms("20000");
    const Bounds bounds = worldBounds(scene, worldTransforms(scene));
    EXPECT_FLOAT_EQ(bounds.min.x, -50.1f) << "half a wall thickness beyond the plan";
    EXPECT_FLOAT_EQ(bounds.max.z, 50.1f);
    EXPECT_EQ(bounds.min.y, 0.0f);
    EXPECT_EQ(bounds.max.y, 3.0f);
    for (const Light& light : scene.lights) {
        EXPECT_EQ(light.intensity, 8.0f);
        EXPECT_EQ(light.range, 3.0f);
        EXPECT_LE(std::max(std::abs(light.position.x), std::abs(light.position.z)), 49.5f);
        EXPECT_GT(light.position.y, 0.0f);
        EXPECT_LT(light.position.y, 3.0f);
    }
}

TEST(Rooms, BoxesFaceOutwards) {
    const Scene scene = rooms("0");
    for (const Mesh& mesh : scene.meshes)
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                            c = mesh.positions[mesh.indices[i + 2]];
            const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
            ASSERT_GT(glm::dot(normal, mesh.normals[mesh.indices[i]]), 0.999f) << mesh.name << ", " << i / 3;
            ASSERT_TRUE(mesh.name != "floor" || normal.y > 0.9f);
            ASSERT_TRUE(mesh.name != "ceiling" || normal.y < -0.9f);
        }
    // A box's center lies behind each of its faces.
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.name == "floor" || mesh.name == "ceiling") continue;
        for (std::size_t first = 0; first < mesh.positions.size(); first += 24) {
            glm::vec3 center(0.0f);
            for (std::size_t i = 0; i < 24; ++i) center += mesh.positions[first + i] / 24.0f;
            for (std::size_t i = 0; i < 24; ++i)
                ASSERT_GT(glm::dot(mesh.normals[first + i], mesh.positions[first + i] - center), 0.0f);
        }
    }
}

// Each wall between two rooms has a doorway, so that all rooms are connected.
TEST(Rooms, EveryInnerWallHasADoorway) {
    const std::vector<Box> boxes = boxesOf(rooms("0"));
    constexpr float side = 6.25f, height = 1.2f;
    for (int row = 0; row < 16; ++row)
        for (int column = 1; column < 16; ++column) {
            const float line = -50.0f + side * static_cast<float>(column);
            const float from = -50.0f + side * static_cast<float>(row);
            int openAlongX = 0, openAlongZ = 0;
            for (float t = 0.05f; t < side; t += 0.1f) {
                openAlongX += !isBlocked(boxes, {line, height, from + t});
                openAlongZ += !isBlocked(boxes, {from + t, height, line});
            }
            // A door is 1.2 m wide and a wide opening 3 m; steps of 0.1 m.
            EXPECT_GE(openAlongX, 11) << column << ", " << row;
            EXPECT_LE(openAlongX, 31) << column << ", " << row;
            EXPECT_GE(openAlongZ, 11) << row << ", " << column;
            EXPECT_LE(openAlongZ, 31) << row << ", " << column;
        }
}

TEST(Rooms, TheCameraIsNotInsideAWall) {
    const Scene scene = rooms("0");
    const CameraView view = cameraView(scene, 0, worldTransforms(scene));
    const std::vector<Box> boxes = boxesOf(scene);
    for (float step = 0.0f; step < 1.0f; step += 0.05f)
        EXPECT_FALSE(isBlocked(boxes, view.eye() - step * glm::vec3(view.worldFromCamera[2]))) << step;
    EXPECT_GT(view.worldFromCamera[1].y, 0.99f) << "upright";
}

// The line from the camera to a light intersects a wall for most lights.
TEST(Rooms, MostLightsAreOccluded) {
    const Scene scene = rooms("300");
    const glm::vec3 eye = cameraView(scene, 0, worldTransforms(scene)).eye();
    const std::vector<Box> boxes = boxesOf(scene);
    int visible = 0;
    for (const Light& light : scene.lights) {
        const float length = glm::length(light.position - eye);
        bool isVisible = true;
        // Walls are 0.2 m thick.
        for (float at = 0.0f; at < length && isVisible; at += 0.15f)
            isVisible = !isBlocked(boxes, glm::mix(eye, light.position, at / length));
        visible += isVisible;
    }
    EXPECT_LT(visible, 30) << "of 300";
}

TEST(Rooms, InvalidCountsAreErrors) {
    try {
        rooms("-1");
        ADD_FAILURE() << "rooms:-1 was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_STREQ(
            error.what(),
            "rooms:-1: number of lights: '-1' is not a whole number from 0 to 16000000, as in rooms:4096");
    }
}

}  // namespace
}  // namespace candela
