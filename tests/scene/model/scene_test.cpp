#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
// A few roundings of single precision on numbers below 10.
constexpr float rounding = 5e-6f;

void expectNear(const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_LE(glm::distance(actual, expected), rounding)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " is not " << expected.x << ' ' << expected.y
        << ' ' << expected.z;
}

Mesh triangle() {
    Mesh mesh;
    mesh.positions = {{0.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
    mesh.normals.assign(3, {0.0f, 0.0f, 1.0f});
    mesh.indices = {0, 1, 2};
    mesh.submeshes = {{0, 3, {}}};
    return mesh;
}

TEST(WorldTransforms, ComposeTranslationRotationScaleDownTheHierarchy) {
    Scene scene;
    scene.nodes.resize(3);
    Transform root;
    root.translation = {1.0f, 2.0f, 3.0f};
    root.rotation = glm::angleAxis(pi / 2.0f, glm::vec3(0.0f, 0.0f, 1.0f));  // X to Y.
    root.scale = {2.0f, 3.0f, 4.0f};
    scene.nodes[0].transform = root;
    scene.nodes[1].parent = 0;
    scene.nodes[1].transform = glm::translate(glm::mat4(1.0f), glm::vec3(1.0f, 0.0f, 0.0f));
    scene.nodes[2].parent = 1;
    Transform leaf;
    leaf.translation = {0.0f, 1.0f, 1.0f};
    scene.nodes[2].transform = leaf;
    const std::vector<glm::mat4> world = worldTransforms(scene);
    ASSERT_EQ(world.size(), 3u);
    expectNear(world[0] * glm::vec4(1.0f, 0.0f, 0.0f, 1.0f), {1.0f, 4.0f, 3.0f});
    expectNear(world[1][3], {1.0f, 4.0f, 3.0f});
    // (1, 1, 1) in the root: scaled (2, 3, 4), rotated (-3, 2, 4), moved.
    expectNear(world[2][3], {-2.0f, 4.0f, 7.0f});
}

TEST(WorldTransforms, RoundedQuaternionsDoNotScale) {
    Scene scene;
    scene.nodes.resize(1);
    Transform trs;
    trs.rotation = 1.005f * glm::angleAxis(0.5f, glm::vec3(0.0f, 1.0f, 0.0f));
    scene.nodes[0].transform = trs;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(glm::length(glm::vec3(worldTransforms(scene)[0][axis])), 1.0f, rounding);
    }
}

TEST(WorldTransforms, SupportDeepHierarchies) {
    Scene scene;
    scene.nodes.resize(200'000);
    for (std::uint32_t i = 1; i < scene.nodes.size(); ++i) scene.nodes[i].parent = i - 1;
    EXPECT_EQ(worldTransforms(scene).back(), glm::mat4(1.0f));
}

TEST(WorldTransforms, RefuseANonFiniteTime) {
    EXPECT_THROW(worldTransforms({}, std::nan("")), Error);
    EXPECT_THROW(worldTransforms({}, INFINITY), Error);
}

TEST(WorldBounds, EncloseMeshesOfNodes) {
    Scene scene;
    scene.meshes.push_back(triangle());
    scene.nodes.resize(3);
    scene.nodes[0].mesh = 0;
    scene.nodes[1].mesh = 0;
    Transform rotated;
    rotated.translation = {10.0f, 0.0f, -1.0f};
    rotated.rotation = glm::angleAxis(pi / 4.0f, glm::vec3(0.0f, 0.0f, 1.0f));
    scene.nodes[1].transform = rotated;
    scene.nodes[2].transform = glm::translate(glm::mat4(1.0f), glm::vec3(1000.0f));  // Without a mesh.
    const Bounds bounds = worldBounds(scene, worldTransforms(scene));
    // Rotated by 45 degrees, (2, 0) moves to (√2, √2): the box is that of the vertices, not of a rotated box.
    const float root = std::sqrt(2.0f);
    expectNear(bounds.min, {0.0f, 0.0f, -1.0f});
    expectNear(bounds.max, {10.0f + root, root, 0.0f});
}

TEST(WorldBounds, OfAnEmptySceneAreEmpty) {
    Scene scene;
    EXPECT_TRUE(worldBounds(scene, {}).empty());
    scene.meshes.emplace_back();
    scene.nodes.resize(1);
    scene.nodes[0].mesh = 0;
    EXPECT_TRUE(worldBounds(scene, worldTransforms(scene)).empty());
}

TEST(TriangleCount, CountsEveryInstance) {
    Scene scene;
    EXPECT_EQ(triangleCount(scene), 0u);
    scene.meshes.push_back(triangle());
    scene.meshes.push_back(triangle());
    scene.meshes[1].indices = {0, 1, 2, 0, 2, 1};
    scene.meshes[1].submeshes = {{0, 3, {}}, {3, 3, {}}};
    EXPECT_EQ(triangleCount(scene), 0u) << "no node has a mesh";
    scene.nodes.resize(4);
    scene.nodes[0].mesh = 0;
    scene.nodes[1].mesh = 1;
    scene.nodes[2].mesh = 1;
    EXPECT_EQ(triangleCount(scene), 5u);
}

}  // namespace
}  // namespace candela
