// Meshes of polygons, which the host triangulates.
#include "expect_error.h"
#include "host_calls.h"
#include "import_samples.h"

#include <candela/scene.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>

namespace candela {
namespace {

// A triangle, then an arrow head with a concave corner at vertex 3, then a pentagon:
//   0 1 2 | 2 1 4 3 | 4 5 6 7 8
constexpr std::array<float, 27> positions{0, 0, 0, 2, 0, 0, 1, 1, 0, 1.6f, 1, 0, 2, 2,
                                          0, 3, 2, 0, 4, 3, 0, 3, 4, 0,    2, 3, 0};
constexpr std::array<std::uint32_t, 12> corners{0, 1, 2, 2, 1, 4, 3, 4, 5, 6, 7, 8};
constexpr std::array<std::uint32_t, 3> sizes{3, 4, 5};
constexpr std::array<candela_submesh, 2> submeshes{{{3, 9, -1}, {0, 3, -1}}};

candela_mesh polygons() {
    candela_mesh mesh = samples::mesh();
    mesh.vertex_count = 9;
    mesh.positions = positions.data();
    mesh.normals = nullptr;
    mesh.index_count = corners.size();
    mesh.indices = corners.data();
    mesh.submesh_count = submeshes.size();
    mesh.submeshes = submeshes.data();
    mesh.face_count = sizes.size();
    mesh.face_sizes = sizes.data();
    return mesh;
}

using ModifyMesh = std::function<void(candela_mesh&)>;

Mesh importedMesh(const ModifyMesh& modify = [](candela_mesh&) {}) {
    return importedScene([&](const candela_host& host) { add(host, modified(polygons(), modify)); })
        .meshes.at(0);
}

void expectRefused(const ModifyMesh& modify, const std::string& text) {
    EXPECT_EQ(expectError([&] { importedMesh(modify); }, ErrorKind::badInput, ""),
              "test: mesh 0 'wheel': " + text);
}

// Twice the signed area of a submesh seen from +Z.
float doubleArea(const Mesh& mesh, const Submesh& submesh) {
    float sum = 0.0f;
    for (std::uint32_t i = submesh.firstIndex; i < submesh.firstIndex + submesh.indexCount; i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        const float area = glm::cross(b - a, c - a).z;
        EXPECT_GT(area, 0.0f) << "the triangle at index " << i << " is clockwise";
        sum += area;
    }
    return sum;
}

TEST(HostTopologies, AreTakenAndChecked) {
    constexpr std::array<candela_submesh, 3> parts{{{0, 3, -1}, {3, 2, -1}, {5, 1, -1}}};
    constexpr std::array<candela_topology, 3> topologies{CANDELA_TRIANGLES, CANDELA_LINES, CANDELA_POINTS};
    const auto mixed = [&](candela_mesh& m) {
        m = samples::mesh();
        m.submesh_count = parts.size();
        m.submeshes = parts.data();
        m.topologies = topologies.data();
    };
    const Mesh lit = importedMesh(mixed);
    ASSERT_EQ(lit.submeshes.size(), 3u);
    EXPECT_EQ(lit.submeshes[0].topology, Topology::triangles);
    EXPECT_EQ(lit.submeshes[1].topology, Topology::lines);
    EXPECT_EQ(lit.submeshes[2].topology, Topology::points);
    const auto with = [&](std::array<candela_submesh, 3> changed, const ModifyMesh& modify = {}) {
        return [=](candela_mesh& m) {
            static std::array<candela_submesh, 3> kept;
            kept = changed;
            mixed(m);
            m.submeshes = kept.data();
            if (modify) modify(m);
        };
    };
    expectRefused(with({{{0, 3, -1}, {3, 1, -1}, {5, 1, -1}}}),
                  "submesh 1: index_count is 1, but a multiple of 2 was expected");
    expectRefused(with({{{0, 2, -1}, {3, 2, -1}, {5, 1, -1}}}),
                  "submesh 0: index_count is 2, but a multiple of 3 was expected");
    expectRefused(with({{{0, 3, -1}, {3, 2, -1}, {5, 2, -1}}}),
                  "submesh 2 ends at index 7, but there are 6 indices");
    static std::array<candela_topology, 3> broken = topologies;
    broken[2] = static_cast<candela_topology>(3);
    expectRefused(with(parts, [](candela_mesh& m) { m.topologies = broken.data(); }),
                  "submesh 2: topology is 3, but 0 to 2 was expected");
    static constexpr std::array<std::uint32_t, 2> faces{3, 3};
    expectRefused(with(parts,
                       [](candela_mesh& m) {
                           m.face_count = 2;
                           m.face_sizes = faces.data();
                       }),
                  "submesh 1: topology is not that of triangles, but the mesh has face_sizes");
}

TEST(HostPolygons, AreTriangulated) {
    const Mesh mesh = importedMesh();
    EXPECT_EQ(mesh.indices.size(), 3u * (1 + 2 + 3));
    ASSERT_EQ(mesh.submeshes.size(), 2u);
    EXPECT_EQ(mesh.submeshes[0].firstIndex, 3u);
    EXPECT_EQ(mesh.submeshes[0].indexCount, 15u);
    EXPECT_EQ(mesh.submeshes[1].firstIndex, 0u);
    EXPECT_EQ(mesh.submeshes[1].indexCount, 3u);
    // By the shoelace formula 2 for the triangle, 1.4 for the arrow head and 5 for the pentagon. A dozen
    // products of numbers below 16 round by less than 1e-5.
    EXPECT_NEAR(doubleArea(mesh, mesh.submeshes[1]), 2.0f, 1e-5f);
    EXPECT_NEAR(doubleArea(mesh, mesh.submeshes[0]), 1.4f + 5.0f, 1e-5f);
}

TEST(HostPolygons, MayBeNone) {
    const Mesh mesh = importedMesh([](candela_mesh& m) {
        m.face_count = m.index_count = 0;
        m.submesh_count = 0;
    });
    EXPECT_TRUE(mesh.indices.empty());
}

TEST(HostPolygons, MayBeTrianglesWithoutSizes) {
    const std::array<candela_submesh, 1> all{{{0, 12, -1}}};
    const auto asTriangles = [&](candela_mesh& m) {
        m.face_sizes = nullptr;
        m.face_count = 4;
        m.submesh_count = 1;
        m.submeshes = all.data();
    };
    EXPECT_EQ(importedMesh(asTriangles).indices, std::vector<std::uint32_t>(corners.begin(), corners.end()));
    expectRefused(
        [&](candela_mesh& m) {
            asTriangles(m);
            m.face_count = 3;
        },
        "face_sizes is NULL, which makes 4 triangles, but face_count is 3");
}

// A struct_size between those of two versions may end within a pointer.
TEST(HostPolygonsRefuses, AnUnknownStructSize) {
    const auto size = static_cast<std::uint32_t>(offsetof(candela_mesh, face_sizes) + 4);
    const auto importElement = [&] { importedMesh([&](candela_mesh& m) { m.struct_size = size; }); };
    expectError(importElement, ErrorKind::badInput, "mesh 0: struct_size is " + std::to_string(size));
}

TEST(HostPolygonsRefuses, Sizes) {
    std::array<std::uint32_t, 3> other{3, 4, 2};
    const auto change = [&](candela_mesh& m) { m.face_sizes = other.data(); };
    expectRefused(change, "face 2 has 2 corners, but 3 or more were expected");
    other = {3, 4, 4};
    expectRefused(change, "its face_sizes add up to 11, but index_count is 12");
    other = {3, 4, 6};
    expectRefused(change, "its face_sizes add up to more than 12, but index_count is 12");
    // The sum is 12 modulo 2^32.
    other = {6, 0x80000000, 0x80000006};
    expectRefused(change, "its face_sizes add up to more than 12, but index_count is 12");
}

TEST(HostPolygonsRefuses, IndicesOutOfRange) {
    auto indices = corners;
    indices[11] = 9;
    expectRefused([&](candela_mesh& m) { m.indices = indices.data(); },
                  "index 11 is 9, but there are 9 vertices");
}

TEST(HostPolygonsRefuses, SubmeshesThatSplitAFace) {
    candela_submesh part{4, 3, -1};
    const auto change = [&](candela_mesh& m) {
        m.submesh_count = 1;
        m.submeshes = &part;
    };
    expectRefused(
        change,
        "submesh 0 begins at index 4, which is within face 1, but the boundary of a face was expected");
    part = {3, 6, -1};
    expectRefused(
        change, "submesh 0 ends at index 9, which is within face 2, but the boundary of a face was expected");
    part = {3, 10, -1};
    expectRefused(change, "submesh 0 ends at index 13, but there are 12 indices");
    part = {0xFFFFFFFF, 3, -1};
    expectRefused(change, "submesh 0 ends at index 4294967298, but there are 12 indices");
    part = {3, 4, 0};
    expectRefused(change, "submesh 0: material is 0, but 0 were added so far and -1 is none");
}

}  // namespace
}  // namespace candela
