#include <gtest/gtest.h>

#include <clocale>
#include <cmath>

#include "obj_scene.h"

namespace candela_test {
namespace {

using Indices = std::vector<std::uint32_t>;

const candela::Mesh& onlyMesh(const candela::ImportedScene& imported) {
    EXPECT_EQ(imported.scene.meshes.size(), 1u);
    return imported.scene.meshes.at(0);
}

float area(const candela::Mesh& mesh) {
    float sum = 0.0f;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                        c = mesh.positions[mesh.indices[i + 2]];
        sum += 0.5f * glm::cross(b - a, c - a).z;
    }
    return sum;
}

glm::vec3 normalAt(const candela::Mesh& mesh, glm::vec3 position) {
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i] == position) return mesh.normals[i];
    ADD_FAILURE() << "no vertex at this position";
    return {};
}

TEST(ObjGeometry, aQuadBecomesTwoTriangles) {
    const auto imported = loadObj(squareVertices() + "f 1 2 3 4\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    EXPECT_EQ(mesh.indices.size(), 6u);
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
    EXPECT_TRUE(mesh.uv0.empty());
    EXPECT_TRUE(mesh.colors.empty());
    ASSERT_EQ(imported.scene.nodes.size(), 1u);
    EXPECT_EQ(imported.scene.nodes[0].mesh, 0u);
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjGeometry, aConcavePolygonKeepsItsArea) {
    // An arrow: the square without the triangle between its upper corners and its centre.
    const auto imported = loadObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv .5 .5 0\nv 0 1 0\nf 1 2 3 4 5\n");
    EXPECT_EQ(onlyMesh(imported).indices.size(), 9u);
    // Quarters are exact in binary.
    EXPECT_EQ(area(onlyMesh(imported)), 0.75f);
}

TEST(ObjGeometry, negativeIndicesCountFromTheEnd) {
    const auto forward = loadObj(squareVertices() + "vt 0 0\nvt 1 1\nf 1/1 2/2 3/1\n");
    const auto backward = loadObj(squareVertices() + "vt 0 0\nvt 1 1\nf -4/-2 -3/-1 -2/-2\n");
    EXPECT_EQ(onlyMesh(forward).positions, onlyMesh(backward).positions);
    EXPECT_EQ(onlyMesh(forward).uv0, onlyMesh(backward).uv0);
    EXPECT_EQ(onlyMesh(forward).indices, onlyMesh(backward).indices);
}

TEST(ObjGeometry, negativeIndicesReferToTheElementsReadSoFar) {
    const auto imported =
        loadObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf -3 -2 -1\n");
    EXPECT_EQ(onlyMesh(imported).positions.size(), 6u);
    EXPECT_EQ(onlyMesh(imported).positions[3], glm::vec3(0, 0, 5));
}

TEST(ObjGeometry, textureCoordinatesAreFlippedVertically) {
    const auto imported = loadObj(squareVertices() + "vt 0.25 1\nvt 0.5 0 0\nvt 1\nf 1/1 2/2 3/3\n");
    EXPECT_EQ(onlyMesh(imported).uv0, (std::vector<glm::vec2>{{0.25f, 0}, {0.5f, 1}, {1, 1}}));
}

TEST(ObjGeometry, everyCornerFormat) {
    const std::string head = squareVertices() + "vt 0 1\nvn 0 0 1\n";
    for (const char* face : {"f 1 2 3", "f 1/1 2/1 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/1/1 3/1/1"})
        EXPECT_EQ(onlyMesh(loadObj(head + face)).indices, (Indices{0, 1, 2})) << face;
    EXPECT_EQ(onlyMesh(loadObj(head + "f 1/1/1 2/1/1 3/1/1")).uv0, std::vector<glm::vec2>(3, glm::vec2(0)));
}

TEST(ObjGeometry, cornersWithEqualAttributesShareAVertex) {
    const std::string head = squareVertices() + "vt 0 0\nvt 1 0\n";
    const auto vertices = [&](const std::string& faces) {
        return onlyMesh(loadObj(head + faces)).positions.size();
    };
    EXPECT_EQ(vertices("s 1\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\n"), 4u);
    EXPECT_EQ(vertices("s 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2\n"), 6u);
    EXPECT_EQ(vertices("vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n"), 4u);
    EXPECT_EQ(vertices("f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n"), 6u);
}

TEST(ObjGeometry, unusedVerticesAreOmitted) {
    const auto imported = loadObj("v 9 9 9\n" + squareVertices() + "v 8 8 8\nf 2 3 4\n");
    EXPECT_EQ(onlyMesh(imported).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
}

TEST(ObjGeometry, normalsOfTheFileAreKept) {
    const auto imported = loadObj(squareVertices() + "vn 0 0 2\nvn 1 0 0\ns 1\nf 1//1 2//2 3//1\n");
    EXPECT_EQ(onlyMesh(imported).normals, (std::vector<glm::vec3>{{0, 0, 1}, {1, 0, 0}, {0, 0, 1}}));
}

// Two squares that meet at a right angle along the y axis.
const std::string corner = "v -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nv 0 0 -1\nv 0 1 -1\n";

TEST(ObjGeometry, smoothingGroupsShareNormals) {
    const auto imported = loadObj(corner + "s 1\nf 1 2 3 4\nf 2 5 6 3\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    EXPECT_EQ(mesh.positions.size(), 6u);
    const float half = std::sqrt(0.5f);
    // Rounding of a square root and of the host's normalisation.
    EXPECT_NEAR(glm::distance(normalAt(mesh, {0, 0, 0}), glm::vec3(half, 0, half)), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::distance(normalAt(mesh, {-1, 0, 0}), glm::vec3(0, 0, 1)), 0.0f, 1e-6f);
}

TEST(ObjGeometry, smoothNormalsAreWeightedByTheAngle) {
    // The right-hand face is cut into two triangles, one of which has 45 degrees at the corner (0, 0, 0) and
    // the other one too: the weighted mean is that of two squares.
    const auto imported = loadObj(corner + "s 1\nf 1 2 3 4\nf 2 5 6\nf 2 6 3\n");
    const float half = std::sqrt(0.5f);
    EXPECT_NEAR(glm::distance(normalAt(onlyMesh(imported), {0, 0, 0}), glm::vec3(half, 0, half)), 0.0f,
                1e-6f);
}

TEST(ObjGeometry, differentSmoothingGroupsMakeAHardEdge) {
    const auto imported = loadObj(corner + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    EXPECT_EQ(mesh.positions.size(), 8u);
    for (std::size_t i = 0; i < mesh.normals.size(); ++i)
        EXPECT_EQ(mesh.normals[i], i < 4 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0)) << i;
}

TEST(ObjGeometry, facesAreFlatWithoutSmoothing) {
    for (const char* smoothing : {"", "s off\n", "s 0\n", "s 1\ns off\n"}) {
        const candela::ImportedScene imported = loadObj(corner + smoothing + "f 1 2 3 4\nf 2 5 6 3\n");
        const candela::Mesh& mesh = onlyMesh(imported);
        for (std::size_t i = 0; i < mesh.indices.size(); ++i)
            EXPECT_EQ(mesh.normals[mesh.indices[i]], i < 6 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
    }
}

TEST(ObjGeometry, aNonPlanarFlatFaceHasOneNormal) {
    const auto imported = loadObj("v 0 0 0\nv 1 0 1\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n");
    EXPECT_EQ(onlyMesh(imported).normals, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
}

TEST(ObjGeometry, flatFacesBesideSmoothOnes) {
    const auto imported = loadObj(corner + "s 3\nf 1 2 3 4\ns off\nf 2 5 6 3\n");
    const candela::Mesh& mesh = onlyMesh(imported);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        EXPECT_EQ(mesh.normals[mesh.indices[i]], i < 6 ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0));
}

TEST(ObjGeometry, vertexColorsAreDecodedFromSrgb) {
    const auto imported = loadObj("v 0 0 0 1 0 0\nv 1 0 0 0 0.5 0 1\nv 0 1 0\nf 1 2 3\n");
    const std::vector<glm::vec4>& colors = onlyMesh(imported).colors;
    ASSERT_EQ(colors.size(), 3u);
    EXPECT_EQ(colors[0], glm::vec4(1, 0, 0, 1));
    // The sRGB curve at one half, by hand; single precision.
    EXPECT_NEAR(colors[1].g, 0.21404114f, 1e-6f);
    EXPECT_EQ(colors[2], glm::vec4(1, 1, 1, 1));
}

TEST(ObjGeometry, aFourthCoordinateIsNotAColor) {
    EXPECT_TRUE(onlyMesh(loadObj("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n")).colors.empty());
}

TEST(ObjGeometry, objectsAndGroupsBecomeMeshesAndNodes) {
    const auto imported = loadObj(squareVertices() +
                                  "f 1 2 3\no box\nf 1 2 4\ng lid top\nf 2 3 4\no ball # 2\ng\nf 1 3 4\n"
                                  "o box\ng lid top\nf 1 2 3\n");
    std::vector<std::string> names;
    for (const candela::Node& node : imported.scene.nodes) names.push_back(node.name);
    EXPECT_EQ(names, (std::vector<std::string>{"", "box", "box/lid top", "ball # 2"}));
    ASSERT_EQ(imported.scene.meshes.size(), 4u);
    EXPECT_EQ(imported.scene.meshes[2].name, "box/lid top");
    EXPECT_EQ(imported.scene.meshes[2].indices.size(), 6u);
    EXPECT_EQ(candela::triangleCount(imported.scene), 5u);
}

TEST(ObjGeometry, smoothNormalsCrossGroups) {
    const auto imported = loadObj(corner + "s 1\ng a\nf 1 2 3 4\ng b\nf 2 5 6 3\n");
    ASSERT_EQ(imported.scene.meshes.size(), 2u);
    EXPECT_EQ(normalAt(imported.scene.meshes[0], {0, 0, 0}), normalAt(imported.scene.meshes[1], {0, 0, 0}));
}

TEST(ObjGeometry, commentsContinuationsAndLineEnds) {
    const auto imported = loadObj(
        "\xEF\xBB\xBF# from C:\\\r\nv 0 0 0 # origin\r\n\tv 1 \\\r\n 0\\\n 0\r\n"
        "v 0 1 0\r\n   \r\nf 1 2 \\\n3 # end");
    EXPECT_EQ(onlyMesh(imported).positions, (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjGeometry, everyNumberFormat) {
    const auto imported = loadObj("v +1. -.5 1e1\nv 1E-400 2.5e+0 0\nv 0 1 0\nf +1 2 3\n");
    EXPECT_EQ(onlyMesh(imported).positions[0], glm::vec3(1.0f, -0.5f, 10.0f));
    EXPECT_EQ(onlyMesh(imported).positions[1], glm::vec3(0.0f, 2.5f, 0.0f));
}

TEST(ObjGeometry, numbersDoNotDependOnTheLocale) {
    const std::string previous = std::setlocale(LC_NUMERIC, nullptr);
    if (!std::setlocale(LC_NUMERIC, "de_DE.UTF-8")) GTEST_SKIP() << "this machine has no German locale";
    const auto imported = loadObj("v 0.5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    std::setlocale(LC_NUMERIC, previous.c_str());
    EXPECT_EQ(onlyMesh(imported).positions[0].x, 0.5f);
}

TEST(ObjGeometry, unsupportedStatementsAreCountedInOneNoteEach) {
    const auto imported = loadObj(squareVertices() +
                                  "f 1 2 3\nvp 0.1\ncstype bezier\ndeg 3\n"
                                  "curv 0 1 1 2 3 4\nparm u 0 1\nend\nlod 2\nwhatever 1 2\n");
    EXPECT_TRUE(hasNote(imported, "not drawn: curves (curv) (once, in line 9)"));
    EXPECT_TRUE(hasNote(imported, "not known: whatever (once, in line 13)"));
    EXPECT_EQ(imported.report.notes.size(), 2u);
}

TEST(ObjGeometry, linesAndPoints) {
    const auto imported =
        loadObj(squareVertices() + "vt 0.5 0.25\no wire\nl 1/1 2 -1\np 3 9\np 4\nf 1 2 3\nl 9 1\n");
    ASSERT_EQ(imported.scene.meshes.size(), 2u);
    const candela::Mesh& mesh = imported.scene.meshes[0];
    EXPECT_EQ(mesh.name, "wire");
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 1, 2, 3, 2}));
    ASSERT_EQ(mesh.submeshes.size(), 2u);
    EXPECT_EQ(mesh.submeshes[0].topology, candela::Topology::lines);
    EXPECT_EQ(mesh.submeshes[0].indexCount, 4u);
    EXPECT_EQ(mesh.submeshes[1].topology, candela::Topology::points);
    EXPECT_EQ(mesh.submeshes[1].indexCount, 2u);
    EXPECT_EQ(mesh.normals, std::vector<glm::vec3>(mesh.positions.size(), glm::vec3(0.0f)));
    EXPECT_EQ(imported.scene.nodes.size(), 2u);
    EXPECT_TRUE(hasNote(imported, "left out of lines (l): vertices that are not there (once, in line 11)"));
    EXPECT_TRUE(hasNote(imported, "left out of points (p): vertices that are not there (once, in line 8)"));
}

TEST(ObjGeometry, linesFarFromTheOriginKeepTheirDigits) {
    const auto imported = loadObj("v 500000.25 0 0\nv 500001.25 0 0\nl 1 2\n");
    EXPECT_EQ(imported.scene.meshes.at(0).positions[1].x - imported.scene.meshes[0].positions[0].x, 1.0f);
}

TEST(ObjGeometry, cagesLeaveOutLines) {
    EXPECT_TRUE(
        hasNote(loadObj(cube() + "l 1 2\n", {}, "?subdivide"), "not drawn: lines (l) (once, in line 15)"));
}

TEST(ObjGeometry, aLargeFileIsReadInLinearTime) {
    // A fan whose first vertex has 100,000 texture coordinates: a linear search through them for each corner
    // would take minutes.
    constexpr int count = 100'000;
    std::string text = "v 0 0 0\n";
    for (int i = 0; i < count; ++i)
        text += "v 1 " + std::to_string(i) + " 0\nvt 0 " + std::to_string(i) + "\n";
    for (int i = 2; i <= count; ++i) {
        const std::string now = std::to_string(i), next = std::to_string(i + 1);
        text += "f 1/" + now + " " + now + "/" + now + " " + next + "/" + now + "\n";
    }
    EXPECT_EQ(candela::triangleCount(loadObj(text).scene), count - 1u);
}

}  // namespace
}  // namespace candela_test
