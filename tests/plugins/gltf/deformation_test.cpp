#include <gtest/gtest.h>

#include "loading.h"

namespace candela_test {
namespace {

/// A square from (0, 0) to (1, 1): positions in accessor 0, normals in 1.
void addSquare(GltfFile& file) {
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    file.addData<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
}

constexpr const char* squareAttributes = R"("POSITION":0,"NORMAL":1)";
constexpr const char* skinnedAttributes = R"("POSITION":0,"NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3)";

std::string strip(const std::string& attributes, const std::string& more = "") {
    return "{\"attributes\":{" + attributes + "},\"mode\":6" + more + "}";
}

/// Joints in accessor 2, weights in accessor 3: the lower edge follows joint 0, the upper one joint 1.
template <typename Joint, typename Weight>
void addInfluences(GltfFile& file, Weight one, const std::string& encoding = "") {
    file.addData<Joint>("VEC4", {0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    file.addData<Weight>("VEC4", {one, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0, one, 0, 0, 0}, encoding);
}

/// Node 0 shows the square with the skin, whose joints are nodes 1 and 2.
GltfFile skinnedFile(const std::string& attributes = skinnedAttributes, const std::string& more = "") {
    GltfFile file;
    addSquare(file);
    addInfluences<std::uint8_t>(file, 1.0f);
    file.add("meshes", R"({"name":"square","primitives":[)" + strip(attributes, more) + "]}");
    file.add("nodes", R"({"name":"body","mesh":0,"skin":0,"scale":[0.01,0.01,0.01]})");
    file.add("nodes", R"({"name":"lower","translation":[10,0,0]})");
    file.add("nodes", R"({"name":"upper","translation":[0,5,0],"scale":[2,2,2]})");
    file.add("skins", R"({"name":"arm","joints":[1,2]})");
    return file;
}

std::vector<glm::vec3> posed(const candela::Scene& scene, std::uint32_t node = 0, double time = 0.0) {
    const candela::PosedPoints points =
        candela::poseMesh(scene, node, candela::worldTransforms(scene, time), time);
    std::vector<glm::vec3> places;
    for (const glm::vec3& point : points.points)
        places.emplace_back(points.worldFromPoints * glm::vec4(point, 1.0f));
    return places;
}

// Without bind matrices they are identities.
const std::vector<glm::vec3> skinnedSquare{{10, 0, 0}, {11, 0, 0}, {2, 7, 0}, {0, 7, 0}};

TEST(MeshDeformation, aSkinMovesAMeshAndItsNodeDoesNot) {
    const candela::ImportedScene imported = load(skinnedFile());
    EXPECT_TRUE(imported.report.notes.empty());
    ASSERT_EQ(imported.scene.skins.size(), 1u);
    EXPECT_EQ(imported.scene.nodes[0].skin, 0u);
    EXPECT_EQ(posed(imported.scene), skinnedSquare);
    const candela::Bounds bounds =
        candela::nodeBounds(imported.scene, 0, candela::worldTransforms(imported.scene));
    EXPECT_EQ(bounds.min, glm::vec3(0, 0, 0));
    EXPECT_EQ(bounds.max, glm::vec3(11, 7, 0));
}

TEST(MeshDeformation, bindMatrices) {
    GltfFile file;
    addSquare(file);
    addInfluences<std::uint8_t>(file, 1.0f);
    file.addData<float>("MAT4", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,  //
                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
    file.add("meshes", R"({"primitives":[)" + strip(skinnedAttributes) + "]}");
    file.add("nodes", R"({"mesh":0,"skin":0})");
    file.add("nodes", "{}");
    file.add("nodes", R"({"scale":[3,3,3]})");
    file.add("skins", R"({"joints":[1,2],"inverseBindMatrices":4})");
    EXPECT_EQ(posed(load(file).scene), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 3, 0}, {-3, 3, 0}}));
}

TEST(MeshDeformation, influencesOfEveryEncoding) {
    const auto check = [](const auto& addAll) {
        GltfFile file;
        addSquare(file);
        addAll(file);
        file.add("meshes", R"({"primitives":[)" + strip(skinnedAttributes) + "]}");
        file.add("nodes", R"({"mesh":0,"skin":0})");
        file.add("nodes", R"({"translation":[10,0,0]})");
        file.add("nodes", R"({"translation":[0,5,0],"scale":[2,2,2]})");
        file.add("skins", R"({"joints":[1,2]})");
        EXPECT_EQ(posed(load(file).scene), skinnedSquare);
    };
    check([](GltfFile& file) { addInfluences<std::uint16_t>(file, 1.0f); });
    check(
        [](GltfFile& file) { addInfluences<std::uint8_t, std::uint8_t>(file, 255, R"("normalized":true)"); });
    check([](GltfFile& file) {
        addInfluences<std::uint16_t, std::uint16_t>(file, 65535, R"("normalized":true)");
    });
}

TEST(MeshDeformation, eightInfluencesOfAnySum) {
    GltfFile file =
        skinnedFile(R"("POSITION":0,"NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3,"JOINTS_1":4,"WEIGHTS_1":3)");
    file.addData<std::uint8_t>("VEC4", {1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.report.notes.empty());
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(mesh.influenceCount, 8u);
    EXPECT_EQ(mesh.jointWeights.at(0), 0.5f) << "weights of the sum 2 are divided by it";
    EXPECT_EQ(mesh.jointWeights.at(4), 0.5f);
    // Halfway between the places to which the two joints take each vertex.
    EXPECT_EQ(posed(imported.scene),
              (std::vector<glm::vec3>{{5, 2.5f, 0}, {6.5f, 2.5f, 0}, {6.5f, 4, 0}, {5, 4, 0}}));
}

TEST(MeshDeformation, brokenInfluencesAreRepaired) {
    GltfFile file;
    addSquare(file);
    file.addData<std::uint8_t>("VEC4", {0, 1, 0, 0, 0, 9, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    file.addData<float>("VEC4", {1, -3, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0});
    file.add("meshes", R"({"name":"square","primitives":[)" + strip(skinnedAttributes) + "]}");
    file.add("nodes", R"({"mesh":0,"skin":0})");
    file.add("nodes", R"({"translation":[10,0,0]})");
    file.add("nodes", R"({"translation":[0,5,0],"scale":[2,2,2]})");
    file.add("skins", R"({"joints":[1,2]})");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(posed(imported.scene), (std::vector<glm::vec3>{{10, 0, 0}, {11, 0, 0}, {11, 1, 0}, {0, 7, 0}}));
    EXPECT_TRUE(hasNote(imported, "joint weights below 0, taken as 0"));
    EXPECT_TRUE(hasNote(imported, "joints that the skin does not have, left out"));
    EXPECT_TRUE(hasNote(imported, "moved by the skin's first joint"));
}

const std::vector<glm::vec3> restingSquare{{0, 0, 0}, {0.01f, 0, 0}, {0.01f, 0.01f, 0}, {0, 0.01f, 0}};

TEST(MeshDeformation, whatIsBrokenLeavesTheMeshAtItsNode) {
    const auto expectAtRest = [](const GltfFile& file, const std::string& note) {
        const candela::ImportedScene imported = load(file);
        EXPECT_TRUE(hasNote(imported, note)) << note;
        EXPECT_EQ(posed(imported.scene), restingSquare) << note;
    };
    expectAtRest(skinnedFile(R"("POSITION":0,"NORMAL":1,"JOINTS_0":2)"), "has no WEIGHTS_0");
    expectAtRest(skinnedFile(R"("POSITION":0,"NORMAL":1,"JOINTS_0":0,"WEIGHTS_0":3)"), "attribute JOINTS_0");
    expectAtRest(skinnedFile(squareAttributes), "a mesh without JOINTS_0 and WEIGHTS_0");
    GltfFile outside = skinnedFile();
    outside.add("scenes", R"({"nodes":[0,1]})");
    expectAtRest(outside, "node 2 'upper', is not in the scene that is drawn");
}

/// The square with two morph targets; the first is sparse and moves vertex 2 by (0, 0, 4).
GltfFile morphedFile(const std::string& mesh = "", const std::string& node = "") {
    GltfFile file;
    addSquare(file);
    const std::string index = std::to_string(file.addView({2}));
    const std::string value = std::to_string(file.addView(bytesOf<float>({0, 0, 4})));
    file.addAccessor(-1, "VEC3", 5126, 4,
                     R"("sparse":{"count":1,"indices":{"bufferView":)" + index +
                         R"(,"componentType":5121},"values":{"bufferView":)" + value + "}}");
    file.addData<float>("VEC3", {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
    file.addData<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    file.add("meshes", R"({"name":"face","primitives":[)" +
                           strip(R"("POSITION":0,"NORMAL":1,"TANGENT":4)",
                                 R"(,"targets":[{"POSITION":2},{"POSITION":3,"NORMAL":3,"TANGENT":3}])") +
                           "]" + mesh + "}");
    file.add("nodes", R"({"name":"head","mesh":0)" + node + "}");
    return file;
}

TEST(MeshDeformation, morphTargets) {
    const candela::ImportedScene imported = load(morphedFile());
    EXPECT_TRUE(imported.report.notes.empty());
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    const std::vector<glm::vec3> alongX(4, glm::vec3(1, 0, 0)), none(4, glm::vec3(0));
    ASSERT_EQ(mesh.morphTargets.size(), 2u);
    EXPECT_EQ(mesh.morphTargets[0].offsets.at(2), glm::vec3(0, 0, 4));
    EXPECT_EQ(mesh.morphTargets[0].normalOffsets, none);
    EXPECT_EQ(mesh.morphTargets[1].offsets, alongX);
    EXPECT_EQ(mesh.morphTargets[1].normalOffsets, alongX);
    EXPECT_EQ(mesh.morphTargets[1].tangentOffsets, alongX);
    EXPECT_TRUE(imported.scene.nodes.at(0).morphWeights.empty());
}

TEST(MeshDeformation, weightsOfTheNodeReplaceThoseOfTheMesh) {
    EXPECT_EQ(load(morphedFile(R"(,"weights":[0.5,2])")).scene.nodes.at(0).morphWeights,
              (std::vector<float>{0.5f, 2.0f}));
    const candela::Scene scene = load(morphedFile(R"(,"weights":[0.5,2])", R"(,"weights":[1,0.25])")).scene;
    EXPECT_EQ(scene.nodes.at(0).morphWeights, (std::vector<float>{1.0f, 0.25f}));
    EXPECT_EQ(posed(scene).at(2), glm::vec3(1.25f, 1, 4));
}

TEST(MeshDeformation, anotherNumberOfWeightsIsRepaired) {
    const candela::ImportedScene imported = load(morphedFile(R"(,"weights":[0.5])"));
    EXPECT_EQ(imported.scene.nodes.at(0).morphWeights, (std::vector<float>{0.5f, 0.0f}));
    EXPECT_TRUE(hasNote(imported, "the number of morph weights is not that of the mesh's targets"));
}

TEST(MeshDeformation, weightsAreAnimatedInAllPartsOfAMesh) {
    GltfFile file;
    addSquare(file);
    file.addData<float>("VEC3", {0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2});
    // Two primitives with different attributes are two meshes of the scene.
    file.add("meshes", R"({"primitives":[)" + strip(squareAttributes, R"(,"targets":[{"POSITION":2}])") +
                           "," + strip(R"("POSITION":0)", R"(,"targets":[{"POSITION":2}])") + "]}");
    file.add("nodes", R"({"mesh":0})");
    file.addData<float>("SCALAR", {0, 2});
    file.addData<float>("SCALAR", {0, 1});
    file.add("animations", R"({"samplers":[{"input":3,"output":4}],
                               "channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}]})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.meshes.size(), 2u);
    ASSERT_EQ(scene.animations.at(0).channels.size(), 2u);
    for (const std::uint32_t node : {0u, 1u}) {
        for (const glm::vec3& place : posed(scene, node, 1.0)) EXPECT_EQ(place.z, 1.0f) << node;
    }
}

TEST(MeshDeformation, flatNormalsFollowTheTargets) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    // Turns the triangle into the plane x = 0.
    file.addData<float>("VEC3", {0, 0, 0, -1, 0, -1, 0, 0, 0});
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0},"targets":[{"POSITION":1}]}]})");
    file.add("nodes", R"({"mesh":0})");
    const candela::Mesh mesh = load(file).scene.meshes.at(0);
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
    EXPECT_EQ(mesh.morphTargets.at(0).normalOffsets, std::vector<glm::vec3>(3, glm::vec3(1, 0, -1)));
}

}  // namespace
}  // namespace candela_test
