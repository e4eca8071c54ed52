// When and where a scene gets an origin of its own.

#include "import/abi_import.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace candela {
namespace {

/// Squares of 2 m at the given places.
Scene squaresAt(const std::vector<glm::vec3>& places) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    for (const glm::vec3& place : places) {
        Node& node = scene.nodes.emplace_back();
        node.transform = Transform{place};
        node.mesh = 0;
    }
    return scene;
}

glm::dvec3 originOf(Scene scene) {
    chooseOrigin(scene);
    return scene.origin;
}

TEST(SceneOrigin, IsTheFilesNearby) {
    EXPECT_EQ(originOf({}), glm::dvec3(0.0));
    EXPECT_EQ(originOf(squaresAt({{0, 0, 0}})), glm::dvec3(0.0));
    EXPECT_EQ(originOf(squaresAt({{100, -100, 50}})), glm::dvec3(0.0));
    EXPECT_EQ(originOf(squaresAt({{0, 0, 0}, {4000, 0, 0}, {8000, 0, 0}})), glm::dvec3(0.0));
    EXPECT_EQ(originOf(squaresAt({{0, 0, 0}, {1, 0, 0}, {1e6f, 0, 0}})), glm::dvec3(0.0)) << "an outlier";
}

TEST(SceneOrigin, IsNotMovedByStrayVertices) {
    Scene unused = squaresAt({{0, 0, 0}});
    unused.meshes[0].positions.insert(unused.meshes[0].positions.end(), 9, glm::vec3(1e6f, 0, 0));
    EXPECT_EQ(originOf(unused), glm::dvec3(0.0));
    unused.meshes[0].indices.insert(unused.meshes[0].indices.end(), {4, 5, 6});
    EXPECT_EQ(originOf(unused), glm::dvec3(0.0));
}

/// Expects an origin within the reach of a square around `place`.
void expectOrigin(const Scene& scene, const glm::dvec3& place, double reach = 1.5) {
    EXPECT_LE(glm::distance(originOf(scene), place), reach)
        << originOf(scene).x << ' ' << originOf(scene).y << ' ' << originOf(scene).z;
}

TEST(SceneOrigin, IsAmongWhatStandsFarAway) {
    expectOrigin(squaresAt({{5e5f, 4e6f, -3}}), {5e5, 4e6, -3});
    expectOrigin(squaresAt({{1, 0, 0}, {5e5f, 1, 0}, {5e5f, 2, 0}, {5e5f, 3, 0}, {5e5f, 4, 0}}), {5e5, 2, 0});
    // 1 mm, 1 m away.
    Scene small = squaresAt({{1, 0, 0}});
    std::get<Transform>(small.nodes[0].transform).scale = glm::vec3(5e-4f);
    expectOrigin(small, {1, 0, 0}, 1e-3);
    // Coordinates that are in the vertices.
    Scene survey = squaresAt({{0, 0, 0}});
    for (glm::vec3& position : survey.meshes[0].positions) position += glm::vec3(5e5f, 4e6f, 100.0f);
    expectOrigin(survey, {5e5, 4e6, 100});
}

TEST(SceneOrigin, LeavesWhatHasNoNodeInItsPlace) {
    Scene scene = squaresAt({{5e5f, 0, 0}});
    scene.lights.emplace_back().position = {500002.0f, 3.0f, 1.0f};
    scene.cameras.emplace_back();
    chooseOrigin(scene);
    const glm::vec3 origin(scene.origin);
    EXPECT_NE(origin.x, 0.0f);
    EXPECT_EQ(worldLights(scene, worldTransforms(scene))[0].position,
              glm::vec3(500002.0f - origin.x, 3.0f - origin.y, 1.0f - origin.z));
    EXPECT_EQ(cameraView(scene, 0, worldTransforms(scene)).eye(), -origin);
}

TEST(SceneOrigin, IsSubtractedInDoublePrecision) {
    Scene scene = squaresAt({{4e6f, 0, 0}});
    scene.nodes[0].translationRemainder = {0.3, -0.1, 0.0};
    Node& child = scene.nodes.emplace_back();
    child.parent = 0;
    child.transform = glm::translate(glm::mat4(1.0f), glm::vec3(0.25f, 0.0f, 2.0f));
    chooseOrigin(scene);
    const std::vector<glm::mat4> world = worldTransforms(scene);
    const glm::dvec3 rest = glm::dvec3(4000000.3, -0.1, 0.0) - scene.origin;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_FLOAT_EQ(world[0][3][axis], static_cast<float>(rest[axis]));
        EXPECT_FLOAT_EQ(world[1][3][axis],
                        static_cast<float>(rest[axis] + std::vector{0.25, 0.0, 2.0}[std::size_t(axis)]));
    }
}

TEST(SceneOrigin, AnimationsKeepTheirDigits) {
    Scene scene = squaresAt({{4e6f, 0, 0}});
    scene.animations.push_back({"",
                                {{0,
                                  AnimationPath::translation,
                                  Interpolation::linear,
                                  {0.0f, 1.0f},
                                  {4e6f, 0, 0, 4000001.0f, 0, 0}}}});
    chooseOrigin(scene);
    EXPECT_FLOAT_EQ(worldTransforms(scene, 0.3)[0][3].x, static_cast<float>(4000000.3 - scene.origin.x));
}

}  // namespace
}  // namespace candela
