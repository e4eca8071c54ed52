// The scene of triangles: it is the same on every machine, has exactly as many as are asked for, none of them
// instanced, and is refused where memory is short.
#include "procedural_scene.h"

#include <candela/error.h>

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <glm/geometric.hpp>

#include <set>
#include <string>

namespace candela {
namespace {

Scene triangles(const std::string& arguments) {
    return importProcedural("triangles:" + arguments).scene;
}

std::string errorOf(const std::string& arguments) {
    try {
        triangles(arguments);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Triangles, IsTheSameOnEveryMachine) {
    const Scene scene = triangles("30000,500");
    EXPECT_EQ(geometryHash(scene), 0x8C510AB32156341Cu) << std::hex << geometryHash(scene);
    EXPECT_EQ(lightHash(scene.lights), 0xB4E3953DBBDD1D1Fu) << std::hex << lightHash(scene.lights);
}

TEST(Triangles, HasExactlyAsManyAsAskedFor) {
    for (const char* count : {"1", "7", "500", "29999", "300000"})
        EXPECT_EQ(elementCount(triangles(count), Topology::triangles), std::stoull(count));
}

TEST(Triangles, LightsAreASecondNumber) {
    EXPECT_EQ(triangles("100,0").lights.size(), 0u);
    EXPECT_EQ(triangles("100,77").lights.size(), 77u);
    EXPECT_EQ(triangles("100").lights.size(), 4096u);
}

TEST(Triangles, NoMeshIsInstanced) {
    const Scene scene = triangles("100000,0");
    std::set<std::uint32_t> meshes;
    for (const Node& node : scene.nodes) {
        if (!node.mesh) continue;
        EXPECT_TRUE(meshes.insert(*node.mesh).second) << node.name;
    }
    EXPECT_EQ(meshes.size(), scene.meshes.size());
    EXPECT_EQ(meshes.size(), 64u + 256u + 1u) << "patches, rocks and splinters";
}

TEST(Triangles, NormalsPointOutOfTheTriangles) {
    const Scene scene = triangles("50000,0");
    for (const Mesh& mesh : scene.meshes) {
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const glm::vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
                            &c = mesh.positions[mesh.indices[i + 2]];
            ASSERT_GT(glm::dot(glm::cross(b - a, c - a), mesh.normals[mesh.indices[i]]), 0.0f)
                << mesh.name << ", triangle " << i / 3;
        }
    }
}

TEST(Triangles, SplintersFaceBothWays) {
    const Scene scene = triangles("20000,0");
    const Mesh& splinters = scene.meshes.back();
    ASSERT_EQ(splinters.name, "splinters");
    std::size_t up = 0;
    for (std::size_t i = 0; i < splinters.normals.size(); i += 3) up += splinters.normals[i].y > 0.0f;
    const std::size_t all = splinters.normals.size() / 3;
    // Half of them; of n independent ones the standard deviation is sqrt(n) / 2, here under 2 % of some 1000.
    EXPECT_NEAR(static_cast<double>(up) / static_cast<double>(all), 0.5, 0.08);
}

TEST(Triangles, RefusesWhatIsNoNumberOfThem) {
    EXPECT_NE(errorOf("0").find("whole number from 1 to 50000000"), std::string::npos) << errorOf("0");
    EXPECT_NE(errorOf("50000001").find("from 1 to 50000000"), std::string::npos);
    EXPECT_NE(errorOf("100,").find("number of lights"), std::string::npos);
    EXPECT_NE(errorOf("100,many").find("number of lights"), std::string::npos);
    EXPECT_NE(errorOf("many").find("number of triangles"), std::string::npos);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

TEST(Triangles, RefusesWhatExceedsMemory) {
    triangles("1,0");  // Loads the plugin.
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
    rlimit small = before;
    small.rlim_cur = rlim_t{4} << 30;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &small), 0);
    const std::string error = errorOf("50000000,0");
    ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
    EXPECT_NE(error.find("50000000 triangles take up to"), std::string::npos) << error;
    EXPECT_NE(error.find("GB are free"), std::string::npos) << error;
}

#endif

}  // namespace
}  // namespace candela
