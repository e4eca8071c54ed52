// Skins and morph targets move the drawn vertices, with both evaluators.

#include "support/drawing_test.h"
#include "support/lit_scenes.h"
#include "support/random_rig.h"

#include "render/gpu_scene/gpu_scene_state.h"
#include "scene/model/deformation.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <limits>

namespace candela::test {
namespace {

constexpr int width = 64, height = 48;

FrameRequest framing(const Bounds& bounds) {
    return {width, height, frameBounds(bounds, static_cast<float>(width) / height), BrdfModel::course,
            Technique::fullscreen};
}

FrameRequest looking(const glm::vec3& eye, const glm::vec3& target) {
    return {width, height, lookAt(eye, target, 0.8f), BrdfModel::course, Technique::fullscreen};
}

std::vector<float> floatsOf(const gl::Buffer& buffer, std::size_t count) {
    std::vector<float> floats(count);
    glGetNamedBufferSubData(buffer.name(), 0, static_cast<GLsizeiptr>(count * sizeof(float)), floats.data());
    return floats;
}

DeformedVertices verticesOf(const std::vector<float>& surface, const std::vector<float>& tangents,
                            const glm::dvec3& origin) {
    DeformedVertices vertices;
    for (std::size_t i = 0; i < surface.size(); i += 6) {
        vertices.positions.push_back(origin + glm::dvec3(surface[i], surface[i + 1], surface[i + 2]));
        vertices.normals.emplace_back(surface[i + 3], surface[i + 4], surface[i + 5]);
    }
    for (std::size_t i = 0; i < tangents.size(); i += 4)
        vertices.tangents.emplace_back(tangents[i], tangents[i + 1], tangents[i + 2], tangents[i + 3]);
    return vertices;
}

/// The vertices that the first deformed mesh is drawn with, in world space.
DeformedVertices drawnVertices(GpuScene& scene, const Mesh& mesh) {
    const GpuDeformations& deformations = scene.state().deformations;
    const DeformedBuffers& buffers = deformations.buffers(0);
    std::vector<float> tangents;
    if (!mesh.tangents.empty()) tangents = floatsOf(buffers.tangents, 4 * mesh.positions.size());
    return verticesOf(floatsOf(buffers.surface, 6 * mesh.positions.size()), tangents,
                      glm::dvec3(deformations.placement(0).worldFromLocal[3]));
}

class DeformationTest : public DrawingTest {
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
    static GpuScene uploadFor(VertexEvaluator evaluator, const Scene& scene) {
        GpuSceneOptions options;
        options.vertexEvaluator = evaluator;
        return GpuScene(context(), scene, options);
    }
    static const GpuScene::State::UpdateCounts& lastUpdate(GpuScene& scene) {
        return scene.state().lastUpdate;
    }
};

void expectBounded(GpuScene& scene, const DeformedVertices& vertices) {
    const GpuDeformations::Placement& placement = scene.state().deformations.placement(0);
    const BoundingSphere sphere = worldSphere(placement.worldFromLocal, placement.sphere);
    for (const glm::dvec3& position : vertices.positions)
        ASSERT_LE(glm::distance(position, glm::dvec3(sphere.center)), 1.0001 * sphere.radius + 1e-6);
}

TEST_F(DeformationTest, randomRigsAgreeWithTheEvaluationInDoublePrecision) {
    constexpr std::array<RigSize, 6> sizes{{{1, 1, 1, 0, false},
                                            {63, 3, 2, 1, true},
                                            {64, 20, 4, 0, true},
                                            {301, 60, 4, 5, false},
                                            {1000, 200, 8, 7, true},
                                            {2500, 130, 11, 2, true}}};
    withBothEvaluators([&](VertexEvaluator evaluator) {
        for (std::uint32_t seed = 0; seed < sizes.size(); ++seed) {
            SCOPED_TRACE(seed);
            Scene rig = randomRig(seed, sizes[seed]);
            for (std::uint32_t pose = 0; pose < 3; ++pose) {
                if (pose > 0) poseRandomly(rig, 100 * seed + pose);
                const std::vector<glm::mat4> world = worldTransforms(rig);
                GpuScene scene = uploadFor(evaluator, rig);
                render(scene, framing(worldBounds(rig, world)));
                ASSERT_EQ(scene.deformationReport().evaluator, toString(evaluator));
                const DeformedVertices vertices = drawnVertices(scene, rig.meshes[0]);
                expectDeformed(vertices, rig, 0, world);
                expectBounded(scene, vertices);
            }
        }
    });
}

TEST_F(DeformationTest, everyInstructionSetDeformsTheSame) {
    const Scene rig = randomRig(9, {777, 50, 8, 3, true});
    const std::vector<glm::mat4> world = worldTransforms(rig);
    const glm::vec3 origin(world[1][3]);
    std::vector<glm::dmat4x3> matrices;
    for (std::size_t i = 0; i < rig.skins[0].joints.size(); ++i)
        matrices.push_back(jointMatrix(world[1 + i], rig.skins[0].inverseBindMatrices[i], origin));
    const PosedJoints joints = posedJoints(matrices);
    const MeshDeformation mesh(rig.meshes[0], GpuMeshes::Detail::everything);
    for (const DeformKernel* kernel : deformKernels()) {
        SCOPED_TRACE(kernel->name);
        for (const bool streams : {false, true}) {
            std::vector<float> surface(6 * mesh.vertexCount()), tangents(4 * mesh.vertexCount());
            DeformJob job = mesh.job();
            job.streams = streams;  // Memory of `new` is aligned as it has to be.
            job.joints = joints.rows.data();
            job.directionScale = joints.directionScale;
            job.morphWeights = rig.nodes[0].morphWeights.data();
            job.surface = surface.data();
            job.tangents = tangents.data();
            kernel->deform(job, 0, mesh.blockCount());
            expectDeformed(verticesOf(surface, tangents, glm::dvec3(origin)), rig, 0, world);
        }
    }
}

TEST_F(DeformationTest, farFromTheOriginIsAsPreciseAsNearIt) {
    const glm::vec3 center(500'000.0f, 0.0f, 4'000'000.0f);
    withBothEvaluators([&](VertexEvaluator evaluator) {
        Scene rig = randomRig(4, {200, 1, 1, 0, false}, center);
        // Of one joint whose place is a whole number, so that its matrix is exact.
        std::get<Transform>(rig.nodes[1].transform).translation = center;
        rig.skins[0].inverseBindMatrices[0] = glm::mat4(1.0f);
        const std::vector<glm::mat4> world = worldTransforms(rig);
        GpuScene scene = uploadFor(evaluator, rig);
        render(scene, framing(worldBounds(rig, world)));
        expectDeformed(drawnVertices(scene, rig.meshes[0]), rig, 0, world);
    });
}

TEST_F(DeformationTest, morphTargetsAloneMoveAMeshAtItsNode) {
    withBothEvaluators([&](VertexEvaluator evaluator) {
        Scene rig = randomRig(5, {150, 1, 1, 3, true});
        rig.nodes[0].skin.reset();
        std::get<Transform>(rig.nodes[0].transform).translation = {1, 2, 3};
        const std::vector<glm::mat4> world = worldTransforms(rig);
        GpuScene scene = uploadFor(evaluator, rig);
        render(scene, framing(worldBounds(rig, world)));
        DeformedVertices vertices = drawnVertices(scene, rig.meshes[0]);
        const GpuDeformations::Placement& placement = scene.state().deformations.placement(0);
        EXPECT_EQ(placement.worldFromLocal, world[0]);
        // The buffers hold the vertices in the node's space.
        for (std::size_t i = 0; i < vertices.positions.size(); ++i)
            vertices.positions[i] -= glm::dvec3(world[0][3]);
        Scene atOrigin = rig;
        atOrigin.nodes[0].transform = Transform{};
        expectDeformed(vertices, atOrigin, 0, worldTransforms(atOrigin));
    });
}

/// A quad from (-0.5, -0.5) to (0.5, 0.5) in the plane z = 0 that faces +Z, moved by one joint. Its node is
/// scaled by 0.01.
Scene skinnedQuad() {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.influenceCount = 1;
    mesh.joints.assign(4, 0);
    mesh.jointWeights.assign(4, 1.0f);
    scene.nodes.resize(2);
    scene.nodes[0].mesh = 0;
    scene.nodes[0].skin = 0;
    scene.nodes[0].transform = Transform{{3, 3, 3}, {1, 0, 0, 0}, glm::vec3(0.01f)};
    scene.nodes[1].name = "joint";
    scene.skins.push_back({"skin", {1}, {glm::mat4(1.0f)}});
    return scene;
}

const FrameRequest front = looking({0, 0, 3}, {0, 0, 0});

bool isDrawn(const HdrImage& picture, int x, int y) {
    return picture.rgba[4 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) + 3] > 0.0f;
}

TEST_F(DeformationTest, skinnedMeshIsPlacedByItsJoints) {
    Scene quad = skinnedQuad();
    const Bounds bounds = nodeBounds(quad, 0, worldTransforms(quad));
    EXPECT_EQ(bounds.min, glm::vec3(-0.5f, -0.5f, 0));
    EXPECT_EQ(bounds.max, glm::vec3(0.5f, 0.5f, 0));
    GpuScene scene = upload(quad);
    const HdrImage picture = drawn(scene, front);
    EXPECT_TRUE(isDrawn(picture, width / 2, height / 2));
    // 48 pixels are 2 × 3 m × tan(0.4) = 2.54 m high: half a metre is 9.5 pixels.
    for (const int away : {-8, 8}) {
        EXPECT_TRUE(isDrawn(picture, width / 2 + away, height / 2 + away));
        EXPECT_FALSE(isDrawn(picture, width / 2 + 2 * away, height / 2));
    }
    EXPECT_EQ(lastFrame().probe(width / 2, height / 2)->node, 0u);
}

TEST_F(DeformationTest, mirroringJointsKeepTheFront) {
    withBothEvaluators([&](VertexEvaluator evaluator) {
        Scene quad = skinnedQuad();
        quad.nodes[1].transform = Transform{{0, 0, 0}, {1, 0, 0, 0}, {-1, 2, 1}};
        GpuScene scene = uploadFor(evaluator, quad);
        EXPECT_TRUE(isDrawn(drawn(scene, front), width / 2, height / 2)) << "back faces are culled";
        EXPECT_EQ(aovs(width).vector("N", width / 2, height / 2).z, 1.0f);
        EXPECT_FALSE(isDrawn(drawn(scene, looking({0, 0, -3}, {0, 0, 0})), width / 2, height / 2));
    });
}

TEST_F(DeformationTest, editsDeformOnlyWhatMoves) {
    withBothEvaluators([&](VertexEvaluator evaluator) {
        Scene quads = skinnedQuad();
        quads.skins.push_back({"other", {2}, {glm::mat4(1.0f)}});
        quads.nodes.emplace_back();
        quads.nodes.emplace_back();
        quads.nodes[3].mesh = 0;
        quads.nodes[3].skin = 1;
        quads.nodes[2].transform = Transform{{0.2f, 0, -1}};
        GpuScene scene = uploadFor(evaluator, quads);
        drawn(scene, front);
        EXPECT_EQ(lastUpdate(scene).deformed, 2u);
        drawn(scene, front);
        EXPECT_EQ(lastUpdate(scene).deformations, 0u);
        EXPECT_EQ(lastUpdate(scene).deformed, 0u) << "nothing has moved";
        quads.nodes[1].transform =
            glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(1, 0, 0)), glm::vec3(0.9f));
        scene.setTransform(1, std::get<glm::mat4>(quads.nodes[1].transform));
        const HdrImage moved = drawn(scene, front);
        EXPECT_EQ(lastUpdate(scene).deformations, 1u);
        EXPECT_EQ(lastUpdate(scene).deformed, 1u);
        EXPECT_TRUE(isDrawn(moved, width / 2 + 19, height / 2)) << "1 m to the right is 19 pixels";
        EXPECT_EQ(moved.rgba, drawn(uploadFor(evaluator, quads), front).rgba) << "as a new scene";
        scene.setTransform(0, glm::mat4(1.0f));
        EXPECT_EQ(drawn(scene, front).rgba, moved.rgba);
        EXPECT_EQ(lastUpdate(scene).deformed, 0u) << "the node of a skinned mesh does not move it";
    });
}

TEST_F(DeformationTest, meshesOutOfViewAreDeformedWhenTheyComeIntoView) {
    Scene quad = skinnedQuad();
    GpuScene scene = upload(quad);
    drawn(scene, looking({0, 0, 3}, {0, 0, 6}));
    EXPECT_EQ(lastUpdate(scene).deformed, 0u);
    scene.setTransform(1, glm::translate(glm::mat4(1.0f), glm::vec3(0.4f, 0, 0)));
    drawn(scene, looking({0, 0, 3}, {0, 0, 6}));
    EXPECT_EQ(lastUpdate(scene).deformed, 0u);
    EXPECT_TRUE(isDrawn(drawn(scene, front), width / 2 + 15, height / 2));
    EXPECT_EQ(lastUpdate(scene).deformed, 1u);
    scene.setVisibility(0, GpuScene::Visibility::hidden);
    scene.setTransform(1, glm::mat4(1.0f));
    drawn(scene, front);
    EXPECT_EQ(lastUpdate(scene).deformed, 0u);
    scene.setVisibility(0, GpuScene::Visibility::shown);
    EXPECT_FALSE(isDrawn(drawn(scene, front), width / 2 + 15, height / 2));
}

TEST_F(DeformationTest, animatedMorphWeightsMoveTheMesh) {
    withBothEvaluators([&](VertexEvaluator evaluator) {
        Scene quad = skinnedQuad();
        quad.nodes[0].skin.reset();
        quad.nodes[0].transform = Transform{};
        quad.meshes[0].morphTargets.resize(1);
        quad.meshes[0].morphTargets[0].offsets.assign(4, {1, 0, 0});
        quad.animations.push_back(
            {"slide", {{0, AnimationPath::morphWeights, Interpolation::linear, {0, 2}, {0, 2}}}});
        GpuScene scene = uploadFor(evaluator, quad);
        EXPECT_TRUE(isDrawn(drawn(scene, front), width / 2, height / 2));
        scene.setTime(1.0);
        const HdrImage moved = drawn(scene, front);
        EXPECT_FALSE(isDrawn(moved, width / 2, height / 2));
        EXPECT_TRUE(isDrawn(moved, width / 2 + 19, height / 2));
        EXPECT_EQ(nodeBounds(quad, 0, worldTransforms(quad, 1.0), 1.0).min.x, 0.5f);
        scene.setTime(1.0);
        drawn(scene, front);
        EXPECT_EQ(lastUpdate(scene).deformations, 0u) << "the time is the same";
        scene.playAnimations({});
        EXPECT_TRUE(isDrawn(drawn(scene, front), width / 2, height / 2)) << "no animation plays";
        constexpr std::array<std::uint32_t, 1> slide{0};
        scene.playAnimations(slide);
        EXPECT_EQ(drawn(scene, front).rgba, moved.rgba);
    });
}

TEST_F(DeformationTest, meshesWithoutSkinAndWeightsAreDrawnAsTheyAre) {
    Scene quad = skinnedQuad();
    quad.nodes[0].skin.reset();
    quad.nodes[0].transform = Transform{};
    quad.meshes[0].morphTargets.resize(1);
    quad.meshes[0].morphTargets[0].offsets.assign(4, {1, 0, 0});
    quad.nodes[0].morphWeights = {0.0f};
    GpuScene scene = upload(quad);
    EXPECT_EQ(scene.deformationReport().meshes, 0u);
    Scene plain = quad;
    plain.meshes[0].morphTargets.clear();
    plain.meshes[0].influenceCount = 0;
    plain.meshes[0].joints.clear();
    plain.meshes[0].jointWeights.clear();
    plain.nodes[0].morphWeights.clear();
    EXPECT_EQ(drawn(scene, front).rgba, drawn(upload(plain), front).rgba);
}

}  // namespace
}  // namespace candela::test
