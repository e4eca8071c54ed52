#include <gtest/gtest.h>

#include "obj_scene.h"

namespace candela_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

candela::Cage cageOf(const std::string& text, const std::string& query = "") {
    const candela::ImportedScene imported = loadObj(text, {}, query);
    EXPECT_TRUE(imported.scene.meshes.empty());
    EXPECT_EQ(imported.scene.cages.size(), 1u);
    return imported.scene.cages.at(0);
}

/// A cube with one tag.
candela::Cage tagged(const std::string& tag) {
    return cageOf(cube() + "t " + tag + "\n");
}

TEST(ObjCage, withoutTagsAFileIsAMesh) {
    const candela::Scene scene = loadObj(cube()).scene;
    EXPECT_TRUE(scene.cages.empty());
    EXPECT_EQ(candela::triangleCount(scene), 12u);
}

TEST(ObjCage, theQuerySelectsACage) {
    const candela::Cage cage = cageOf(cube(), "?subdivide");
    EXPECT_EQ(cage.scheme, candela::SubdivisionScheme::catmullClark);
    EXPECT_EQ(cage.positions.size(), 8u);
    EXPECT_EQ(cage.positions[0], glm::vec3(-1, 1, -1));
    EXPECT_EQ(cage.positions[6], glm::vec3(1, 1, 1));
    EXPECT_EQ(cage.faceSizes, Numbers(6, 4));
    EXPECT_EQ(cage.faceVertices.size(), 24u);
    EXPECT_TRUE(cage.uvs.empty());
    EXPECT_FALSE(cage.level.has_value());
    EXPECT_TRUE(cage.creases.empty());
}

TEST(ObjCage, schemeAndLevelFromTheQuery) {
    const std::string triangles = squareVertices() + "f 1 2 3\nf 1 3 4\n";
    EXPECT_EQ(cageOf(triangles, "?subdivide=loop").scheme, candela::SubdivisionScheme::loop);
    EXPECT_EQ(cageOf(triangles, "?subdivide=bilinear&level=2").scheme, candela::SubdivisionScheme::bilinear);
    EXPECT_EQ(cageOf(triangles, "?subdivide=bilinear&level=2").level, 2u);
    EXPECT_EQ(cageOf(triangles, "?level=8").level, 8u);
    EXPECT_EQ(cageOf(triangles, "?subdivide=catmullClark").scheme, candela::SubdivisionScheme::catmullClark);
}

TEST(ObjCage, defaultRules) {
    const candela::Cage cage = cageOf(cube(), "?subdivide");
    EXPECT_EQ(cage.boundaryInterpolation, candela::BoundaryInterpolation::edges);
    EXPECT_EQ(cage.faceVaryingInterpolation, candela::FaceVaryingInterpolation::all);
    EXPECT_EQ(cage.creaseMethod, candela::CreaseMethod::uniform);
    EXPECT_EQ(cage.triangleSubdivision, candela::TriangleSubdivision::catmullClark);
}

TEST(ObjCage, aNodeInstancesTheCage) {
    const candela::Scene scene = loadObj("o thing\n" + cube() + "t hole 1/0/0 0\n").scene;
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(scene.nodes[0].name, "thing");
    EXPECT_EQ(scene.cages.at(0).name, "thing");
    ASSERT_TRUE(scene.nodes[0].cage.has_value());
    EXPECT_EQ(scene.nodes[0].cage, 0u);
    EXPECT_FALSE(scene.nodes[0].mesh.has_value());
}

TEST(ObjCage, aCrease) {
    const candela::Cage cage = tagged("crease 2/1/0 0 1 2.5");
    ASSERT_EQ(cage.creases.size(), 1u);
    // The first face of the cube is 4 3 2 1: its vertices come first.
    EXPECT_EQ(cage.positions[cage.creases[0].vertex0] + cage.positions[cage.creases[0].vertex1],
              glm::vec3(0, -2, -2));
    EXPECT_EQ(cage.creases[0].sharpness, 2.5f);
}

/// The sharpness of the edge between two vertices of the cube, counted from 0; -1 where it is no crease.
float sharpnessOf(const candela::Cage& cage, std::uint32_t a, std::uint32_t b) {
    // Vertices are numbered in the order in which the faces use them.
    constexpr std::uint32_t indexOf[] = {3, 2, 1, 0, 4, 5, 6, 7};
    for (const candela::Crease& crease : cage.creases) {
        const bool forward = crease.vertex0 == indexOf[a] && crease.vertex1 == indexOf[b];
        const bool backward = crease.vertex0 == indexOf[b] && crease.vertex1 == indexOf[a];
        if (forward || backward) return crease.sharpness;
    }
    return -1.0f;
}

TEST(ObjCage, severalCreasesInOneTag) {
    const candela::Cage one = tagged("crease 6/1/0 0 1 1 2 6 7 3");
    EXPECT_EQ(one.creases.size(), 3u);
    EXPECT_EQ(sharpnessOf(one, 0, 1), 3.0f);
    EXPECT_EQ(sharpnessOf(one, 2, 1), 3.0f);
    EXPECT_EQ(sharpnessOf(one, 6, 7), 3.0f);
    const candela::Cage each = tagged("crease 4/2/0 0 1 1 2 3 4");
    EXPECT_EQ(sharpnessOf(each, 0, 1), 3.0f);
    EXPECT_EQ(sharpnessOf(each, 1, 2), 4.0f);
    // OpenSubdiv's reader indexes the sharpnesses by the position of a pair's first vertex.
    const candela::Cage twice = tagged("crease 4/4/0 0 1 1 2 3 30 4 40");
    EXPECT_EQ(sharpnessOf(twice, 0, 1), 3.0f);
    EXPECT_EQ(sharpnessOf(twice, 1, 2), 4.0f);
}

TEST(ObjCage, theLastCreaseOfAnEdgeIsUsed) {
    const candela::Cage cage = cageOf(cube() + "t crease 2/1/0 0 1 1\nt crease 2/1/0 1 0 2\n");
    ASSERT_EQ(cage.creases.size(), 1u);
    EXPECT_EQ(cage.creases[0].sharpness, 2.0f);
}

TEST(ObjCage, corners) {
    const candela::Cage cage =
        cageOf(cube() + "t corner 1/1/0 6 1.5\nt corner 2/1/0 4 5 9\nt corner 2/2/0 0 1 3 4\n");
    std::vector<float> sharpness(8, -1.0f);
    for (const candela::Corner& corner : cage.corners) sharpness[corner.vertex] = corner.sharpness;
    EXPECT_EQ(sharpness, (std::vector<float>{-1, -1, 4, 3, 9, 9, 1.5f, -1}));
}

TEST(ObjCage, holes) {
    EXPECT_EQ(tagged("hole 2/0/0 4 1").holes, (Numbers{1, 4}));
}

TEST(ObjCage, boundaryRules) {
    using enum candela::BoundaryInterpolation;
    EXPECT_EQ(tagged("interpolateboundary 1/0/0 0").boundaryInterpolation, none);
    EXPECT_EQ(tagged("interpolateboundary 1/0/0 1").boundaryInterpolation, edgesAndCorners);
    EXPECT_EQ(tagged("interpolateboundary 1/0/0 2").boundaryInterpolation, edges);
}

TEST(ObjCage, faceVaryingRules) {
    using enum candela::FaceVaryingInterpolation;
    constexpr candela::FaceVaryingInterpolation rules[] = {none,         cornersOnly, cornersPlus1,
                                                           cornersPlus2, boundaries,  all};
    for (int i = 0; i < 6; ++i) {
        const std::string tag = "facevaryinginterpolateboundary 1/0/0 " + std::to_string(i);
        EXPECT_EQ(tagged(tag).faceVaryingInterpolation, rules[i]) << tag;
    }
}

TEST(ObjCage, propagatedCorners) {
    const std::string plus1 = cube() + "t facevaryinginterpolateboundary 1/0/0 2\n",
                      propagate = "t facevaryingpropagatecorners 1/0/0 1\n";
    using enum candela::FaceVaryingInterpolation;
    EXPECT_EQ(cageOf(plus1 + propagate).faceVaryingInterpolation, cornersPlus2);
    EXPECT_EQ(cageOf(propagate + plus1).faceVaryingInterpolation, cornersPlus2);
    EXPECT_EQ(cageOf(plus1 + "t facevaryingpropagatecorners 1/0/0 0\n").faceVaryingInterpolation,
              cornersPlus1);
    const auto alone = loadObj(cube() + propagate);
    EXPECT_EQ(alone.scene.cages.at(0).faceVaryingInterpolation, all);
    EXPECT_TRUE(hasNote(alone, "line 15: the tag 'facevaryingpropagatecorners' changes nothing"));
}

TEST(ObjCage, creaseMethodAndTriangleRule) {
    EXPECT_EQ(tagged("creasemethod 0/0/1 chaikin").creaseMethod, candela::CreaseMethod::chaikin);
    EXPECT_EQ(tagged("creasemethod 0/0/1 normal").creaseMethod, candela::CreaseMethod::uniform);
    using enum candela::TriangleSubdivision;
    EXPECT_EQ(tagged("smoothtriangles 0/0/1 smooth").triangleSubdivision, smooth);
    EXPECT_EQ(tagged("smoothtriangles 0/0/1 catmark").triangleSubdivision, catmullClark);
    EXPECT_EQ(tagged("smoothtriangles 1/0/0 2").triangleSubdivision, smooth);
    EXPECT_EQ(tagged("smoothtriangles 1/0/0 1").triangleSubdivision, catmullClark);
}

TEST(ObjCage, unknownTagsAndSurplusValuesAreNoted) {
    const auto imported = loadObj(cube() + "t vertexedit 1/3/3 0 1 2 3 add P value\nt hole 1/0/0 1 2 3\n");
    EXPECT_TRUE(hasNote(imported, "line 15: the tag 'vertexedit' is not used"));
    EXPECT_TRUE(hasNote(imported, "line 16: 2 surplus words of the tag 'hole' are not used"));
    EXPECT_EQ(imported.scene.cages.at(0).holes, Numbers{1});
}

TEST(ObjCage, textureCoordinatesHaveTheirOwnTopology) {
    // Two squares side by side, whose common edge is a seam in one of its two vertices.
    const candela::Cage cage = cageOf(
        "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
        "vt 9 9\nvt 0 0\nvt .5 0\nvt .5 1\nvt 0 1\nvt .75 0\nvt 1 0\nvt 1 1\n"
        "f 1/2 2/3 5/4 4/5\nf 2/6 3/7 6/8 5/4\n",
        "?subdivide");
    EXPECT_EQ(cage.faceVertices, (Numbers{0, 1, 2, 3, 1, 4, 5, 2}));
    EXPECT_EQ(cage.faceUvs, (Numbers{0, 1, 2, 3, 4, 5, 6, 2}));
    EXPECT_EQ(cage.uvs,
              (std::vector<glm::vec2>{{0, 1}, {.5f, 1}, {.5f, 0}, {0, 0}, {.75f, 1}, {1, 1}, {1, 0}}));
}

TEST(ObjCage, missingTextureCoordinatesAreZero) {
    const auto imported = loadObj(squareVertices() + "vt 1 1\nf 1/1 2/1 3/1\nf 1 3 4\n", {}, "?subdivide");
    const candela::Cage& cage = imported.scene.cages.at(0);
    EXPECT_EQ(cage.uvs, (std::vector<glm::vec2>{{1, 0}, {0, 0}}));
    EXPECT_EQ(cage.faceUvs, (Numbers{0, 0, 0, 1, 1, 1}));
    // No material reads them.
    EXPECT_TRUE(imported.report.notes.empty());
}

TEST(ObjCage, facesKeepTheirMaterials) {
    const auto imported = loadObj(squareVertices() + "mtllib a.mtl\nf 1 2 3\nusemtl b\nf 1 3 4\n",
                                  {{"a.mtl", "newmtl b\n"}}, "?subdivide");
    const candela::Cage& cage = imported.scene.cages.at(0);
    ASSERT_EQ(cage.faceMaterials.size(), 2u);
    EXPECT_EQ(cage.faceMaterials[0], 1u);
    EXPECT_EQ(cage.faceMaterials[1], 0u);
    EXPECT_EQ(imported.scene.materials.at(1).name, "default");
}

TEST(ObjCage, eachObjectIsASeparateCage) {
    const std::string second = "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\n";
    const auto imported =
        loadObj(squareVertices() + second +
                "o a\ng x\nf 1 2 3\ng y\nf 1 3 4\no b\nf 5 6 7 8\n"
                "t crease 2/1/0 6 7 2\nt crease 2/1/0 0 2 3\nt corner 1/1/0 7 4\nt hole 1/0/0 2\n");
    ASSERT_EQ(imported.scene.cages.size(), 2u);
    const candela::Cage &a = imported.scene.cages[0], &b = imported.scene.cages[1];
    EXPECT_EQ(a.name, "a");
    EXPECT_EQ(a.faceSizes, (Numbers{3, 3}));
    EXPECT_EQ(a.positions.size(), 4u);
    ASSERT_EQ(a.creases.size(), 1u);
    EXPECT_EQ(a.creases[0].sharpness, 3.0f);
    EXPECT_TRUE(a.corners.empty());
    EXPECT_TRUE(a.holes.empty());
    EXPECT_EQ(b.positions[0], glm::vec3(5, 0, 0));
    ASSERT_EQ(b.creases.size(), 1u);
    EXPECT_EQ(b.creases[0].vertex0 + b.creases[0].vertex1, 5u);
    ASSERT_EQ(b.corners.size(), 1u);
    EXPECT_EQ(b.corners[0].vertex, 3u);
    EXPECT_EQ(b.holes, Numbers{0});
}

TEST(ObjCage, unusedVerticesAreOmitted) {
    const candela::Cage cage = cageOf("v 9 9 9\n" + squareVertices() + "f 2 3 4 5\nt crease 2/1/0 1 2 1\n");
    EXPECT_EQ(cage.positions.size(), 4u);
    EXPECT_EQ(cage.faceVertices, (Numbers{0, 1, 2, 3}));
    ASSERT_EQ(cage.creases.size(), 1u);
    EXPECT_EQ(cage.creases[0].vertex0 + cage.creases[0].vertex1, 1u);
}

TEST(ObjCage, missingNormalsAreIgnored) {
    // Some of OpenSubdiv's shapes reference normals that the file lacks; a cage does not use normals.
    EXPECT_EQ(
        cageOf(squareVertices() + "vt 0 0\nf 1/1/1 2/1/2 3/1/3\nt interpolateboundary 1/0/0 2\n").faceSizes,
        Numbers{3});
}

TEST(ObjCage, TagsThatCannotBeUsedAreLeftOut) {
    const std::vector<std::pair<const char*, const char*>> cases{
        {"t hole 1/0 1", "line 15: t hole: counts such as 2/1/0 were expected"},
        {"t hole 1/x/0 1", "line 15: t: 'x' is not a whole number"},
        {"t hole -1/0/0 1", "line 15: t hole: counts such as 2/1/0 were expected"},
        {"t hole 999999999999999/0/0 1", "line 15: t hole: counts such as 2/1/0 were expected"},
        {"t hole 2/0/0 1", "line 15: t hole: 2 words were expected, but 1 follows"},
        {"t hole 1/0/0 1.5", "line 15: t: '1.5' is not a whole number"},
        {"t hole 1/0/0 6", "line 15: t hole: face 6, but 0 to 5 was expected"},
        {"t hole 1/0/0 -1", "line 15: t hole: face -1, but 0 to 5 was expected"},
        {"t hole 0/0/0", "line 15: t hole: no face is named"},
        {"t crease 2/1/0 0 1 nan", "line 15: t: 'nan', but a number of at most 3e+38 was expected"},
        {"t crease 2/1/0 0 1 -1", "line 15: t crease: sharpness -1.000000, but 0 or more was expected"},
        {"t crease 2/1/0 0 8 1", "line 15: t crease: vertex 8, but 0 to 7 was expected"},
        {"t crease 3/1/0 0 1 2 1", "line 15: t crease: 3 vertices, but pairs were expected"},
        {"t crease 4/3/0 0 1 1 2 1 2 3",
         "line 15: t crease: 3 numbers, but one sharpness or one a pair of vertices was expected"},
        {"t crease 2/0/0 0 1",
         "line 15: t crease: 0 numbers, but one sharpness or one a pair of vertices was expected"},
        {"t corner 0/1/0 1", "line 15: t corner: no vertex is named"},
        {"t corner 1/1/0 8 1", "line 15: t corner: vertex 8, but 0 to 7 was expected"},
        {"t corner 1/1/0 1 -2", "line 15: t corner: sharpness -2.000000, but 0 or more was expected"},
        {"t corner 1/2/0 1 2 3",
         "line 15: t corner: 2 numbers, but one sharpness or one a vertex was expected"},
        {"t interpolateboundary 1/0/0 3", "line 15: t interpolateboundary: 3, but 0 to 2 was expected"},
        {"t interpolateboundary 0/0/0", "line 15: t interpolateboundary: one whole number was expected"},
        {"t facevaryinginterpolateboundary 1/0/0 6",
         "line 15: t facevaryinginterpolateboundary: 6, but 0 to 5 was expected"},
        {"t facevaryingpropagatecorners 2/0/0 1 1",
         "line 15: t facevaryingpropagatecorners: one whole number was expected"},
        {"t creasemethod 0/0/1 round",
         "line 15: t creasemethod: 'round', but 'normal' or 'chaikin' was expected"},
        {"t creasemethod 0/0/0", "line 15: t creasemethod: 'normal' or 'chaikin' was expected"},
        {"t smoothtriangles 1/0/0 3",
         "line 15: t smoothtriangles: '3', but 'catmark', 'smooth', 1 or 2 was expected"}};
    for (const auto& [tag, note] : cases) {
        // Another tag makes it a cage.
        const auto imported = loadObj(cube() + tag + "\nt corner 1/1/0 0 3\n");
        ASSERT_EQ(imported.scene.cages.size(), 1u) << tag;
        EXPECT_EQ(imported.scene.cages[0].corners.size(), 1u) << tag;
        EXPECT_TRUE(imported.scene.cages[0].creases.empty() && imported.scene.cages[0].holes.empty()) << tag;
        EXPECT_EQ(noteLines(imported), Lines{std::string(note) + ": left out"});
    }
}

TEST(ObjCage, ACreaseThatIsNoEdgeIsNotUsed) {
    const auto imported = loadObj(cube() + "t crease 4/1/0 0 6 0 1 2\nt crease 2/1/0 1 7 1\n");
    EXPECT_EQ(imported.scene.cages.at(0).creases.size(), 1u);
    EXPECT_EQ(noteLines(imported),
              Lines{"line 15, t crease, edge 0 6 and 1 more: an edge of no face: not used"});
}

TEST(ObjCage, WhatOnlyLooksLikeATagMakesNoCage) {
    const auto imported = loadObj(squareVertices() + "t 0.5 0.5\nf 1 2 3\n");
    EXPECT_EQ(imported.scene.meshes.size(), 1u);
    EXPECT_EQ(imported.report.notes.size(), 1u);
}

}  // namespace
}  // namespace candela_test
