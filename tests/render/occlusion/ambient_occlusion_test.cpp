// The AOV `ambient_occlusion` against closed forms and against all triangles in double precision.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/occluder_scenes.h"
#include "support/procedural_scene.h"
#include "support/random_rig.h"
#include "support/shadow_reference.h"

#include <candela/error.h>
#include <candela/threads.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace candela::test {
namespace {

constexpr int width = 64, height = 36;

FrameRequest frameOf(const CameraView& view, const AmbientOcclusionSettings& settings = {}) {
    FrameRequest request{width, height, view};
    request.ambientOcclusion = settings;
    return request;
}

const Material grey = doubleSided(0.5f);

class AmbientOcclusionTest : public DrawingTest {
  protected:
    void SetUp() override {
        if (!hasShadows()) GTEST_SKIP() << "built without shadows";
    }

    static AovReader traced(GpuScene& scene, const FrameRequest& request) {
        render(scene, request);
        return {lastFrame().aovs({"P", "N", "Z", "ambient_occlusion"}), width};
    }

    static std::vector<float> values(GpuScene& scene, const FrameRequest& request) {
        render(scene, request);
        return lastFrame().aovs({"ambient_occlusion"}).front().values.front();
    }
};

TEST_F(AmbientOcclusionTest, anOpenPlaneIsOne) {
    for (std::uint32_t i = 0; i < 6; ++i) {
        Scene scene =
            sceneOf(makeQuad(50.0f), grey, rotated({0, 0, 0}, 360.0f * hashed(1, i), hashedDirection(2, i)));
        GpuScene uploaded = upload(scene);
        for (const Shadows shadows : {Shadows::off, Shadows::on}) {
            FrameRequest request = frameOf(lookAt(4.0f * hashedDirection(3, i), {0, 0, 0}, 1.0f),
                                           {.distance = 1.0e4f, .rays = 1000});
            request.shadows = shadows;
            const AovReader reader = traced(uploaded, request);
            int surfaces = 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const bool isSurface = reader.scalar("Z", x, y) > 0.0f;
                    surfaces += isSurface;
                    ASSERT_EQ(reader.scalar("ambient_occlusion", x, y), isSurface ? 1.0f : 0.0f)
                        << i << ": " << x << ", " << y;
                }
            }
            EXPECT_GT(surfaces, 500);
        }
    }
}

TEST_F(AmbientOcclusionTest, aCornerOfTwoPlanes) {
    EXPECT_EQ(freeBesideAWall(0.0, 1.0), 0.5);
    GpuScene scene = upload(floorAndWall(grey));
    CameraView orthographic = lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f);
    orthographic.orthographicHeight = 1.6f;
    for (const CameraView& view : {lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f),
                                   lookAt({0.3f, 0.2f, 0.5f}, {0, 0, 0}, 1.0f), orthographic}) {
        for (const float distance : {0.5f, 2.0f}) {
            const AovReader reader = traced(scene, frameOf(view, {.distance = distance, .rays = 1024}));
            double sum = 0.0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    const glm::vec3 p = reader.vector("P", x, y);
                    // The planes end.
                    const bool isBeside =
                        std::abs(p.z) + distance < 5.0f && std::max(p.x, p.y) + distance < 10.0f;
                    if (reader.scalar("Z", x, y) == 0.0f || !isBeside) continue;
                    const double expected = freeBesideAWall(std::max(p.x, p.y), distance);
                    const double actual = reader.scalar("ambient_occlusion", x, y);
                    // 1024 points of a Hammersley set: the discrepancy for segments of a disc.
                    ASSERT_NEAR(actual, expected, 0.01) << p.x << ", " << p.y << ", " << p.z;
                    sum += actual - expected;
                }
            }
            // Rotations of the set average its error away.
            EXPECT_LT(std::abs(sum), 5e-4 * width * height);
        }
    }
}

TEST_F(AmbientOcclusionTest, insideAClosedBox) {
    Scene scene;
    for (int i = 0; i < 4; ++i)
        place(scene, makeQuad(1.0f), grey,
              glm::translate(rotated({}, 90.0f * float(i), {0, 1, 0}), {0, 0, 1}));
    for (const float side : {-1.0f, 1.0f}) place(scene, makeQuad(1.0f), grey, flatAt({0, side, 0}));
    GpuScene uploaded = upload(scene);
    const CameraView view = lookAt({0.2f, 0.1f, 0.3f}, {-1, -0.8f, -1}, 1.2f);
    for (const float value : values(uploaded, frameOf(view, {.distance = 10.0f}))) ASSERT_EQ(value, 0.0f);
    // Nearer than the nearest other side nothing is hidden.
    const AovReader reader = traced(uploaded, frameOf(view, {.distance = 0.05f}));
    int open = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 p = glm::abs(reader.vector("P", x, y));
            const float second = p.x + p.y + p.z - std::max({p.x, p.y, p.z}) - std::min({p.x, p.y, p.z});
            if (second > 0.949f) continue;
            ++open;
            ASSERT_EQ(reader.scalar("ambient_occlusion", x, y), 1.0f);
        }
    }
    EXPECT_GT(open, 500);
}

TEST_F(AmbientOcclusionTest, runsAndThreadsGiveTheSameBits) {
    GpuScene scene = upload(cardsOnAFloor(grey));
    const FrameRequest request = frameOf(lookAt({0, 3, 6}, {0, 0.3f, 0}, 0.7f), {.rays = 37});
    const std::vector<float> expected = values(scene, request);
    EXPECT_EQ(values(scene, request), expected);
    for (const unsigned threads : {1u, 3u, 8u}) {
        setThreadCount(threads);
        EXPECT_EQ(values(scene, request), expected) << threads;
    }
    setThreadCount(0);
    // Each value is a number of rays out of 37.
    for (const float value : expected) EXPECT_NEAR(37.0f * value, std::round(37.0f * value), 1e-5f);
}

/// Whether a ray meets a triangle between `margin` and `distance` (Möller and Trumbore, 1997).
bool isBlocked(const std::vector<Triangle>& triangles, const glm::dvec3& origin, const glm::dvec3& direction,
               double margin, double distance) {
    for (const Triangle& triangle : triangles) {
        const glm::dvec3 ab = triangle.corners[1] - triangle.corners[0],
                         ac = triangle.corners[2] - triangle.corners[0], p = glm::cross(direction, ac);
        const double determinant = glm::dot(ab, p);
        if (determinant == 0.0) continue;
        const glm::dvec3 way = origin - triangle.corners[0], q = glm::cross(way, ab);
        const double u = glm::dot(way, p) / determinant, v = glm::dot(direction, q) / determinant;
        const double t = glm::dot(ac, q) / determinant;
        if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > margin && t < distance) return true;
    }
    return false;
}

/// By directions on a spiral of equal areas (Vogel, 1979), which is another set than the renderer's.
double freeShare(const std::vector<Triangle>& triangles, const glm::dvec3& position, const glm::dvec3& normal,
                 double margin, double distance) {
    constexpr int count = 400;
    const glm::dvec3 other = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 a = glm::normalize(glm::cross(normal, other)), b = glm::cross(normal, a);
    int open = 0;
    for (int i = 0; i < count; ++i) {
        const double area = (i + 0.5) / count, angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const glm::dvec3 direction =
            std::sqrt(area) * (std::cos(angle) * a + std::sin(angle) * b) + std::sqrt(1.0 - area) * normal;
        open += !isBlocked(triangles, position + margin * normal, direction, 0.0, distance);
    }
    return double(open) / count;
}

TEST_F(AmbientOcclusionTest, allTrianglesInDoublePrecisionAgree) {
    const Scene scene = cardsOnAFloor(grey);
    const std::vector<Triangle> triangles = trianglesOf(scene);
    GpuScene uploaded = upload(scene);
    const CameraView view = lookAt({0, 3, 5}, {0, 0.3f, 0}, 0.6f);
    constexpr float distance = 0.7f;
    const AovReader reader = traced(uploaded, frameOf(view, {.distance = distance, .rays = 1024}));
    double sum = 0.0, expectedSum = 0.0;
    int count = 0;
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; x += 2) {
            if (reader.scalar("Z", x, y) == 0.0f) continue;
            const glm::dvec3 position(reader.vector("P", x, y));
            const double expected = freeShare(triangles, position, glm::dvec3(reader.vector("N", x, y)),
                                              marginAt(position, view, height), distance);
            const double actual = reader.scalar("ambient_occlusion", x, y);
            // The discrepancies of both sets for what some edges of rectangles bound.
            ASSERT_NEAR(actual, expected, 0.03) << x << ", " << y;
            sum += actual;
            expectedSum += expected;
            ++count;
        }
    }
    EXPECT_GT(count, 300);
    EXPECT_LT(expectedSum, 0.95 * count);
    EXPECT_NEAR(sum, expectedSum, 1e-3 * count);
}

/// Rays start on the smooth surface that vertex normals describe: the facets of a convex mesh hide nothing.
TEST_F(AmbientOcclusionTest, aCoarseSphereIsOpen) {
    GpuScene scene = upload(sceneOf(makeSphere(1.0f, 12, 6), grey));
    const AovReader reader =
        traced(scene, frameOf(lookAt({1, 1, 2}, {0, 0, 0}, 0.7f), {.distance = 10.0f, .rays = 256}));
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (reader.scalar("Z", x, y) == 0.0f) continue;
            sum += reader.scalar("ambient_occlusion", x, y);
            ++count;
        }
    }
    EXPECT_GT(count, 300);
    EXPECT_GT(sum, 0.998 * count);
}

TEST_F(AmbientOcclusionTest, whatCastsNoShadowHidesNothing) {
    Scene scene = floorAndWall(grey);
    for (Node& node : scene.nodes) node.castsShadow = false;
    GpuScene uploaded = upload(scene);
    const FrameRequest request = frameOf(lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f));
    for (const float value : values(uploaded, request)) ASSERT_EQ(value, 1.0f);
}

/// In a frame without shadows what is out of view may be out of date.
TEST_F(AmbientOcclusionTest, framesWithoutShadowsSeeDeformedMeshesOutOfView) {
    Scene scene = randomRig(5, {.vertices = 120, .joints = 8});
    place(scene, makeQuad(6.0f), grey, flatAt({0, -4.0f, 0}));
    poseRandomly(scene, 9);
    FrameRequest request = frameOf(lookAt({0, -2.5f, 5}, {0, -4, 2}, 0.9f), {.distance = 20.0f});
    GpuScene withoutShadows = upload(scene), withShadows = upload(scene);
    const std::vector<float> expected = values(withoutShadows, request);
    request.shadows = Shadows::on;
    EXPECT_EQ(values(withShadows, request), expected);
    EXPECT_LT(*std::ranges::min_element(expected), 0.99f);
}

TEST_F(AmbientOcclusionTest, settingsOutOfRangeAreErrors) {
    GpuScene scene = upload(floorAndWall(grey));
    constexpr float infinity = std::numeric_limits<float>::infinity(),
                    nan = std::numeric_limits<float>::quiet_NaN();
    for (const AmbientOcclusionSettings& settings : {AmbientOcclusionSettings{0.0f, 64},
                                                     {-1.0f, 64},
                                                     {infinity, 64},
                                                     {nan, 64},
                                                     {1.0f, 0},
                                                     {1.0f, 4097}}) {
        try {
            render(scene, frameOf(lookAt({3, 3, 1}, {0, 0, 0}, 0.5f), settings));
            ADD_FAILURE() << settings.distance << ", " << settings.rays;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            EXPECT_NE(std::string(error.what()).find("ambient occlusion"), std::string::npos) << error.what();
        }
    }
}

class WithoutShadowsTest : public DrawingTest {};

TEST_F(WithoutShadowsTest, ambientOcclusionIsAnError) {
    if (hasShadows()) GTEST_SKIP() << "built with shadows";
    GpuScene scene = upload(floorAndWall(grey));
    render(scene, frameOf(lookAt({3, 3, 1}, {0, 0, 0}, 0.5f)));
    EXPECT_EQ(std::ranges::count(Renderer::aovNames(), "ambient_occlusion"), 0);
    try {
        lastFrame().aovs({"ambient_occlusion"});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::environment);
        EXPECT_NE(std::string(error.what()).find("CANDELA_SHADOWS"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace candela::test
