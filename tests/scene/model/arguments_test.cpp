#include "sample_cage_scene.h"

#include <candela/error.h>
#include <candela/refined_cage.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

// Invalid arguments that public functions refuse in every build type.

namespace candela {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void expectRefused(const std::function<void()>& call, const char* what) {
    try {
        call();
        ADD_FAILURE() << "nothing was thrown for " << what;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput) << what;
    }
}

TEST(Arguments, WorldTransforms) {
    Scene scene = sampleCageScene();
    scene.nodes[1].parent = 7;
    expectRefused([&] { worldTransforms(scene); }, "a parent that does not exist");
    scene = sampleCageScene();
    scene.nodes[2].transform = glm::mat4(1.0f);
    expectRefused([&] { worldTransforms(scene); }, "an animated node with a matrix");
    scene = sampleCageScene();
    scene.animations[0].channels[0].node = 99;
    expectRefused([&] { worldTransforms(scene); }, "a channel without a node");
    scene = sampleCageScene();
    scene.animations[0].channels[0].values.pop_back();
    expectRefused([&] { worldTransforms(scene); }, "a channel with too few values");
    expectRefused([&] { worldTransforms(sampleCageScene(), std::nan("")); }, "a time that is NaN");
}

TEST(Arguments, PosesAndBounds) {
    const Scene scene = sampleCageScene();
    const std::vector<glm::mat4> world = worldTransforms(scene);
    const std::vector<glm::mat4> tooFew(2, glm::mat4(1.0f));
    expectRefused([&] { poseCage(scene, 5, world); }, "a node that does not exist");
    expectRefused([&] { poseCage(scene, 1, world); }, "a node without a cage");
    expectRefused([&] { poseCage(scene, 0, tooFew); }, "too few matrices");
    expectRefused([&] { poseCage(scene, 0, world, INFINITY); }, "an infinite time");
    expectRefused([&] { nodeBounds(scene, 5, world); }, "a node that does not exist");
    expectRefused([&] { worldBounds(scene, tooFew); }, "too few matrices");
    Scene broken = scene;
    broken.cages[0].joints[3] = 9;
    expectRefused([&] { poseCage(broken, 0, world); }, "a joint that the skin does not have");
    broken = scene;
    broken.cages[0].morphTargets[0].offsets.pop_back();
    expectRefused([&] { poseCage(broken, 0, world); }, "a morph target with too few offsets");
    broken = scene;
    broken.nodes[4].mesh = 3;
    expectRefused([&] { triangleCount(broken); }, "a mesh that does not exist");
}

TEST(Arguments, CamerasAndLights) {
    Scene scene;
    scene.nodes.resize(1);
    scene.cameras.push_back({.name = "main", .node = 0});
    scene.lights.resize(1);
    scene.lights[0].node = 3;
    const std::vector<glm::mat4> world = {glm::mat4(1.0f)}, notFinite = {glm::mat4(nan)};
    expectRefused([&] { cameraView(scene, 1, world); }, "a camera that does not exist");
    expectRefused([&] { cameraView(scene, 0, {}); }, "too few matrices");
    expectRefused([&] { cameraView(scene, 0, notFinite); }, "a matrix that is NaN");
    expectRefused([&] { worldLights(scene, world); }, "a light at a node that does not exist");
    for (const float aspect : {0.0f, -1.0f, nan, INFINITY}) {
        expectRefused([&] { projection({}, aspect); }, "an aspect ratio");
        expectRefused([&] { frameBounds({glm::vec3(0.0f), glm::vec3(1.0f)}, aspect); }, "an aspect ratio");
    }
    expectRefused([] { projection({.nearPlane = 0.0f}, 1.0f); }, "a near plane at 0");
    expectRefused([] { projection({.verticalFov = nan}, 1.0f); }, "a field of view that is NaN");
    expectRefused([] { frameBounds({glm::vec3(nan), glm::vec3(1.0f)}, 1.0f); }, "a box that is NaN");
    expectRefused([] { candelaFromLumen(-1.0f); }, "negative lumen");
    expectRefused([] { candelaFromLumen(1.0f, 0.0f); }, "a cone without an angle");
    expectRefused([] { candelaFromLumen(1.0f, 1e-30f); }, "a cone too narrow for a float");
    expectRefused([] { lumenFromWatt(3e38f); }, "more watt than a float holds in lumen");
}

TEST(Arguments, LimitSurfaces) {
    const RefinedCage refined = cagePolygons(sampleTent());
    const std::vector<glm::vec3> points = sampleTent().positions;
    std::vector<glm::vec3> positions(refined.vertexCount()), normals(refined.vertexCount());
    const LimitVertices out{positions, normals, {}, {}};
    EXPECT_NO_THROW(evaluateLimit(refined, points, out));
    expectRefused([&] { evaluateLimit(refined, std::span(points).first(3), out); }, "too few points");
    expectRefused(
        [&] {
            evaluateLimit(refined, points, {out.positions.first(1), normals, {}, {}});
        },
        "an output that is too small");
    RefinedCage broken = refined;
    broken.positions.controlIndices.back() = 99;
    expectRefused([&] { evaluateLimit(broken, points, out); }, "a control index out of range");
    broken = refined;
    broken.positions.offsets.back() += 1;
    expectRefused([&] { evaluateLimit(broken, points, out); }, "a stencil beyond the entries");
    broken = refined;
    broken.seamPoints.front() = 99;
    expectRefused([&] { evaluateLimit(broken, points, out); },
                  "a seam vertex of a point that does not exist");
    expectRefused([&] { refined.pointOf(999); }, "a vertex that does not exist");
    const RefinedCage hull = cagePolygons(sampleHull());
    expectRefused([&] { evaluateLimitUvs(hull, {}); }, "too few texture coordinates");
    Cage cage = sampleHull();
    cage.faceVertices[0] = 99;
    expectRefused([&] { cagePolygons(cage); }, "a face vertex out of range");
}

TEST(TriangleCount, OfAMeshWithoutSubmeshesFollowsFromItsIndices) {
    Scene scene;
    scene.meshes.resize(1);
    scene.meshes[0].indices = {0, 1, 2, 0, 2, 3};
    scene.nodes.resize(2);
    scene.nodes[0].mesh = scene.nodes[1].mesh = 0;
    EXPECT_EQ(triangleCount(scene.meshes[0]), 2u);
    EXPECT_EQ(triangleCount(scene), 4u);
}

}  // namespace
}  // namespace candela
