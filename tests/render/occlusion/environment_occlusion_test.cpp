// How much of the environment pixels see, by Embree and in shaders, against closed forms and each other.

#include "occlusion/visibility_fixture.h"
#include "render/occlusion/shared_rays.h"
#include "support/occluder_scenes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace candela::test {
namespace {

constexpr float everything = 1.0e30f;

const Material grey = doubleSided(0.5f);

/// What the filter may change beside a wall at the distance d: its window holds pixels up to three beside
/// the one in its middle, of the size in which the tests below see the floor and the wall.
double windowTolerance(double d, double distance) {
    constexpr double window = 3.0 * 0.06;
    return freeBesideAWall(d + window, distance) - freeBesideAWall(std::max(d - window, 0.0), distance);
}

TEST_F(VisibilityTest, OpenSurfacesSeeAllOfIt) {
    std::vector<Scene> scenes{sceneOf(makeSphere(1.0f, 12, 6), grey),
                              sceneOf(makeSphere(1.0f, 64, 32), grey)};
    for (std::uint32_t i = 0; i < 4; ++i)
        scenes.push_back(
            sceneOf(makeQuad(50.0f), grey, rotated({}, 360.0f * hashed(1, i), hashedDirection(2, i))));
    for (const Scene& scene : scenes) {
        GpuScene uploaded = upload(scene);
        for (const Form form : forms) {
            for (const std::uint32_t rays : {1u, 4u, 7u, 64u}) {
                const Picture picture = visibility(uploaded, lookAt({1.4f, 1.6f, 2.7f}, {0, 0, 0}, 0.8f),
                                                   {rays, rays, everything}, form);
                int surfaces = 0;
                for (std::size_t i = 0; i < picture.depth.size(); ++i) {
                    if (picture.depth[i] == 0.0f) continue;
                    ++surfaces;
                    ASSERT_EQ(picture.bytes[i], 255) << i << ", " << rays << " rays";
                }
                EXPECT_GT(surfaces, 300);
            }
        }
    }
}

TEST_F(VisibilityTest, ACornerOfTwoPlanes) {
    GpuScene scene = upload(floorAndWall(grey));
    CameraView orthographic = lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f);
    orthographic.orthographicHeight = 1.6f;
    orthographic.farPlane = 100.0f;
    for (const CameraView& view : {lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f), orthographic}) {
        for (const Form form : forms) {
            for (const std::uint32_t rays : {4u, 256u}) {
                constexpr float distance = 1.5f;
                const Picture picture = visibility(scene, view, {rays, 0, distance}, form);
                double sum = 0.0;
                int count = 0;
                for (std::size_t i = 0; i < picture.depth.size(); ++i) {
                    const glm::vec3 p = picture.positions[i];
                    const float d = std::max(p.x, p.y);
                    const bool isBeside = std::abs(p.z) + distance < 5.0f && d + distance < 10.0f;
                    if (picture.depth[i] == 0.0f || !isBeside) continue;
                    const double error = picture.bytes[i] / 255.0 - freeBesideAWall(d, distance);
                    // A byte, the discrepancy of 16 × rays directions for segments of a disc (of fewer beside
                    // the edge, where the filter's window is cut), and the filter.
                    const double directions = rays == 256 ? 0.004 : d > 0.15f && isInside(i) ? 0.05 : 0.12;
                    const double tolerance = 0.002 + directions + windowTolerance(d, distance);
                    ASSERT_NEAR(error, 0.0, tolerance) << p.x << ", " << p.y;
                    sum += error;
                    ++count;
                }
                EXPECT_GT(count, 1000);
                EXPECT_LT(std::abs(sum), 0.006 * count) << rays;
            }
        }
    }
}

TEST_F(VisibilityTest, SamplesAverageToTheClosedForm) {
    GpuScene scene = upload(floorAndWall(grey));
    const CameraView view = lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f);
    struct Case {
        std::uint32_t samples, rays;
        double bound;
    };
    // Where the filter finds few neighbours a pixel has little more than its own 256 and 16 directions.
    for (const Case& drawn : {Case{64, 4, 0.006}, Case{16, 1, 0.04}}) {
        std::vector<double> sums;
        Picture picture;
        for (std::uint32_t sample = 0; sample < drawn.samples; ++sample) {
            const Picture next = visibility(scene, view, {drawn.rays, sample, 1.5f}, Form::cpu);
            EXPECT_NE(next.bytes, picture.bytes) << sample;
            picture = next;
            sums.resize(picture.bytes.size());
            for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += picture.bytes[i] / 255.0;
        }
        double worst = 0.0;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            const glm::vec3 p = picture.positions[i];
            if (picture.depth[i] == 0.0f || std::abs(p.z) > 3.4f || std::max(p.x, p.y) > 8.0f) continue;
            const double d = std::max(p.x, p.y);
            const double off = std::abs(sums[i] / drawn.samples - freeBesideAWall(d, 1.5));
            worst = std::max(worst, off - windowTolerance(d, 1.5));
        }
        std::printf("%u samples of %u rays: off by %.4f\n", drawn.samples, drawn.rays, worst);
        EXPECT_LT(worst, drawn.bound);
    }
}

/// A (0, 4, 2)-net: one point in each of the 16 boxes of equal size, whatever their shape.
TEST(EnvironmentRays, SixteenSamplesOfAPixelAreANet) {
    for (std::uint32_t pixel = 0; pixel < 16; ++pixel) {
        for (std::uint32_t first = 0; first < 64; first += 16) {
            for (std::uint32_t columns = 1; columns <= 16; columns *= 2) {
                std::set<std::pair<int, int>> boxes;
                for (std::uint32_t sample = first; sample < first + 16; ++sample) {
                    const std::uint32_t ray = rays::firstEnvironmentRay(pixel % 4, pixel / 4, sample, 1);
                    boxes.emplace(rays::radicalInverse(ray) * static_cast<float>(columns),
                                  rays::sobolNumber(ray) * static_cast<float>(16 / columns));
                }
                EXPECT_EQ(boxes.size(), 16u) << pixel << ", " << first << ", " << columns;
            }
        }
    }
}

TEST_F(VisibilityTest, InsideAClosedBoxNothingIsSeen) {
    GpuScene scene = upload(closedRoom(grey));
    const CameraView view = lookAt({0.2f, 0.1f, 0.3f}, {-1, -0.8f, -1}, 1.2f);
    for (const Form form : forms) {
        for (const std::uint8_t value : visibility(scene, view, {4, 0, everything}, form).bytes)
            ASSERT_EQ(value, 0);
    }
}

/// Neighbours on another surface do not take part.
TEST_F(VisibilityTest, NoHaloesAtEdges) {
    Scene scene = floorAndWall(grey);
    for (std::uint32_t i = 0; i < 6; ++i) {
        const glm::vec3 center(1.2f + 0.1f * float(i), 0.6f + 0.5f * hashed(9, i), 0.35f * float(i) - 0.9f);
        // Towards the eye.
        place(scene, makeQuad(0.08f), grey,
              glm::inverse(glm::lookAt(center, 2.0f * center - glm::vec3(3, 3, 1), {0, 1, 0})));
    }
    GpuScene uploaded = upload(scene);
    for (const Form form : forms) {
        const Picture picture =
            visibility(uploaded, lookAt({3, 3, 1}, {0.4f, 0.3f, 0}, 0.5f), {16, 0, 0.2f}, form);
        int onCards = 0, dark = 0;
        for (std::size_t i = 0; i < picture.depth.size(); ++i) {
            const glm::vec3 p = picture.positions[i];
            if (picture.depth[i] == 0.0f) continue;
            dark += picture.bytes[i] < 200;
            if (std::min(p.x, p.y) < 0.25f) continue;
            ++onCards;
            ASSERT_EQ(picture.bytes[i], 255) << i;
        }
        EXPECT_GT(onCards, 50);
        EXPECT_GT(dark, 50);
    }
}

TEST_F(VisibilityTest, ShadersAgreeWithTheCpu) {
    GpuScene scene = upload(cardsOnAFloor(grey));
    for (const std::uint32_t rays : {4u, 37u}) {
        const EnvironmentRays settings{rays, 3, 0.9f};
        const CameraView view = lookAt({0, 3, 6}, {0, 0.3f, 0}, 0.7f);
        const Picture cpu = visibility(scene, view, settings, Form::cpu),
                      shader = visibility(scene, view, settings, Form::shader);
        int different = 0, surfaces = 0;
        for (std::size_t i = 0; i < cpu.depth.size(); ++i) {
            if (cpu.depth[i] == 0.0f) continue;
            ++surfaces;
            // One code of rounding; more where a ray grazes an edge.
            different += std::abs(int(cpu.bytes[i]) - int(shader.bytes[i])) > 1;
        }
        std::printf("%u rays: %d of %d pixels differ\n", rays, different, surfaces);
        EXPECT_LT(different, surfaces / 100);
        EXPECT_LT(*std::ranges::min_element(cpu.bytes), 200);
    }
}

TEST_F(VisibilityTest, ThreadsGiveTheSameBits) {
    GpuScene scene = upload(cardsOnAFloor(grey));
    const CameraView view = lookAt({0, 3, 6}, {0, 0.3f, 0}, 0.7f);
    const std::vector<std::uint8_t> expected = visibility(scene, view, {5, 1, 0.9f}, Form::cpu).bytes;
    for (const unsigned threads : {1u, 3u, 8u}) {
        setThreadCount(threads);
        EXPECT_EQ(visibility(scene, view, {5, 1, 0.9f}, Form::cpu).bytes, expected);
    }
    setThreadCount(0);
}

TEST_F(VisibilityTest, MovedNodesHideAsInAFreshScene) {
    Scene scene = cardsOnAFloor(grey);
    GpuScene moving = upload(scene);
    const CameraView view = lookAt({0, 3, 6}, {0, 0.3f, 0}, 0.7f);
    for (std::uint32_t step = 0; step < 4; ++step) {
        for (std::uint32_t node = 1 + step; node < scene.nodes.size(); node += 3) {
            glm::mat4& transform = std::get<glm::mat4>(scene.nodes[node].transform);
            transform[3] +=
                glm::vec4(hashed(90 + step, node) - 0.5f, 0.2f * hashed(91 + step, node), 0.1f, 0.0f);
            moving.setTransform(node, transform);
        }
        GpuScene fresh = upload(scene);
        for (const Form form : forms) {
            EXPECT_EQ(visibility(moving, view, {4, step, 0.9f}, form).bytes,
                      visibility(fresh, view, {4, step, 0.9f}, form).bytes);
        }
    }
}

/// glTF 2.0, 3.9.3: mix(1, R, strength), read with its own texture coordinates.
TEST_F(VisibilityTest, OcclusionTexturesMultiply) {
    for (const float strength : {1.0f, 0.5f, 0.0f}) {
        Material material = grey;
        material.occlusionTexture = Texture{};
        material.occlusionTexture->uvSet = 1;
        material.occlusionTexture->magFilter = material.occlusionTexture->minFilter = Filter::nearest;
        material.occlusionTexture->scale = {2.0f, 1.0f};
        material.occlusionStrength = strength;
        Mesh quad = makeQuad(50.0f);
        quad.uv1 = quad.uv0;
        Scene scene = sceneOf(quad, material);
        place(scene, makeQuad(1.0f), grey, glm::translate(glm::mat4(1.0f), {0, 0, 0.5f}));
        scene.images.push_back(makeImage(
            2, 2, [](std::uint32_t x, std::uint32_t) { return glm::u8vec4(x == 0 ? 51 : 204, 0, 0, 255); }));
        scene.environment = whiteEnvironment();
        GpuScene uploaded = upload(scene);
        for (const Form form : forms) {
            const Picture picture =
                visibility(uploaded, lookAt({0, 0, 30}, {0, 0, 0}, 1.0f), {4, 0, 0.1f}, form);
            for (std::size_t i = 0; i < picture.depth.size(); ++i) {
                const glm::vec3 p = picture.positions[i];
                if (std::max(std::abs(p.x), std::abs(p.y)) < 1.5f && p.z < 0.4f) continue;
                const float place = (p.x + 50.0f) / 100.0f * 4.0f;
                if (std::abs(place - std::round(place)) < 0.05f) continue;
                const float red = int(std::floor(place)) % 2 == 0 ? 51.0f : 204.0f;
                const float expected = p.z > 0.4f ? 255.0f : 255.0f + strength * (red - 255.0f);
                ASSERT_NEAR(picture.bytes[i], expected, 0.51f) << p.x;
            }
        }
    }
}

}  // namespace
}  // namespace candela::test
