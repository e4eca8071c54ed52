// What blended triangles let through: rays in a shader against Embree's and against all triangles.

#include "occlusion/occlusion_scenes.h"
#include "occlusion/ray_program.h"
#include "occlusion/ray_references.h"

#include "render/occlusion/embree_scene.h"

#include <candela/context.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace candela::test {
namespace {

/// Lets the last triangles of each mesh blend, each with an alpha of its own; one in eight with an alpha
/// of 1.
void blendTriangles(TestScene& scene, unsigned seed) {
    Random random(seed);
    for (OcclusionMesh& mesh : scene.meshes) {
        for (std::size_t i = mesh.triangles.size() / 8; i < mesh.triangles.size(); ++i) {
            CutoutTriangle triangle{};
            const float alpha = i % 8 == 0 ? 1.0f : 0.5f + 0.5f * random.number();
            std::fill_n(triangle.alpha, 3, alpha);
            triangle.image = CutoutTriangle::noImage;
            triangle.blends = true;
            mesh.cutouts.push_back(triangle);
        }
    }
}

/// 1 - alpha of each of `worldTriangles`.
std::vector<double> sharesOf(const TestScene& scene) {
    std::vector<double> shares;
    for (const OcclusionInstance& instance : scene.instances) {
        const OcclusionMesh& mesh = scene.meshes[instance.mesh];
        shares.insert(shares.end(), mesh.opaqueCount(), 0.0);
        for (const CutoutTriangle& triangle : mesh.cutouts) shares.push_back(1.0 - double(triangle.alpha[0]));
    }
    return shares;
}

std::vector<float> tracedByEmbree(const TestScene& scene, const std::vector<Ray>& rays) {
    EmbreeScene embree;
    for (std::uint32_t i = 0; i < scene.meshes.size(); ++i)
        embree.setMesh(i, std::make_shared<const OcclusionMesh>(scene.meshes[i]));
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) embree.setInstance(i, scene.instances[i]);
    embree.commit();
    std::vector<float> passing;
    for (std::size_t first = 0; first < rays.size(); first += RayPacket::size) {
        RayPacket packet{};
        for (std::size_t lane = 0; lane < RayPacket::size && first + lane < rays.size(); ++lane) {
            const Ray& ray = rays[first + lane];
            for (int axis = 0; axis < 3; ++axis) {
                packet.origin[axis][lane] = ray.from[axis];
                packet.direction[axis][lane] = ray.way[axis];
            }
            packet.tMin[lane] = ray.tMin, packet.tMax[lane] = ray.tMax;
            packet.active[lane] = -1;
        }
        float shares[RayPacket::size];
        const std::uint32_t hidden = embree.trace(packet, shares);
        for (std::size_t lane = 0; lane < RayPacket::size; ++lane) {
            EXPECT_EQ((hidden >> lane & 1) != 0, shares[lane] == 0.0f);
            EXPECT_TRUE(packet.active[lane] != 0 || shares[lane] == 1.0f);
            if (first + lane < rays.size()) passing.push_back(shares[lane]);
        }
    }
    return passing;
}

// 1 - alpha of a dozen surfaces, each rounded to 6e-8.
bool differ(double a, double b) {
    return std::abs(a - b) > 1e-6;
}

class TransmittanceRaysTest : public RayProgramTest {
  protected:
    static std::vector<float> tracedByShader(const TestScene& scene, const std::vector<Ray>& rays) {
        GpuOcclusion structure;
        upload(structure, scene);
        return program().transmittances(structure, rays);
    }
};

TEST_F(TransmittanceRaysTest, TheShaderAgreesWithEmbree) {
    TestScene scene = mixedScene(41);
    blendTriangles(scene, 42);
    const std::vector<WorldTriangle> triangles = worldTriangles(scene);
    const std::vector<Ray> rays = randomRays(43, 200'000, 12.0f);
    const std::vector<float> shader = tracedByShader(scene, rays), embree = tracedByEmbree(scene, rays);
    std::size_t partial = 0, different = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        partial += shader[i] > 0.0f && shader[i] < 1.0f;
        if (!differ(shader[i], embree[i])) continue;
        ++different;
        EXPECT_TRUE(grazes(triangles, rays[i])) << "ray " << i << ": " << shader[i] << ", " << embree[i];
    }
    std::printf("200,000 rays, %zu pass in part: %zu graze an edge and differ\n", partial, different);
    EXPECT_GT(partial, rays.size() / 10);
    EXPECT_LT(different, 200u);
}

TEST_F(TransmittanceRaysTest, BothAgreeWithAllTrianglesInDoublePrecision) {
    TestScene scene = mixedScene(51);
    blendTriangles(scene, 52);
    const std::vector<WorldTriangle> triangles = worldTriangles(scene);
    const std::vector<double> shares = sharesOf(scene);
    const std::vector<Ray> rays = randomRays(53, 4000, 12.0f);
    const std::vector<float> shader = tracedByShader(scene, rays), embree = tracedByEmbree(scene, rays);
    std::size_t severalSurfaces = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        double expected = 1.0;
        int met = 0;
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            if (!meets(triangles[k], rays[i])) continue;
            expected *= shares[k];
            ++met;
        }
        severalSurfaces += met > 1 && expected > 0.0;
        if (!differ(shader[i], expected) && !differ(embree[i], expected)) continue;
        EXPECT_TRUE(grazes(triangles, rays[i]))
            << "ray " << i << ": " << shader[i] << " and " << embree[i] << " instead of " << expected;
    }
    EXPECT_GT(severalSurfaces, rays.size() / 20);
}

}  // namespace
}  // namespace candela::test
