// The drawn limit surfaces follow their cages, with both evaluators.

#include "support/cage_scenes.h"
#include "support/drawing_test.h"
#include "support/procedural_scene.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>

namespace candela::test {
namespace {

constexpr std::uint32_t level = 3;

FrameRequest frameOf(const glm::vec3& eye, const glm::vec3& target = {0, 0, 0}) {
    return {64, 48, lookAt(eye, target, 0.8f), BrdfModel::course, Technique::fullscreen};
}

const FrameRequest front = frameOf({1.0f, 1.5f, 6.0f});

DrawnVertices limitOf(const Cage& cage, std::span<const glm::vec3> points) {
    const RefinedCage refined = subdivider().refine(cage, level);
    DrawnVertices limit;
    limit.positions.resize(refined.vertexCount());
    limit.normals.resize(refined.vertexCount());
    evaluateLimit(refined, points, {limit.positions, limit.normals, {}, {}});
    return limit;
}

/// Some twenty products are summed, each rounded to 6e-8 of numbers that are 2 at most; the derivatives
/// whose cross product is a normal are shorter than the points by up to ten times.
constexpr float positionTolerance = 3e-6f, normalTolerance = 3e-5f;

void expectSame(const DrawnVertices& actual, const DrawnVertices& expected) {
    ASSERT_EQ(actual.positions.size(), expected.positions.size());
    for (std::size_t i = 0; i < expected.positions.size(); ++i) {
        ASSERT_LT(glm::distance(actual.positions[i], expected.positions[i]), positionTolerance) << i;
        ASSERT_LT(glm::distance(actual.normals[i], expected.normals[i]), normalTolerance) << i;
    }
}

class CageMotionTest : public DrawingTest {
  protected:
    void TearDown() override { EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)); }

    /// Calls `body(evaluator)` for both evaluators.
    template <typename Body>
    static void withBothEvaluators(const Body& body) {
        for (const VertexEvaluator evaluator : {VertexEvaluator::compute, VertexEvaluator::cpu}) {
            SCOPED_TRACE(toString(evaluator));
            body(evaluator);
        }
    }
    static GpuScene uploadCages(const Scene& scene, VertexEvaluator evaluator) {
        GpuSceneOptions options = subdividing(level);
        options.vertexEvaluator = evaluator;
        return GpuScene(context(), scene, options);
    }
    static std::string evaluatorOf(GpuScene& scene) { return scene.cageReport().evaluator; }
};

TEST_F(CageMotionTest, drawnVerticesAreTheLimitOfTheMovedCage) {
    withBothEvaluators([](VertexEvaluator evaluator) {
        for (const Cage& cage : {makeCubeCage(1.0f), makeSharpCubeCage(1.0f), makeSheetCage(1.5f, 5)}) {
            GpuScene scene = uploadCages(sceneOfCage(cage, Material{}), evaluator);
            render(scene, front);
            EXPECT_EQ(evaluatorOf(scene), toString(evaluator));
            expectSame(drawnVertices(scene), limitOf(cage, cage.positions));
            for (std::uint32_t move = 0; move < 3; ++move) {
                const std::vector<glm::vec3> points = jittered(cage.positions, 0.4f, 10 * move);
                scene.setCagePoints(0, points);
                render(scene, front);
                expectSame(drawnVertices(scene), limitOf(cage, points));
            }
        }
    });
}

TEST_F(CageMotionTest, allVerticesOfAPointAgreeBitForBit) {
    const Cage cage = makeSharpCubeCage(1.0f);
    const RefinedCage refined = subdivider().refine(cage, level);
    // Seven points inside each of the 12 sharp edges have two sides, 8 corners have three.
    ASSERT_EQ(refined.seamPoints.size(), 12u * 7u + 8u * 2u);
    withBothEvaluators([&](VertexEvaluator evaluator) {
        GpuScene scene = uploadCages(sceneOfCage(cage, Material{}), evaluator);
        scene.setCagePoints(0, jittered(cage.positions, 0.3f, 3));
        render(scene, front);
        const DrawnVertices drawn = drawnVertices(scene);
        for (std::uint32_t i = refined.pointCount; i < refined.vertexCount(); ++i)
            ASSERT_EQ(drawn.positions[i], drawn.positions[refined.pointOf(i)]) << i;
    });
}

TEST_F(CageMotionTest, movedCageGivesTheImageOfANewScene) {
    const Cage cage = makeCubeCage(1.0f);
    const WorldLight light = pointLight({2, 3, 5}, 30.0f, glm::vec3(10.0f));
    withBothEvaluators([&](VertexEvaluator evaluator) {
        GpuScene moved = uploadCages(sceneOfCage(cage, Material{}), evaluator);
        moved.setLights({&light, 1});
        drawn(moved, front);
        Cage movedCage = cage;
        movedCage.positions = jittered(cage.positions, 0.4f, 77);
        moved.setCagePoints(0, movedCage.positions);
        moved.setTransform(0, glm::translate(glm::mat4(1.0f), {0.3f, 0.0f, 0.0f}));
        GpuScene fresh = uploadCages(
            sceneOfCage(movedCage, Material{}, glm::translate(glm::mat4(1.0f), {0.3f, 0.0f, 0.0f})),
            evaluator);
        fresh.setLights({&light, 1});
        const HdrImage expected = drawn(fresh, front);
        EXPECT_EQ(drawn(moved, front).rgba, expected.rgba);
        EXPECT_GT(pixelOf(expected, 32, 24).x, 0.0f);
    });
}

/// A cube whose upper half follows a rotating joint, with an animated morph target, over one second.
Scene animatedScene() {
    Cage cage = makeCubeCage(1.0f);
    cage.influenceCount = 2;
    for (const glm::vec3& point : cage.positions) {
        const float upper = point.y > 0.0f ? 0.8f : 0.1f;
        cage.joints.insert(cage.joints.end(), {0, 1});
        cage.jointWeights.insert(cage.jointWeights.end(), {1.0f - upper, upper});
    }
    cage.morphTargets.push_back({jittered(std::vector<glm::vec3>(8, glm::vec3(0.0f)), 0.5f, 5)});
    Scene scene = sceneOfCage(cage, Material{}, glm::translate(glm::mat4(1.0f), {5, 0, 0}));
    scene.nodes[0].skin = 0;
    scene.nodes[0].morphWeights = {0.2f};
    scene.nodes.resize(3);
    scene.nodes[2].parent = 1;
    scene.skins.push_back({"", {1, 2}, {glm::mat4(1.0f), glm::mat4(1.0f)}});
    const float half = std::sqrt(0.5f);
    Animation animation;
    animation.channels.push_back(
        {2, AnimationPath::rotation, Interpolation::linear, {0.0f, 1.0f}, {0, 0, 0, 1, 0, 0, half, half}});
    animation.channels.push_back(
        {0, AnimationPath::morphWeights, Interpolation::linear, {0.0f, 1.0f}, {0.2f, 1.0f}});
    scene.animations.push_back(animation);
    return scene;
}

TEST_F(CageMotionTest, skinAndMorphTargetsMoveTheSurface) {
    Scene scene = animatedScene();
    scene.nodes[0].transform = Transform{};
    withBothEvaluators([&](VertexEvaluator evaluator) {
        GpuScene uploaded = uploadCages(scene, evaluator);
        for (const double time : {0.0, 0.4, 1.0, 0.0}) {
            uploaded.setTime(time);
            render(uploaded, front);
            const PosedPoints posed = poseCage(scene, 0, worldTransforms(scene, time), time);
            expectSame(drawnVertices(uploaded), limitOf(scene.cages[0], posed.points));
        }
    });
}

TEST_F(CageMotionTest, skinnedCageIsPlacedByItsJoints) {
    const Scene scene = animatedScene();
    GpuScene uploaded = uploadCages(scene, VertexEvaluator::cpu);
    EXPECT_GT(drawn(uploaded, front).rgba[4 * (24 * 64 + 32) + 3], 0.0f) << "its node is 5 m to the side";
}

TEST_F(CageMotionTest, nodesThatShareACageMoveIndependently) {
    const Cage cage = makeCubeCage(1.0f);
    Scene scene = sceneOfCage(cage, Material{}, glm::translate(glm::mat4(1.0f), {-1.5f, 0, 0}));
    scene.nodes.push_back(scene.nodes[0]);
    scene.nodes[1].transform = glm::translate(glm::mat4(1.0f), {1.5f, 0, 0});
    withBothEvaluators([&](VertexEvaluator evaluator) {
        GpuScene uploaded = uploadCages(scene, evaluator);
        render(uploaded, front);
        EXPECT_EQ(uploaded.cageReport().cages, 2u);
        const std::vector<glm::vec3> points = jittered(cage.positions, 0.4f, 8);
        uploaded.setCagePoints(1, points);
        render(uploaded, front);
        expectSame(drawnVertices(uploaded, 0), limitOf(cage, cage.positions));
        expectSame(drawnVertices(uploaded, 1), limitOf(cage, points));
        // The last instance of the shared surface keeps it.
        uploaded.setCagePoints(0, points);
        render(uploaded, front);
        expectSame(drawnVertices(uploaded, 0), limitOf(cage, points));
        EXPECT_EQ(uploaded.cageReport().triangles, 2u * 6u * 64u * 2u);
    });
}

TEST_F(CageMotionTest, aovsReadAfterAnEditDoNotDrawSurfacesThatAreNotYetEvaluated) {
    Scene scene = sceneOfCage(makeCubeCage(1.0f), Material{});
    scene.nodes.push_back(scene.nodes[0]);
    scene.materials[0].emission = glm::vec3(1.0f);
    GpuScene uploaded = uploadCages(scene, VertexEvaluator::compute);
    render(uploaded, front);
    uploaded.setCagePoints(1, jittered(makeCubeCage(1.0f).positions, 0.2f, 4));
    EXPECT_EQ(aovs(64).vector("emission", 32, 24), glm::vec3(1.0f)) << "the other node's";
}

TEST_F(CageMotionTest, cageMovedOutOfViewIsEvaluatedWhenItComesIntoView) {
    const Cage cage = makeCubeCage(1.0f);
    GpuScene scene = uploadCages(sceneOfCage(cage, Material{}), VertexEvaluator::compute);
    const FrameRequest away = frameOf({0, 0, 6}, {0, 0, 12});
    render(scene, away);
    EXPECT_EQ(evaluatorOf(scene), "") << "nothing has been evaluated";
    const std::vector<glm::vec3> points = jittered(cage.positions, 0.4f, 21);
    scene.setCagePoints(0, points);
    render(scene, away);
    render(scene, front);
    expectSame(drawnVertices(scene), limitOf(cage, points));
}

TEST_F(CageMotionTest, deviceDecidesTheEvaluator) {
    GpuScene scene(context(), sceneOfCage(makeCubeCage(1.0f), Material{}), subdividing(6));
    render(scene, front);
    EXPECT_EQ(evaluatorOf(scene), context().isSoftware() ? "cpu" : "compute");
}

TEST_F(CageMotionTest, invalidCagePointsAreErrors) {
    Scene scene = sceneOfCage(makeCubeCage(1.0f), Material{});
    scene.nodes[0].name = "box";
    scene.nodes.emplace_back();
    GpuScene uploaded = uploadCages(scene, VertexEvaluator::cpu);
    const auto errorOfEdit = [&](std::uint32_t node, const std::vector<glm::vec3>& points) -> std::string {
        try {
            uploaded.setCagePoints(node, points);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::badInput);
            return error.what();
        }
        return "";
    };
    std::vector<glm::vec3> points = makeCubeCage(1.0f).positions;
    EXPECT_NE(errorOfEdit(1, points).find("node 1"), std::string::npos);
    points[5].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NE(errorOfEdit(0, points).find("point 5"), std::string::npos);
    points.pop_back();
    EXPECT_NE(errorOfEdit(0, points).find("box"), std::string::npos);
    EXPECT_EQ(drawn(uploaded, front).rgba.size(), 4u * 64u * 48u) << "the scene is usable after an error";
}

}  // namespace
}  // namespace candela::test
