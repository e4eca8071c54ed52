// What a plugin changes from frame to frame, against closed forms: tests/import/fixtures/wave.cpp.
#include "scene/model/frame_callback.h"
#include "expect_error.h"
#include "scene/model/property_animation.h"
#include "support/fuzz_iterations.h"

#include <candela/geometry.h>
#include <candela/import.h>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <dlfcn.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace candela {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(CANDELA_TEST_FIXTURES) / "frames";
constexpr double pi = std::numbers::pi;
constexpr double times[] = {0.0, 0.3, 1.7, -0.5, 12.25};
/// Of a number that is rounded to a float once.
constexpr float ulp = 1.2e-7f;

class FrameCallbacks : public testing::Test {
  protected:
    FrameCallbacks() {
        ::unsetenv("WAVE_UPDATES");
        ::unsetenv("WAVE_DESTROYED");
    }
    static Scene load(const std::string& mode) {
        return importScene(PluginRegistry({folder}), "wave:" + mode).scene;
    }
    static int counted(const char* name) {
        const char* value = std::getenv(name);
        return value ? std::atoi(value) : 0;
    }
    static bool isLoaded() {
        void* library = ::dlopen((folder / "wave.so").c_str(), RTLD_NOW | RTLD_NOLOAD);
        if (library) ::dlclose(library);
        return library != nullptr;
    }
};

TEST_F(FrameCallbacks, MoveTheVerticesOfAMesh) {
    // Flat normals split all vertices, those of the plugin and smooth ones none.
    const std::pair<const char*, std::size_t> modes[] = {{"flat", 384}, {"normals", 81}, {"smooth", 81}};
    for (const auto& [mode, vertices] : modes) {
        const Scene scene = load(mode);
        EXPECT_EQ(scene.meshes.at(0).positions.size(), vertices) << mode;
        EXPECT_TRUE(scene.meshes[0].furtherUvs.empty());
        for (const double time : times) {
            const PosedPoints posed = poseMesh(scene, 0, worldTransforms(scene, time), time);
            ASSERT_EQ(posed.points.size(), vertices);
            for (std::size_t i = 0; i < vertices; ++i) {
                const glm::vec3& point = posed.points[i];
                EXPECT_EQ(point.x, scene.meshes[0].positions[i].x);
                EXPECT_EQ(point.y, scene.meshes[0].positions[i].y);
                EXPECT_NEAR(point.z, 0.25 * std::sin(2.0 * pi * (point.x - time)), 0.25 * ulp) << time;
            }
        }
    }
}

TEST_F(FrameCallbacks, NormalsOfThePluginAreNormalized) {
    const Scene scene = load("normals");
    for (const double time : times) {
        const SceneUpdate::MeshVertices& sheet = *updateAt(scene, time)->ofMesh(0);
        for (std::size_t i = 0; i < sheet.normals.size(); ++i) {
            const double slope = 0.5 * pi * std::cos(2.0 * pi * (sheet.positions[i].x - time));
            const glm::dvec3 expected = glm::normalize(glm::dvec3(-slope, 0.0, 1.0));
            // The plugin rounds the slope, and the host the result.
            EXPECT_LT(glm::distance(glm::dvec3(sheet.normals[i]), expected), 2.0 * ulp);
        }
    }
}

TEST_F(FrameCallbacks, FlatNormalsStayFlat) {
    const Scene scene = load("flat");
    const std::vector<std::uint32_t>& indices = scene.meshes[0].indices;
    for (const double time : times) {
        const SceneUpdate::MeshVertices& sheet = *updateAt(scene, time)->ofMesh(0);
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const glm::dvec3 a(sheet.positions[indices[i]]), b(sheet.positions[indices[i + 1]]),
                c(sheet.positions[indices[i + 2]]);
            const glm::dvec3 expected = glm::normalize(glm::cross(b - a, c - a));
            for (std::size_t corner = i; corner < i + 3; ++corner)
                EXPECT_LT(glm::distance(glm::dvec3(sheet.normals[indices[corner]]), expected), 2.0 * ulp);
        }
    }
}

TEST_F(FrameCallbacks, SmoothNormalsAreThoseOfTheMovedMesh) {
    const Scene scene = load("smooth");
    for (const double time : times) {
        const SceneUpdate::MeshVertices& sheet = *updateAt(scene, time)->ofMesh(0);
        Mesh moved = scene.meshes[0];
        moved.positions = sheet.positions;
        computeNormals(moved, std::numbers::pi_v<float>);
        ASSERT_EQ(moved.normals.size(), sheet.normals.size());
        // Sums of six terms in another order, in double precision, and one rounding.
        for (std::size_t i = 0; i < moved.normals.size(); ++i)
            EXPECT_LT(glm::distance(moved.normals[i], sheet.normals[i]), 2.0f * ulp);
    }
}

TEST_F(FrameCallbacks, MoveTheVerticesOfACage) {
    const Scene scene = load("flat");
    for (const double time : times) {
        const PosedPoints posed = poseCage(scene, 2, worldTransforms(scene, time), time);
        for (const glm::vec3& point : posed.points)
            EXPECT_EQ(std::abs(point.x), static_cast<float>(0.5 + 0.25 * time));
    }
}

TEST_F(FrameCallbacks, SetTransformsAndProperties) {
    Scene scene = load("flat");
    for (const double time : times) {
        const auto t = static_cast<float>(time);
        const std::vector<glm::mat4> world = worldTransforms(scene, time);
        EXPECT_EQ(world.at(1)[3], glm::vec4(static_cast<float>(3.0 * time), 0, 0, 1));
        EXPECT_EQ(world.at(0), glm::mat4(1.0f)) << "what it does not set stays";
        const std::vector<WorldLight> lights = worldLights(scene, world, time);
        EXPECT_EQ(lights.at(0).position, glm::vec3(t, 1, 2));
        EXPECT_EQ(lights.at(0).intensity, glm::vec3(10.0f + t));
        EXPECT_EQ(visibleNodes(scene, time), (std::vector<bool>{true, true, time < 2.0, true}));
        poseProperties(scene, time);
        EXPECT_EQ(scene.materials.at(0).baseColor, glm::vec4(std::min(std::abs(t), 1.0f), 0.5f, 0.25f, 1.0f));
        EXPECT_EQ(scene.nodes[2].visible, time < 2.0);
        EXPECT_EQ(scene.lights[0].intensity, 10.0f + t);
    }
}

TEST_F(FrameCallbacks, WhatIsNotSetIsAtRest) {
    const Scene scene = load("rests");
    const std::shared_ptr<const SceneUpdate> moved = updateAt(scene, 0.5), rest = updateAt(scene, 1.5);
    EXPECT_NE(moved->ofMesh(0)->positions, scene.meshes[0].positions);
    EXPECT_EQ(rest->ofMesh(0)->positions, scene.meshes[0].positions);
    EXPECT_EQ(rest->ofMesh(0)->normals, scene.meshes[0].normals);
    EXPECT_EQ(rest->ofCage(0)->positions, scene.cages[0].positions);
    EXPECT_EQ(worldTransforms(scene, 1.5).at(1), glm::mat4(1.0f));
}

TEST_F(FrameCallbacks, NumbersAreInTheAxisAndUnitOfTheFile) {
    const Scene scene = load("centimetres");
    const std::vector<glm::mat4> world = worldTransforms(scene, 1.0);
    // Node 0 is that of the unit.
    EXPECT_NEAR(world.at(2)[3].x, 0.03f, ulp);
    const WorldLight lamp = worldLights(scene, world, 1.0).at(0);
    EXPECT_LT(glm::distance(lamp.position, glm::vec3(0.01f, 0.02f, -0.01f)), ulp);
}

TEST_F(FrameCallbacks, WorldSpaceIsThatOfTheSceneFarFromItsOrigin) {
    const Scene scene = load("survey");
    ASSERT_GT(scene.origin.x, 1e5);
    const std::vector<glm::mat4> world = worldTransforms(scene, 0.3);
    EXPECT_EQ(world.at(1)[3].x, static_cast<float>(3.0 * 0.3 - scene.origin.x));
    EXPECT_EQ(worldLights(scene, world, 0.3).at(0).position.x,
              static_cast<float>(double{0.3f} - scene.origin.x));
}

TEST_F(FrameCallbacks, TheBoxOfThePictureHoldsTheMotion) {
    const Bounds bounds = framingBounds(load("flat"));
    EXPECT_EQ(bounds.max.x, 7.0f) << "the block at 2 s";
    EXPECT_NEAR(bounds.max.z, 1.0f, ulp) << "the cage at 2 s";
    EXPECT_EQ(frameCallbackSpan(load("flat")).last, 2.0);
    EXPECT_TRUE(isAnimated(load("flat")));
}

TEST_F(FrameCallbacks, OneTimeIsOneCall) {
    const Scene scene = load("flat");
    const int before = counted("WAVE_UPDATES");
    const Scene copy = scene;
    const std::vector<glm::mat4> world = worldTransforms(scene, 0.625);
    worldLights(copy, world, 0.625);
    poseMesh(scene, 0, world, 0.625);
    worldBounds(scene, world, 0.625);
    EXPECT_EQ(counted("WAVE_UPDATES"), before + 1);
}

TEST_F(FrameCallbacks, AreCalledByOneThreadAtATime) {
    const Scene scene = load("normals");
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&scene, i] {
            for (int frame = 0; frame < 25; ++frame) {
                const double time = 0.01 * (i + frame);
                const glm::vec3 point = updateAt(scene, time)->ofMesh(0)->positions[1];
                EXPECT_NEAR(point.z, 0.25 * std::sin(2.0 * pi * (0.125 - time)), 0.25 * ulp);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
}

TEST_F(FrameCallbacks, LiveAsLongAsTheLastCopyOfTheScene) {
    std::optional<Scene> copy;
    {
        const Scene scene = load("flat");
        copy = scene;
    }
    EXPECT_EQ(counted("WAVE_DESTROYED"), 0);
    EXPECT_TRUE(isLoaded()) << "the registry is gone";
    EXPECT_EQ(worldTransforms(*copy, 0.5).at(1)[3].x, 1.5f);
    copy.reset();
    EXPECT_EQ(counted("WAVE_DESTROYED"), 1);
    EXPECT_FALSE(isLoaded());
}

TEST_F(FrameCallbacks, AFailedImportDestroysTheCallbackOnce) {
    const auto expectFailure = [&](const std::string& mode, const std::string& text, int destroyed) {
        ::unsetenv("WAVE_DESTROYED");
        expectError([&] { load(mode); }, ErrorKind::badInput, text);
        EXPECT_EQ(counted("WAVE_DESTROYED"), destroyed) << mode;
        EXPECT_FALSE(isLoaded());
    };
    // Where it was not taken, it stays the plugin's.
    expectFailure("no-callback", "set_frame_callback: the struct is NULL", 0);
    expectFailure("no-update", "set_frame_callback: update is NULL", 0);
    expectFailure("bad-span", "first_second is 0 and last_second is -1", 0);
    expectFailure("twice", "set_frame_callback: it has been called before", 1);
    expectFailure("no-import", "no import", 1);
    expectFailure("bad-flag", "mesh 0 'sheet': is_moved is 2", 1);
}

TEST_F(FrameCallbacks, AFaultIsOneErrorThatNamesFileTimePluginAndElement) {
    const std::pair<const char*, const char*> faults[] = {
        {"fails", "cache 'sheet.pc': it ends at 0.08 s"},
        {"silent", "it failed and gave no reason"},
        {"throws", "it threw an exception, which the plugin interface forbids"},
        {"count", "mesh 0 'sheet': vertex_count is 80, but it has 81 vertices"},
        {"goes-on", "mesh 0 'sheet': vertex_count is 80, but it has 81 vertices"},
        {"null", "mesh 0 'sheet': position is NULL, but 81 elements were expected"},
        {"still", "mesh 1 'block': its is_moved is 0"},
        {"index", "set_vertices: mesh is 7, but the scene has 2"},
        {"nan", "mesh 0 'sheet': position 1 has the component nan"},
        {"far", "mesh 0 'sheet': position 1 is farther than 1e9 metres"},
        {"nan-normal", "mesh 0 'sheet': normal 1 has the component inf"},
        {"cage-count", "cage 0 'cube': vertex_count is 7, but it has 8 vertices"},
        {"no-node", "set_transform: node is 5, but the scene has 4"},
        {"no-matrix", "node 1 'block': matrix is NULL"},
        {"matrix", "node 1 'block': matrix is not affine"},
        {"range", "set_property: intensity"},
        {"numbers", "set_property: count is 3, but base colour has 4"},
        {"absent", "light 0 has no range to animate"},
        {"weight", "set_property: property is MORPH_WEIGHT"},
        {"file", "file 'cache.pc': a procedural scene has no folder"},
    };
    for (const auto& [mode, text] : faults) {
        const Scene scene = load(mode);
        EXPECT_NO_THROW(worldTransforms(scene, 1.0 / 24.0)) << mode;
        const std::string error =
            expectError([&] { worldTransforms(scene, 2.0 / 24.0); }, ErrorKind::badInput, text);
        EXPECT_EQ(
            error.find("wave:" + std::string(mode) + ": the frame at 0.0833333 s, by the plugin 'wave': "),
            0u)
            << error;
        EXPECT_NO_THROW(worldTransforms(scene, 0.0)) << "other times are as before";
    }
}

TEST_F(FrameCallbacks, WhatIsTakenIsValid) {
    const Scene scene = load("random");
    int taken = 0;
    for (int frame = 1; frame < candela_test::fuzzIterations(4000); ++frame) {
        const double time = 0.01 * frame;
        std::shared_ptr<const SceneUpdate> update;
        try {
            update = updateAt(scene, time);
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).find("wave:random: the frame at "), 0u) << error.what();
            continue;
        }
        ++taken;
        const std::vector<glm::mat4> world = worldTransforms(scene, time);
        EXPECT_EQ(poseMesh(scene, 0, world, time).points.size(), 384u);
        EXPECT_EQ(poseCage(scene, 2, world, time).points.size(), 8u);
        Scene posed = scene;
        poseProperties(posed, time);
        for (const SceneUpdate::MeshVertices& mesh : update->meshes) {
            posed.meshes[mesh.mesh].positions = mesh.positions;
            posed.meshes[mesh.mesh].normals = mesh.normals;
        }
        posed.frameCallback.reset();
        EXPECT_NO_THROW(validate(posed)) << time;
    }
    EXPECT_GT(taken, 100);
}

}  // namespace
}  // namespace candela
