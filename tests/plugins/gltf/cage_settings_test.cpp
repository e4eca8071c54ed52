#include <gtest/gtest.h>

#include "cage_file.h"

namespace candela_test {
namespace {

TEST(CageSettings, aMeshWithSettingsIsACage) {
    const candela::Scene scene = load(cubeFile()).scene;
    ASSERT_EQ(scene.cages.size(), 1u);
    EXPECT_TRUE(scene.meshes.empty());
    EXPECT_EQ(scene.cages[0].name, "cage");
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_FALSE(scene.nodes[0].mesh.has_value());
    ASSERT_TRUE(scene.nodes[0].cage.has_value());
    EXPECT_EQ(scene.nodes[0].cage, 0u);
    EXPECT_FALSE(scene.nodes[0].skin.has_value());
}

TEST(CageSettings, otherExtrasChangeNothing) {
    for (const char* extras : {"7", "\"text\"", "[]", "null", "{}", R"({"level":3})"}) {
        GltfFile file;
        addTriangle(file);
        file.add("meshes",
                 std::string(R"({"primitives":[{"attributes":{"POSITION":0}}],"extras":)") + extras + "}");
        file.add("nodes", R"({"mesh":0})");
        const candela::Scene scene = load(file).scene;
        EXPECT_EQ(scene.meshes.size(), 1u) << extras;
        EXPECT_TRUE(scene.cages.empty()) << extras;
    }
}

TEST(CageSettings, defaults) {
    const candela::Cage cage = cageOf(cubeFile());
    EXPECT_EQ(cage.scheme, candela::SubdivisionScheme::catmullClark);
    EXPECT_EQ(cage.boundaryInterpolation, candela::BoundaryInterpolation::edgesAndCorners);
    EXPECT_EQ(cage.faceVaryingInterpolation, candela::FaceVaryingInterpolation::cornersOnly);
    EXPECT_EQ(cage.creaseMethod, candela::CreaseMethod::uniform);
    EXPECT_EQ(cage.triangleSubdivision, candela::TriangleSubdivision::catmullClark);
    EXPECT_FALSE(cage.level.has_value());
    EXPECT_TRUE(cage.creases.empty());
    EXPECT_TRUE(cage.corners.empty());
    EXPECT_TRUE(cage.holes.empty());
}

candela::Cage cageWith(const std::string& key, const std::string& value) {
    return cageOf(cubeFile("{\"" + key + "\":" + value + "}", Faces::triangles));
}

TEST(CageSettings, schemes) {
    EXPECT_EQ(cageWith("scheme", "\"catmullClark\"").scheme, candela::SubdivisionScheme::catmullClark);
    EXPECT_EQ(cageWith("scheme", "\"loop\"").scheme, candela::SubdivisionScheme::loop);
    EXPECT_EQ(cageWith("scheme", "\"bilinear\"").scheme, candela::SubdivisionScheme::bilinear);
}

TEST(CageSettings, boundaryInterpolations) {
    using enum candela::BoundaryInterpolation;
    const auto read = [](const char* value) {
        return cageWith("boundaryInterpolation", value).boundaryInterpolation;
    };
    EXPECT_EQ(read("\"none\""), none);
    EXPECT_EQ(read("\"edges\""), edges);
    EXPECT_EQ(read("\"edgesAndCorners\""), edgesAndCorners);
}

TEST(CageSettings, faceVaryingInterpolations) {
    using enum candela::FaceVaryingInterpolation;
    const auto read = [](const char* value) {
        return cageWith("faceVaryingInterpolation", value).faceVaryingInterpolation;
    };
    EXPECT_EQ(read("\"none\""), none);
    EXPECT_EQ(read("\"cornersOnly\""), cornersOnly);
    EXPECT_EQ(read("\"cornersPlus1\""), cornersPlus1);
    EXPECT_EQ(read("\"cornersPlus2\""), cornersPlus2);
    EXPECT_EQ(read("\"boundaries\""), boundaries);
    EXPECT_EQ(read("\"all\""), all);
}

TEST(CageSettings, methodsAndLevels) {
    EXPECT_EQ(cageWith("creaseMethod", "\"chaikin\"").creaseMethod, candela::CreaseMethod::chaikin);
    EXPECT_EQ(cageWith("creaseMethod", "\"uniform\"").creaseMethod, candela::CreaseMethod::uniform);
    EXPECT_EQ(cageWith("triangleSubdivision", "\"smooth\"").triangleSubdivision,
              candela::TriangleSubdivision::smooth);
    EXPECT_EQ(cageWith("level", "1").level, 1u);
    EXPECT_EQ(cageWith("level", "8.0").level, 8u);
}

/// An invalid setting, and what its error message must contain.
struct InvalidSetting {
    std::string settings;
    std::vector<std::string> parts;
};

TEST(CageSettings, errorsNameTheMeshAndTheKey) {
    const InvalidSetting invalidSettings[] = {
        {"true", {"is not an object"}},
        {R"({"levels":2})", {"levels", "is not known"}},
        {R"({"scheme":1})", {"scheme", "expected catmullClark, loop or bilinear"}},
        {R"({"scheme":"doo"})", {"scheme", "is 'doo'", "expected catmullClark, loop or bilinear"}},
        {R"({"level":0})", {"level", "an integer from 1 to 8"}},
        {R"({"level":9})", {"level", "an integer from 1 to 8"}},
        {R"({"level":2.5})", {"level", "an integer from 1 to 8"}},
        {R"({"level":"3"})", {"level", "an integer from 1 to 8"}},
        {R"({"boundaryInterpolation":"all"})", {"boundaryInterpolation", "none, edges or edgesAndCorners"}},
        {R"({"faceVaryingInterpolation":null})", {"faceVaryingInterpolation", "cornersPlus2"}},
        {R"({"creaseMethod":"Chaikin"})", {"creaseMethod", "is 'Chaikin'", "uniform or chaikin"}},
        {R"({"triangleSubdivision":[]})", {"triangleSubdivision", "catmullClark or smooth"}},
        {R"({"creases":{}})", {"creases", "expected an array"}},
        {R"({"creases":[[0,1,2],[0,1]]})", {"creases 1", "expected [vertex, vertex, sharpness]"}},
        {R"({"creases":[[0,"1",2]]})", {"creases 0", "expected the number of a vertex"}},
        {R"({"creases":[[0,-1,2]]})", {"creases 0", "not an integer from 0"}},
        {R"({"creases":[[0,1,-2]]})", {"creases 0", "a sharpness that is not 0 or more"}},
        {R"({"creases":[[0,1,1e39]]})", {"creases 0", "a sharpness that is not 0 or more"}},
        {R"({"creases":[[0,24,1]]})", {"creases 0", "vertex 24 does not exist: the mesh has 24"}},
        {R"({"creases":[[0,2,1]]})", {"creases 0", "no edge from vertex 0 to vertex 2"}},
        {R"({"creases":[[0,0,1]]})", {"creases 0", "no edge from vertex 0 to vertex 0"}},
        {R"({"creases":[[0,1,1],[1,0,2]]})", {"creases 1", "another sharpness", "entry 0"}},
        {R"({"corners":[0,1]})", {"corners 0", "expected [vertex, sharpness]"}},
        {R"({"corners":[[99,1]]})", {"corners 0", "vertex 99 does not exist"}},
        {R"({"corners":[[0,1],[0,2]]})", {"corners 1", "another sharpness", "entry 0"}},
        {R"({"holes":[[0]]})", {"holes 0", "expected the number"}},
        {R"({"holes":[0,6]})", {"holes 1", "face 6 does not exist: the mesh has 6"}},
        {R"({"scheme":"loop"})", {"face 0 has 4 corners", "triangles only"}},
    };
    for (const InvalidSetting& invalid : invalidSettings) {
        const std::string error = complaintsOf(cubeFile(invalid.settings));
        EXPECT_NE(error.find("mesh 0 'cage'"), std::string::npos) << invalid.settings << ": " << error;
        for (const std::string& part : invalid.parts) {
            EXPECT_NE(error.find(part), std::string::npos) << invalid.settings << ": " << error;
        }
    }
}

/// The positions of the two vertices of a crease.
std::pair<glm::vec3, glm::vec3> endsOf(const candela::Cage& cage, std::size_t crease) {
    return {cage.positions.at(cage.creases.at(crease).vertex0),
            cage.positions.at(cage.creases.at(crease).vertex1)};
}

TEST(CageSettings, creasesUseVertexNumbersOfTheFile) {
    // Corners 1 and 2 of face 0, at +X: y is along the first axis, z along the second.
    const candela::Cage cage = cageOf(cubeFile(R"({"creases":[[1,2,2.5],[4,5,10]]})"));
    ASSERT_EQ(cage.creases.size(), 2u);
    EXPECT_EQ(endsOf(cage, 0), std::pair(glm::vec3(1, 1, -1), glm::vec3(1, 1, 1)));
    EXPECT_EQ(cage.creases[0].sharpness, 2.5f);
    // Face 1, at -X, is mirrored along y.
    EXPECT_EQ(endsOf(cage, 1), std::pair(glm::vec3(-1, 1, -1), glm::vec3(-1, -1, -1)));
    EXPECT_EQ(cage.creases[1].sharpness, 10.0f);
}

TEST(CageSettings, bothSidesOfASeamMayNameAnEdge) {
    // Corners 3 and 2 of face 2, at +Y, have the positions of corners 1 and 2 of face 0, at +X.
    const candela::Cage cage =
        cageOf(cubeFile(R"({"creases":[[1,2,3],[11,10,3]],"corners":[[2,1],[10,1]]})"));
    EXPECT_EQ(cage.creases.size(), 1u);
    EXPECT_EQ(cage.corners.size(), 1u);
}

TEST(CageSettings, cornersAndHoles) {
    const candela::Cage cage = cageOf(cubeFile(R"({"corners":[[0,4.5]],"holes":[5,2,5]})"));
    ASSERT_EQ(cage.corners.size(), 1u);
    EXPECT_EQ(cage.positions.at(cage.corners[0].vertex), glm::vec3(1, -1, -1));
    EXPECT_EQ(cage.corners[0].sharpness, 4.5f);
    EXPECT_EQ(cage.holes, (std::vector<std::uint32_t>{5, 2}));
}

TEST(CageSettings, settingsOfAnUnusedMeshAreChecked) {
    GltfFile file = triangleFile();
    file.add("meshes", R"({"primitives":[{"attributes":{"POSITION":0}}],
                           "extras":{"candela_subdivision":{"level":-1}}})");
    EXPECT_TRUE(hasNote(load(file), "mesh 1, candela_subdivision, level"));
}

}  // namespace
}  // namespace candela_test
