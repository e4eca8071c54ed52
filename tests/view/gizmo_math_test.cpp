// Drags of a gizmo, against points that are computed by hand.

#include "gizmo_math.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace {

/// Single precision, over a few products of matrices.
constexpr float rounding = 1.0e-4f;

/// A camera at (0, 0, 10) that looks along -Z with a field of view of 90 degrees, on a screen of 200 x 100:
/// at the origin, 10 units are 2 m.
candela::CameraView front() {
    return candela::lookAt({0.0f, 0.0f, 10.0f}, glm::vec3(0.0f), 0.5f * std::numbers::pi_v<float>);
}

ScreenView screen(const candela::CameraView& view = front()) {
    return {view, {30.0f, 20.0f}, {200.0f, 100.0f}};
}

constexpr glm::vec2 middle{130.0f, 70.0f};

void expectNear(const glm::vec3& a, const glm::vec3& b) {
    EXPECT_LT(glm::distance(a, b), rounding) << a.x << " " << a.y << " " << a.z;
}

glm::vec3 moved(const glm::mat4& change, const glm::vec3& point) {
    return glm::vec3(change * glm::vec4(point, 1.0f));
}

TEST(ScreenView, ProjectsAndCastsRays) {
    const ScreenView view = screen();
    EXPECT_LT(glm::distance(*view.at(glm::vec3(0.0f)), middle), rounding);
    EXPECT_LT(glm::distance(*view.at({2.0f, 1.0f, 0.0f}), middle + glm::vec2(10.0f, -5.0f)), rounding);
    EXPECT_FALSE(view.at({0.0f, 0.0f, 11.0f})) << "behind the camera";
    EXPECT_NEAR(view.metresAt(glm::vec3(0.0f), 10.0f), 2.0f, rounding);
}

/// For each kind of camera, a ray through the place of a point passes through the point.
TEST(ScreenView, RaysPassThroughWhatTheyShow) {
    candela::CameraView shifted = front(), orthographic = front(), both = front();
    shifted.shift = {0.2f, -0.1f};
    orthographic.orthographicHeight = 8.0f;
    both.orthographicHeight = 8.0f;
    both.shift = {0.2f, -0.1f};
    const glm::vec3 point(1.3f, -0.7f, 2.0f);
    for (const candela::CameraView& camera : {front(), shifted, orthographic, both}) {
        const ScreenView view = screen(camera);
        const ScreenView::Ray ray = view.rayAt(*view.at(point));
        const float along = glm::dot(point - ray.origin, ray.direction);
        EXPECT_GT(along, 0.0f);
        expectNear(ray.origin + along * ray.direction, point);
    }
}

TEST(Gizmo, MovesAlongAnAxisOnly) {
    const GizmoShape shape{glm::vec3(0.0f), 2.0f};
    // 10 to the right and 7 up.
    const glm::vec2 to = middle + glm::vec2(10.0f, -7.0f);
    const glm::mat4 x = dragged(screen(), shape, GizmoMode::move, GizmoHandle::x, middle, {to.x, middle.y});
    expectNear(moved(x, glm::vec3(0.0f)), {2.0f, 0.0f, 0.0f});
    const glm::mat4 y = dragged(screen(), shape, GizmoMode::move, GizmoHandle::y, middle, {middle.x, to.y});
    expectNear(moved(y, glm::vec3(0.0f)), {0.0f, 1.4f, 0.0f});
    const glm::mat4 free = dragged(screen(), shape, GizmoMode::move, GizmoHandle::middle, middle, to);
    expectNear(moved(free, glm::vec3(0.0f)), {2.0f, 1.4f, 0.0f});
    // Beside the axis, its point nearest to the ray: still on it.
    const glm::vec3 beside =
        moved(dragged(screen(), shape, GizmoMode::move, GizmoHandle::x, middle, to), glm::vec3(0.0f));
    EXPECT_NEAR(beside.x, 2.0f, 0.1f);
    EXPECT_EQ(beside.y, 0.0f);
    EXPECT_EQ(beside.z, 0.0f);
    const glm::mat4 z = dragged(screen(), shape, GizmoMode::move, GizmoHandle::z, middle, to);
    expectNear(moved(z, glm::vec3(0.0f)), glm::vec3(0.0f));
}

TEST(Gizmo, TurnsAboutItsOrigin) {
    const GizmoShape shape{{1.0f, 0.0f, 0.0f}, 2.0f};
    const glm::vec2 origin = middle + glm::vec2(5.0f, 0.0f);
    // A quarter from the right to above.
    const glm::mat4 change = dragged(screen(), shape, GizmoMode::turn, GizmoHandle::z,
                                     origin + glm::vec2(10.0f, 0.0f), origin - glm::vec2(0.0f, 10.0f));
    expectNear(moved(change, {3.0f, 0.0f, 0.0f}), {1.0f, 2.0f, 0.0f});
    expectNear(moved(change, shape.origin), shape.origin);
}

TEST(Gizmo, ScalesAnAxisOrAll) {
    const GizmoShape shape{glm::vec3(0.0f), 2.0f};
    const glm::vec2 end = middle + glm::vec2(10.0f, 0.0f);
    const glm::mat4 x =
        dragged(screen(), shape, GizmoMode::scale, GizmoHandle::x, end, end + glm::vec2(5.0f, 0.0f));
    expectNear(moved(x, glm::vec3(1.0f)), {1.5f, 1.0f, 1.0f});
    const glm::mat4 all = dragged(screen(), shape, GizmoMode::scale, GizmoHandle::middle, middle, end);
    expectNear(moved(all, glm::vec3(1.0f)), glm::vec3(2.0f));
    const glm::mat4 least = dragged(screen(), shape, GizmoMode::scale, GizmoHandle::middle, middle,
                                    middle - glm::vec2(90.0f, 0.0f));
    EXPECT_GT(moved(least, glm::vec3(1.0f)).x, 0.0f) << "nothing is turned inside out";
}

TEST(Gizmo, FindsTheHandleUnderThePointer) {
    const GizmoShape shape{glm::vec3(0.0f), 4.0f};
    const auto at = [&](GizmoMode mode, const glm::vec2& offset) {
        return handleAt(screen(), shape, mode, middle + offset, 3.0f);
    };
    EXPECT_EQ(at(GizmoMode::move, {1.0f, 1.0f}), GizmoHandle::middle);
    EXPECT_EQ(at(GizmoMode::move, {15.0f, 1.0f}), GizmoHandle::x);
    EXPECT_EQ(at(GizmoMode::scale, {-1.0f, -15.0f}), GizmoHandle::y);
    EXPECT_EQ(at(GizmoMode::move, {15.0f, 15.0f}), std::nullopt);
    // The circle about Z faces the camera.
    const float diagonal = 20.0f / std::numbers::sqrt2_v<float>;
    EXPECT_EQ(at(GizmoMode::turn, {diagonal, diagonal}), GizmoHandle::z);
}

}  // namespace
