// A hidden node gives the image of a scene whose node has no mesh or cage.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <glm/gtc/matrix_transform.hpp>

namespace candela::test {
namespace {

const FrameRequest inputs{64, 48, lookAt({0, 0.5f, 6}, {0, 0, 0}, 0.8f), BrdfModel::course,
                          Technique::fullscreen};

glm::mat4 at(float x) {
    return glm::translate(glm::mat4(1.0f), {x, 0.0f, 0.0f});
}

/// A sphere, a cage, and another sphere whose parent is the first.
Scene threeObjects() {
    Material emissive;
    emissive.emission = {0.2f, 0.5f, 0.1f};
    Scene scene = sceneOf(makeSphere(0.8f), emissive, at(-2.0f));
    placeCage(scene, makeCubeCage(0.8f), Material{});
    place(scene, makeSphere(0.8f), Material{}, at(4.0f));
    scene.nodes[2].parent = 0;
    return scene;
}

class VisibilityTest : public DrawingTest {
  protected:
    static GpuScene uploadLit(const Scene& scene) {
        GpuScene uploaded(context(), scene, subdividing(2));
        uploaded.setLights({&light, 1});
        return uploaded;
    }
    static inline const WorldLight light = pointLight({0, 3, 5}, 30.0f, glm::vec3(20.0f));
};

TEST_F(VisibilityTest, hiddenNodeIsNotDrawn) {
    const Scene scene = threeObjects();
    GpuScene changed = uploadLit(scene);
    const HdrImage all = drawn(changed, inputs);
    for (std::uint32_t node = 0; node < 3; ++node) {
        Scene without = scene;
        without.nodes[node].mesh.reset();
        without.nodes[node].cage.reset();
        GpuScene fresh = uploadLit(without);
        changed.setVisibility(node, GpuScene::Visibility::hidden);
        const HdrImage picture = drawn(changed, inputs);
        EXPECT_EQ(picture.rgba, drawn(fresh, inputs).rgba) << node;
        EXPECT_NE(picture.rgba, all.rgba) << node;
        changed.setVisibility(node, GpuScene::Visibility::shown);
        EXPECT_EQ(drawn(changed, inputs).rgba, all.rgba) << node;
    }
}

TEST_F(VisibilityTest, hiddenCageIsNotEvaluated) {
    GpuScene scene = uploadLit(threeObjects());
    scene.setVisibility(1, GpuScene::Visibility::hidden);
    render(scene, inputs);
    EXPECT_EQ(scene.cageReport().evaluator, "");
    scene.setVisibility(1, GpuScene::Visibility::shown);
    render(scene, inputs);
    EXPECT_NE(scene.cageReport().evaluator, "");
}

TEST_F(VisibilityTest, nodeWithoutMeshOrCageCanBeHidden) {
    Scene scene = threeObjects();
    scene.nodes.emplace_back();
    GpuScene uploaded = uploadLit(scene);
    const HdrImage all = drawn(uploaded, inputs);
    uploaded.setVisibility(3, GpuScene::Visibility::hidden);
    EXPECT_EQ(drawn(uploaded, inputs).rgba, all.rgba);
}

}  // namespace
}  // namespace candela::test
