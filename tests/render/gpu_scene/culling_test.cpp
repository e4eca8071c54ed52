// Which instances pass culling, and how their draws are batched.

#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "render/gpu_scene/gpu_scene_state.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <numbers>

namespace candela::test {
namespace {

constexpr int width = 40, height = 20;
constexpr float halfHeight = 0.5f, halfWidth = 1.0f;  // of the picture at a depth of one metre

/// From the origin along -Z.
CameraView forward() {
    CameraView view;
    view.verticalFov = 2.0f * std::atan(halfHeight);
    view.nearPlane = 0.5f;
    return view;
}

class CullingTest : public DrawingTest {
  protected:
    static DrawSelection selectionOf(auto&& scene) {
        DrawSelection selection;
        scene.state().cull(Frustum(forward(), float(width) / float(height)), selection);
        return selection;
    }
    static std::size_t drawsOf(auto&& scene) {
        render(scene, {width, height, forward(), BrdfModel::course, Technique::fullscreen});
        return selectionOf(scene).drawCount();
    }

    static bool isDrawn(const glm::vec3& center, float radius) {
        const glm::mat4 there = glm::translate(glm::mat4(1.0f), center);
        Material material;
        material.doubleSided = true;  // The near plane may cut off all but the far half of a sphere.
        return drawsOf(upload(sceneOf(makeSphere(radius), material, there))) == 1;
    }

    static int coveredPixels() {
        int covered = 0;
        const std::vector<float> rgba = lastFrame().radiance().rgba;
        for (std::size_t i = 3; i < rgba.size(); i += 4) covered += rgba[i] > 0.0f;
        return covered;
    }
};

TEST_F(CullingTest, objectsOutsideAPlaneAreCulledAndThoseAcrossItAreNot) {
    constexpr float depth = 10.0f, radius = 0.5f;
    struct Side {
        glm::vec3 onPlane, outwards;
    };
    // Culling uses the bounding sphere, which is larger by sqrt(3) for any matrix: "just outside" is two
    // radii.
    const Side sides[] = {
        {{-halfWidth * depth, 0, -depth}, glm::normalize(glm::vec3(-1, 0, halfWidth))},
        {{halfWidth * depth, 0, -depth}, glm::normalize(glm::vec3(1, 0, halfWidth))},
        {{0, -halfHeight * depth, -depth}, glm::normalize(glm::vec3(0, -1, halfHeight))},
        {{0, halfHeight * depth, -depth}, glm::normalize(glm::vec3(0, 1, halfHeight))},
        {{0, 0, -0.5f}, {0, 0, 1}},
    };
    for (const Side& side : sides) {
        EXPECT_FALSE(isDrawn(side.onPlane + 2.0f * radius * side.outwards, radius));
        EXPECT_EQ(coveredPixels(), 0);
        EXPECT_TRUE(isDrawn(side.onPlane + 0.9f * radius * side.outwards, radius));
        EXPECT_TRUE(isDrawn(side.onPlane, radius));
        EXPECT_GT(coveredPixels(), 0);
        EXPECT_TRUE(isDrawn(side.onPlane - 3.0f * radius * side.outwards, radius));
    }
}

TEST_F(CullingTest, objectsBehindTheCameraAreCulled) {
    EXPECT_FALSE(isDrawn({0, 0, 10}, 1.0f));
    EXPECT_FALSE(isDrawn({100, 0, 3}, 1.0f));
}

TEST_F(CullingTest, visibleObjectsAreNotCulled) {
    // Random spheres, some mirrored, scaled unevenly and sheared.
    int seen = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
        const glm::vec3 center(20 * hashed(90, i) - 10, 10 * hashed(91, i) - 5, -9 * hashed(92, i) + 1);
        glm::mat4 transform = glm::translate(glm::mat4(1.0f), center);
        transform =
            glm::rotate(transform, 6.0f * hashed(93, i), glm::normalize(glm::vec3(1, hashed(94, i), 2)));
        transform = glm::scale(transform, glm::vec3(3 * hashed(95, i) - 1.5f, 0.2f, 4 * hashed(96, i)));
        transform[0] += 0.5f * transform[1];
        Material material;
        material.doubleSided = true;
        const bool drawnAtAll = drawsOf(upload(sceneOf(makeSphere(1.0f), material, transform))) == 1;
        const int covered = coveredPixels();
        if (!drawnAtAll) {
            EXPECT_EQ(covered, 0);
        }
        seen += covered > 0;
        // A culled sphere has no vertex that projects into the picture.
        if (drawnAtAll) continue;
        for (const glm::vec3& vertex : makeSphere(1.0f).positions) {
            const glm::vec3 p(transform * glm::vec4(vertex, 1.0f));
            const bool inside =
                p.z < -0.5f && std::abs(p.x) < -p.z * halfWidth && std::abs(p.y) < -p.z * halfHeight;
            ASSERT_FALSE(inside) << i;
        }
    }
    EXPECT_GT(seen, 10);
    EXPECT_LT(seen, 60);
}

TEST_F(CullingTest, movedInstanceIsCulledAtItsNewPosition) {
    GpuScene scene =
        upload(sceneOf(makeSphere(0.5f), Material{}, glm::translate(glm::mat4(1.0f), {0, 0, -5})));
    EXPECT_EQ(drawsOf(scene), 1u);
    scene.setTransform(0, glm::translate(glm::mat4(1.0f), {0, 0, 5}));
    EXPECT_EQ(drawsOf(scene), 0u);
    scene.setTransform(0, glm::translate(glm::mat4(1.0f), {3, 0, -5}));
    EXPECT_EQ(drawsOf(scene), 1u);
}

TEST_F(CullingTest, drawsOfOneStateAreBatched) {
    Scene scene;
    Material plain, doubleSided;
    doubleSided.doubleSided = true;
    for (int i = 0; i < 12; ++i) {
        const glm::mat4 there = glm::translate(glm::mat4(1.0f), {0.3f * float(i) - 2, 0, -5});
        const glm::mat4 mirrored = glm::scale(there, glm::vec3(-1, 1, 1));
        place(scene, makeSphere(0.1f), i % 2 == 0 ? plain : doubleSided, i % 3 == 0 ? mirrored : there);
    }
    GpuScene uploaded = upload(scene);
    EXPECT_EQ(drawsOf(uploaded), 12u);
    EXPECT_EQ(selectionOf(uploaded).batches().size(), 4u);
}

TEST_F(CullingTest, selectionsOfSeveralViewsAreIndependent) {
    Scene scene = sceneOf(makeSphere(0.5f), Material{}, glm::translate(glm::mat4(1.0f), {0, 0, -5}));
    Material emissive;
    emissive.emission = glm::vec3(1.0f);
    place(scene, makeSphere(0.5f), emissive, glm::translate(glm::mat4(1.0f), {0, 0, 5}));
    GpuScene uploaded = upload(scene);
    EXPECT_EQ(drawsOf(uploaded), 1u);
    const DrawSelection ahead = selectionOf(uploaded);
    DrawSelection behind;
    uploaded.state().cull(Frustum(lookAt({0, 0, 0}, {0, 0, 1}, 0.8f), 2.0f), behind);
    EXPECT_EQ(ahead.commandCount(), 1u);
    EXPECT_FALSE(ahead.emits());
    EXPECT_EQ(behind.commandCount(), 1u);
    EXPECT_TRUE(behind.emits());
}

TEST_F(CullingTest, instancesOfOneMeshAreAllDrawn) {
    Scene scene = sceneOf(makeSphere(0.3f), Material{}, glm::translate(glm::mat4(1.0f), {-2, 0, -5}));
    for (int i = 1; i < 5; ++i) {
        Node node = scene.nodes[0];
        node.transform = glm::translate(glm::mat4(1.0f), {float(i) - 2, 0, -5});
        scene.nodes.push_back(node);
    }
    GpuScene uploaded = upload(scene);
    EXPECT_EQ(drawsOf(uploaded), 5u);
    EXPECT_EQ(selectionOf(uploaded).commandCount(), 1u) << "one command draws neighbouring instances";
    uploaded.setVisibility(2, GpuScene::Visibility::hidden);
    EXPECT_EQ(drawsOf(uploaded), 4u);
    EXPECT_EQ(selectionOf(uploaded).commandCount(), 2u) << "before and after the hidden one";
    uploaded.setVisibility(2, GpuScene::Visibility::shown);
    EXPECT_EQ(drawsOf(uploaded), 5u);
    const AovReader reader = aovs(width);
    for (int i = 0; i < 5; ++i) {
        const int x = int((0.5f + 0.5f * (float(i) - 2.0f) / 5.0f) * width);
        EXPECT_GT(reader.scalar("Z", x, height / 2), 4.0f) << i;
    }
}

TEST_F(CullingTest, eachPartOfAMeshIsOneCommandForAllItsInstances) {
    Scene scene = sceneOf(makeSphere(0.3f), Material{}, glm::translate(glm::mat4(1.0f), {-2, 0, -5}));
    Material red;
    red.baseColor = {1, 0, 0, 1};
    scene.materials.push_back(red);
    const auto half = static_cast<std::uint32_t>(scene.meshes[0].indices.size() / 6 * 3);
    const auto rest = static_cast<std::uint32_t>(scene.meshes[0].indices.size()) - half;
    scene.meshes[0].submeshes = {{0, half, 0u}, {half, rest, 1u}};
    for (int i = 1; i < 5; ++i) {
        Node node = scene.nodes[0];
        node.transform = glm::translate(glm::mat4(1.0f), {float(i) - 2, 0, -5});
        scene.nodes.push_back(node);
    }
    GpuScene uploaded = upload(scene);
    EXPECT_EQ(drawsOf(uploaded), 10u);
    EXPECT_EQ(selectionOf(uploaded).commandCount(), 2u);
    const AovReader reader = aovs(width);
    for (int i = 0; i < 5; ++i) {
        const int x = int((0.5f + 0.5f * (float(i) - 2.0f) / 5.0f) * width);
        EXPECT_GT(reader.scalar("Z", x, height / 2), 4.0f) << i;
    }
}

}  // namespace
}  // namespace candela::test
