// How pointer drags and keys move the camera.

#include "camera_control.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

constexpr float pi = std::numbers::pi_v<float>;

CameraControl cameraAt(const glm::vec3& eye, const glm::vec3& target) {
    CameraControl camera;
    camera.lookAt(eye, target);
    return camera;
}

/// The position of a point in the image, in image heights from the centre, x to the right, y up.
glm::vec2 imagePosition(const CameraControl& camera, const glm::vec3& point) {
    const candela::CameraView view = camera.view();
    const glm::vec3 seen(glm::inverse(view.worldFromCamera) * glm::vec4(point, 1.0f));
    return glm::vec2(seen) / (-seen.z * 2.0f * std::tan(0.5f * view.verticalFov));
}

bool isFinite(const CameraControl& camera) {
    const candela::CameraView view = camera.view();
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(view.worldFromCamera[column][row])) return false;
    return true;
}

TEST(Orbit, KeepsTargetAndDistance) {
    CameraControl camera = cameraAt({3.0f, 2.0f, 6.0f}, {1.0f, 0.0f, 0.0f});
    const float distance = glm::distance(camera.eye(), camera.target());
    for (int i = 0; i < 1000; ++i) camera.orbit({0.013f, 0.007f * std::sin(0.1f * static_cast<float>(i))});
    EXPECT_EQ(camera.target(), glm::vec3(1.0f, 0.0f, 0.0f));
    // A thousand rotations, each rounded in single precision.
    EXPECT_NEAR(glm::distance(camera.eye(), camera.target()), distance, 1.0e-3f);
}

TEST(Orbit, RotatesTheSceneWithThePointer) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.orbit({0.1f, 0.0f});
    // The near side of the scene follows to the right, so the eye moves left.
    EXPECT_LT(camera.eye().x, 0.0f);
    EXPECT_GT(imagePosition(camera, {0.0f, 0.0f, 1.0f}).x, 0.0f);
    camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.orbit({0.0f, 0.1f});  // y grows downwards on a screen
    EXPECT_GT(camera.eye().y, 0.0f);
    EXPECT_LT(imagePosition(camera, {0.0f, 0.0f, 1.0f}).y, 0.0f);
}

TEST(Orbit, ADragOverTheWindowsHeightIs180Degrees) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.orbit({1.0f, 0.0f});
    // Rounding of an angle in single precision, times 5 m.
    EXPECT_LT(glm::distance(camera.eye(), {0.0f, 0.0f, -5.0f}), 1.0e-5f);
}

TEST(Orbit, StopsAtThePolesWithoutFlipping) {
    for (const float drag : {0.05f, -0.05f}) {
        CameraControl camera = cameraAt({0.0f, 1.0f, 5.0f}, glm::vec3(0.0f));
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 right(camera.view().worldFromCamera[0]);
            camera.orbit({0.0f, drag});
            ASSERT_TRUE(isFinite(camera));
            // The camera does not flip: its right axis keeps its direction.
            ASSERT_GT(glm::dot(right, glm::vec3(camera.view().worldFromCamera[0])), 0.999f) << i;
        }
        // Nearly above, or below.
        EXPECT_GT(std::abs(camera.eye().y), 4.99f);
        camera.orbit({0.0f, -10.0f * drag});
        EXPECT_LT(std::abs(camera.eye().y), 1.0f);
    }
}

TEST(Pan, MovesTheTargetWithThePointer) {
    CameraControl camera = cameraAt({2.0f, 3.0f, 6.0f}, {0.5f, 1.0f, -1.0f});
    const glm::vec3 target = camera.target(), back = camera.eye() - camera.target();
    camera.pan({0.2f, -0.1f});
    // y grows downwards on a screen and upwards in the picture. Rounding in single precision.
    EXPECT_LT(glm::distance(imagePosition(camera, target), {0.2f, 0.1f}), 1.0e-5f);
    EXPECT_LT(glm::distance(camera.eye() - camera.target(), back), 1.0e-5f);
}

TEST(Dolly, ApproachesTheTargetButNeverReachesIt) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.dolly(1.0f);
    EXPECT_LT(camera.eye().z, 5.0f);
    camera.dolly(-1.0f);
    EXPECT_NEAR(camera.eye().z, 5.0f, 1.0e-5f);  // rounding
    for (int i = 0; i < 1000; ++i) camera.dolly(1.0f);
    EXPECT_GT(camera.eye().z, 0.0f);
    EXPECT_TRUE(isFinite(camera));
    for (int i = 0; i < 150; ++i) camera.dolly(-1.0f);
    EXPECT_GT(camera.eye().z, 1.0f);
}

TEST(LookAround, KeepsTheEye) {
    CameraControl camera = cameraAt({1.0f, 2.0f, 3.0f}, {0.0f, 2.0f, 0.0f});
    const glm::vec3 ahead = camera.target();
    camera.lookAround({0.1f, 0.0f});
    EXPECT_EQ(camera.eye(), glm::vec3(1.0f, 2.0f, 3.0f));
    // The view rotates with the pointer, so the former target moves to the left.
    EXPECT_LT(imagePosition(camera, ahead).x, 0.0f);
    camera.lookAround({-0.1f, 0.1f});
    EXPECT_GT(imagePosition(camera, ahead).y, 0.0f) << "it looks down";
    for (int i = 0; i < 100; ++i) camera.lookAround({0.0f, 0.05f});
    EXPECT_TRUE(isFinite(camera));
}

TEST(Fly, MovesAlongTheViewDirection) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 1.0f});
    camera.fly({0.0f, 0.0f, -1.0f}, 2.0f);
    EXPECT_LT(glm::distance(camera.eye(), {0.0f, 0.0f, 3.0f}), 1.0e-6f);      // rounding
    EXPECT_LT(glm::distance(camera.target(), {0.0f, 0.0f, -1.0f}), 1.0e-6f);  // rounding
    camera.fly({1.0f, 0.0f, 0.0f}, 0.5f);
    EXPECT_LT(glm::distance(camera.eye(), {0.5f, 0.0f, 3.0f}), 1.0e-6f);  // rounding
}

candela::Bounds box(const glm::vec3& min, const glm::vec3& max) {
    candela::Bounds bounds;
    bounds.min = min;
    bounds.max = max;
    return bounds;
}

TEST(Frame, FitsTheWholeBoxIntoTheView) {
    const candela::Bounds bounds = box({-3.0f, 1.0f, 2.0f}, {5.0f, 2.0f, 20.0f});
    for (const float aspect : {0.2f, 1.0f, 2.5f}) {
        for (const float fov : {10.0f, 45.0f, 120.0f}) {
            CameraControl camera = cameraAt({7.0f, 9.0f, -4.0f}, {1.0f, 0.0f, 0.0f});
            camera.setVerticalFov(glm::radians(fov));
            const glm::vec3 ahead = glm::normalize(camera.target() - camera.eye());
            camera.frame(bounds, aspect);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::vec3 point(corner & 1 ? bounds.max.x : bounds.min.x,
                                      corner & 2 ? bounds.max.y : bounds.min.y,
                                      corner & 4 ? bounds.max.z : bounds.min.z);
                const glm::vec2 position = imagePosition(camera, point);
                EXPECT_LE(std::abs(position.y), 0.5f) << fov << " degrees, " << aspect;
                EXPECT_LE(std::abs(position.x), 0.5f * aspect) << fov << " degrees, " << aspect;
            }
            // The view direction is kept; rounding in single precision.
            EXPECT_GT(glm::dot(ahead, glm::normalize(camera.target() - camera.eye())), 0.99999f);
        }
    }
}

TEST(Frame, AcceptsAPointAndIgnoresAnEmptyBox) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.frame(candela::Bounds(), 1.0f);
    EXPECT_EQ(camera.eye(), glm::vec3(0.0f, 0.0f, 5.0f));
    camera.frame(box(glm::vec3(2.0f), glm::vec3(2.0f)), 1.0f);
    EXPECT_EQ(camera.target(), glm::vec3(2.0f));
    EXPECT_TRUE(isFinite(camera));
}

TEST(Orthographic, DollyPanAndFrameFollowTheHeight) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.setOrthographicHeight(4.0f);
    EXPECT_EQ(camera.heightAtTarget(), 4.0f);
    camera.pan({0.25f, 0.0f});
    EXPECT_FLOAT_EQ(camera.target().x, -1.0f);
    camera.dolly(2.0f);
    EXPECT_FLOAT_EQ(*camera.orthographicHeight(), 4.0f * 0.81f);
    EXPECT_EQ(camera.view().orthographicHeight, camera.orthographicHeight());
    camera.frame(box(glm::vec3(-1.0f), glm::vec3(1.0f)), 0.5f);
    EXPECT_FLOAT_EQ(*camera.orthographicHeight(), 4.0f * std::sqrt(3.0f));
    camera.setOrthographicHeight(std::nullopt);
    EXPECT_FALSE(camera.view().orthographicHeight);
}

TEST(Dolly, ApproachesSmallThings) {
    CameraControl camera = cameraAt({0.0f, 0.0f, 5.0f}, glm::vec3(0.0f));
    camera.dolly(120.0f);
    EXPECT_LT(camera.eye().z, 1.0e-4f);
    EXPECT_TRUE(isFinite(camera));
    camera = cameraAt({1000.0f, 0.0f, 5.0f}, {1000.0f, 0.0f, 0.0f});
    camera.dolly(1000.0f);
    EXPECT_TRUE(isFinite(camera));
}

TEST(Set, ReproducesAView) {
    const candela::CameraView view = candela::lookAt({1.0f, 2.0f, 3.0f}, {4.0f, 0.0f, -2.0f}, 0.3f * pi);
    CameraControl camera;
    camera.set(view, 7.0f);
    EXPECT_EQ(camera.verticalFov(), view.verticalFov);
    EXPECT_EQ(camera.eye(), view.eye());
    EXPECT_NEAR(glm::distance(camera.eye(), camera.target()), 7.0f, 1.0e-5f);  // rounding
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            EXPECT_NEAR(camera.view().worldFromCamera[column][row], view.worldFromCamera[column][row],
                        1.0e-5f);
}

}  // namespace
