#include <gtest/gtest.h>

#include <set>

#include "cage_file.h"
#include "image_files.h"

namespace candela_test {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(Cage, verticesSplitAlongSeamsAreWelded) {
    const candela::Cage cage = cageOf(cubeFile());
    EXPECT_EQ(cage.positions.size(), 8u);
    EXPECT_EQ(cage.faceSizes, Indices(6, 4));
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t face = 0; face < 6; ++face) {
        for (std::size_t i = 0; i < 4; ++i) {
            const bool isNew =
                edges.insert({cage.faceVertices[4 * face + i], cage.faceVertices[4 * face + (i + 1) % 4]})
                    .second;
            EXPECT_TRUE(isNew) << "two faces have an edge in the same direction";
        }
    }
    // A closed surface: each of the 12 edges once in each direction.
    EXPECT_EQ(edges.size(), 24u);
}

TEST(Cage, cornersKeepTheirPositions) {
    const candela::Cage cage = cageOf(cubeFile());
    const glm::vec3 expected[] = {{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cage.positions[cage.faceVertices[i]], expected[i]);
}

TEST(Cage, uvsDifferAcrossSeams) {
    const candela::Cage cage = cageOf(cubeFile());
    // Six squares side by side: no corner shares its texture coordinates with that of another face.
    EXPECT_EQ(cage.uvs.size(), 24u);
    ASSERT_EQ(cage.faceUvs.size(), 24u);
    EXPECT_EQ(cage.uvs[cage.faceUvs[0]], glm::vec2(0, 0));
    EXPECT_EQ(cage.uvs[cage.faceUvs[4 * 5 + 2]], glm::vec2(5.5f, 0.5f));
}

/// Two squares that share the edge x = 1, each with four vertices and a normal of its own; `u` are the
/// texture coordinates of the shared edge in the second square.
GltfFile twoSquares(float u, const std::string& settings = "{}") {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0});
    file.addData<float>("VEC2", {0, 0, 1, 0, 1, 1, 0, 1, u, 0, 2, 0, 2, 1, u, 1});
    file.addData<float>("VEC3", {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});
    file.addData<std::uint8_t>("SCALAR", {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7});
    addCageMesh(file,
                R"({"attributes":{"POSITION":0,"TEXCOORD_0":1,"NORMAL":2},"indices":3)" +
                    facesMember(Faces::ngonEncoding) + "}",
                settings);
    return file;
}

TEST(Cage, equalUvsAtAVertexAreNotASeam) {
    const candela::Cage cage = cageOf(twoSquares(1.0f));
    EXPECT_EQ(cage.positions.size(), 6u);
    EXPECT_EQ(cage.uvs.size(), 6u);
    EXPECT_EQ(cage.faceUvs[1], cage.faceUvs[4]);
    EXPECT_EQ(cage.faceUvs[2], cage.faceUvs[7]);
}

TEST(Cage, differentUvsAtAVertexAreASeam) {
    const candela::Cage cage = cageOf(twoSquares(1.5f));
    EXPECT_EQ(cage.positions.size(), 6u);
    EXPECT_EQ(cage.uvs.size(), 8u);
    EXPECT_EQ(cage.faceVertices[1], cage.faceVertices[4]);
    EXPECT_NE(cage.faceUvs[1], cage.faceUvs[4]);
}

TEST(Cage, zeroAndMinusZeroAreWelded) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, -0.0f, 1, -0.0f, 1, 0, 0, 1, 1, 0});
    addCageMesh(file, R"({"attributes":{"POSITION":0}})", "{}");
    EXPECT_EQ(cageOf(file).positions.size(), 4u);
}

TEST(Cage, withoutUvs) {
    GltfFile file;
    addSquareCage(file);
    const candela::Cage cage = cageOf(file);
    EXPECT_TRUE(cage.uvs.empty());
    EXPECT_TRUE(cage.faceUvs.empty());
    EXPECT_EQ(cage.positions.size(), 4u);
}

TEST(Cage, degenerateFacesAreOmittedAndCounted) {
    GltfFile file;
    // The second triangle has (1, 0, 0) twice, as two vertices of the file, the third as one; the fourth is
    // not degenerate.
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0});
    file.addData<std::uint8_t>("SCALAR", {0, 1, 2, 1, 3, 4, 0, 2, 2, 1, 4, 2});
    addCageMesh(file, R"({"attributes":{"POSITION":0},"indices":1})", R"({"holes":[1,3]})");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(hasNote(imported, "mesh 0 'cage': 2 faces pass twice through a vertex: left out"));
    const candela::Cage& cage = imported.scene.cages.at(0);
    EXPECT_EQ(cage.faceVertices, (Indices{0, 1, 2, 1, 3, 2}));
    EXPECT_EQ(cage.holes, (Indices{1})) << "holes count the faces of the file";
}

TEST(Cage, unusedVerticesAreOmitted) {
    GltfFile file;
    file.addData<float>("VEC3", {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.addData<std::uint8_t>("SCALAR", {1, 2, 3});
    addCageMesh(file, R"({"attributes":{"POSITION":0},"indices":1})", R"({"corners":[[3,1]]})");
    const candela::Cage cage = cageOf(file);
    EXPECT_EQ(cage.positions.size(), 3u);
    EXPECT_EQ(cage.corners.at(0).vertex, vertexAt(cage, {0, 1, 0}));
}

TEST(Cage, aCornerWithoutAFaceIsAnError) {
    GltfFile file;
    file.addData<float>("VEC3", {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0});
    file.addData<std::uint8_t>("SCALAR", {1, 2, 3});
    addCageMesh(file, R"({"attributes":{"POSITION":0},"indices":1})", R"({"corners":[[0,1]]})");
    EXPECT_NE(errorOf(file).find("corners 0: vertex 0 belongs to no face"), std::string::npos)
        << errorOf(file);
}

/// Two triangles of a square, each a primitive with its own material.
GltfFile twoPrimitives(const std::string& settings = "{}") {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0});
    file.addData<float>("VEC3", {0, 0, 0, 1, 1, 0, 0, 1, 0});
    file.add("materials", R"({"name":"red"})");
    file.add("materials", R"({"name":"blue"})");
    addCageMesh(file,
                R"({"attributes":{"POSITION":0},"material":1},{"attributes":{"POSITION":1}},)"
                R"({"attributes":{"POSITION":1},"mode":1})",
                settings);
    return file;
}

TEST(Cage, primitivesBecomeOneCageWithAMaterialPerFace) {
    const candela::ImportedScene imported = load(twoPrimitives());
    const candela::Cage& cage = imported.scene.cages.at(0);
    EXPECT_EQ(cage.positions.size(), 4u);
    ASSERT_EQ(cage.faceMaterials.size(), 2u);
    EXPECT_EQ(cage.faceMaterials[0], 1u);
    EXPECT_EQ(cage.faceMaterials[1], imported.scene.materials.size() - 1) << "the default material";
    EXPECT_TRUE(hasNote(imported, "primitive 2: points and lines are no part of a cage"));
}

TEST(Cage, vertexNumbersContinueAcrossPrimitives) {
    // Vertex 5 is vertex 2 of primitive 1; edge 3-4 of primitive 1 is edge 0-2 of primitive 0.
    const candela::Cage cage =
        cageOf(twoPrimitives(R"({"corners":[[5,2]],"creases":[[3,4,1],[2,0,1]],"holes":[1]})"));
    EXPECT_EQ(cage.corners.at(0).vertex, vertexAt(cage, {0, 1, 0}));
    EXPECT_EQ(cage.creases.size(), 1u);
    EXPECT_EQ(cage.holes, Indices{1});
}

TEST(Cage, vertexNumbersContinueAcrossSharedAccessors) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    file.addData<std::uint8_t>("SCALAR", {0, 1, 2});
    file.addData<std::uint8_t>("SCALAR", {0, 2, 3});
    addCageMesh(file,
                R"({"attributes":{"POSITION":0},"indices":1},{"attributes":{"POSITION":0},"indices":2})",
                R"({"corners":[[3,1],[5,2]]})");
    const candela::Cage cage = cageOf(file);
    ASSERT_EQ(cage.corners.size(), 2u);
    EXPECT_EQ(cage.corners[0].vertex, vertexAt(cage, {0, 1, 0}));
    EXPECT_EQ(cage.corners[1].vertex, vertexAt(cage, {1, 0, 0}));
}

TEST(Cage, withoutFacesIsOmitted) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0});
    addCageMesh(file, R"({"attributes":{"POSITION":0},"mode":0})", "{}");
    const candela::ImportedScene imported = load(file);
    EXPECT_TRUE(imported.scene.cages.empty());
    EXPECT_FALSE(imported.scene.nodes.at(0).cage.has_value());
    EXPECT_TRUE(hasNote(imported, "mesh 0 'cage': a cage without a face"));
}

TEST(Cage, ofAnUnusedMeshIsNotAdded) {
    GltfFile file = cubeFile();
    file.add("nodes", "{}");
    file.add("scenes", R"({"nodes":[1]})");
    EXPECT_TRUE(load(file).scene.cages.empty());
}

TEST(Cage, severalNodesMayInstanceIt) {
    GltfFile file = cubeFile();
    file.add("nodes", R"({"mesh":0,"translation":[3,0,0]})");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.cages.size(), 1u);
    ASSERT_EQ(scene.nodes.size(), 2u);
    EXPECT_EQ(scene.nodes[1].cage, 0u);
}

TEST(Cage, togetherWithMeshes) {
    GltfFile file = cubeFile();
    file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":1},"indices":3)");
    const candela::Scene scene = load(file).scene;
    EXPECT_EQ(scene.cages.size(), 1u);
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].positions.size(), 24u);
    EXPECT_EQ(scene.nodes.at(1).mesh, 0u);
}

TEST(Cage, vertexColorsAreNoted) {
    GltfFile file;
    file.addData<float>("VEC3", {0, 0, 0, 1, 0, 0, 1, 1, 0});
    file.addData<float>("VEC3", {1, 1, 1, 1, 1, 1, 1, 1, 1});
    addCageMesh(file, R"({"attributes":{"POSITION":0,"COLOR_0":1}})", "{}");
    EXPECT_TRUE(hasNote(load(file), "mesh 0 'cage', primitive 0: a cage has no vertex colours"));
}

TEST(Cage, quantizedPositionsAndUvs) {
    GltfFile file;
    file.set("extensionsUsed", R"(["KHR_mesh_quantization"])");
    file.addData<std::int8_t>("VEC3", {0, 0, 0, 127, 0, 0, 0, -127, 0}, R"("normalized":true)");
    file.addData<std::uint8_t>("VEC2", {0, 0, 255, 0, 0, 255}, R"("normalized":true)");
    addCageMesh(file, R"({"attributes":{"POSITION":0,"TEXCOORD_0":1}})", "{}");
    const candela::Cage cage = cageOf(file);
    EXPECT_EQ(cage.positions.at(2), glm::vec3(0, -1, 0));
    EXPECT_EQ(cage.uvs.at(1), glm::vec2(1, 0));
}

/// A square whose primitive has both sets of texture coordinates, u 0 to 1 and u 4 to 5, and materials whose
/// textures read `sets`.
GltfFile fileWithSets(const std::vector<int>& sets, const std::string& attributes) {
    GltfFile file;
    addSquareCage(file, {attributes, R"(,"material":0)", ""});
    file.addData<float>("VEC2", {0, 0, 1, 0, 1, 1, 0, 1});
    file.addData<float>("VEC2", {4, 0, 5, 0, 5, 1, 4, 1});
    file.add("images", R"({"uri":"data:image/png;base64,)" + base64(makePng(1, 1, 1, 2, 3, 4)) + "\"}");
    file.add("textures", R"({"source":0})");
    const char* uses[] = {"emissiveTexture", "normalTexture"};
    std::string material;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        material += std::string(i > 0 ? ",\"" : "\"") + uses[i] + R"(":{"index":0,"texCoord":)" +
                    std::to_string(sets[i]) + "}";
    }
    file.add("materials", "{" + material + "}");
    return file;
}

constexpr const char* bothSets = R"(,"TEXCOORD_0":2,"TEXCOORD_1":3)";

TEST(Cage, usesTheUvSetThatItsMaterialsRead) {
    EXPECT_EQ(cageOf(fileWithSets({}, bothSets)).uvs.at(0), glm::vec2(0, 0));
    EXPECT_EQ(cageOf(fileWithSets({0}, bothSets)).uvs.at(0), glm::vec2(0, 0));
    EXPECT_EQ(cageOf(fileWithSets({1, 1}, bothSets)).uvs.at(0), glm::vec2(4, 0));
}

TEST(Cage, itsMaterialsUseUvSetZero) {
    GltfFile file = fileWithSets({1, 1}, bothSets);
    file.addMeshNode(R"("attributes":{"POSITION":0,"TEXCOORD_1":3},"indices":1,"material":0)");
    file.addMeshNode(R"("attributes":{"POSITION":0,"TEXCOORD_1":3},"indices":1,"material":0)");
    const candela::Scene scene = load(file).scene;
    ASSERT_EQ(scene.materials.size(), 2u) << "the file's material, for the meshes, and its copy";
    EXPECT_EQ(scene.materials[0].emissionTexture.value().uvSet, 1u);
    EXPECT_EQ(scene.meshes.at(0).submeshes.at(0).material, 0u);
    EXPECT_EQ(scene.cages.at(0).faceMaterials.at(0), 1u);
    EXPECT_EQ(scene.materials[1].emissionTexture.value().uvSet, 0u);
    EXPECT_EQ(scene.materials[1].normalTexture.value().uvSet, 0u);
}

TEST(Cage, usesTheFirstUvSetWhenItsMaterialsReadBoth) {
    const candela::ImportedScene imported = load(fileWithSets({0, 1}, bothSets));
    EXPECT_EQ(imported.scene.cages.at(0).uvs.at(0), glm::vec2(0, 0));
    EXPECT_TRUE(hasNote(imported,
                        "mesh 0 'cage': its materials read several sets of texture coordinates, but a "
                        "cage has one: TEXCOORD_0 for all"));
}

TEST(Cage, missingUvsAreNoted) {
    const candela::ImportedScene imported = load(fileWithSets({1}, R"(,"TEXCOORD_0":2)"));
    EXPECT_TRUE(hasNote(imported, "mesh 0 'cage', primitive 0: no TEXCOORD_1, which material 0 reads"));
    // One a vertex.
    EXPECT_EQ(imported.scene.cages.at(0).uvs, std::vector<glm::vec2>(4, glm::vec2(0)));
}

}  // namespace
}  // namespace candela_test
