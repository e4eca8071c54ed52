// The triangle filter: G-buffers with and without it are the same bit for bit, and it drops what it can.

#include "support/drawing_test.h"
#include "support/gbuffer_words.h"
#include "support/hashed_points.h"
#include "support/procedural_scene.h"

#include "gl/state_guard.h"
#include "render/culling/compute_triangle_filter.h"
#include "render/culling/cpu_triangle_filter.h"
#include "render/frame_uniforms.h"
#include "render/gbuffer/geometry_pass.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

namespace candela::test {
namespace {

constexpr int width = 211, height = 117;

/// Triangles in a cube of 2 m, of sizes from a thousandth of a millimetre to metres, each direction of view
/// alike.
Mesh soup(std::uint32_t triangles, std::uint32_t seed) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const glm::vec3 center = hashedPoint(seed, i);
        const float size = std::exp(hashedBetween(std::log(1.0e-6f), std::log(2.0f), seed + 3, i));
        for (std::uint32_t k = 0; k < 3; ++k) {
            mesh.positions.push_back(center + size * hashedPoint(seed + 4 + 3 * k, i));
            mesh.indices.push_back(3 * i + k);
        }
        const std::size_t first = mesh.positions.size() - 3;
        const glm::vec3 normal = glm::cross(mesh.positions[first + 1] - mesh.positions[first],
                                            mesh.positions[first + 2] - mesh.positions[first]);
        const float length = glm::length(normal);
        mesh.normals.insert(mesh.normals.end(), 3, length > 0.0f ? normal / length : glm::vec3(0, 0, 1));
    }
    // The same triangles with other normals: what is drawn first is seen.
    for (std::uint32_t i = 0; i < triangles / 3 * 3; ++i) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(mesh.positions[i]);
        mesh.normals.push_back(-mesh.normals[i]);
    }
    return mesh;
}

CameraView viewOf(const glm::vec3& eye, const glm::vec3& target) {
    return lookAt(eye, target, 0.8f);
}

/// A form of the filter.
struct Form {
    std::string name;
    std::function<std::unique_ptr<TriangleFilter>(const GpuScene::State&)> make;
};

/// All that the device and the processor run.
std::vector<Form> forms(const Context& context) {
    std::vector<Form> all{{"compute", [](const GpuScene::State& scene) {
                               return std::make_unique<ComputeTriangleFilter>(scene, 64);
                           }}};
    // The CPU reads the meshes of software devices.
    if (!context.isSoftware()) return all;
    for (const TriangleFilterKernel* kernel : triangleFilterKernels())
        all.push_back({kernel->name, [kernel](const GpuScene::State& scene) {
                           return std::make_unique<CpuTriangleFilter>(scene, *kernel);
                       }});
    return all;
}

class TriangleFilterTest : public DrawingTest {
  protected:
    static layout::FrameUniforms select(const GpuScene::State& state, const CameraView& view,
                                        DrawSelection& draws) {
        state.cull(Frustum(view, static_cast<float>(width) / height), draws);
        return frameUniforms(view, width, height, glm::dmat3(1.0), state.lights.counts());
    }

    /// Without a filter where `form` is null.
    static GBufferWords drawn(GpuScene& scene, const CameraView& view, const Form* form,
                              TriangleFilter::Counts* counts = nullptr) {
        context().makeCurrent();
        const gl::StateGuard guard(*context().state().binding, "a test");
        GpuScene::State& state = scene.state();
        state.update();
        DrawSelection draws;
        const layout::FrameUniforms uniforms = select(state, view, draws);
        gl::Buffer buffer("frame", gl::BufferUsage::dynamic);
        buffer.upload(std::span<const layout::FrameUniforms>(&uniforms, 1));
        glBindBufferBase(GL_UNIFORM_BUFFER, layout::FRAME_BINDING, buffer.name());
        const GBufferTargets targets(width, height);
        std::unique_ptr<TriangleFilter> filter;
        if (form != nullptr) {
            filter = form->make(state);
            // An earlier frame, which sees more.
            DrawSelection earlier;
            const layout::FrameUniforms far = select(state, viewOf({30, 20, 10}, {0, 0, 0}), earlier);
            filter->filter(earlier, far);
            filter->filter(draws, uniforms);
            if (counts != nullptr) *counts = filter->counts();
        }
        GeometryPass().render({state, draws, targets, LoadOp::clear, SurfaceSet::all, filter.get()});
        return wordsOf(targets);
    }

    static void expectSame(const Scene& scene, const CameraView& view) {
        GpuScene uploaded = upload(scene);
        const GBufferWords expected = drawn(uploaded, view, nullptr);
        for (const Form& form : forms(context())) {
            TriangleFilter::Counts counts;
            EXPECT_TRUE(drawn(uploaded, view, &form, &counts) == expected) << form.name;
            EXPECT_LT(counts.kept, counts.asked) << form.name << ": nothing was dropped";
        }
    }
};

/// One-sided, two-sided, masked and emissive materials.
void addMaterials(Scene& scene) {
    Material material;
    material.baseColor = {0.8f, 0.2f, 0.1f, 1.0f};
    scene.materials.push_back(material);
    material.doubleSided = true;
    scene.materials.push_back(material);
    material.emission = {1.0f, 0.5f, 0.0f};
    scene.materials.push_back(material);
    material.doubleSided = false;
    material.alphaMode = AlphaMode::mask;
    scene.materials.push_back(material);
}

/// Somewhere around `middle`, rotated, mirrored, flattened, sheared.
glm::mat4 randomTransform(std::uint32_t hash, const glm::vec3& middle) {
    glm::mat4 matrix = glm::translate(glm::mat4(1.0f), middle + 4.0f * hashedPoint(1, hash));
    matrix = glm::rotate(matrix, 6.3f * hashed(4, hash),
                         glm::normalize(hashedPoint(5, hash) + glm::vec3(0.0f, 0.0f, 1.0e-3f)));
    glm::vec3 scale(hashedBetween(0.2f, 2.0f, 8, hash), hashedBetween(0.2f, 2.0f, 9, hash),
                    hashedBetween(0.2f, 2.0f, 10, hash));
    if (hashed(11, hash) < 0.4f) scale.x = -scale.x;
    if (hashed(12, hash) < 0.2f) scale.y = 1.0e-3f;
    matrix = glm::scale(matrix, scale);
    matrix[1][0] += hashedBetween(-0.5f, 0.5f, 13, hash);
    return matrix;
}

/// Instances of a soup around the origin: rotated, mirrored, flattened, sheared.
Scene soupScene(std::uint32_t seed, const glm::vec3& middle = glm::vec3(0.0f)) {
    Scene scene;
    addMaterials(scene);
    for (std::uint32_t m = 0; m < 4; ++m) {
        Mesh mesh = soup(1003 + 1000 * m, 100 * seed + 20 * m);
        const auto half = static_cast<std::uint32_t>(mesh.indices.size() / 6 * 3);
        const auto rest = static_cast<std::uint32_t>(mesh.indices.size()) - half;
        mesh.submeshes = {{0, half, m}, {half, rest, (m + 1) % 4}};
        // Half of what these meshes have of the masked material is not there.
        for (std::uint32_t i = 0; m >= 2 && i < mesh.positions.size(); ++i)
            mesh.colors.push_back({1.0f, 1.0f, 1.0f, hashed(seed + 60, i)});
        scene.meshes.push_back(mesh);
    }
    for (std::uint32_t i = 0; i < 12; ++i) {
        Node node;
        node.transform = randomTransform(1000 * seed + i, middle);
        node.mesh = i % 4;
        scene.nodes.push_back(node);
    }
    return scene;
}

TEST_F(TriangleFilterTest, randomTrianglesAroundTheEyeAreTheSame) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        CameraView view = viewOf(3.0f * hashedPoint(20, seed), hashedPoint(23, seed));
        view.nearPlane = seed % 2 == 0 ? 0.01f : 1.5f;
        expectSame(soupScene(seed), view);
    }
}

TEST_F(TriangleFilterTest, orthographicViewsAreTheSame) {
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        CameraView view = viewOf(6.0f * hashedPoint(30, seed), {0, 0, 0});
        view.orthographicHeight = 5.0f;
        view.nearPlane = 1.0f;
        view.farPlane = 9.0f;
        expectSame(soupScene(10 + seed), view);
    }
}

TEST_F(TriangleFilterTest, shiftedViewsAreTheSame) {
    CameraView view = viewOf({4, 3, 5}, {0, 0, 0});
    view.shift = {0.3f / width, -0.4f / height};
    expectSame(soupScene(20), view);
}

/// Positions are off by 1 mm there, so that the margins of vertices are many pixels wide.
TEST_F(TriangleFilterTest, farFromTheOriginItIsTheSame) {
    const glm::vec3 middle(9000.0f, -4000.0f, 12000.0f);
    GpuScene scene = upload(soupScene(21, middle));
    const CameraView view = viewOf(middle + glm::vec3(5, 4, 6), middle);
    const GBufferWords expected = drawn(scene, view, nullptr);
    for (const Form& form : forms(context())) EXPECT_TRUE(drawn(scene, view, &form) == expected) << form.name;
}

/// Corners at pixel centres and edges, where a hundredth of a pixel decides.
TEST_F(TriangleFilterTest, trianglesOfHalfPixelsAreTheSame) {
    const float pixel = 2.0f / height;
    Mesh mesh;
    for (std::uint32_t i = 0; i < 6000; ++i) {
        const glm::vec3 corner(std::floor(hashed(40, i) * 2.0f * width) * 0.5f * pixel - width * 0.5f * pixel,
                               std::floor(hashed(41, i) * 2.0f * height) * 0.5f * pixel - 1.0f, 0.0f);
        const float a = std::floor(hashedBetween(-2.0f, 3.0f, 42, i)) * 0.5f * pixel;
        const float b = std::floor(hashedBetween(-2.0f, 3.0f, 43, i)) * 0.5f * pixel;
        for (const glm::vec3 offset : {glm::vec3(0), glm::vec3(a, 0, 0), glm::vec3(0, b, 0)}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(corner + offset);
            mesh.normals.push_back({0, 0, 1});
        }
    }
    CameraView view = lookAt({0, 0, 3}, {0, 0, 0}, 2.0f * std::atan(1.0f / 3.0f));
    expectSame(sceneOf(mesh, Material{}), view);
}

TEST_F(TriangleFilterTest, dropsTheBackOfASphereAndWhatIsBesideTheFrame) {
    GpuScene sphere = upload(sceneOf(makeSphere(1.0f), Material{}));
    for (const Form& form : forms(context())) {
        TriangleFilter::Counts counts;
        drawn(sphere, viewOf({0, 0, 8}, {0, 0, 0}), &form, &counts);
        // Less than half of a sphere is seen, and small triangles between pixels are dropped as well. Kept
        // are some at the outline, of which a device of few subpixel bits may round the direction.
        EXPECT_LT(counts.kept, counts.asked * 6 / 10) << form.name;
        EXPECT_GT(counts.kept, counts.asked / 20) << form.name;
        drawn(sphere, viewOf({0, 0, 1.2f}, {0, 0.7f, 1.2f}), &form, &counts);
        EXPECT_LT(counts.kept, counts.asked / 4) << form.name << ": all but a part is below the frame";
    }
}

/// A square of 2 m with a bump, 64 × 64 cells in order of 8 × 8 blocks, so that a cluster is compact.
Mesh blocks(float bump, std::uint32_t seed) {
    constexpr std::uint32_t cells = 64, side = cells + 1;
    Mesh mesh;
    for (std::uint32_t i = 0; i < side * side; ++i) {
        const float x = static_cast<float>(i % side) / 32.0f - 1.0f,
                    y = static_cast<float>(i / side) / 32.0f - 1.0f;
        mesh.positions.push_back(
            {x, y, bump * (std::cos(1.5f * x) * std::cos(1.5f * y) + 0.01f * hashed(seed, i))});
        mesh.normals.push_back({0, 0, 1});
    }
    for (std::uint32_t i = 0; i < cells * cells; ++i) {
        const std::uint32_t block = i / 64, x = block % 8 * 8 + i % 8, y = block / 8 * 8 + i % 64 / 8;
        const std::uint32_t a = y * side + x, b = a + 1, c = a + side, d = c + 1;
        mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
    return mesh;
}

/// Bent squares around the origin, turned any way, mirrored, flattened, from millimetres to metres.
Scene blockScene(std::uint32_t seed) {
    Scene scene;
    addMaterials(scene);
    for (std::uint32_t m = 0; m < 4; ++m) {
        Mesh mesh = blocks(0.2f * static_cast<float>(m), seed);
        mesh.submeshes = {{0, static_cast<std::uint32_t>(mesh.indices.size()), m}};
        scene.meshes.push_back(mesh);
    }
    for (std::uint32_t i = 0; i < 24; ++i) {
        glm::mat4 transform = randomTransform(1000 * seed + i, glm::vec3(0.0f));
        if (i % 3 == 0) transform = glm::scale(transform, glm::vec3(0.01f));
        Node node;
        node.transform = transform;
        node.mesh = i % 4;
        scene.nodes.push_back(node);
    }
    return scene;
}

TEST_F(TriangleFilterTest, clustersAroundTheEyeAreTheSame) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        SCOPED_TRACE(seed);
        CameraView view = viewOf(4.0f * hashedPoint(50, seed), hashedPoint(53, seed));
        view.nearPlane = seed % 2 == 0 ? 0.01f : 1.5f;
        if (seed == 5) {
            view.orthographicHeight = 5.0f;
            view.farPlane = 9.0f;
        }
        const Scene scene = blockScene(seed);
        expectSame(scene, view);
        GpuScene uploaded = upload(scene);
        for (const Form& form : forms(context())) {
            TriangleFilter::Counts counts;
            drawn(uploaded, view, &form, &counts);
            EXPECT_LT(counts.inKeptClusters, counts.asked) << form.name << ": no cluster was dropped";
        }
    }
}

TEST_F(TriangleFilterTest, meshesThatChangeAreTheSame) {
    Scene scene = blockScene(7);
    GpuScene edited = upload(scene);
    // Bent the other way, so that the clusters of before would drop what is seen now.
    for (glm::vec3& position : scene.meshes[1].positions) position.z = -3.0f * position.z;
    edited.setPositions(1, scene.meshes[1].positions, scene.meshes[1].normals);
    const std::vector<Submesh> submeshes = scene.meshes[2].submeshes;
    scene.meshes[2] = blocks(-0.8f, 8);
    scene.meshes[2].submeshes = submeshes;
    edited.replaceMesh(2, scene.meshes[2]);
    GpuScene fresh = upload(scene);
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const CameraView view = viewOf(4.0f * hashedPoint(70, seed), hashedPoint(73, seed));
        const GBufferWords expected = drawn(fresh, view, nullptr);
        for (const Form& form : forms(context())) {
            TriangleFilter::Counts counts;
            EXPECT_TRUE(drawn(edited, view, &form, &counts) == expected) << form.name;
            EXPECT_LT(counts.inKeptClusters, counts.asked) << form.name << ": no cluster was dropped";
        }
    }
}

TEST_F(TriangleFilterTest, dropsWholeClusters) {
    Material material;
    GpuScene oneSided = upload(sceneOf(blocks(0.0f, 1), material));
    material.doubleSided = true;
    GpuScene twoSided = upload(sceneOf(blocks(0.0f, 1), material));
    const CameraView front = viewOf({0, 0, 2}, {0, 0, 0}), back = viewOf({0, 0, -2}, {0, 0, 0});
    const CameraView far = viewOf({0.0f, 0.0f, 900.0f}, {0.3f, 0.3f, 0.0f});
    for (const Form& form : forms(context())) {
        TriangleFilter::Counts counts;
        drawn(oneSided, front, &form, &counts);
        EXPECT_EQ(counts.asked, 8192u) << form.name;
        EXPECT_GT(counts.inKeptClusters, counts.asked / 2) << form.name;
        drawn(oneSided, back, &form, &counts);
        EXPECT_EQ(counts.inKeptClusters, 0u) << form.name << ": all triangles face away";
        drawn(twoSided, back, &form, &counts);
        EXPECT_GT(counts.inKeptClusters, counts.asked / 2) << form.name;
        drawn(twoSided, far, &form, &counts);
        // The square is a third of a pixel wide, and each of its clusters a 24th.
        EXPECT_LT(counts.inKeptClusters, counts.asked / 2) << form.name;
    }
}

TEST_F(TriangleFilterTest, smallMeshesStayAsTheyAre) {
    GpuScene quad = upload(sceneOf(makeQuad(1.0f), Material{}));
    for (const Form& form : forms(context())) {
        TriangleFilter::Counts counts;
        drawn(quad, viewOf({0, 0, 3}, {0, 0, 0}), &form, &counts);
        EXPECT_EQ(counts.asked, 0u) << form.name;
    }
}

}  // namespace
}  // namespace candela::test
