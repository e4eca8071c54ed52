// Files whose faces, vertices or lines are not as the format has them: the rest is drawn.
#include <gtest/gtest.h>

#include "obj_scene.h"

namespace candela_test {
namespace {

using Indices = std::vector<std::uint32_t>;

const candela::Mesh& onlyMesh(const candela::ImportedScene& imported) {
    EXPECT_EQ(imported.scene.meshes.size(), 1u);
    return imported.scene.meshes.at(0);
}

std::size_t triangles(const candela::ImportedScene& imported) {
    return candela::triangleCount(imported.scene);
}

TEST(ObjFace, OneWithAVertexThatIsNotThereIsLeftOut) {
    for (const char* face : {"f 1 2 9", "f 1 2 0", "f 1 2 -9", "f 1 2 99999999999999999999"}) {
        const auto imported = loadObj(squareVertices() + face + "\nf 1 2 3\n" + face + "\n");
        EXPECT_EQ(triangles(imported), 1u);
        EXPECT_EQ(noteLines(imported),
                  Lines{"left out: faces with a vertex that is not there (2 times, first in line 5)"});
    }
}

TEST(ObjFace, OneThatCannotBeReadIsLeftOut) {
    for (const char* face : {"f 1 2 x", "f 1 2 3.5", "f 1 2 /1", "f 1 2 /"}) {
        const auto imported = loadObj(squareVertices() + face + "\nf 1 2 3\n");
        EXPECT_EQ(triangles(imported), 1u);
        EXPECT_EQ(noteLines(imported),
                  Lines{"left out: faces with a corner that cannot be read (once, in line 5)"});
    }
}

TEST(ObjFace, OneOfFewerThanThreeCornersIsNotDrawn) {
    const auto imported = loadObj(squareVertices() + "f 1 2\nf\nf 1 2 3\n");
    EXPECT_EQ(triangles(imported), 1u);
    EXPECT_EQ(noteLines(imported),
              Lines{"not drawn: faces of fewer than 3 corners (2 times, first in line 5)"});
}

TEST(ObjFace, VerticesMayFollow) {
    const auto imported = loadObj("f 1//1 2//1 3//1\n" + squareVertices() + "vn 0 0 1\nf -4 -3 -1\n");
    EXPECT_EQ(triangles(imported), 2u);
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjFace, AbsentTextureCoordinatesAndNormalsLeaveTheGeometry) {
    for (const char* face :
         {"f 1/1/1 2/1/1 3/1/1", "f 1/-1/-1 2/-1/-1 3/-1/-1", "f 1/x/x 2/x/x 3/x/x", "f 1/0/0 2/0/0 3/0/0"}) {
        const auto imported = loadObj(squareVertices() + face + "\n");
        const candela::Mesh& mesh = onlyMesh(imported);
        EXPECT_TRUE(mesh.uv0.empty());
        EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(3, glm::vec3(0, 0, 1)));
        EXPECT_EQ(
            noteLines(imported),
            (Lines{"without texture coordinates: faces that have none for each corner (once, in line 5)",
                   "without their normals: faces that have none for each corner (once, in line 5)"}));
    }
}

TEST(ObjFace, CornersOfOneFaceMayDifferInForm) {
    const auto imported =
        loadObj(squareVertices() + "vt 0 0\nvn 1 0 0\nf 1/1/1 2//1 3/1\nf 1/1/1 2/1/1 3/1/1/7\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    EXPECT_EQ(triangles(imported), 2u);
    EXPECT_EQ(mesh.normals.at(0), glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals.at(3), glm::vec3(1, 0, 0));
    EXPECT_TRUE(hasNote(imported, "without texture coordinates: faces"));
    EXPECT_TRUE(hasNote(imported, "without their normals: faces"));
}

TEST(ObjFace, AVertexWithoutUsableCoordinatesTakesItsFacesWithIt) {
    for (const char* vertex : {"nan 0 0", "0 -inf 0", "0 0 1e400", "2e9 0 0", "1.#QNAN 0 0", "-nan(ind) 0 0",
                               "x 0 0", "0x10 0 0", "1,2,3 0 0", "", "7"}) {
        const auto imported =
            loadObj(std::string("v ") + vertex + "\n" + squareVertices() + "f 1 2 3\nf 2 3 4\n");
        EXPECT_EQ(triangles(imported), 1u) << vertex;
        EXPECT_EQ(noteLines(imported),
                  (Lines{"left out: faces with a vertex without usable coordinates (once, in line 6)",
                         "vertices without three numbers of at most 1e+09 (once, in line 1)"}));
    }
}

TEST(ObjFace, UnusableTextureCoordinatesAndNormalsAreNotUsed) {
    const auto imported =
        loadObj(squareVertices() +
                "vt nan 0\nvt 0 inf\nvt\nvn 0 nan 1\nvn 1 0\nf 1/1/1 2/1/1 3/1/1\nf 1/2/2 3/3/2 4/3/2\n");
    EXPECT_EQ(triangles(imported), 2u);
    EXPECT_TRUE(onlyMesh(imported).uv0.empty());
    for (const glm::vec3& normal : onlyMesh(imported).normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(imported.report.notes.size(), 2u);
}

TEST(ObjFace, DecimalCommasAreRead) {
    const auto imported = loadObj("v 0,5 0 0\nv 1 -2,25e1 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(onlyMesh(imported).positions[0], glm::vec3(0.5f, 0, 0));
    EXPECT_EQ(onlyMesh(imported).positions[1], glm::vec3(1, -22.5f, 0));
    EXPECT_EQ(noteLines(imported), Lines{"decimal commas, read as points (2 times, first in line 1)"});
}

TEST(ObjFace, VerticesOfTwoOrOfMoreNumbers) {
    const auto imported = loadObj("v 0 0\nv 1 0 0 9 9\nv 0 1 0 1 1 1 1 1\nf 1 2 3\n");
    EXPECT_EQ(onlyMesh(imported).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(onlyMesh(imported).colors.empty());
    EXPECT_TRUE(hasNote(imported, "vertices of two coordinates: z is taken as 0 (once, in line 1)"));
    EXPECT_TRUE(hasNote(imported, "only x y z is used (2 times, first in line 2)"));
}

TEST(ObjFace, ColorsFrom0To255) {
    const auto imported = loadObj("v 0 0 0 255 0 51\nv 1 0 0 128 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::vector<glm::vec4>& colors = onlyMesh(imported).colors;
    // The sRGB curve at 0.2, by hand; single precision.
    EXPECT_NEAR(glm::distance(colors.at(0), glm::vec4(1, 0, 0.03310477f, 1)), 0.0f, 1e-6f);
    EXPECT_EQ(colors.at(2), glm::vec4(1));
    EXPECT_EQ(noteLines(imported), Lines{"colours of vertices from 0 to 255: divided by 255"});
}

TEST(ObjFace, ColorsBeyondTheirRangeAreHeld) {
    const auto imported = loadObj("v 0 0 0 1.0001 -0.5 nan\nv 1 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
    EXPECT_EQ(onlyMesh(imported).colors.at(0), glm::vec4(1, 0, 1, 1));
    EXPECT_EQ(onlyMesh(imported).colors.at(1), glm::vec4(1));
    EXPECT_EQ(noteLines(imported), Lines{"colours of vertices beyond 0 to 1: held at the limit"});
}

TEST(ObjFace, SurveyCoordinatesKeepThePrecisionOfTheFile) {
    const auto imported = loadObj(
        "v 500000.125 4000000.0625 0\nv 500001.1251 4000000.0625 0\nv 500000.125 4000001.0625 -2\nf 1 2 3\n");
    const candela::Node& node = imported.scene.nodes.at(0);
    // Multiples of 1024, which leave the fractions to the positions.
    EXPECT_EQ(std::get<candela::Transform>(node.transform).translation, glm::vec3(499712, 3999744, 0));
    EXPECT_EQ(onlyMesh(imported).positions,
              (std::vector<glm::vec3>{
                  {288.125f, 256.0625f, 0}, {289.1251f, 256.0625f, 0}, {288.125f, 257.0625f, -2}}));
    const auto wide = loadObj("v -500000 0 0\nv 500000 0 0\nv 0 500000 0\nf 1 2 3\n");
    EXPECT_EQ(std::get<candela::Transform>(wide.scene.nodes.at(0).transform).translation, glm::vec3(0));
}

TEST(ObjFace, SmoothingGroupsThatAreNoneAreOff) {
    const auto imported = loadObj(squareVertices() + "s maybe\nf 1 2 3\ns -1\nf 1 3 4\ns\nf 2 3 4\n");
    EXPECT_EQ(triangles(imported), 3u);
    EXPECT_TRUE(hasNote(imported, "neither a number nor 'off': taken as off (2 times, first in line 5)"));
}

// Seen from +z the corners run clockwise, and the normal is that of the file.
TEST(ObjWinding, NormalsDecideTheFront) {
    const auto imported = loadObj(squareVertices() + "vn 0 0 1\nf 4//1 3//1 2//1 1//1\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        const glm::vec3 u = mesh.positions[mesh.indices[i + 1]] - a,
                        v = mesh.positions[mesh.indices[i + 2]] - a;
        EXPECT_GT(glm::cross(u, v).z, 0.0f);
    }
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjWinding, EachFaceIsTurnedForItself) {
    // The second face agrees with its normals, the third has none, and those of the fourth cancel each other
    // out.
    const auto imported = loadObj(squareVertices() +
                                  "vn 0 0 1\nvn 0 0 -1\nf 3//1 2//1 1//1\nf 1//1 2//1 3//1\n"
                                  "f 4 3 1\nf 3//1 2//1 1//2 4//2\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    const auto cornersOf = [&](std::size_t triangle) {
        std::vector<glm::vec3> corners;
        for (std::size_t i = 0; i < 3; ++i) corners.push_back(mesh.positions[mesh.indices[3 * triangle + i]]);
        return corners;
    };
    const auto facesUp = [&](std::size_t triangle) {
        const auto corners = cornersOf(triangle);
        return glm::cross(corners[1] - corners[0], corners[2] - corners[0]).z > 0.0f;
    };
    EXPECT_TRUE(facesUp(0));
    EXPECT_TRUE(facesUp(1));
    EXPECT_FALSE(facesUp(2));
    EXPECT_FALSE(facesUp(3));
}

TEST(ObjWinding, TextureCoordinatesTurnWithTheirCorners) {
    const auto imported =
        loadObj(squareVertices() + "vt 0 1\nvt 1 1\nvt 1 0\nvn 0 0 1\nf 3/3/1 2/2/1 1/1/1\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(mesh.uv0[i], glm::vec2(mesh.positions[i]));
}

TEST(ObjLines, EveryLineEnd) {
    const std::string lines = "v 0 0 0|v 1 0 0|v 0 1 0||f 1 2 3|l 1 2|f 9 1 2";
    for (const std::string end : {"\n", "\r\n", "\r", "\r\r\n"}) {
        std::string text;
        for (const char c : lines) text += c == '|' ? end : std::string(1, c);
        const auto imported = loadObj(text);
        EXPECT_EQ(triangles(imported), 1u);
        EXPECT_EQ(candela::elementCount(imported.scene, candela::Topology::lines), 1u);
        EXPECT_TRUE(hasNote(imported, "is not there (once, in line 7)")) << end.size();
    }
    EXPECT_EQ(triangles(loadObj("v 0 0 0\rv 1 0 0\r\nv 0 1 0\n\r\rf 1 2 3\r")), 1u);
}

TEST(ObjLines, ManyEmptyLinesTakeLinearTime) {
    // Quadratic time would take minutes.
    const std::string empty(2'000'000, '\r');
    EXPECT_EQ(triangles(loadObj(squareVertices() + empty + "f 1 2 3" + empty)), 1u);
}

TEST(ObjLines, KeywordsInOtherCases) {
    const auto imported =
        loadObj("V 0 0 0\nV 1 0 0\nV 0 1 0\nVN 0 0 1\nUseMtl m\nMTLLIB a.mtl\nF 1//1 2//1 3//1\n",
                {{"a.mtl", "NewMtl m\nKD 0.5 0.25 1\nmap_kd\n"}});
    EXPECT_EQ(triangles(imported), 1u);
    EXPECT_EQ(imported.scene.materials.at(0).baseColor, glm::vec4(0.5f, 0.25f, 1, 1));
}

std::string utf16(const std::string& text, bool bigEndian) {
    std::string bytes;
    for (const char c : text) bytes += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

TEST(ObjLines, Utf16IsNamed) {
    const std::string text = squareVertices() + "f 1 2 3\n", error = "UTF-16 text, but an OBJ file is UTF-8";
    EXPECT_EQ(errorOfObj("\xFF\xFE" + utf16(text, false)), error);
    EXPECT_EQ(errorOfObj("\xFE\xFF" + utf16(text, true)), error);
    EXPECT_EQ(errorOfObj(utf16(text, false)), error);
    EXPECT_EQ(errorOfObj(utf16(text, true)), error);
    const auto imported =
        loadObj("mtllib a.mtl\nusemtl m\n" + text, {{"a.mtl", "\xFF\xFE" + utf16("newmtl m\n", false)}});
    EXPECT_EQ(noteLines(imported), Lines{"material file 'a.mtl': UTF-16 text, expected UTF-8: left out"});
}

TEST(ObjLines, AByteOrderMarkOfUtf8IsAccepted) {
    const auto imported = loadObj("\xEF\xBB\xBFmtllib a.mtl\n" + squareVertices() + "usemtl m\nf 1 2 3\n",
                                  {{"a.mtl", "\xEF\xBB\xBFnewmtl m\nPm 1\n"}});
    EXPECT_EQ(imported.scene.materials.at(0).metallic, 1.0f);
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjCageFaces, RepeatedVerticesAreLeftOut) {
    const auto imported = loadObj(squareVertices() + "f 1 2 2 3 4 1\nf 1 2 3 2\nf 1 1 2\n", {}, "?subdivide");
    ASSERT_EQ(imported.scene.cages.size(), 1u);
    EXPECT_EQ(imported.scene.cages[0].faceSizes, Indices{4});
    EXPECT_TRUE(hasNote(imported, "left out: faces that pass through a vertex twice (once, in line 6)"));
    EXPECT_TRUE(hasNote(imported, "not drawn: faces of fewer than 3 corners (once, in line 7)"));
}

TEST(ObjCageFaces, HolesCountTheFacesThatAreLeftOut) {
    const auto imported = loadObj("f 1 2 99\n" + cube() + "t hole 2/0/0 0 2\n");
    ASSERT_EQ(imported.scene.cages.size(), 1u);
    EXPECT_EQ(imported.scene.cages[0].holes, Indices{1});
}

TEST(ObjCageFaces, AnObjectThatLosesAllFacesIsNoCage) {
    const auto imported = loadObj("o gone\nf 1 2 99\no box\n" + cube(), {}, "?subdivide");
    ASSERT_EQ(imported.scene.cages.size(), 1u);
    EXPECT_EQ(imported.scene.cages[0].name, "box");
}

}  // namespace
}  // namespace candela_test
