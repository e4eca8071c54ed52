#include <candela/camera.h>
#include <candela/error.h>
#include <candela/scene.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace candela {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
// A few roundings of single precision on numbers near 1.
constexpr float rounding = 1e-6f;

void expectNear(const glm::vec3& actual, const glm::vec3& expected, float tolerance) {
    EXPECT_LE(glm::distance(actual, expected), tolerance)
        << actual.x << ' ' << actual.y << ' ' << actual.z << " is not " << expected.x << ' ' << expected.y
        << ' ' << expected.z;
}

void expectRigid(const glm::mat4& matrix) {
    const glm::mat3 axes(matrix);
    const glm::mat3 product = glm::transpose(axes) * axes;
    for (int i = 0; i < 3; ++i) expectNear(product[i], glm::mat3(1.0f)[i], rounding);
    EXPECT_NEAR(glm::determinant(axes), 1.0f, rounding);
    EXPECT_EQ(glm::vec4(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]), glm::vec4(0, 0, 0, 1));
}

// Normalised device coordinates of a world position.
glm::vec3 project(const CameraView& view, float aspect, const glm::vec3& position) {
    const glm::vec4 clip =
        projection(view, aspect) * glm::inverse(view.worldFromCamera) * glm::vec4(position, 1.0f);
    return glm::vec3(clip) / clip.w;
}

TEST(LookAt, IsAtTheEyeAndLooksAlongMinusZ) {
    const CameraView view = lookAt({1.0f, 2.0f, 3.0f}, {4.0f, 6.0f, 3.0f}, 1.0f);
    expectRigid(view.worldFromCamera);
    EXPECT_EQ(view.eye(), glm::vec3(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(view.verticalFov, 1.0f);
    expectNear(-glm::vec3(view.worldFromCamera[2]), {0.6f, 0.8f, 0.0f}, rounding);
    expectNear(glm::vec3(view.worldFromCamera[1]), {-0.8f, 0.6f, 0.0f}, rounding);
    expectNear(glm::vec3(view.worldFromCamera[0]), {0.0f, 0.0f, 1.0f}, rounding);
}

TEST(LookAt, HasZUpWhenLookingAlongY) {
    for (const float side : {-1.0f, 1.0f}) {
        const CameraView view = lookAt(glm::vec3(0.0f), {0.0f, side * 3.0f, 0.0f}, 1.0f);
        expectRigid(view.worldFromCamera);
        expectNear(-glm::vec3(view.worldFromCamera[2]), {0.0f, side, 0.0f}, rounding);
        expectNear(glm::vec3(view.worldFromCamera[1]), {0.0f, 0.0f, 1.0f}, rounding);
    }
}

TEST(LookAt, RefusesInvalidViews) {
    const glm::vec3 eye(1.0f), target(2.0f);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(lookAt(eye, eye, 1.0f), Error);
    EXPECT_THROW(lookAt({nan, 0.0f, 0.0f}, target, 1.0f), Error);
    EXPECT_THROW(lookAt(eye, {0.0f, 0.0f, INFINITY}, 1.0f), Error);
    EXPECT_THROW(lookAt(eye, target, 0.0f), Error);
    EXPECT_THROW(lookAt(eye, target, pi), Error);
    EXPECT_THROW(lookAt(eye, target, nan), Error);
}

TEST(LookAt, AcceptsVerySmallAndLargeDistances) {
    expectRigid(lookAt(glm::vec3(3e38f, 0.0f, 0.0f), glm::vec3(-3e38f, 0.0f, 1.0f), 1.0f).worldFromCamera);
    expectRigid(lookAt(glm::vec3(0.0f), glm::vec3(1e-40f, 0.0f, 0.0f), 1.0f).worldFromCamera);
}

TEST(Projection, ReversesDepthWithoutAFarPlane) {
    CameraView view;
    view.nearPlane = 0.25f;
    view.verticalFov = pi / 2.0f;
    const float aspect = 2.0f;
    // The top right corner of the near plane.
    expectNear(project(view, aspect, {0.5f, 0.25f, -0.25f}), {1.0f, 1.0f, 1.0f}, rounding);
    expectNear(project(view, aspect, {-2.0f, -1.0f, -1.0f}), {-1.0f, -1.0f, 0.25f}, rounding);
    const glm::vec4 infinitelyFar = projection(view, aspect) * glm::vec4(0.0f, 0.0f, -1.0f, 0.0f);
    EXPECT_EQ(infinitelyFar.z / infinitelyFar.w, 0.0f);
}

TEST(Projection, EndsAtTheFarPlane) {
    CameraView view;
    view.nearPlane = 0.25f;
    view.farPlane = 4.0f;
    EXPECT_FLOAT_EQ(project(view, 1.0f, {0.0f, 0.0f, -4.0f}).z, 0.0f);
    EXPECT_FLOAT_EQ(project(view, 1.0f, {0.0f, 0.0f, -1.0f}).z, 0.2f);
    EXPECT_FLOAT_EQ(project(view, 1.0f, {0.0f, 0.0f, -0.25f}).z, 1.0f);
    EXPECT_LT(project(view, 1.0f, {0.0f, 0.0f, -4.1f}).z, 0.0f);
    view.farPlane = 0.25f;
    EXPECT_THROW(projection(view, 1.0f), Error);
}

TEST(Projection, OrthographicDepthIsLinear) {
    CameraView view;
    view.orthographicHeight = 3.0f;
    EXPECT_THROW(projection(view, 2.0f), Error) << "there is no far plane";
    view.nearPlane = 0.0f;
    view.farPlane = 8.0f;
    expectNear(project(view, 2.0f, {3.0f, 1.5f, 0.0f}), {1.0f, 1.0f, 1.0f}, rounding);
    expectNear(project(view, 2.0f, {-1.5f, -0.75f, -2.0f}), {-0.5f, -0.5f, 0.75f}, rounding);
    expectNear(project(view, 2.0f, {0.0f, 0.0f, -8.0f}), {0.0f, 0.0f, 0.0f}, rounding);
    view.orthographicHeight = 0.0f;
    EXPECT_THROW(projection(view, 1.0f), Error);
}

TEST(CameraView, HasTheLensOfTheCamera) {
    Scene scene;
    scene.cameras.push_back({.name = "plan", .orthographicHeight = 2.5f, .farPlane = 10.0f});
    CameraView view = cameraView(scene, 0, {});
    EXPECT_EQ(view.orthographicHeight, 2.5f);
    EXPECT_EQ(view.nearPlane, 0.0f);
    EXPECT_EQ(view.farPlane, 10.0f);
    scene.cameras[0] = {.name = "short", .farPlane = 0.005f};
    view = cameraView(scene, 0, {});
    EXPECT_LT(view.nearPlane, 0.005f);
    scene.cameras[0] = {.name = "wrong", .nearPlane = 2.0f, .farPlane = 1.0f};
    EXPECT_THROW(cameraView(scene, 0, {}), Error);
}

TEST(CameraView, HasTheFrameOfItsNodeWithoutScale) {
    Scene scene;
    scene.nodes.resize(2);
    Transform parent;
    parent.translation = {5.0f, 0.0f, 0.0f};
    parent.scale = {2.0f, 3.0f, 0.5f};
    scene.nodes[0].transform = parent;
    Transform child;
    child.translation = {1.0f, 1.0f, 1.0f};
    child.rotation = glm::angleAxis(pi / 2.0f, glm::vec3(0.0f, 1.0f, 0.0f));  // Looks along -X.
    scene.nodes[1].transform = child;
    scene.nodes[1].parent = 0;
    scene.cameras.push_back({.name = "eye", .verticalFov = 0.7f, .nearPlane = 0.3f, .node = 1});
    const CameraView view = cameraView(scene, 0, worldTransforms(scene));
    expectRigid(view.worldFromCamera);
    expectNear(view.eye(), {7.0f, 3.0f, 0.5f}, rounding);
    expectNear(-glm::vec3(view.worldFromCamera[2]), {-1.0f, 0.0f, 0.0f}, rounding);
    EXPECT_EQ(view.verticalFov, 0.7f);
    EXPECT_EQ(view.nearPlane, 0.3f);
}

TEST(CameraView, IsRigidForMirroringShearAndSingularMatrices) {
    Scene scene;
    scene.nodes.resize(1);
    scene.cameras.emplace_back().node = 0;
    glm::mat4 shear(1.0f);
    shear[1] = {0.7f, 1.0f, 0.2f, 0.0f};
    glm::mat4 flat(1.0f);
    flat[2] = glm::vec4(0.0f);
    glm::mat4 zero(0.0f);
    zero[3] = {1.0f, 2.0f, 3.0f, 1.0f};
    glm::mat4 tiny = glm::scale(glm::mat4(1.0f), glm::vec3(1e-30f));
    for (const glm::mat4& matrix :
         {glm::scale(glm::mat4(1.0f), glm::vec3(-1.0f, 1.0f, 1.0f)), shear, flat, zero, tiny}) {
        scene.nodes[0].transform = matrix;
        const CameraView view = cameraView(scene, 0, worldTransforms(scene));
        expectRigid(view.worldFromCamera);
        expectNear(glm::vec3(view.worldFromCamera[2]), {0.0f, 0.0f, 1.0f}, rounding);
        EXPECT_EQ(view.eye(), glm::vec3(matrix[3]));
    }
}

TEST(CameraView, WithoutANodeIsTheWorldsFrame) {
    Scene scene;
    scene.cameras.push_back({});
    EXPECT_EQ(cameraView(scene, 0, {}).worldFromCamera, glm::mat4(1.0f));
}

TEST(FrameBounds, ContainsTheWholeBoxAtEveryAspectRatio) {
    const Bounds boxes[] = {
        {glm::vec3(-1.0f), glm::vec3(1.0f)},
        {{-100.0f, 0.0f, -100.0f}, {100.0f, 0.1f, 100.0f}},
        {{3.0f, -2.0f, 7.0f}, {3.0f, 40.0f, 7.0f}},
        {{1000.0f, 1000.0f, 1000.0f}, {1000.5f, 1000.25f, 1001.0f}},
        {glm::vec3(-1e-3f), glm::vec3(1e-3f)},
        {glm::vec3(-1e8f), glm::vec3(1e9f)},
    };
    for (const Bounds& box : boxes) {
        for (const float aspect : {0.2f, 1.0f, 16.0f / 9.0f, 8.0f}) {
            const CameraView view = frameBounds(box, aspect);
            expectRigid(view.worldFromCamera);
            EXPECT_FLOAT_EQ(view.verticalFov, pi / 4.0f);
            float maxExtent = 0.0f;
            for (int i = 0; i < 8; ++i) {
                const glm::vec3 corner((i & 1) != 0 ? box.max.x : box.min.x,
                                       (i & 2) != 0 ? box.max.y : box.min.y,
                                       (i & 4) != 0 ? box.max.z : box.min.z);
                const glm::vec3 projected = project(view, aspect, corner);
                maxExtent = std::max({maxExtent, std::abs(projected.x), std::abs(projected.y)});
                EXPECT_GT(projected.z, 0.0f) << "behind the eye";
                EXPECT_LT(projected.z, 1.0f) << "in front of the near plane";
            }
            EXPECT_LT(maxExtent, 1.0f);
            EXPECT_GT(maxExtent, 0.9f) << "the box is needlessly small";
        }
    }
}

TEST(FrameBounds, LooksFromTheFrontTheRightAndAbove) {
    const CameraView view = frameBounds({glm::vec3(-1.0f), glm::vec3(1.0f)}, 1.0f);
    EXPECT_GT(view.eye().z, view.eye().x);
    EXPECT_GT(view.eye().x, 0.0f);
    EXPECT_GT(view.eye().y, 0.0f);
}

TEST(FrameBounds, OfAPointHasADistance) {
    for (const float coordinate : {0.0f, 1.0f, 1e9f}) {
        const CameraView view = frameBounds({glm::vec3(coordinate), glm::vec3(coordinate)}, 1.0f);
        expectRigid(view.worldFromCamera);
        EXPECT_GT(view.nearPlane, 0.0f);
        EXPECT_LT(view.nearPlane, glm::distance(view.eye(), glm::vec3(coordinate)));
    }
}

TEST(FrameBounds, OfAnEmptyBoxIsTheDefaultView) {
    const CameraView view = frameBounds({}, 1.0f);
    EXPECT_EQ(view.eye(), glm::vec3(0.0f, 0.0f, 5.0f));
    expectNear(-glm::vec3(view.worldFromCamera[2]), {0.0f, 0.0f, -1.0f}, rounding);
}

}  // namespace
}  // namespace candela
