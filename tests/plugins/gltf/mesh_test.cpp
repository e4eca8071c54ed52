#include <gtest/gtest.h>

#include "image_files.h"
#include "loading.h"

namespace candela_test {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Five vertices of a strip or a fan with normals: accessors 0 and 1.
void addFiveVertices(GltfFile& file) {
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});
    file.addData<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
}

Indices indicesOfMode(const std::string& mode) {
    GltfFile file;
    addFiveVertices(file);
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"mode":)" + mode);
    return load(file).scene.meshes.at(0).indices;
}

TEST(Mesh, trianglesWithoutIndices) {
    const candela::Mesh mesh = load(triangleFile()).scene.meshes.at(0);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.submeshes.size(), 1u);
    EXPECT_EQ(mesh.submeshes[0].material, 0u) << "the default material";
}

TEST(Mesh, stripsAlternateTheirWinding) {
    EXPECT_EQ(indicesOfMode("5"), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(Mesh, fansShareTheirFirstVertex) {
    EXPECT_EQ(indicesOfMode("6"), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST(Mesh, indexedStripAndFan) {
    GltfFile file;
    addFiveVertices(file);
    file.addData<std::uint8_t>("SCALAR", {4, 3, 2, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2,"mode":5)");
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"indices":2,"mode":6)");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.meshes.at(0).indices, (Indices{4, 3, 2, 3, 1, 2}));
    EXPECT_EQ(scene.meshes.at(1).indices, (Indices{3, 2, 4, 2, 1, 4}));
}

/// Of a file whose only primitive has this mode and the vertices of `addFiveVertices`.
candela::Mesh meshOfMode(const std::string& mode) {
    GltfFile file;
    addFiveVertices(file);
    file.addMeshNode(R"("attributes":{"POSITION":0},"mode":)" + mode);
    return load(file).scene.meshes.at(0);
}

TEST(Mesh, pointsAndLines) {
    const candela::Mesh points = meshOfMode("0"), strip = meshOfMode("3"), loop = meshOfMode("2");
    EXPECT_EQ(points.indices, (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(points.submeshes.at(0).topology, candela::Topology::points);
    EXPECT_EQ(strip.indices, (Indices{0, 1, 1, 2, 2, 3, 3, 4}));
    EXPECT_EQ(loop.indices, (Indices{0, 1, 1, 2, 2, 3, 3, 4, 4, 0}));
    for (const candela::Mesh& mesh : {strip, loop})
        EXPECT_EQ(mesh.submeshes.at(0).topology, candela::Topology::lines);
    for (const candela::Mesh& mesh : {points, strip, loop})
        EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(5, glm::vec3(0.0f))) << "they are unlit";
}

TEST(Mesh, linesOfAListAreWhole) {
    GltfFile file;
    addFiveVertices(file);
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"mode":1)");
    const candela::ImportedScene imported = load(file);
    const candela::Mesh& mesh = imported.scene.meshes.at(0);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(5, glm::vec3(0, 0, 1))) << "they are lit";
    EXPECT_TRUE(hasNote(imported, "mesh 0, primitive 0: corners beyond the last whole line: left out"));
}

TEST(Mesh, linesWithVerticesThatDoNotExistAreLeftOut) {
    GltfFile file;
    addFiveVertices(file);
    file.addData<std::uint8_t>("SCALAR", {0, 1, 9, 2, 3});
    file.addMeshNode(R"("attributes":{"POSITION":0},"indices":2,"mode":3)");
    const candela::ImportedScene imported = load(file);
    EXPECT_EQ(imported.scene.meshes.at(0).indices, (Indices{0, 1, 2, 3}));
    EXPECT_TRUE(hasNote(imported, "lines with a vertex that does not exist: left out"));
}

TEST(Mesh, trianglesAndLinesOfAMeshAreDrawnByOneNodeEach) {
    GltfFile file;
    addTriangle(file);
    const std::string attributes = R"({"attributes":{"POSITION":0},"mode":)";
    file.add("meshes", "{\"primitives\":[" + attributes + "0}," + attributes + "3}," + attributes + "4}]}");
    file.add("nodes", R"({"mesh":0})");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(candela::elementCount(scene, candela::Topology::triangles), 1u);
    EXPECT_EQ(candela::elementCount(scene, candela::Topology::lines), 2u);
    EXPECT_EQ(candela::elementCount(scene, candela::Topology::points), 3u);
}

TEST(Mesh, primitivesBecomeSubmeshesAndShareVertices) {
    GltfFile file;
    addFiveVertices(file);
    file.addData<std::uint16_t>("SCALAR", {0, 1, 2});
    file.addData<std::uint16_t>("SCALAR", {1, 3, 2});
    const auto other = addTriangle(file);
    file.add("materials", "{}");
    file.add("materials", "{}");
    file.add("meshes", R"({"name":"pair","primitives":[
        {"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":1},
        {"attributes":{"POSITION":0,"NORMAL":1},"indices":3,"material":0},
        {"attributes":{"POSITION":)" +
                           std::to_string(other.positions) + R"(,"NORMAL":)" + std::to_string(other.normals) +
                           "}}]}");
    file.add("nodes", R"({"mesh":0})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.meshes.size(), 1u);
    const candela::Mesh& mesh = scene.meshes[0];
    EXPECT_EQ(mesh.name, "pair");
    EXPECT_EQ(mesh.positions.size(), 8u);
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2, 1, 3, 2, 5, 6, 7}));
    ASSERT_EQ(mesh.submeshes.size(), 3u);
    EXPECT_EQ(mesh.submeshes[0].material, 1u);
    EXPECT_EQ(mesh.submeshes[1].firstIndex, 3u);
    EXPECT_EQ(mesh.submeshes[1].material, 0u);
    EXPECT_EQ(mesh.submeshes[2].material, scene.materials.size() - 1) << "the default material";
}

TEST(Mesh, primitivesWithDifferentAttributesBecomeSeveralMeshes) {
    GltfFile file;
    addTriangle(file);
    file.addData<float>("VEC2", {0, 0, 1, 0, 0, 1});
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":1}},
                                         {"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2}},
                                         {"attributes":{"POSITION":0,"NORMAL":1}}]})");
    file.add("nodes", R"({"mesh":0,"translation":[1,2,3],"name":"both"})");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].submeshes.size(), 2u);
    EXPECT_TRUE(scene.meshes[0].uv0.empty());
    EXPECT_EQ(scene.meshes[1].uv0.size(), 3u);
    ASSERT_EQ(scene.nodes.size(), 2u);
    EXPECT_EQ(scene.nodes[1].parent, 0u);
    EXPECT_EQ(scene.nodes[1].mesh, 1u);
    const std::vector<glm::mat4> world = candela::worldTransforms(scene);
    EXPECT_EQ(world[1], world[0]);
    EXPECT_EQ(world[0][3], glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(candela::triangleCount(scene), 3u);
}

TEST(Mesh, missingNormalsAreFlat) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 0, 0, 1, 0, 1, 0});
    file.addMeshNode(R"("attributes":{"POSITION":0})");
    const candela::Mesh mesh = load(file).scene.meshes.at(0);
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, glm::vec3(-1, 0, 0)));
}

TEST(Mesh, tangentsWithoutNormalsAreIgnored) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.addData<float>("VEC4", {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
    file.addMeshNode(R"("attributes":{"POSITION":0,"TANGENT":1})");
    EXPECT_TRUE(load(file).scene.meshes.at(0).tangents.empty());
}

TEST(Mesh, bothTextureCoordinateSets) {
    GltfFile file;
    addTriangle(file);
    file.addData<float>("VEC2", {0, 0, 1, 0, 0, 1});
    file.addData<float>("VEC2", {5, 5, 6, 5, 5, 6});
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":3})");
    const candela::Mesh mesh = load(file).scene.meshes.at(0);
    EXPECT_EQ(mesh.uv0, (std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}}));
    EXPECT_EQ(mesh.uv1, (std::vector<glm::vec2>{{5, 5}, {6, 5}, {5, 6}}));
}

template <typename T>
std::vector<glm::vec4> colors(const std::string& type, const std::vector<T>& values) {
    GltfFile file;
    addTriangle(file);
    file.addData<T>(type, values, std::is_same_v<T, float> ? "" : R"("normalized":true)");
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2})");
    return load(file).scene.meshes.at(0).colors;
}

TEST(Mesh, vertexColorsOfEveryType) {
    const std::vector<glm::vec4> opaque{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
    const std::vector<glm::vec4> clear{{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 0, 1, 0}};
    EXPECT_EQ(colors<float>("VEC3", {1, 0, 0, 0, 1, 0, 0, 0, 1}), opaque);
    EXPECT_EQ(colors<std::uint16_t>("VEC3", {65535, 0, 0, 0, 65535, 0, 0, 0, 65535}), opaque);
    EXPECT_EQ(colors<float>("VEC4", {1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0}), clear);
    EXPECT_EQ(colors<std::uint8_t>("VEC4", {255, 0, 0, 0, 0, 255, 0, 255, 0, 0, 255, 0}), clear);
    EXPECT_EQ(colors<std::uint16_t>("VEC4", {65535, 0, 0, 0, 0, 65535, 0, 65535, 0, 0, 65535, 0}), clear);
}

TEST(Mesh, threeByteColorsAtAStride) {
    GltfFile file;
    addTriangle(file);
    const int view = file.addView({255, 0, 0, 9, 0, 255, 0, 9, 0, 0, 255}, R"("byteStride":4)");
    file.addAccessor(view, "VEC3", 5121, 3, R"("normalized":true)");
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1,"COLOR_0":2})");
    EXPECT_EQ(load(file).scene.meshes.at(0).colors,
              (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}));
}

TEST(Mesh, sharedByTwoNodesIsAddedOnce) {
    GltfFile file = triangleFile();
    file.add("nodes", R"({"mesh":0})");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(candela::triangleCount(scene), 2u);
}

TEST(Mesh, withoutPositionsIsNotedAndOmitted) {
    GltfFile file;
    addTriangle(file);
    file.addMeshNode(R"("attributes":{"NORMAL":1})", "empty");
    EXPECT_TRUE(hasNote(load(file), "mesh 0 'empty', primitive 0: not drawn: no POSITION"));
}

TEST(Mesh, missingTextureCoordinatesAreZeroAndNoted) {
    GltfFile file = triangleFile(R"("material":0)");
    file.add("images", R"({"uri":"data:image/png;base64,)" + base64(makePng(1, 1, 1, 2, 3, 4)) + "\"}");
    file.add("textures", R"({"source":0})");
    file.add("materials", R"({"emissiveTexture":{"index":0,"texCoord":1}})");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.scene.meshes.at(0).uv0.empty());
    EXPECT_EQ(imported.scene.meshes.at(0).uv1, std::vector<glm::vec2>(3, glm::vec2(0)));
    EXPECT_TRUE(hasNote(imported, "mesh 0, primitive 0: no TEXCOORD_1, which material 0 reads"));
}

}  // namespace
}  // namespace candela_test
