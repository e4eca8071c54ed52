// Views from projection matrices, intrinsics, pairs of eyes and cubes.

#include <candela/camera.h>
#include <candela/error.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace candela {
namespace {

// Some roundings of single precision of numbers near 1: of the matrix, of the view and of its projection.
constexpr float rounding = 4e-6f;

void expectRefused(const glm::mat4& matrix, ClipDepth depth, const std::string& part) {
    try {
        viewOfProjection(glm::mat4(1.0f), matrix, depth);
        ADD_FAILURE() << "no error, expected: " << part;
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::badInput);
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

/// x / w, y / w and w in camera space.
glm::vec3 onScreen(const glm::mat4& clipFromCamera, const glm::vec3& point) {
    const glm::vec4 clip = clipFromCamera * glm::vec4(point, 1.0f);
    return {clip.x / clip.w, clip.y / clip.w, clip.w};
}

void expectSamePicture(const glm::mat4& host, const CameraView& view) {
    const glm::mat4 own = projection(view, 1.0f) * glm::inverse(view.worldFromCamera);
    for (const float x : {-0.7f, 0.1f, 0.9f}) {
        for (const float depth : {0.6f, 3.0f, 9.0f}) {
            const glm::vec3 expected = onScreen(host, {x, 0.4f, -depth}),
                            is = onScreen(own, {x, 0.4f, -depth});
            EXPECT_NEAR(is.x, expected.x, rounding * (1.0f + std::abs(expected.x)));
            EXPECT_NEAR(is.y, expected.y, rounding * (1.0f + std::abs(expected.y)));
        }
    }
}

/// Reversed depth of a matrix whose depth is 0 to 1.
glm::mat4 reversed(glm::mat4 matrix) {
    for (int column = 0; column < 4; ++column) matrix[column][2] = matrix[column][3] - matrix[column][2];
    return matrix;
}

TEST(ViewOfProjection, IsWhatThePerspectiveMatrixShows) {
    // glFrustum's matrices: off-centre, with a pixel aspect of their own.
    const glm::mat4 classic = glm::frustumRH_NO(-0.3f, 0.5f, -0.1f, 0.2f, 0.25f, 40.0f);
    const glm::mat4 vulkan = glm::frustumRH_ZO(-0.3f, 0.5f, -0.1f, 0.2f, 0.25f, 40.0f);
    const std::array matrices{std::pair(classic, ClipDepth::negativeOneToOne),
                              std::pair(vulkan, ClipDepth::zeroToOne),
                              std::pair(reversed(vulkan), ClipDepth::oneToZero)};
    for (const auto& [matrix, depth] : matrices) {
        const CameraView view = viewOfProjection(glm::mat4(1.0f), matrix, depth);
        EXPECT_NEAR(view.nearPlane, 0.25f, 0.25f * rounding);
        ASSERT_TRUE(view.farPlane);
        // 1 + slope has lost the digits of far / near.
        EXPECT_NEAR(*view.farPlane, 40.0f, 40.0f * 160.0f * 1.2e-7f);
        EXPECT_NEAR(*view.aspect, 0.8f / 0.3f, rounding * 3.0f);
        EXPECT_NEAR(view.shift.x, 0.1f / 0.8f, rounding);
        EXPECT_NEAR(view.shift.y, 0.05f / 0.3f, rounding);
        expectSamePicture(matrix, view);
    }
}

TEST(ViewOfProjection, FarPlanesAtInfinityAreNone) {
    const glm::mat4 classic = glm::infinitePerspective(0.9f, 1.5f, 0.1f);
    const CameraView view = viewOfProjection(glm::mat4(1.0f), classic, ClipDepth::negativeOneToOne);
    EXPECT_FALSE(view.farPlane);
    EXPECT_NEAR(view.nearPlane, 0.1f, 0.1f * rounding);
    EXPECT_NEAR(view.verticalFov, 0.9f, rounding);
    // candela's own projection comes back.
    const CameraView again = viewOfProjection(glm::mat4(1.0f), projection(view, 7.0f), ClipDepth::oneToZero);
    EXPECT_FALSE(again.farPlane);
    EXPECT_NEAR(again.nearPlane, view.nearPlane, 0.1f * rounding);
    EXPECT_NEAR(*again.aspect, 1.5f, 1.5f * rounding) << "the view's own, not that of the pixels";
}

TEST(ViewOfProjection, OrthographicEyesGoBackToTheNearPlane) {
    const glm::mat4 host = glm::orthoRH_NO(-1.0f, 3.0f, -0.5f, 1.5f, -2.0f, 10.0f);
    const CameraView view = viewOfProjection(glm::mat4(1.0f), host, ClipDepth::negativeOneToOne);
    EXPECT_NEAR(*view.orthographicHeight, 2.0f, 2.0f * rounding);
    EXPECT_NEAR(view.eye().z, 2.0f, 4.0f * rounding);
    EXPECT_EQ(view.nearPlane, 0.0f);
    EXPECT_NEAR(*view.farPlane, 12.0f, 12.0f * rounding);
    expectSamePicture(host, view);
}

TEST(ViewOfProjection, RefusesWhatIsNoViewAndSaysWhy) {
    const glm::mat4 good = glm::perspectiveRH_NO(0.9f, 1.5f, 0.1f, 50.0f);
    const auto with = [&](int column, int row, float value) {
        glm::mat4 bad = good;
        bad[column][row] = value;
        return bad;
    };
    constexpr ClipDepth depth = ClipDepth::negativeOneToOne;
    expectRefused(with(0, 0, NAN), depth, "finite");
    expectRefused(with(1, 0, 0.1f), depth, "rotate or skew");
    expectRefused(with(1, 1, -1.0f), depth, "mirror");
    expectRefused(with(3, 0, 0.1f), depth, "origin of camera space");
    expectRefused(with(2, 3, 1.0f), depth, "looks along -Z");
    expectRefused(reversed(good), ClipDepth::zeroToOne, "clip depth");
    expectRefused(good, ClipDepth::oneToZero, "clip depth");
    expectRefused(glm::mat4(0.0f), depth, "last row");
}

TEST(ViewOfIntrinsics, ProjectsAsThePinholeDoes) {
    const CameraIntrinsics camera{520.0, 610.0, 300.5, 255.25, 640, 480};
    const CameraView view = viewOfIntrinsics(glm::mat4(1.0f), camera);
    const glm::mat4 clip = projection(view, 640.0f / 480.0f);
    for (const glm::vec3 point : {glm::vec3(0.2f, 0.1f, -2.0f), glm::vec3(-1.0f, -0.6f, -3.0f)}) {
        const glm::vec3 is = onScreen(clip, point);
        const double x = camera.focalX * point.x / -point.z + camera.centerX;
        const double y = camera.focalY * -point.y / -point.z + camera.centerY;
        // Pixels; 640 times the rounding of numbers near 1.
        EXPECT_NEAR((0.5 + 0.5 * is.x) * 640.0, x, 640.0 * rounding);
        EXPECT_NEAR((0.5 - 0.5 * is.y) * 480.0, y, 480.0 * rounding);
    }
    CameraIntrinsics bad = camera;
    bad.focalY = 0.0;
    EXPECT_THROW(viewOfIntrinsics(glm::mat4(1.0f), bad), Error);
    bad = camera;
    bad.height = 0;
    EXPECT_THROW(viewOfIntrinsics(glm::mat4(1.0f), bad), Error);
}

TEST(StereoViews, MeetInThePlaneOfConvergence) {
    CameraView view = lookAt({1.0f, 2.0f, 3.0f}, {0.0f, 1.0f, -4.0f}, 0.8f);
    view.shift = {0.1f, -0.2f};
    constexpr float aspect = 1.6f, distance = 0.065f, convergence = 2.5f;
    const auto [left, right] = stereoViews(view, distance, convergence, aspect);
    const auto seen = [&](const CameraView& eye, const glm::vec3& point) {
        return onScreen(projection(eye, aspect) * glm::inverse(eye.worldFromCamera), point);
    };
    for (const float depth : {1.0f, convergence, 20.0f}) {
        const glm::vec3 point(view.worldFromCamera * glm::vec4(0.3f, -0.2f, -depth, 1.0f));
        const float parallax = seen(right, point).x - seen(left, point).x;
        // In units of half the width: (e / c - e / z) / tan(half of the horizontal field of view).
        const float expected = distance * (1.0f / convergence - 1.0f / depth) / (aspect * std::tan(0.4f));
        EXPECT_NEAR(parallax, expected, 5.0f * rounding) << depth;  // of positions 5 m from the origin
        EXPECT_NEAR(seen(right, point).y, seen(left, point).y, 5.0f * rounding);
    }
    EXPECT_THROW(stereoViews(view, -0.1f, 1.0f, 1.0f), Error);
    EXPECT_THROW(stereoViews(view, 0.1f, 0.0f, 1.0f), Error);
    view.orthographicHeight = 2.0f;
    EXPECT_THROW(stereoViews(view, 0.1f, 1.0f, 1.0f), Error);
}

TEST(CubeViews, ShowEachDirectionOnceAndMoreWithAMargin) {
    const CameraView view = lookAt({0.0f, 0.0f, 0.0f}, {0.3f, 0.2f, -1.0f}, 0.8f);
    for (const float margin : {0.0f, 0.05f}) {
        const auto faces = cubeViews(view, margin);
        for (int i = 0; i < 500; ++i) {
            const float height = std::fmod(0.618034f * float(i), 1.0f) * 2.0f - 1.0f, angle = 2.4f * float(i);
            const float radius = std::sqrt(1.0f - height * height);
            const glm::vec3 direction(radius * std::cos(angle), height, radius * std::sin(angle));
            int shown = 0;
            for (const CameraView& face : faces) {
                const glm::vec3 p =
                    onScreen(projection(face, 1.0f) * glm::inverse(face.worldFromCamera), direction);
                shown += p.z > 0.0f && std::abs(p.x) <= 1.0f && std::abs(p.y) <= 1.0f;
            }
            if (margin == 0.0f)
                EXPECT_EQ(shown, 1) << i;
            else
                EXPECT_GE(shown, 1) << i;
        }
    }
    // What lies ahead, to the right and above, in the view's own frame.
    const auto faces = cubeViews(CameraView{});
    const std::array<glm::vec3, 6> ahead{glm::vec3(1, 0, 0),  glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0),
                                         glm::vec3(0, -1, 0), glm::vec3(0, 0, -1), glm::vec3(0, 0, 1)};
    const std::array<glm::vec3, 6> up{glm::vec3(0, 1, 0),  glm::vec3(0, 1, 0), glm::vec3(0, 0, 1),
                                      glm::vec3(0, 0, -1), glm::vec3(0, 1, 0), glm::vec3(0, 1, 0)};
    for (std::size_t i = 0; i < faces.size(); ++i) {
        EXPECT_EQ(-glm::vec3(faces[i].worldFromCamera[2]), ahead[i]) << i;
        EXPECT_EQ(glm::vec3(faces[i].worldFromCamera[1]), up[i]) << i;
        EXPECT_EQ(glm::determinant(glm::mat3(faces[i].worldFromCamera)), 1.0f) << i;
    }
    EXPECT_THROW(cubeViews(view, -0.1f), Error);
}

}  // namespace
}  // namespace candela
