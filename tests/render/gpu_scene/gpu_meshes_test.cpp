// What the shared buffers of a scene's meshes hold, and where.

#include "render/gpu_scene/gpu_meshes.h"

#include "base/runs.h"
#include "render/gpu_scene/mesh_vertices.h"

#include <candela/context.h>
#include <candela/threads.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <ranges>
#include <vector>

namespace candela::test {
namespace {

using Access = GpuMeshes::Access;
using Detail = GpuMeshes::Detail;

constexpr Access bothAccesses[] = {Access::device, Access::deviceAndCpu};

/// A number that no other vertex of any mesh has.
float numbered(std::size_t mesh, std::size_t vertex, int component) {
    return static_cast<float>(vertex) + 0.25f * static_cast<float>(component) -
           static_cast<float>(mesh) * 4'194'304.0f;
}

std::vector<glm::vec2> uvsOf(std::size_t mesh, std::size_t vertices, int component) {
    std::vector<glm::vec2> uvs;
    for (std::size_t i = 0; i < vertices; ++i)
        uvs.emplace_back(numbered(mesh, i, component), numbered(mesh, i, component + 1));
    return uvs;
}

Mesh meshOf(std::size_t number, std::size_t vertices, std::size_t indices) {
    Mesh mesh;
    for (std::size_t i = 0; i < vertices; ++i) {
        mesh.positions.emplace_back(numbered(number, i, 0), numbered(number, i, 1), numbered(number, i, 2));
        mesh.normals.emplace_back(0.0f, 0.0f, i % 2 == 0 ? 1.0f : -1.0f);
    }
    for (std::size_t i = 0; i < indices; ++i)
        mesh.indices.push_back(static_cast<std::uint32_t>((i * 7 + number) % vertices));
    return mesh;
}

/// Meshes of no vertices, of a few and of several runs for the threads.
std::vector<Mesh> manySizes() {
    std::vector<Mesh> meshes;
    for (const std::size_t vertices :
         {std::size_t{3}, std::size_t{0}, runLength, runLength + 1, std::size_t{5}, 3 * runLength + 17})
        meshes.push_back(meshOf(meshes.size(), vertices, vertices == 0 ? 0 : 3 * vertices));
    return meshes;
}

void expectMeshes(const GpuMeshes& buffers, const std::vector<Mesh>& meshes) {
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        const MeshPlace& place = buffers.places()[i];
        EXPECT_EQ(buffers.readPositions(i), meshes[i].positions) << "mesh " << i;
        EXPECT_EQ(buffers.readIndices({place.firstIndex, place.indexCount}), meshes[i].indices)
            << "mesh " << i;
        const auto surface = buffers.surface().read<SurfaceVertex>(static_cast<std::size_t>(place.baseVertex),
                                                                   place.vertexCount);
        EXPECT_TRUE(std::ranges::equal(surface, meshes[i].normals, {}, &SurfaceVertex::normal))
            << "mesh " << i;
    }
}

class GpuMeshesTest : public testing::Test {
  protected:
    // Of several threads, also where the machine has one core.
    void SetUp() override { setThreadCount(4); }
    void TearDown() override { setThreadCount(0); }

  private:
    Context context_ = Context::createHeadless();
};

TEST_F(GpuMeshesTest, EachMeshHasItsVerticesAndIndices) {
    const std::vector<Mesh> meshes = manySizes();
    for (const Access access : bothAccesses)
        expectMeshes(GpuMeshes(meshes, Detail::positionsAndNormals, access), meshes);
}

TEST_F(GpuMeshesTest, NoMeshesAreNoError) {
    for (const Access access : bothAccesses) {
        EXPECT_TRUE(GpuMeshes({}, Detail::everything, access).places().empty());
        const std::vector<Mesh> empty(1);
        expectMeshes(GpuMeshes(empty, Detail::everything, access), empty);
    }
}

// More than what the device copies at once.
TEST_F(GpuMeshesTest, LargeBuffersAreWrittenPartAfterPart) {
    std::vector<Mesh> meshes{meshOf(0, 1'000, 300)};
    meshes.push_back(meshOf(1, 1'500'000, 9'000'000));
    meshes.push_back(meshOf(2, 100'000, 30));
    for (const Access access : bothAccesses)
        expectMeshes(GpuMeshes(meshes, Detail::positionsAndNormals, access), meshes);
}

TEST_F(GpuMeshesTest, TheCpuReadsWhatTheDeviceHas) {
    const std::vector<Mesh> meshes = manySizes();
    const GpuMeshes buffers(meshes, Detail::positionsAndNormals, Access::deviceAndCpu);
    const MeshPlace& place = buffers.places()[3];
    const auto vertices = buffers.mappedVertices().subspan(static_cast<std::size_t>(place.baseVertex) * 6,
                                                           std::size_t{place.vertexCount} * 6);
    for (std::size_t i = 0; i < place.vertexCount; ++i) {
        ASSERT_EQ(vertices[6 * i + 1], meshes[3].positions[i].y);
        ASSERT_EQ(vertices[6 * i + 5], meshes[3].normals[i].z);
    }
    const auto indices = buffers.mappedIndices().subspan(place.firstIndex, place.indexCount);
    EXPECT_TRUE(std::ranges::equal(indices, meshes[3].indices));
}

TEST_F(GpuMeshesTest, DetailIsThatOfTheMeshOrTheDefault) {
    std::vector<Mesh> meshes = manySizes();
    const std::size_t vertices = meshes[5].positions.size();
    meshes[5].uv0 = uvsOf(5, vertices, 0);
    meshes[3].uv1 = uvsOf(3, meshes[3].positions.size(), 2);
    meshes[5].colors.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i) meshes[5].colors[i].a = static_cast<float>(i);
    for (const Access access : bothAccesses) {
        const GpuMeshes buffers(meshes, Detail::everything, access);
        for (std::uint32_t mesh = 0; mesh < meshes.size(); ++mesh) {
            const auto read = buffers.readAlphaVertices(mesh);
            ASSERT_EQ(read.size(), meshes[mesh].positions.size());
            for (std::size_t i = 0; i < read.size(); ++i) {
                ASSERT_EQ(read[i].uv0, mesh == 5 ? meshes[5].uv0[i] : glm::vec2(0.0f));
                ASSERT_EQ(read[i].uv1, mesh == 3 ? meshes[3].uv1[i] : glm::vec2(0.0f));
                ASSERT_EQ(read[i].alpha, mesh == 5 ? static_cast<float>(i) : 1.0f);
            }
        }
    }
}

// Meshes with further sets come first.
TEST_F(GpuMeshesTest, FurtherCoordinatesAreThoseOfTheMesh) {
    std::vector<Mesh> meshes = manySizes();
    meshes[2].furtherUvs = {uvsOf(2, meshes[2].positions.size(), 0)};
    meshes[5].furtherUvs = {
        {}, uvsOf(5, meshes[5].positions.size(), 1), uvsOf(5, meshes[5].positions.size(), 3)};
    for (const Access access : bothAccesses) {
        const GpuMeshes buffers(meshes, Detail::everything, access);
        ASSERT_TRUE(buffers.hasFurtherUvs());
        expectMeshes(buffers, meshes);
        EXPECT_EQ(buffers.places()[2].baseVertex, 0);
        EXPECT_EQ(buffers.readFurtherUvs(2, 2), meshes[2].furtherUvs[0]);
        EXPECT_EQ(buffers.readFurtherUvs(2, 4), std::vector<glm::vec2>(runLength, glm::vec2(0.0f)));
        const std::vector<glm::vec2> none(meshes[5].positions.size(), glm::vec2(0.0f));
        EXPECT_EQ(buffers.readFurtherUvs(5, 2), none);
        EXPECT_EQ(buffers.readFurtherUvs(5, 3), meshes[5].furtherUvs[1]);
        EXPECT_EQ(buffers.readFurtherUvs(5, 4), meshes[5].furtherUvs[2]);
    }
}

// The sphere that one loop over all points gives.
TEST_F(GpuMeshesTest, BoundingSpheresDoNotDependOnTheRuns) {
    std::vector<glm::vec3> points;
    for (std::size_t i = 0; i < 4 * runLength + 3; ++i) {
        const auto value = [&](std::size_t factor) {
            return static_cast<float>((i * factor) % 10'007) * 0.37f - 900.0f;
        };
        points.emplace_back(value(7919), value(104'729), value(1'299'709));
    }
    points[runLength] = {5000.0f, 0.0f, 0.0f};
    glm::vec3 low = points[0], high = points[0];
    for (const glm::vec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::vec3 center = 0.5f * low + 0.5f * high;
    float radius = 0.0f;
    for (const glm::vec3& point : points) radius = std::max(radius, glm::distance(point, center));
    const BoundingSphere sphere = boundingSphere(points);
    EXPECT_EQ(sphere.center, center);
    EXPECT_EQ(sphere.radius, radius);
}

}  // namespace
}  // namespace candela::test
