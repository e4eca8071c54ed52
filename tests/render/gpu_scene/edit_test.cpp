// Edits of an uploaded scene: their cost, their errors, and that the image is that of a newly uploaded scene.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include "gl/state_guard.h"
#include "render/layout.h"

#include <candela/error.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <thread>

namespace candela::test {
namespace {

const FrameRequest inputs{64, 48, lookAt({0.5f, 1.0f, 6}, {0, 0, 0}, 0.8f), BrdfModel::course,
                          Technique::fullscreen};

glm::mat4 at(float x, float y = 0.0f) {
    return glm::translate(glm::mat4(1.0f), {x, y, 0.0f});
}

constexpr std::uint32_t groups = 100, children = 9, nodesPerGroup = 1 + children;

/// Groups of a parent and its children, which show the same mesh. Group i has material i, and every child of
/// an odd index has a light.
Scene sceneOfGroups() {
    Scene scene;
    for (std::uint32_t group = 0; group < groups; ++group) {
        const std::uint32_t parent =
            place(scene, makeQuad(0.05f), Material{}, at(0.1f * float(group % 10), 0.1f * float(group / 10)));
        for (std::uint32_t child = 0; child < children; ++child) {
            Node node;
            node.parent = parent;
            node.mesh = scene.nodes[parent].mesh;
            node.transform = at(0.01f * float(child));
            scene.nodes.push_back(node);
            if (child % 2 == 0) continue;
            Light light;
            light.node = static_cast<std::uint32_t>(scene.nodes.size() - 1);
            scene.lights.push_back(light);
        }
    }
    return scene;
}

class EditTest : public DrawingTest {
  protected:
    static GpuScene::State::UpdateCounts updated(GpuScene& scene) {
        const gl::StateGuard guard(*context().state().binding, "a test");
        scene.state().update();
        return scene.state().lastUpdate;
    }
    /// The message of the error that `edit` has to throw.
    static std::string errorOfEdit(const std::function<void()>& edit) {
        try {
            edit();
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            return error.what();
        }
        ADD_FAILURE() << "no error was thrown";
        return "";
    }
};

TEST_F(EditTest, uploadLeavesNothingToUpdate) {
    GpuScene scene(context(), sceneOfGroups());
    GpuScene::State::UpdateCounts counts = updated(scene);
    EXPECT_EQ(counts.nodes + counts.instances + counts.lights + counts.materials + counts.draws, 0u);
}

TEST_F(EditTest, movedNodeCostsItsSubtree) {
    GpuScene scene(context(), sceneOfGroups());
    scene.setTransform(1, at(0.3f));
    GpuScene::State::UpdateCounts counts = updated(scene);
    EXPECT_EQ(counts.nodes, 1u);
    EXPECT_EQ(counts.instances, 1u);
    EXPECT_EQ(counts.lights, 0u);
    EXPECT_EQ(counts.draws, 0u);
    scene.setTransform(nodesPerGroup, at(0.3f));
    scene.setTransform(nodesPerGroup + 3, at(0.3f));  // A child of the other: counts once.
    counts = updated(scene);
    EXPECT_EQ(counts.nodes, std::size_t{nodesPerGroup});
    EXPECT_EQ(counts.instances, std::size_t{nodesPerGroup});
    EXPECT_EQ(counts.lights, std::size_t{children / 2});
    EXPECT_EQ(counts.draws, 0u);
}

TEST_F(EditTest, mirroredNodeCostsItsDraws) {
    GpuScene scene(context(), sceneOfGroups());
    scene.setTransform(0, glm::scale(glm::mat4(1.0f), glm::vec3(-1, 1, 1)));
    EXPECT_EQ(updated(scene).draws, std::size_t{nodesPerGroup});
}

TEST_F(EditTest, visibilityCostsNothingToUpdate) {
    GpuScene scene(context(), sceneOfGroups());
    for (std::uint32_t node = 0; node < groups * nodesPerGroup; node += 2)
        scene.setVisibility(node, GpuScene::Visibility::hidden);
    GpuScene::State::UpdateCounts counts = updated(scene);
    EXPECT_EQ(counts.nodes + counts.instances + counts.lights + counts.draws, 0u);
}

TEST_F(EditTest, materialCostsItsRecordAndItsDrawsWhereTheirStateChanges) {
    GpuScene scene(context(), sceneOfGroups());
    Material material;
    material.roughness = 0.3f;
    scene.setMaterial(5, material);
    scene.setMaterial(5, material);
    GpuScene::State::UpdateCounts counts = updated(scene);
    EXPECT_EQ(counts.materials, 1u);
    EXPECT_EQ(counts.draws, 0u);
    material.doubleSided = true;
    scene.setMaterial(5, material);
    counts = updated(scene);
    EXPECT_EQ(counts.materials, 1u);
    EXPECT_EQ(counts.draws, std::size_t{nodesPerGroup});
    EXPECT_EQ(counts.instances, 0u);
}

/// Animates the translation of a node from (0, 0, 0) to (1, 0, 0) in one second.
void animate(Scene& scene, std::uint32_t node) {
    scene.nodes[node].transform = Transform{};
    Animation animation;
    animation.channels.push_back(
        {node, AnimationPath::translation, Interpolation::linear, {0.0f, 1.0f}, {0, 0, 0, 1, 0, 0}});
    scene.animations.push_back(animation);
}

TEST_F(EditTest, timeCostsTheAnimatedSubtrees) {
    Scene animated = sceneOfGroups();
    animate(animated, 0);
    animate(animated, nodesPerGroup + 1);
    GpuScene scene(context(), animated);
    scene.setTime(0.5);
    EXPECT_EQ(updated(scene).nodes, std::size_t{nodesPerGroup + 1});
    scene.setTime(7.0);
    updated(scene);
    scene.setTime(9.0);
    EXPECT_EQ(updated(scene).nodes, 0u) << "both have ended";
}

TEST_F(EditTest, matrixReplacesTheAnimationOfANode) {
    Scene animated = sceneOf(makeSphere(0.5f), Material{});
    place(animated, makeSphere(0.5f), Material{});
    animate(animated, 0);
    animate(animated, 1);
    Scene expected = animated;
    GpuScene scene(context(), animated);
    scene.setTransform(0, at(-1.5f));
    const WorldLight light = pointLight({1, 3, 5}, 30.0f, glm::vec3(30.0f));
    scene.setLights({&light, 1});
    expected.animations.clear();
    expected.nodes[0].transform = at(-1.5f);
    for (const float seconds : {0.0f, 0.75f}) {
        scene.setTime(double{seconds});
        expected.nodes[1].transform = at(seconds);
        EXPECT_EQ(drawn(scene, inputs).rgba, drawn(upload(expected, {&light, 1}), inputs).rgba) << seconds;
    }
}

TEST_F(EditTest, animationsThatPlayAreSelected) {
    Scene animated = sceneOf(makeSphere(0.5f), Material{});
    place(animated, makeSphere(0.5f), Material{});
    animate(animated, 0);
    animate(animated, 1);
    const WorldLight light = pointLight({1, 3, 5}, 30.0f, glm::vec3(30.0f));
    GpuScene scene = upload(animated, {&light, 1});
    scene.setTime(0.75);
    const std::vector<std::vector<std::uint32_t>> selections{{1}, {}, {0}, {0, 1}};
    for (const std::vector<std::uint32_t>& selection : selections) {
        Scene expected = animated;
        for (std::uint32_t i = 0; i < 2; ++i)
            expected.animations[i].plays = std::ranges::find(selection, i) != selection.end();
        scene.playAnimations(selection);
        GpuScene fresh = upload(expected, {&light, 1});
        fresh.setTime(0.75);
        EXPECT_EQ(drawn(scene, inputs).rgba, drawn(fresh, inputs).rgba);
    }
    // A node that the host places stays there.
    scene.setTransform(0, at(-1.5f));
    const HdrImage before = drawn(scene, inputs);
    scene.playAnimations(selections[2]);
    scene.playAnimations(selections[3]);
    EXPECT_EQ(drawn(scene, inputs).rgba, before.rgba);
    const std::vector<std::uint32_t> beyond{2};
    EXPECT_NE(errorOfEdit([&] { scene.playAnimations(beyond); }).find("animation 2"), std::string::npos);
}

TEST_F(EditTest, manyEditsGiveTheImageOfANewScene) {
    Scene edited = sceneOfGroups();
    GpuScene scene(context(), edited);
    for (std::uint32_t step = 0; step < 40; ++step) {
        const auto node = static_cast<std::uint32_t>(hashed(step, 1) * float(edited.nodes.size() - 1));
        const float mirror = step % 3 == 0 ? -1.0f : 1.0f;
        const glm::mat4 matrix =
            glm::scale(at(hashed(step, 2) - 0.5f, hashed(step, 3) - 0.5f), glm::vec3(mirror, 2, 2));
        edited.nodes[node].transform = matrix;
        scene.setTransform(node, matrix);
        const auto index = static_cast<std::uint32_t>(hashed(step, 4) * float(groups - 1));
        Material& material = edited.materials[index];
        material.baseColor = {hashed(step, 5), hashed(step, 6), 0.5f, 1.0f};
        material.doubleSided = step % 2 == 0;
        if (step % 5 == 0) material.emission = glm::vec3(0.1f);
        scene.setMaterial(index, material);
        if (step % 8 != 7) continue;
        EXPECT_EQ(drawn(scene, inputs).rgba, drawn(GpuScene(context(), edited), inputs).rgba) << step;
    }
}

TEST_F(EditTest, indicesOutOfRangeAreErrors) {
    GpuScene scene(context(), sceneOfCage(makeCubeCage(1.0f), Material{}), subdividing(1));
    const std::vector<glm::vec3> points = makeCubeCage(1.0f).positions;
    constexpr std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
    for (const std::uint32_t index : {1u, last}) {
        EXPECT_NE(
            errorOfEdit([&] { scene.setTransform(index, at(1)); }).find("node " + std::to_string(index)),
            std::string::npos);
        EXPECT_NE(errorOfEdit([&] { scene.setVisibility(index, GpuScene::Visibility::hidden); }).find("node"),
                  std::string::npos);
        EXPECT_NE(
            errorOfEdit([&] { scene.setCastsShadow(index, GpuScene::ShadowCasting::off); }).find("node"),
            std::string::npos);
        EXPECT_NE(errorOfEdit([&] { scene.setCagePoints(index, points); }).find("node"), std::string::npos);
        EXPECT_NE(
            errorOfEdit([&] { scene.setMaterial(index, {}); }).find("material " + std::to_string(index)),
            std::string::npos);
    }
}

TEST_F(EditTest, invalidMatricesAndTimesAreErrorsAndChangeNothing) {
    Scene animated = sceneOf(makeSphere(0.5f), Material{});
    animated.nodes[0].name = "ball";
    animate(animated, 0);
    GpuScene scene(context(), animated);
    const HdrImage before = drawn(scene, inputs);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    glm::mat4 projective(1.0f), unknown(1.0f);
    projective[2][3] = 1.0f;
    unknown[3][0] = nan;
    EXPECT_NE(errorOfEdit([&] { scene.setTransform(0, unknown); }).find("ball"), std::string::npos);
    EXPECT_NE(errorOfEdit([&] { scene.setTransform(0, projective); }).find("affine"), std::string::npos);
    errorOfEdit([&] { scene.setTime(infinite); });
    errorOfEdit([&] { scene.setTime(double{nan}); });
    EXPECT_EQ(drawn(scene, inputs).rgba, before.rgba);
}

TEST_F(EditTest, invalidLightsAreErrorsAndChangeNothing) {
    Scene lit = sceneOf(makeSphere(1.0f), Material{});
    GpuScene scene(context(), lit);
    const WorldLight good = pointLight({1, 3, 5}, 30.0f, glm::vec3(30.0f));
    scene.setLights({&good, 1});
    const HdrImage before = drawn(scene, inputs);
    std::vector<WorldLight> lights(40, good);
    lights[39].range = -1.0f;
    EXPECT_NE(errorOfEdit([&] { scene.setLights(lights); }).find("light 39"), std::string::npos);
    EXPECT_EQ(scene.lightReport().lights, 1u);
    EXPECT_EQ(drawn(scene, inputs).rgba, before.rgba);
}

/// `w` of the second texel of each light's record.
std::vector<float> shadowFlags(GpuScene& scene) {
    const std::span<const glm::vec4> texels = scene.state().lights.recordData();
    std::vector<float> flags;
    for (std::size_t i = 1; i < texels.size(); i += layout::LIGHT_TEXELS) flags.push_back(texels[i].w);
    return flags;
}

TEST_F(EditTest, lightRecordsTellWhichLightsCastShadows) {
    Scene description = sceneOf(makeSphere(1.0f), Material{});
    description.lights.resize(2);
    description.lights[1].type = LightType::directional;
    description.lights[1].node = 0;
    description.lights[1].castsShadow = false;
    GpuScene scene(context(), description);
    EXPECT_EQ(shadowFlags(scene), (std::vector<float>{1, 0}));
    scene.setTransform(0, glm::rotate(glm::mat4(1.0f), 0.5f, {1, 0, 0}));
    updated(scene);
    EXPECT_EQ(shadowFlags(scene), (std::vector<float>{1, 0})) << "a light that moves keeps its flag";

    // Records are sorted by type: points, spots, directional lights.
    std::vector<WorldLight> lights{directionalLight({0, 0, -1}, glm::vec3(1)),
                                   spotLight({0, 0, 1}, {0, 0, 0}, 1.0f, glm::vec3(1), 0.1f, 0.5f),
                                   pointLight({0, 0, 1}, 1.0f, glm::vec3(1))};
    for (std::size_t shadowed = 0; shadowed < lights.size(); ++shadowed) {
        for (std::size_t i = 0; i < lights.size(); ++i) lights[i].castsShadow = i == shadowed;
        scene.setLights(lights);
        std::vector<float> expected(3, 0.0f);
        expected[2 - shadowed] = 1.0f;
        EXPECT_EQ(shadowFlags(scene), expected);
        EXPECT_TRUE(scene.state().lights.anyCastsShadow());
    }
    for (WorldLight& light : lights) light.castsShadow = false;
    scene.setLights(lights);
    EXPECT_EQ(shadowFlags(scene), std::vector<float>(3, 0.0f));
    EXPECT_FALSE(scene.state().lights.anyCastsShadow());
}

TEST_F(EditTest, nodesCastShadowsAsTheSceneOrTheHostSays) {
    Scene description = sceneOfGroups();
    description.nodes[1].castsShadow = false;
    GpuScene scene(context(), description);
    const std::vector<Node>& nodes = scene.state().sceneState.nodes;
    EXPECT_TRUE(nodes[0].castsShadow);
    EXPECT_FALSE(nodes[1].castsShadow);
    scene.setCastsShadow(0, GpuScene::ShadowCasting::off);
    scene.setCastsShadow(1, GpuScene::ShadowCasting::on);
    EXPECT_FALSE(nodes[0].castsShadow);
    EXPECT_TRUE(nodes[1].castsShadow) << "a child is not affected";
    const GpuScene::State::UpdateCounts counts = updated(scene);
    EXPECT_EQ(counts.nodes + counts.instances + counts.lights + counts.draws, 0u);
}

TEST_F(EditTest, movedFromSceneIsAnError) {
    GpuScene scene(context(), sceneOf(makeSphere(1.0f), Material{}));
    GpuScene taken = std::move(scene);
    // NOLINTBEGIN(bugprone-use-after-move): use after move is what is tested.
    EXPECT_NE(errorOfEdit([&] { scene.setTime(1.0); }).find("moved from"), std::string::npos);
    errorOfEdit([&] { scene.setTransform(0, at(1)); });
    errorOfEdit([&] { scene.setLights({}); });
    errorOfEdit([&] { scene.triangleCount(); });
    errorOfEdit([&] { drawn(scene, inputs); });
    // NOLINTEND(bugprone-use-after-move)
    EXPECT_EQ(taken.triangleCount(), candela::triangleCount(sceneOf(makeSphere(1.0f), Material{})));
}

TEST_F(EditTest, editsWithoutTheContextAreErrors) {
    GpuScene scene(context(), sceneOfCage(makeCubeCage(1.0f), Material{}), subdividing(1));
    const std::vector<glm::vec3> points = makeCubeCage(1.0f).positions;
    const std::function<void()> edits[] = {[&] { scene.setLights({}); },
                                           [&] { scene.setCagePoints(0, points); },
                                           [&] { scene.setMaterial(0, {}); }};
    for (const std::function<void()>& edit : edits) {
        std::optional<ErrorKind> kind;
        std::thread([&] {  // No context is current on it.
            try {
                edit();
            } catch (const Error& error) {
                kind = error.kind();
            }
        })
            .join();
        EXPECT_EQ(kind, ErrorKind::environment);
        EXPECT_NO_THROW(edit());
    }
}

TEST_F(EditTest, meshWithoutSubmeshesIsDrawnWithTheDefaultMaterial) {
    Scene whole = sceneOf(makeSphere(1.0f), Material{});
    whole.meshes[0].submeshes[0].material.reset();
    Scene bare = whole;
    bare.meshes[0].submeshes.clear();
    const WorldLight light = pointLight({1, 3, 5}, 30.0f, glm::vec3(30.0f));
    const HdrImage expected = drawn(upload(whole, {&light, 1}), inputs);
    EXPECT_GT(pixelOf(expected, 32, 24).x, 0.0f);
    EXPECT_EQ(drawn(upload(bare, {&light, 1}), inputs).rgba, expected.rgba);
    EXPECT_EQ(triangleCount(bare), triangleCount(whole));
}

}  // namespace
}  // namespace candela::test
