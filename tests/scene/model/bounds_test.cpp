// What the automatic camera frames: what is drawn, where it moves, and no outliers.

#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// The square from (-1, -1, 0) to (1, 1, 0).
Mesh square() {
    Mesh mesh;
    mesh.positions = {{-1.0f, -1.0f, 0.0f}, {1.0f, -1.0f, 0.0f}, {1.0f, 1.0f, 0.0f}, {-1.0f, 1.0f, 0.0f}};
    mesh.normals.assign(4, {0.0f, 0.0f, 1.0f});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.submeshes = {{0, 6, {}}};
    return mesh;
}

/// The square at each of the given places.
Scene squaresAt(const std::vector<glm::mat4>& places) {
    Scene scene;
    scene.meshes.push_back(square());
    for (const glm::mat4& place : places) {
        Node& node = scene.nodes.emplace_back();
        node.transform = place;
        node.mesh = 0;
    }
    return scene;
}

glm::mat4 at(float x, float y, float z) {
    return glm::translate(glm::mat4(1.0f), glm::vec3(x, y, z));
}

void expectBox(const Bounds& box, const glm::vec3& min, const glm::vec3& max) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_FLOAT_EQ(box.min[axis], min[axis]) << "axis " << axis;
        EXPECT_FLOAT_EQ(box.max[axis], max[axis]) << "axis " << axis;
    }
}

void expectSquare(const Bounds& box) {
    expectBox(box, {-1.0f, -1.0f, 0.0f}, {1.0f, 1.0f, 0.0f});
}

TEST(DrawnBounds, LeaveOutVerticesOfNoFace) {
    Scene scene = squaresAt({glm::mat4(1.0f)});
    scene.meshes[0].positions.emplace_back(1e6f, 0.0f, 0.0f);
    scene.meshes[0].normals.emplace_back(0.0f, 0.0f, 1.0f);
    expectSquare(worldBounds(scene, worldTransforms(scene)));
    expectSquare(nodeBounds(scene, 0, worldTransforms(scene)));
    expectSquare(framingBounds(scene));
    // Indices of no submesh are not drawn either.
    scene.meshes[0].indices.insert(scene.meshes[0].indices.end(), {0, 1, 4});
    expectSquare(worldBounds(scene, worldTransforms(scene)));
}

TEST(DrawnBounds, LeaveOutCagePointsOfNoFace) {
    Scene scene;
    Cage cage;
    cage.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1e6f, 0, 0}};
    cage.faceSizes = {4};
    cage.faceVertices = {0, 1, 2, 3};
    scene.cages.push_back(cage);
    scene.nodes.emplace_back().cage = 0;
    expectBox(worldBounds(scene, worldTransforms(scene)), glm::vec3(0.0f), {1.0f, 1.0f, 0.0f});
}

TEST(DrawnBounds, LeaveOutNodesThatFlattenEverything) {
    const auto scaled = [](float x, float y, float z) {
        return glm::scale(at(1000.0f, 0.0f, 0.0f), glm::vec3(x, y, z));
    };
    expectSquare(framingBounds(squaresAt({glm::mat4(1.0f), scaled(0.0f, 0.0f, 0.0f)})));
    expectSquare(framingBounds(squaresAt({glm::mat4(1.0f), scaled(2.0f, 0.0f, 0.0f)})));
    // A flat matrix still shows a square.
    expectBox(worldBounds(squaresAt({scaled(2.0f, 2.0f, 0.0f)}), {scaled(2.0f, 2.0f, 0.0f)}),
              {998.0f, -2.0f, 0.0f}, {1002.0f, 2.0f, 0.0f});
}

TEST(DrawnBounds, RefuseIndicesBeyondTheVertices) {
    Scene scene = squaresAt({glm::mat4(1.0f)});
    scene.meshes[0].indices[5] = 4;
    EXPECT_THROW(worldBounds(scene, worldTransforms(scene)), Error);
    EXPECT_THROW(framingBounds(scene), Error);
}

TEST(FramingBounds, LeaveOutOutliers) {
    Scene stray = squaresAt({glm::mat4(1.0f)});
    for (const glm::vec3& far : {glm::vec3(1e6f, 0, 0), glm::vec3(1e6f, 1, 0), glm::vec3(1e6f, 0, 1)}) {
        stray.meshes[0].positions.push_back(far);
        stray.meshes[0].normals.emplace_back(0.0f, 0.0f, 1.0f);
    }
    stray.meshes[0].indices.insert(stray.meshes[0].indices.end(), {4, 5, 6});
    stray.meshes[0].submeshes[0].indexCount = 9;
    expectSquare(framingBounds(stray));
    for (const float where : {-1e9f, -1e4f, 1e4f, 1e6f}) {
        SCOPED_TRACE(where);
        expectSquare(framingBounds(squaresAt({glm::mat4(1.0f), glm::mat4(1.0f), at(0.0f, where, 3.0f)})));
    }
}

TEST(FramingBounds, KeepWhatIsOnlyFarAway) {
    // Half of the vertices here and half there: neither is an outlier.
    expectBox(framingBounds(squaresAt({glm::mat4(1.0f), at(1e5f, 0.0f, 0.0f)})), {-1.0f, -1.0f, 0.0f},
              {1e5f + 1.0f, 1.0f, 0.0f});
    // A row that thins out.
    expectBox(framingBounds(squaresAt({glm::mat4(1.0f), at(3, 0, 0), at(50, 0, 0), at(2000, 0, 0)})),
              {-1.0f, -1.0f, 0.0f}, {2001.0f, 1.0f, 0.0f});
    // A ground a hundred times as wide as what stands on it.
    const glm::mat4 ground = glm::scale(glm::mat4(1.0f), glm::vec3(100.0f, 100.0f, 1.0f));
    expectBox(framingBounds(squaresAt({glm::mat4(1.0f), glm::mat4(1.0f), ground})), {-100.0f, -100.0f, 0.0f},
              {100.0f, 100.0f, 0.0f});
}

TEST(FramingBounds, AreEmptyWhereNothingIsDrawn) {
    EXPECT_TRUE(framingBounds({}).empty());
    EXPECT_TRUE(framingBounds(squaresAt({glm::scale(glm::mat4(1.0f), glm::vec3(0.0f))})).empty());
}

Animation moving(std::uint32_t node, AnimationPath path, std::vector<float> times,
                 std::vector<float> values) {
    return {"", {{node, path, Interpolation::linear, std::move(times), std::move(values)}}};
}

TEST(FramingBounds, HoldTheWholeMotion) {
    Scene scene = squaresAt({glm::mat4(1.0f), glm::mat4(1.0f)});
    scene.nodes[1].transform = Transform{};
    scene.animations.push_back(
        moving(1, AnimationPath::translation, {2.0f, 3.0f, 4.0f}, {0, 0, 0, 20, 0, 0, 0, 0, 5}));
    expectBox(framingBounds(scene), {-1.0f, -1.0f, 0.0f}, {21.0f, 1.0f, 5.0f});
}

TEST(FramingBounds, HoldTheMotionBetweenKeys) {
    // Half a turn about Y: in the middle the square's edges lie at z = -1 and 1.
    Scene scene = squaresAt({glm::mat4(1.0f)});
    scene.nodes[0].transform = Transform{};
    scene.animations.push_back(moving(0, AnimationPath::rotation, {0.0f, 1.0f}, {0, 0, 0, 1, 0, 1, 0, 0}));
    const Bounds box = framingBounds(scene);
    EXPECT_NEAR(box.min.z, -1.0f, 1e-6f);
    EXPECT_NEAR(box.max.z, 1.0f, 1e-6f);
}

TEST(FramingBounds, HoldMorphTargets) {
    Scene scene;
    Cage cage;
    cage.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    cage.faceSizes = {4};
    cage.faceVertices = {0, 1, 2, 3};
    cage.morphTargets.push_back({{{0, 0, 0}, {0, 0, 3}, {0, 0, 0}, {0, 0, 0}}});
    scene.cages.push_back(cage);
    scene.nodes.emplace_back().cage = 0;
    scene.animations.push_back(moving(0, AnimationPath::morphWeights, {0.0f, 1.0f, 2.0f}, {0, 1, 0}));
    expectBox(framingBounds(scene), glm::vec3(0.0f), {1.0f, 1.0f, 3.0f});
}

TEST(DefaultNearPlane, IsAHundredthOfASmallScene) {
    EXPECT_FLOAT_EQ(defaultNearPlane({}), 0.01f);
    EXPECT_FLOAT_EQ(defaultNearPlane({glm::vec3(3.0f), glm::vec3(3.0f)}), 0.01f);
    EXPECT_FLOAT_EQ(defaultNearPlane({glm::vec3(0.0f), glm::vec3(1000.0f)}), 0.01f);
    EXPECT_FLOAT_EQ(defaultNearPlane({glm::vec3(0.0f), glm::vec3(0.001f)}), 1e-5f * std::sqrt(3.0f));
    EXPECT_THROW(defaultNearPlane({glm::vec3(0.0f), glm::vec3(INFINITY)}), Error);
}

TEST(CameraView, TakesTheNearPlaneOfTheSceneWhereTheCameraHasNone) {
    Scene scene = squaresAt({glm::scale(glm::mat4(1.0f), glm::vec3(1e-3f))});
    scene.cameras.emplace_back();
    EXPECT_FLOAT_EQ(cameraView(scene, 0, worldTransforms(scene)).nearPlane, 2e-5f * std::sqrt(2.0f));
}

TEST(FrameBounds, ShowsTheWholeBoxAtEveryFieldOfView) {
    const Bounds box{{-3.0f, 0.0f, -1.0f}, {3.0f, 2.0f, 1.0f}};
    for (const float fov : {0.05f, 0.5f, 1.5f, 3.0f}) {
        const CameraView view = frameBounds(box, 1.5f, fov);
        EXPECT_EQ(view.verticalFov, fov);
        float reach = 0.0f;
        for (int i = 0; i < 8; ++i) {
            const glm::vec4 corner((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                                   (i & 4) != 0 ? box.max.z : box.min.z, 1.0f);
            const glm::vec4 clip = projection(view, 1.5f) * glm::inverse(view.worldFromCamera) * corner;
            EXPECT_GT(clip.w, view.nearPlane);
            reach = std::max({reach, std::abs(clip.x) / clip.w, std::abs(clip.y) / clip.w});
        }
        EXPECT_LT(reach, 1.0f) << fov;
        EXPECT_GT(reach, 0.9f) << fov;
    }
    EXPECT_THROW(frameBounds(box, 1.0f, 0.0f), Error);
    EXPECT_THROW(frameBounds(box, 1.0f, pi), Error);
}

}  // namespace
}  // namespace candela
