// Occlusion culling: G-buffers with and without it are the same bit for bit, and what walls hide is not
// drawn.

#include "support/drawing_test.h"
#include "support/gbuffer_words.h"
#include "support/hashed_points.h"
#include "support/procedural_scene.h"

#include <candela/shapes.h>

#include "gl/state_guard.h"
#include "render/culling/occlusion_culler.h"
#include "render/culling/triangle_filter.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/geometry_pass.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <vector>

namespace candela::test {
namespace {

constexpr int width = 331, height = 197;

class OcclusionCullerTest : public DrawingTest {
  protected:
    void SetUp() override {
        if (!context().isSoftware()) GTEST_SKIP() << "the CPU reads the meshes of software devices alone";
    }

    struct Drawn {
        GBufferWords words;
        std::size_t draws;
        std::size_t hiddenTriangles;
    };
    enum class Culling { frustum, occlusion };

    static Drawn draw(GpuScene& scene, const CameraView& view, Culling culling) {
        context().makeCurrent();
        const gl::StateGuard guard(*context().state().binding, "a test");
        GpuScene::State& state = scene.state();
        state.update();
        const Frustum frustum(view, static_cast<float>(width) / height);
        const layout::FrameUniforms uniforms =
            frameUniforms(view, width, height, glm::dmat3(1.0), state.lights.counts());
        DrawSelection draws;
        // A new one, which searches each frame.
        state.occlusionCuller = std::make_unique<OcclusionCuller>(state);
        if (culling == Culling::frustum) {
            state.cull(frustum, draws);
        } else {
            // Meshes hide others from the second frame on.
            state.cullOccluded(frustum, uniforms, draws);
            EXPECT_EQ(draws.hiddenTriangles().size(), 0u);
            state.cullOccluded(frustum, uniforms, draws);
        }
        gl::Buffer buffer("frame", gl::BufferUsage::dynamic);
        buffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
        glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, buffer.name());
        const GBufferTargets targets(width, height);
        TriangleFilter* filter = culling == Culling::occlusion ? state.triangleFilter.get() : nullptr;
        if (filter != nullptr) filter->filter(draws, uniforms);
        GeometryPass().render({state, draws, targets, LoadOp::clear, SurfaceSet::all, filter});
        return {wordsOf(targets), draws.drawCount(), draws.hiddenTriangles().size()};
    }

    /// Returns how many draws were left out; adds to `triangles` how many triangles of the others were.
    static std::size_t expectSame(GpuScene& scene, const CameraView& view, std::size_t* triangles = nullptr) {
        const Drawn all = draw(scene, view, Culling::frustum), some = draw(scene, view, Culling::occlusion);
        EXPECT_TRUE(all.words == some.words);
        EXPECT_LE(some.draws, all.draws);
        if (triangles != nullptr) *triangles += some.hiddenTriangles;
        return all.draws - some.draws;
    }
};

std::uint32_t addMaterial(Scene& scene, const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void addBox(Scene& scene, std::uint32_t mesh, const glm::vec3& center, const glm::vec3& size,
            const glm::mat4& rotation = glm::mat4(1.0f)) {
    Node node;
    node.mesh = mesh;
    node.transform = glm::scale(glm::translate(glm::mat4(1.0f), center) * rotation, size);
    scene.nodes.push_back(node);
}

/// A wall of 10 m by 10 m at z = 0, which cuts the x axis at 0, and 100 small boxes 1 m behind it.
Scene wallScene(const Material& material) {
    Scene scene;
    const std::uint32_t wall = addMaterial(scene, material), plain = addMaterial(scene, {});
    for (const std::uint32_t of : {wall, plain}) {
        Mesh mesh = boxMesh();
        mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), of}};
        scene.meshes.push_back(mesh);
    }
    addBox(scene, 0, {0, 0, 0}, {10, 10, 0.1f});
    for (int i = 0; i < 100; ++i) {
        const glm::vec2 place(i % 10 - 5, i / 10 - 5);
        addBox(scene, 1, {0.6f * place, -1.5f}, glm::vec3(0.3f));
    }
    return scene;
}

const CameraView beforeTheWall = lookAt({0.3f, 0.2f, 6}, {0.1f, 0, 0}, 0.8f);

TEST_F(OcclusionCullerTest, whatAWallHidesIsNotDrawn) {
    GpuScene scene = upload(wallScene({}));
    EXPECT_EQ(expectSame(scene, beforeTheWall), 100u);
    // Those that show beside the wall are drawn: at 30 m the picture is 25 m wide.
    const CameraView beside = lookAt({18, 0, 1}, {0, 0, -1.5f}, 0.8f);
    EXPECT_LT(expectSame(scene, beside), 100u);
}

TEST_F(OcclusionCullerTest, whatLetsLightThroughHidesNothing) {
    Material mask, blend, glass;
    mask.alphaMode = AlphaMode::mask;
    blend.alphaMode = AlphaMode::blend;
    glass.transmission.factor = 1.0f;
    for (const Material& material : {mask, blend, glass}) {
        GpuScene scene = upload(wallScene(material));
        EXPECT_EQ(expectSame(scene, beforeTheWall), 0u);
    }
}

TEST_F(OcclusionCullerTest, whatFacesAwayHidesNothing) {
    Scene scene = wallScene({});
    // From the inside a box shows nothing of itself, unless it has two sides. Its other walls are out of
    // view.
    scene.nodes[0].transform = glm::scale(glm::mat4(1.0f), glm::vec3(4, 4, 1));
    const CameraView inside = lookAt({0, 0, 0.4f}, {0, 0, -3}, 0.8f);
    GpuScene oneSided = upload(scene);
    EXPECT_EQ(expectSame(oneSided, inside), 0u);
    scene.materials[0].doubleSided = true;
    GpuScene twoSided = upload(scene);
    EXPECT_GT(expectSame(twoSided, inside), 0u);
}

TEST_F(OcclusionCullerTest, aHiddenOrMovedWallHidesNothing) {
    GpuScene scene = upload(wallScene({}));
    scene.setVisibility(0, GpuScene::Visibility::hidden);
    EXPECT_EQ(expectSame(scene, beforeTheWall), 0u);
    scene.setVisibility(0, GpuScene::Visibility::shown);
    EXPECT_EQ(expectSame(scene, beforeTheWall), 100u);
    scene.setTransform(0, glm::translate(glm::mat4(1.0f), glm::vec3(0, 50, 0)));
    EXPECT_EQ(expectSame(scene, beforeTheWall), 0u);
}

TEST_F(OcclusionCullerTest, aMeshHidesOthersWhileItRests) {
    GpuScene scene = upload(wallScene({}));
    GpuScene::State& state = scene.state();
    const Frustum frustum(beforeTheWall, static_cast<float>(width) / height);
    const layout::FrameUniforms uniforms =
        frameUniforms(beforeTheWall, width, height, glm::dmat3(1.0), state.lights.counts());
    DrawSelection draws;
    const auto drawn = [&] {
        context().makeCurrent();
        state.update();
        state.cullOccluded(frustum, uniforms, draws);
        return draws.drawCount();
    };
    const Mesh wall = boxMesh();
    for (int i = 0; i < 4; ++i) {
        SCOPED_TRACE(i);
        EXPECT_EQ(drawn(), 101u);
        EXPECT_EQ(drawn(), 1u);
        scene.setPositions(0, wall.positions, wall.normals);
    }
    // It has moved too often to be read again.
    for (int i = 0; i < 3; ++i) EXPECT_EQ(drawn(), 101u);
}

TEST_F(OcclusionCullerTest, positionsThatAreNotFiniteHideNothing) {
    const std::vector<float> vertices{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, NAN, 0, 0, 0, 1};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    EXPECT_FALSE(boxOf(vertices));
    EXPECT_TRUE(occluderMesh(vertices, indices).triangles.empty());
}

TEST_F(OcclusionCullerTest, orthographicViewsDrawAll) {
    GpuScene scene = upload(wallScene({}));
    CameraView view = beforeTheWall;
    view.orthographicHeight = 4.0f;
    view.farPlane = 100.0f;
    EXPECT_EQ(expectSame(scene, view), 0u);
}

/// Small boxes behind a wall, which reach beyond its right edge by up to two pixels or end before it.
Scene edgeScene() {
    Scene scene;
    scene.meshes = {boxMesh()};
    addBox(scene, 0, {-5, 0, 0}, {10, 10, 0.1f});
    // As beforeTheEdge sees them: a pixel is 1 / 77 m at the front of the wall.
    for (std::uint32_t i = 0; i < 100; ++i) {
        const float pixels = hashedBetween(-1.0f, 2.0f, 1, i), nearest = 1.4f;
        const float right = pixels / 77.0f * (3.0f + nearest) / 2.95f;
        addBox(scene, 0, {right - 0.05f, 0.015f * static_cast<float>(i) - 0.75f, -nearest - 0.01f},
               {0.1f, 0.006f, 0.02f});
    }
    return scene;
}

TEST_F(OcclusionCullerTest, whatReachesBeyondAnEdgeByLessThanAPixelIsDrawn) {
    GpuScene scene = upload(edgeScene());
    CameraView beforeTheEdge = lookAt({0, 0, 3}, {0, 0, 0}, 0.8f);
    std::size_t hidden = 0;
    // The edge at all places of a block and between the centres of pixels.
    for (int i = 0; i < 64; ++i) {
        SCOPED_TRACE(i);
        beforeTheEdge.shift.x = static_cast<float>(i) / 8.0f / width;
        hidden += expectSame(scene, beforeTheEdge);
    }
    EXPECT_GT(hidden, 50u);
}

/// Boxes of all sizes and directions around the origin, some of them walls.
Scene randomBoxes(std::uint32_t seed) {
    Scene scene;
    Material material;
    std::vector<std::uint32_t> materials;
    for (const bool isDoubleSided : {false, true}) {
        material.doubleSided = isDoubleSided;
        materials.push_back(addMaterial(scene, material));
        material.emission = {1.0f, 0.5f, 0.2f};
    }
    for (const std::uint32_t of : materials) {
        Mesh box = boxMesh();
        // The wall of a face may have any material.
        box.submeshes = {{0, 18, of}, {18, 18, materials[0]}};
        scene.meshes.push_back(box);
        scene.meshes.push_back(makeSphere(0.5f, 8, 4));
    }
    Material other;
    other.baseColor = {1.0f, 0.0f, 0.0f, 1.0f};
    Mesh redBox = boxMesh();
    redBox.submeshes = {{0, static_cast<std::uint32_t>(redBox.indices.size()), addMaterial(scene, other)}};
    const auto red = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(redBox);
    for (std::uint32_t i = 0; i < 160; ++i) {
        const bool isWall = i % 5 == 0;
        const glm::mat4 rotation =
            glm::rotate(glm::mat4(1.0f), hashed(seed + 9, i) < 0.5f ? 0.0f : 6.3f * hashed(seed + 8, i),
                        glm::normalize(hashedPoint(seed + 10, i) + glm::vec3(0, 0, 1.0e-3f)));
        glm::vec3 size(hashedBetween(0.1f, 1.0f, seed + 3, i));
        if (isWall)
            size = {hashedBetween(2.0f, 12.0f, seed + 4, i), hashedBetween(2.0f, 12.0f, seed + 5, i), 0.1f};
        if (hashed(seed + 6, i) < 0.2f) size.x = -size.x;
        const glm::vec3 center = 8.0f * hashedPoint(seed, i);
        addBox(scene, i % 4, center, size, rotation);
        // Surfaces of equal depth, of which the one that is drawn first is seen.
        if (i % 4 == 0 && !isWall) addBox(scene, red, center, size, rotation);
    }
    return scene;
}

TEST_F(OcclusionCullerTest, randomBoxesAreTheSame) {
    std::size_t hidden = 0;
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        GpuScene scene = upload(randomBoxes(100 * seed));
        for (std::uint32_t i = 0; i < 6; ++i) {
            SCOPED_TRACE(i);
            CameraView view = lookAt(9.0f * hashedPoint(20 + seed, i), 3.0f * hashedPoint(40 + seed, i),
                                     hashedBetween(0.3f, 1.6f, 60 + seed, i));
            view.nearPlane = i % 2 == 0 ? 0.01f : 0.7f;
            if (i % 3 == 0) view.farPlane = 30.0f;
            view.shift = 0.02f * glm::vec2(hashedPoint(80 + seed, i));
            hidden += expectSame(scene, view);
        }
    }
    // Of some 5,000 draws in view. That none were would prove nothing.
    EXPECT_GT(hidden, 200u);
}

/// Adds a box to a mesh.
void appendBox(Mesh& mesh, const glm::vec3& center, const glm::vec3& size) {
    const Mesh box = boxMesh(size);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& position : box.positions) mesh.positions.push_back(position + center);
    mesh.normals.insert(mesh.normals.end(), box.normals.begin(), box.normals.end());
    for (const std::uint32_t index : box.indices) mesh.indices.push_back(first + index);
}

/// One mesh of walls of two materials that share it, and small boxes.
Scene mazeScene(std::uint32_t seed) {
    Scene scene;
    Material twoSided;
    twoSided.doubleSided = true;
    addMaterial(scene, {});
    addMaterial(scene, twoSided);
    Mesh walls;
    for (std::uint32_t i = 0; i < 120; ++i) {
        glm::vec3 size(hashedBetween(1.0f, 9.0f, seed + 4, i), 3.0f, 0.1f);
        if (hashed(seed + 5, i) < 0.5f) std::swap(size.x, size.z);
        appendBox(walls, glm::round(20.0f * hashedPoint(seed, i) * glm::vec3(1, 0, 1)), size);
    }
    const auto half = static_cast<std::uint32_t>(walls.indices.size() / 2);
    walls.submeshes = {{0, half, 0}, {half, half, 1}};
    // Submeshes may share triangles.
    if (seed % 200 == 0) walls.submeshes.push_back({0, half, 0});
    scene.meshes = {walls, boxMesh()};
    Node node;
    node.mesh = 0;
    scene.nodes.push_back(node);
    for (std::uint32_t i = 0; i < 60; ++i)
        addBox(scene, 1, 20.0f * hashedPoint(seed + 7, i) * glm::vec3(1, 0, 1), glm::vec3(0.4f));
    return scene;
}

TEST_F(OcclusionCullerTest, trianglesThatWallsOfTheSameMeshHideAreNotDrawn) {
    std::size_t hidden = 0, triangles = 0;
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        GpuScene scene = upload(mazeScene(100 * seed));
        for (std::uint32_t i = 0; i < 6; ++i) {
            SCOPED_TRACE(i);
            const glm::vec3 eye = 15.0f * hashedPoint(20 + seed, i) * glm::vec3(1, 0.05f, 1);
            CameraView view = lookAt(eye, eye + hashedPoint(40 + seed, i) * glm::vec3(1, 0.1f, 1),
                                     hashedBetween(0.3f, 1.6f, 60 + seed, i));
            view.nearPlane = i % 2 == 0 ? 0.01f : 0.3f;
            hidden += expectSame(scene, view, &triangles);
        }
    }
    // That none were would prove nothing.
    EXPECT_GT(hidden, 200u);
    EXPECT_GT(triangles, 300u);
}

/// The kernel draws a polygon where its edges say, whatever the instruction set.
TEST(OcclusionBufferTest, blocksAreHiddenWherePolygonsCoverThem) {
    for (const OcclusionKernel* kernel : occlusionKernels()) {
        SCOPED_TRACE(kernel->name);
        OcclusionBuffer buffer(*kernel);
        buffer.clear(200, 100);
        // x from 20 to 120, y from 10 to 60; nearness 1 - x / 1000.
        OccluderPolygon left{};
        left.edges[0] = {1, 0, -20}, left.edges[1] = {-1, 0, 70}, left.edges[2] = {0, 1, -10},
        left.edges[3] = {0, -1, 60};
        left.edgeCount = 4;
        left.plane[0] = -0.001f, left.plane[2] = 1.0f;
        left.maxY = 60;
        OccluderPolygon right = left;
        right.edges[0] = {1, 0, -70}, right.edges[1] = {-1, 0, 120};
        const OccluderPolygon both[] = {left, right};
        buffer.draw(both);
        EXPECT_TRUE(buffer.hides({24, 16, 119, 55}, 0.87f));
        EXPECT_FALSE(buffer.hides({24, 16, 119, 55}, 0.885f)) << "the right end is farther";
        EXPECT_TRUE(buffer.hides({24, 16, 40, 55}, 0.95f));
        EXPECT_FALSE(buffer.hides({24, 16, 120, 55}, 0.5f)) << "column 120 is not covered";
        EXPECT_FALSE(buffer.hides({15, 16, 40, 55}, 0.5f));
        EXPECT_FALSE(buffer.hides({24, 16, 40, 60}, 0.5f));
        EXPECT_FALSE(buffer.hides({-20, 16, -10, 55}, 0.5f)) << "out of the picture";
        const OccluderPolygon one[] = {left};
        buffer.clear(200, 100);
        buffer.draw(one);
        EXPECT_FALSE(buffer.hides({64, 16, 71, 23}, 0.5f)) << "a part of a block is not covered";
    }
}

}  // namespace
}  // namespace candela::test
