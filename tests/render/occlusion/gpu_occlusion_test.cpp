// Occlusion rays in a shader, against all triangles in double precision and against Embree.

#include "occlusion/occlusion_scenes.h"
#include "occlusion/ray_program.h"
#include "occlusion/ray_references.h"

#include <candela/context.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace candela::test {
namespace {

class GpuOcclusionTest : public RayProgramTest {
  protected:
    static std::vector<bool> trace(const GpuOcclusion& structure, const std::vector<Ray>& rays) {
        const std::vector<float> passing = program().transmittances(structure, rays);
        std::vector<bool> occluded(passing.size());
        for (std::size_t i = 0; i < passing.size(); ++i) occluded[i] = passing[i] == 0.0f;
        return occluded;
    }

    /// Rays answered otherwise than by brute force graze an edge. Returns how many those are.
    static std::size_t expectBruteForce(const GpuOcclusion& structure, const TestScene& scene,
                                        const std::vector<Ray>& rays) {
        const std::vector<WorldTriangle> triangles = worldTriangles(scene);
        const std::vector<bool> answers = trace(structure, rays);
        std::size_t occluded = 0, different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool expected = std::ranges::any_of(
                triangles, [&](const auto& triangle) { return meets(triangle, rays[i]); });
            occluded += expected;
            if (answers[i] == expected) continue;
            ++different;
            EXPECT_TRUE(grazes(triangles, rays[i])) << "ray " << i << ", expected " << expected;
        }
        if (!triangles.empty()) {
            EXPECT_GT(occluded, rays.size() / 20);
            EXPECT_LT(occluded, rays.size() * 19 / 20);
        }
        return different;
    }
};

TEST_F(GpuOcclusionTest, RandomScenesAgreeWithAllTrianglesInDoublePrecision) {
    std::size_t different = 0;
    for (unsigned seed = 0; seed < 4; ++seed) {
        SCOPED_TRACE(seed);
        const TestScene scene = mixedScene(seed);
        GpuOcclusion structure;
        upload(structure, scene);
        different += expectBruteForce(structure, scene, randomRays(seed + 100, 4000, 12.0f));
    }
    std::printf("16,000 rays against brute force: %zu graze an edge and differ\n", different);
}

TEST_F(GpuOcclusionTest, AMillionRaysAgreeWithEmbree) {
    const TestScene scene = mixedScene(11);
    GpuOcclusion structure;
    upload(structure, scene);
    const std::vector<Ray> rays = randomRays(12, 1'000'000, 12.0f);
    const std::vector<bool> answers = trace(structure, rays);
    const std::vector<WorldTriangle> triangles = worldTriangles(scene);
    const EmbreeReference reference(triangles);
    std::size_t different = 0, occluded = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool expected = reference.isOccluded(rays[i]);
        occluded += expected;
        if (answers[i] == expected) continue;
        ++different;
        EXPECT_TRUE(grazes(triangles, rays[i])) << "ray " << i << ", expected " << expected;
    }
    std::printf("1,000,000 rays against Embree, %zu of them occluded: %zu graze an edge and differ\n",
                occluded, different);
    EXPECT_LT(different, 200u);
}

TEST_F(GpuOcclusionTest, ClosedMeshesHaveNoGapsAtVerticesAndEdges) {
    Random random(3);
    for (const float scale : {0.001f, 1.0f, 1000.0f}) {
        TestScene scene;
        scene.meshes = {sphere(1.0f, 16, 9)};
        glm::mat4 world = glm::scale(randomRotation(random), {scale, -1.3f * scale, 0.6f * scale});
        world[3] = glm::vec4(random.vector() * scale, 1.0f);
        scene.instances = {{0, world, true}};
        GpuOcclusion structure;
        upload(structure, scene);
        std::vector<Ray> rays;
        const glm::vec3 center(world[3]);
        for (const glm::uvec3& corners : scene.meshes[0].triangles) {
            for (int i = 0; i < 30; ++i) {
                const glm::vec3 from = center + 0.1f * scale * random.vector();
                // On an edge, its ends included.
                const float along = i < 3 ? 0.0f : 0.5f + 0.5f * random.number();
                const glm::vec3 local = glm::mix(scene.meshes[0].positions[corners[i % 3]],
                                                 scene.meshes[0].positions[corners[(i + 1) % 3]], along);
                rays.push_back({from, 0.0f, glm::vec3(world * glm::vec4(local, 1.0f)) - from, 2.0f});
            }
        }
        const std::vector<bool> answers = trace(structure, rays);
        EXPECT_EQ(std::ranges::count(answers, false), 0) << "scale " << scale;
    }
}

TEST_F(GpuOcclusionTest, NothingAndHiddenInstancesOccludeNothing) {
    TestScene scene = mixedScene(5);
    GpuOcclusion structure;
    const std::vector<Ray> rays = randomRays(6, 2000, 12.0f);
    EXPECT_EQ(std::ranges::count(trace(structure, rays), true), 0);
    for (OcclusionInstance& instance : scene.instances) instance.castsShadow = false;
    upload(structure, scene);
    EXPECT_EQ(std::ranges::count(trace(structure, rays), true), 0);
    for (std::size_t i = 0; i < scene.instances.size(); i += 2) scene.instances[i].castsShadow = true;
    setInstances(structure, scene);
    expectBruteForce(structure, scene, rays);
}

TEST_F(GpuOcclusionTest, SingularInstancesAndTrianglesWithoutAreaOccludeNothing) {
    TestScene scene;
    scene.meshes = {sphere(1.0f, 12, 7), {}};
    for (const glm::vec3 scale : {glm::vec3(0.0f), glm::vec3(1, 0, 1), glm::vec3(1e-30f)})
        scene.instances.push_back({0, glm::scale(glm::mat4(1.0f), scale), true});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    scene.instances.push_back({0, glm::mat4(nan), true});
    scene.instances.push_back({1, glm::mat4(1.0f), true});
    OcclusionMesh flat;
    addTriangle(flat, {-1, 0, 0}, {1, 0, 0}, {0, 0, 0});
    addTriangle(flat, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    scene.meshes.push_back(flat);
    scene.instances.push_back({2, glm::mat4(1.0f), true});
    GpuOcclusion structure;
    upload(structure, scene);
    EXPECT_EQ(std::ranges::count(trace(structure, randomRays(6, 2000, 2.0f)), true), 0);
}

TEST_F(GpuOcclusionTest, ARayWithoutLengthMeetsNothing) {
    TestScene scene;
    scene.meshes = {sphere(1.0f, 12, 7)};
    scene.instances = {{0, glm::mat4(1.0f), true}};
    GpuOcclusion structure;
    upload(structure, scene);
    const std::vector<bool> answers =
        trace(structure, {{{0, 0, 0}, 0.0f, {0, 0, 0}, 1.0f}, {{0, 1, 0}, 0.0f, {0, 0, 0}, 1.0f}});
    EXPECT_EQ(std::ranges::count(answers, true), 0);
}

TEST_F(GpuOcclusionTest, AfterMovesAndChangesItAnswersAsAFreshOne) {
    Random random(21);
    TestScene scene = mixedScene(20);
    GpuOcclusion structure;
    upload(structure, scene);
    InstanceTree upper;
    setInstances(structure, scene, upper);
    std::vector<WideTree> trees;
    for (const OcclusionMesh& mesh : scene.meshes) trees.push_back(buildWideTree(trianglesOf(mesh)));
    const std::vector<Ray> rays = randomRays(22, 20000, 12.0f);
    for (int step = 0; step < 40; ++step) {
        SCOPED_TRACE(step);
        OcclusionInstance& moved = scene.instances[static_cast<std::size_t>(step) % scene.instances.size()];
        moved.worldFromLocal[3] = glm::vec4(8.0f * random.vector(), 1.0f);
        moved.castsShadow = step % 3 != 0;
        const auto changed = static_cast<std::uint32_t>(step % 9);
        OcclusionMesh& mesh = scene.meshes[changed];
        if (step % 4 == 0) {
            // Of another size, so that its texels move.
            const float unit = changed < 3 ? 1000.0f : changed < 6 ? 1.0f : 0.001f;
            mesh = soup(random, 40 + 10 * step, unit, 0.4f * unit);
            trees[changed] = buildWideTree(trianglesOf(mesh));
        } else {
            for (glm::vec3& position : mesh.positions) position *= 1.0f + 0.1f * random.number();
            refit(trees[changed], trianglesOf(mesh));
        }
        structure.setMesh(changed, mesh, trees[changed]);
        setInstances(structure, scene, upper);
        if (step % 8 != 7) continue;
        GpuOcclusion fresh;
        upload(fresh, scene);
        EXPECT_EQ(trace(structure, rays), trace(fresh, rays));
    }
    expectBruteForce(structure, scene, randomRays(23, 2000, 12.0f));
}

TEST_F(GpuOcclusionTest, DeepTreesAreWalkedToTheirEnd) {
    // Sizes and distances fall by a factor, so that each level of the tree holds a few triangles.
    TestScene scene;
    OcclusionMesh& mesh = scene.meshes.emplace_back();
    for (int i = 0; i < 3000; ++i) {
        const float size = std::pow(0.97f, float(i));
        addTriangle(mesh, glm::vec3(size, 0, 0), glm::vec3(size, 0.1f * size, 0),
                    glm::vec3(size, 0, 0.1f * size));
    }
    // And equal ones, which no tree separates.
    for (int i = 0; i < 3000; ++i) addTriangle(mesh, {-1, 0, 0}, {-1, 1, 0}, {-1, 0, 1});
    scene.instances = {{0, glm::mat4(1.0f), true}};
    GpuOcclusion structure;
    upload(structure, scene);
    std::vector<Ray> rays;
    for (int i = 0; i < 200; ++i) {
        const float size = std::pow(0.97f, float(i));
        rays.push_back(
            {glm::vec3(1.01f * size, 0.02f * size, 0.02f * size), 0.0f, {-0.02f * size, 0, 0}, 1.0f});
        rays.push_back(
            {glm::vec3(1.01f * size, 0.02f * size, 0.02f * size), 0.0f, {-0.005f * size, 0, 0}, 1.0f});
    }
    rays.push_back({{-2, 0.1f, 0.1f}, 0.0f, {2, 0, 0}, 1.0f});
    const std::vector<bool> answers = trace(structure, rays);
    for (std::size_t i = 0; i < answers.size(); ++i) EXPECT_EQ(answers[i], i % 2 == 0) << i;
}

TEST_F(GpuOcclusionTest, CutoutsLetRaysThroughAsInCpp) {
    Random random(31);
    TestScene scene;
    OcclusionMesh& mesh = scene.meshes.emplace_back();
    addTriangle(mesh, {-100, -100, -50}, {-101, -100, -50}, {-100, -101, -50});  // opaque, out of the way
    std::vector<std::uint8_t> alpha(7 * 5);
    for (std::uint8_t& value : alpha) value = static_cast<std::uint8_t>(127.0f + 127.0f * random.number());
    mesh.images = {std::make_shared<const AlphaImage>(AlphaImage{1, 1, {0}}),
                   std::make_shared<const AlphaImage>(AlphaImage{7, 5, alpha})};
    const AlphaWrap wraps[] = {AlphaWrap::repeat, AlphaWrap::clampToEdge, AlphaWrap::mirroredRepeat};
    for (unsigned i = 0; i < 40; ++i) {
        const glm::vec3 corner(float(i) * 2.0f, 0.0f, random.number());
        addTriangle(mesh, corner, corner + glm::vec3(1.8f, 0.1f, 0), corner + glm::vec3(0.3f, 1.7f, 0));
        CutoutTriangle cutout{};
        for (int k = 0; k < 3; ++k) {
            cutout.uv[k] = 3.0f * glm::vec2(random.number(), random.number());
            cutout.alpha[k] = 0.9f + 0.1f * random.number();
        }
        cutout.cutoff = 0.5f;
        cutout.image = i % 10 == 9 ? CutoutTriangle::noImage : i % 10 == 8 ? 0 : 1;
        cutout.wrapS = wraps[i % 3];
        cutout.wrapT = wraps[i / 3 % 3];
        cutout.nearest = i % 4 == 3;
        mesh.cutouts.push_back(cutout);
    }
    scene.instances = {{0, glm::mat4(1.0f), true}};
    GpuOcclusion structure;
    upload(structure, scene);
    std::vector<Ray> rays;
    std::vector<glm::vec3> weights;
    for (std::uint32_t i = 0; i < 40; ++i) {
        for (int k = 0; k < 500; ++k) {
            const float u = 0.5f + 0.5f * random.number(), v = (1.0f - u) * (0.5f + 0.5f * random.number());
            const glm::uvec3& corners = mesh.triangles[i + 1];
            weights.emplace_back(1.0f - u - v, u, v);
            const glm::vec3 on = weights.back().x * mesh.positions[corners.x] +
                                 u * mesh.positions[corners.y] + v * mesh.positions[corners.z];
            rays.push_back({on + glm::vec3(0, 0, 3), 0.0f, {0, 0, -6}, 1.0f});
        }
    }
    const std::vector<bool> answers = trace(structure, rays);
    std::size_t different = 0, open = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto cutout = static_cast<std::uint32_t>(i / 500);
        const bool passes = transmittance(mesh, cutout, weights[i]) == 1.0f;
        open += passes;
        if (answers[i] != passes) continue;
        // Where the alpha crosses the cutoff, or the triangle ends, within what weights are exact to at 80 m.
        ++different;
        bool changes = std::min({weights[i].x, weights[i].y, weights[i].z}) < 1e-4f;
        for (const glm::vec3 step : {glm::vec3(1, -1, 0), glm::vec3(0, 1, -1), glm::vec3(1, 0, -1)}) {
            for (const float size : {-1e-4f, 1e-4f})
                changes =
                    changes || (transmittance(mesh, cutout, weights[i] + size * step) == 1.0f) != passes;
        }
        EXPECT_TRUE(changes) << "ray " << i << ", image " << mesh.cutouts[cutout].image;
    }
    std::printf("20,000 rays through cut-outs, %zu pass: %zu differ at the cutoff\n", open, different);
    EXPECT_GT(open, rays.size() / 10);
    EXPECT_LT(open, rays.size() * 9 / 10);
    EXPECT_LT(different, 100u);
}

}  // namespace
}  // namespace candela::test
