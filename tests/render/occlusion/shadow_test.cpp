// Shadows of pictures against a test of all triangles in double precision.

#include "occlusion/shadow_fixture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela::test {
namespace {

TEST_F(ShadowTest, boxesOnAFloor) {
    const Scene scene = boxesOnAFloor();
    std::vector<WorldLight> lights = scatteredLights(16, 30);
    lights.push_back(directionalLight({0.4f, -1.0f, 0.3f}, glm::vec3(2.0f)));
    lights.push_back(directionalLight({1.0f, -0.1f, 0.0f}, glm::vec3(2.0f)));
    lights.push_back(spotLight({2, 3, 2}, {0, 0, 0}, 20.0f, glm::vec3(30.0f), 0.2f, 0.7f));
    const Tally tally = compare(scene, trianglesOf(scene), lights, lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f));
    EXPECT_GT(tally.blocked, 3000);
    EXPECT_GT(tally.lit, 10000);
    EXPECT_LT(tally.grazing, (tally.lit + tally.blocked) / 20);
}

/// Two rooms behind a wall of one millimetre. Not one pixel of a room is lit by a light in the other.
TEST_F(ShadowTest, noLightThroughAWallOfAMillimetre) {
    Scene scene;
    place(scene, makeBox({4.0f, 0.0005f, 2.0f}), grey(), at({0, 0, 0}));
    place(scene, makeBox({4.0f, 0.0005f, 2.0f}), grey(), at({0, 2, 0}));
    for (const float x : {-4.0f, 0.0f, 4.0f})
        place(scene, makeBox({0.0005f, 1.0f, 2.0f}), grey(), at({x, 1, 0}));
    for (const float z : {-2.0f, 2.0f}) place(scene, makeBox({4.0f, 1.0f, 0.0005f}), grey(), at({0, 1, z}));
    std::vector<WorldLight> lights;
    for (std::uint32_t i = 0; i < 64; ++i)
        lights.push_back(pointLight(
            {0.01f + 3.9f * hashed(1, i), 0.01f + 1.98f * hashed(2, i), 3.9f * hashed(3, i) - 1.95f}, 0.0f,
            glm::vec3(1000.0f)));
    GpuScene uploaded = upload(scene, lights);
    for (const glm::vec3& target :
         {glm::vec3(-0.2f, 0.1f, 1.8f), glm::vec3(-4, 1, -2), glm::vec3(-0.1f, 1.9f, 0)}) {
        const CameraView view = lookAt({-3.0f, 1.2f, -0.5f}, target, 1.2f);
        const HdrImage picture = drawnWith(uploaded, view, Shadows::on);
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) ASSERT_EQ(picture.rgba[i], 0.0f) << i / 4;
        const HdrImage without = drawnWith(uploaded, view, Shadows::off);
        std::size_t lit = 0;
        for (std::size_t i = 0; i < without.rgba.size(); i += 4) lit += without.rgba[i] > 1.0f;
        EXPECT_GT(lit, 500u);
    }
}

TEST_F(ShadowTest, mirroredAndScaledInstances) {
    Scene scene = sceneOf(makeBox({8.0f, 0.1f, 8.0f}), grey(), at({0, -0.1f, 0}));
    for (std::uint32_t i = 0; i < 12; ++i) {
        const float unit = std::pow(1000.0f, float(i % 3) - 1.0f);  // metres of the mesh for one of the world
        const glm::vec3 position(6.0f * hashed(11, i) - 3.0f, 0.3f + hashed(12, i),
                                 6.0f * hashed(13, i) - 3.0f);
        glm::mat4 matrix = glm::rotate(at(position), 6.0f * hashed(14, i), hashedDirection(15, i));
        matrix = glm::scale(matrix, glm::vec3(i % 2 == 0 ? -1.0f : 1.0f, 1.0f, 0.6f) / unit);
        place(scene, makeBox(glm::vec3(0.4f, 0.3f, 0.2f) * unit), grey(), matrix);
    }
    const Tally tally =
        compare(scene, trianglesOf(scene), scatteredLights(12, 50), lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f));
    EXPECT_GT(tally.blocked, 1000);
}

/// Interpolated normals of a coarse sphere: what the smooth surface sees is lit, without bands of its facets.
TEST_F(ShadowTest, facetsOfACoarseSphereShowNoBands) {
    const Scene scene = sceneOf(makeSphere(1.0f, 12, 6), grey());
    GpuScene uploaded(context(), scene);
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::vector<WorldLight> lights{
            pointLight(4.0f * hashedDirection(21, i), 0.0f, glm::vec3(20.0f))};
        uploaded.setLights(lights);
        const CameraView view = lookAt({0, 0, 3}, {0, 0, 0}, 0.9f);
        const HdrImage without = drawnWith(uploaded, view, Shadows::off),
                       with = drawnWith(uploaded, view, Shadows::on);
        double lost = 0.0, all = 0.0;
        for (std::size_t p = 0; p < with.rgba.size(); p += 4) {
            lost += without.rgba[p] - with.rgba[p];
            all += without.rgba[p];
        }
        // The tangent planes leave out what lies behind the terminator of the facets only by a few pixels.
        EXPECT_LE(lost, 0.002 * all) << i;
    }
}

/// A light sealed in a box lights nothing outside; without the box every pixel is that of a frame without
/// shadows.
TEST_F(ShadowTest, lightSealedInABox) {
    Scene scene = sceneOf(makeBox({8.0f, 0.1f, 8.0f}), grey(), at({0, -0.1f, 0}));
    const std::uint32_t box = place(scene, makeBox({0.3f, 0.3f, 0.3f}), grey(), at({0, 1, 0}));
    GpuScene uploaded = upload(scene, std::vector{pointLight({0.1f, 1.1f, -0.05f}, 0.0f, glm::vec3(50.0f))});
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    const HdrImage sealed = drawnWith(uploaded, view, Shadows::on);
    for (std::size_t i = 0; i < sealed.rgba.size(); i += 4) ASSERT_EQ(sealed.rgba[i], 0.0f) << i / 4;
    uploaded.setVisibility(box, GpuScene::Visibility::hidden);
    EXPECT_EQ(drawnWith(uploaded, view, Shadows::on).rgba, drawnWith(uploaded, view, Shadows::off).rgba);
}

/// A light on a surface, or in its plane, shines on that surface's sides as without shadows.
TEST_F(ShadowTest, lightOnASurface) {
    Scene ceiling = sceneOf(makeBox({3.0f, 0.1f, 3.0f}), grey(), at({0, -0.1f, 0}));
    place(ceiling, makeBox({3.0f, 0.05f, 3.0f}), grey(), at({0, 2.05f, 0}));
    GpuScene uploaded =
        upload(ceiling, std::vector{pointLight({0.37f, 2.0f, 0.21f}, 0.0f, glm::vec3(10.0f))});
    const CameraView view = lookAt({0, 1, 5}, {0, 0.5f, 0}, 0.9f);
    EXPECT_EQ(drawnWith(uploaded, view, Shadows::on).rgba, drawnWith(uploaded, view, Shadows::off).rgba);
}

/// Instances that move for 200 frames: the structure answers as that of a scene uploaded anew.
TEST_F(ShadowTest, movedInstancesAnswerAsAFreshScene) {
    Scene scene = boxesOnAFloor();
    const std::vector<WorldLight> lights = scatteredLights(6, 70);
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    GpuScene moved = upload(scene, lights);
    for (std::uint32_t frame = 0; frame < 200; ++frame) {
        const std::uint32_t node = 1 + frame % static_cast<std::uint32_t>(scene.nodes.size() - 1);
        const glm::vec3 position(6.0f * hashed(81, frame) - 3.0f, 0.3f + hashed(82, frame),
                                 6.0f * hashed(83, frame) - 3.0f);
        const glm::mat4 matrix =
            glm::rotate(at(position), 6.0f * hashed(84, frame), hashedDirection(85, frame));
        scene.nodes[node].transform = matrix;
        moved.setTransform(node, matrix);
        const HdrImage picture = drawnWith(moved, view, Shadows::on);
        if (frame % 20 != 19) continue;
        GpuScene fresh = upload(scene, lights);
        ASSERT_EQ(picture.rgba, drawnWith(fresh, view, Shadows::on).rgba) << frame;
    }
}

/// Alpha masks let light through where their texture says.
TEST_F(ShadowTest, maskedCardsLetLightThrough) {
    Scene scene = sceneOf(makeBox({4.0f, 0.1f, 4.0f}), grey(), at({0, -0.1f, 0}));
    // The left half is clear.
    scene.images.push_back(makeImage(
        8, 8, [](std::uint32_t x, std::uint32_t) { return glm::u8vec4(255, 255, 255, x < 4 ? 0 : 255); }));
    Material mask = grey();
    mask.alphaMode = AlphaMode::mask;
    mask.doubleSided = true;
    Texture texture;
    texture.wrapS = texture.wrapT = Wrap::clampToEdge;
    mask.baseColorTexture = texture;
    const glm::mat4 flat = glm::rotate(at({0, 1, 0}), glm::radians(-90.0f), glm::vec3(1, 0, 0));
    const std::uint32_t card = place(scene, makeQuad(1.0f), mask, flat);
    GpuScene uploaded = upload(scene, std::vector{directionalLight({0, -1, 0}, glm::vec3(1.0f))});
    // From the side, below the card.
    const CameraView view = lookAt({0.3f, 0.7f, 4.0f}, {0, 0, 0}, 0.9f);
    uploaded.setVisibility(card, GpuScene::Visibility::hidden);
    const HdrImage open = drawnWith(uploaded, view, Shadows::on);
    uploaded.setVisibility(card, GpuScene::Visibility::shown);
    FrameRequest request{width, height, view};
    request.shadows = Shadows::on;
    const HdrImage picture = drawn(uploaded, request);
    const AovReader aovs(lastFrame().aovs({"P"}), width);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const glm::vec3 p = aovs.vector("P", x, y);
            // Off the card, its edges, and the texels between which alpha is interpolated.
            const bool decided = std::abs(p.x) > 0.15f && std::abs(std::abs(p.x) - 1.0f) > 0.05f &&
                                 std::abs(std::abs(p.z) - 1.0f) > 0.05f && p.y < 0.01f;
            if (!decided) continue;
            const bool covered = std::abs(p.z) < 1.0f && p.x > 0.0f && p.x < 1.0f;
            EXPECT_EQ(pixelOf(picture, x, y), covered ? glm::vec3(0.0f) : pixelOf(open, x, y))
                << p.x << ", " << p.z;
        }
    }
    // An opaque material hides the light over the whole card.
    mask.alphaMode = AlphaMode::opaque;
    uploaded.setMaterial(*scene.meshes[*scene.nodes[card].mesh].submeshes[0].material, mask);
    EXPECT_NE(drawnWith(uploaded, view, Shadows::on).rgba, picture.rgba);
}

/// Lights and nodes that cast no shadow.
TEST_F(ShadowTest, castsShadowOfLightsAndNodes) {
    Scene scene = boxesOnAFloor();
    std::vector<WorldLight> lights = scatteredLights(3, 90);
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    GpuScene uploaded = upload(scene, lights);
    const HdrImage without = drawnWith(uploaded, view, Shadows::off);
    EXPECT_NE(drawnWith(uploaded, view, Shadows::on).rgba, without.rgba);
    for (WorldLight& light : lights) light.castsShadow = false;
    uploaded.setLights(lights);
    EXPECT_EQ(drawnWith(uploaded, view, Shadows::on).rgba, without.rgba);
    for (WorldLight& light : lights) light.castsShadow = true;
    for (Node& node : scene.nodes) node.castsShadow = false;
    GpuScene none = upload(scene, lights);
    EXPECT_EQ(drawnWith(none, view, Shadows::on).rgba, without.rgba);
}

/// The AOV `shadowed_count` against pictures of each light alone.
TEST_F(ShadowTest, shadowedCountIsThatOfThePictures) {
    const Scene scene = boxesOnAFloor();
    std::vector<WorldLight> lights = scatteredLights(9, 30);
    lights[2].range = 2.0f;
    lights[4].castsShadow = false;
    lights.push_back(spotLight({2, 3, 2}, {0, 0, 0}, 20.0f, glm::vec3(30.0f), 0.2f, 0.7f));
    lights.push_back(directionalLight({0.4f, -1.0f, 0.3f}, glm::vec3(2.0f)));
    const CameraView view = lookAt({0, 3, 6}, {0, 0.5f, 0}, 0.9f);
    GpuScene uploaded = upload(scene);
    std::vector<float> expected(width * height);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        uploaded.setLights(std::span(lights).subspan(i, 1));
        const HdrImage without = drawnWith(uploaded, view, Shadows::off),
                       with = drawnWith(uploaded, view, Shadows::on);
        for (std::size_t p = 0; p < expected.size(); ++p)
            expected[p] += without.rgba[4 * p] > 0.0f && with.rgba[4 * p] == 0.0f ? 1.0f : 0.0f;
    }
    uploaded.setLights(lights);
    const auto counts = [&](DebugView debugView, Shadows shadows) {
        FrameRequest request{width, height, view};
        request.debugView = debugView;
        request.shadows = shadows;
        render(uploaded, request);
        return lastFrame().aovs({"shadowed_count"}).front().values.front();
    };
    const float most = *std::ranges::max_element(expected);
    EXPECT_GE(most, 4.0f);
    EXPECT_EQ(counts(DebugView::none, Shadows::on), expected);
    EXPECT_GT(lastFrame().shadowCounts().raysAsked, 0u);
    EXPECT_EQ(counts(DebugView::normals, Shadows::on), expected);
    EXPECT_EQ(counts(DebugView::none, Shadows::off), std::vector<float>(expected.size()));
    EXPECT_EQ(counts(DebugView::shadowedCount, Shadows::off), std::vector<float>(expected.size()));
    EXPECT_EQ(lastFrame().maxLightCount(), 0u);
    EXPECT_EQ(counts(DebugView::shadowedCount, Shadows::on), expected);
    EXPECT_EQ(lastFrame().maxLightCount(), static_cast<std::uint32_t>(most));
    const HdrImage heat = lastFrame().radiance();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float count = expected[static_cast<std::size_t>(y * width + x)];
            ASSERT_LT(glm::distance(pixelOf(heat, x, y), heatColor(count / most)), 1e-5f) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace candela::test
