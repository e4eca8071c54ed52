// EXT_mesh_gpu_instancing.
#include <gtest/gtest.h>

#include "loading.h"

namespace candela_test {
namespace {

/// A triangle that node 0 places by the attributes, which are JSON text.
GltfFile instancedFile(const std::string& attributes) {
    GltfFile file;
    addTriangle(file);
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}}]})");
    file.add("nodes",
             R"({"name":"tree","mesh":0,"translation":[10,0,0],"extensions":{"EXT_mesh_gpu_instancing":)"
             R"({"attributes":{)" +
                 attributes + "}}}}");
    file.set("extensionsRequired", R"(["EXT_mesh_gpu_instancing"])");
    return file;
}

/// The world matrices of the nodes that show a mesh.
std::vector<glm::mat4> placesOf(const candela::Scene& scene) {
    const std::vector<glm::mat4> world = candela::worldTransforms(scene);
    std::vector<glm::mat4> places;
    for (std::size_t i = 0; i < world.size(); ++i) {
        if (scene.nodes[i].mesh) places.push_back(world[i]);
    }
    return places;
}

TEST(Instances, areMovedTurnedAndScaledBelowTheirNode) {
    GltfFile file = instancedFile(R"("TRANSLATION":2,"ROTATION":3,"SCALE":4)");
    file.addData<float>("VEC3", {0, 0, 0, 1, 2, 3});
    // A quarter turn about +Y, as integers.
    file.addData<std::int16_t>("VEC4", {0, 0, 0, 32767, 0, 23170, 0, 23170}, R"("normalized":true)");
    file.addData<float>("VEC3", {1, 1, 1, 2, 2, 2});
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    EXPECT_EQ(candela::triangleCount(imported.scene), 2u);
    const std::vector<glm::mat4> places = placesOf(imported.scene);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0][3], glm::vec4(10, 0, 0, 1));
    EXPECT_EQ(places[1][3], glm::vec4(11, 2, 3, 1));
    // +X of the instance points to -Z, at twice the length. Tolerance: the rotation has 15 bits.
    EXPECT_NEAR(places[1][0].x, 0.0f, 2e-4f);
    EXPECT_NEAR(places[1][0].z, -2.0f, 2e-4f);
}

TEST(Instances, ofMeshesWithSeveralPartsShowAllParts) {
    GltfFile file = instancedFile(R"("TRANSLATION":2)");
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 2, 0, 0});
    file.add("meshes",
             R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}},{"attributes":{"POSITION":0}}]})");
    file.add("nodes",
             R"({"mesh":1,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":2}}}})");
    EXPECT_EQ(placesOf(load(file).scene).size(), 3u + 6u);
}

TEST(Instances, attributesThatCannotBeReadAreLeftOut) {
    GltfFile file = instancedFile(R"("TRANSLATION":2,"SCALE":3)");
    file.addData<float>("VEC3", {0, 0, 0, 1, 2, 3});
    file.addData<float>("VEC3", {1, 1, 1});
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(placesOf(imported.scene).size(), 2u);
    EXPECT_TRUE(
        hasNote(imported, "node 0 'tree', EXT_mesh_gpu_instancing, attribute SCALE: accessor 3 has 1"));
}

TEST(Instances, thatTheFileDoesNotHoldAreFew) {
    GltfFile file = instancedFile(R"("TRANSLATION":2)");
    file.addAccessor(-1, "VEC3", 5126, 10000000);
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(placesOf(imported.scene).size(), 1u);
    EXPECT_TRUE(hasNote(imported, "has no bufferView and 10000000 elements"));
}

}  // namespace
}  // namespace candela_test
