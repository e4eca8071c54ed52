// Off-centre projections: `CameraView::shift`.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/procedural_scene.h"

#include "render/frustum.h"

#include <candela/error.h>
#include <glm/geometric.hpp>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela::test {
namespace {

constexpr int width = 64, height = 36;

const std::array shifts{glm::vec2(0.3f, -0.2f), glm::vec2(-1.5f, 0.5f), glm::vec2(0.0f, 2.0f),
                        glm::vec2(0.004f, 0.007f)};

Scene room() {
    Material material;
    material.roughness = 0.5f;
    Scene scene = sceneOf(makeQuad(40.0f), material, glm::translate(glm::mat4(1.0f), {0, 0, -6}));
    for (std::uint32_t i = 0; i < 60; ++i) {
        const glm::vec3 center(24 * hashed(140, i) - 12, 18 * hashed(141, i) - 9, 5 * hashed(142, i) - 5);
        place(scene, makeSphere(0.7f), material, glm::translate(glm::mat4(1.0f), center));
    }
    return scene;
}

/// Small ones everywhere, so that some lie across each border of any view.
std::vector<WorldLight> smallLights() {
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 1500; ++i) {
        const glm::vec3 position(50 * hashed(143, i) - 25, 40 * hashed(144, i) - 20, 8 * hashed(145, i) - 6);
        lights.push_back(pointLight(position, 1.5f, glm::vec3(0.2f, 0.5f, 0.9f)));
    }
    return lights;
}

CameraView view(bool orthographic) {
    CameraView seen = lookAt({0, 0, 9}, {0, 0, 0}, 0.8f);
    if (orthographic) seen.orthographicHeight = 8.0f;
    return seen;
}

class ShiftTest : public DrawingTest {
  protected:
    /// The share of the values that differ by more than rounding: a silhouette may take another pixel where
    /// it passes a pixel's centre.
    static double differing(const HdrImage& a, const HdrImage& b) {
        EXPECT_EQ(a.rgba.size(), b.rgba.size());
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.rgba.size(); ++i)
            count += std::abs(a.rgba[i] - b.rgba[i]) > 1e-4f + 1e-3f * std::abs(b.rgba[i]);
        return double(count) / double(a.rgba.size());
    }
};

TEST_F(ShiftTest, picturesAreTheCropOfALargerOne) {
    constexpr int across = 5, up = -3, larger = 2;  // pixels; larger in each direction
    GpuScene scene = upload(room(), smallLights());
    for (const bool orthographic : {false, true}) {
        CameraView wide = view(orthographic);
        wide.verticalFov = 2.0f * std::atan(larger * std::tan(0.5f * wide.verticalFov));
        if (orthographic) *wide.orthographicHeight *= larger;
        const HdrImage whole = drawn(scene, {larger * width, larger * height, wide});
        CameraView shifted = view(orthographic);
        shifted.shift = {float(across) / width, float(up) / height};
        const HdrImage crop = drawn(scene, {width, height, shifted});
        HdrImage expected = crop;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const glm::vec3 there =
                    pixelOf(whole, x + across + (larger - 1) * width / 2, y - up + (larger - 1) * height / 2);
                for (int c = 0; c < 3; ++c) expected.rgba[std::size_t(4 * (y * width + x) + c)] = there[c];
            }
        }
        EXPECT_LT(differing(crop, expected), 0.004) << (orthographic ? "orthographic" : "perspective");
    }
}

TEST_F(ShiftTest, techniquesAgreeAndKeepTheLightsAtTheBorders) {
    GpuScene scene = upload(room(), smallLights());
    for (const bool orthographic : {false, true}) {
        for (const glm::vec2& shift : shifts) {
            CameraView shifted = view(orthographic);
            shifted.shift = shift;
            FrameRequest request{width, height, shifted};
            request.technique = Technique::fullscreen;
            const HdrImage reference = drawn(scene, request);
            for (const Technique technique : {Technique::volumes, Technique::tiles}) {
                request.technique = technique;
                EXPECT_EQ(differing(drawn(scene, request), reference), 0.0)
                    << toString(technique) << ", shift " << shift.x << ", " << shift.y;
            }
            request.technique = Technique::tiles;
            request.tileBackend = TileBackend::compute;
            EXPECT_EQ(differing(drawn(scene, request), reference), 0.0) << "compute, shift " << shift.x;
        }
    }
}

TEST_F(ShiftTest, positionsFollowTheShift) {
    GpuScene scene = upload(room());
    for (const bool orthographic : {false, true}) {
        CameraView shifted = view(orthographic);
        shifted.shift = shifts[0];
        render(scene, {width, height, shifted});
        const AovReader reader = aovs(width);
        const glm::mat4 cameraFromWorld = glm::inverse(shifted.worldFromCamera);
        const float halfHeight =
            orthographic ? 0.5f * *shifted.orthographicHeight : std::tan(0.5f * shifted.verticalFov);
        for (int y = 0; y < height; y += 5) {
            for (int x = 0; x < width; x += 5) {
                const glm::vec3 p(cameraFromWorld * glm::vec4(reader.vector("P", x, y), 1.0f));
                const glm::vec2 onPlane = glm::vec2(p) / (orthographic ? 1.0f : -p.z);
                const glm::vec2 expected =
                    2.0f * halfHeight * glm::vec2(float(width) / height, 1.0f) *
                    (glm::vec2((float(x) + 0.5f) / width - 0.5f, 0.5f - (float(y) + 0.5f) / height) +
                     shifted.shift);
                EXPECT_NEAR(onPlane.x, expected.x, 2e-5f);
                EXPECT_NEAR(onPlane.y, expected.y, 2e-5f);
            }
        }
    }
}

TEST(FrustumShiftTest, spheresWithAPointInThePictureAreNotCulled) {
    int met = 0;
    for (const bool orthographic : {false, true}) {
        for (const glm::vec2& shift : shifts) {
            CameraView shifted = view(orthographic);
            shifted.worldFromCamera = glm::mat4(1.0f);
            shifted.farPlane = 1000.0f;
            shifted.shift = shift;
            const Frustum frustum(shifted, 16.0f / 9.0f);
            const glm::mat4 clip = projection(shifted, 16.0f / 9.0f);
            for (std::uint32_t i = 0; i < 2000; ++i) {
                const glm::vec3 center(40 * hashed(150, i) - 20, 40 * hashed(151, i) - 20,
                                       -12 * hashed(152, i));
                const float radius = 0.05f + 2.0f * hashed(153, i);
                const bool meets = frustum.meets(center, radius);
                met += meets;
                const bool inFront = !frustum.meetsNearPlane(center, radius);
                for (std::uint32_t k = 0; k < 24; ++k) {
                    const glm::vec3 point = center + 0.999f * radius * hashedDirection(154 + 2 * k, i);
                    const glm::vec4 p = clip * glm::vec4(point, 1.0f);
                    const bool inside =
                        p.w > 0.0f && p.z <= p.w && std::abs(p.x) < p.w && std::abs(p.y) < p.w;
                    if (inside) {
                        ASSERT_TRUE(meets);
                    }
                    if (!inFront) continue;
                    const auto [low, high] = frustum.projectedBounds(center, radius);
                    const glm::vec2 place = 0.5f + 0.5f * glm::vec2(p) / p.w;
                    ASSERT_TRUE(place.x > low.x && place.y > low.y && place.x < high.x && place.y < high.y);
                }
            }
        }
    }
    EXPECT_GT(met, 300);
}

TEST_F(ShiftTest, shiftsThatAreNotFiniteAreRefused) {
    GpuScene scene = upload(room());
    CameraView bad = view(false);
    bad.shift.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(render(scene, {width, height, bad}), Error);
    EXPECT_THROW(projection(bad, 1.0f), Error);
    bad.shift = {std::numeric_limits<float>::infinity(), 0.0f};
    EXPECT_THROW(render(scene, {width, height, bad}), Error);
}

}  // namespace
}  // namespace candela::test
