#include <gtest/gtest.h>

#include "obj_scene.h"

namespace candela_test {
namespace {

struct Case {
    const char *text, *error;
};

void expectErrors(const std::string& head, const std::vector<Case>& cases, const std::string& tail = "") {
    for (const Case& test : cases)
        EXPECT_EQ(errorOfObj(head + test.text + "\n" + tail), test.error) << test.text;
}

TEST(ObjError, vertices) {
    expectErrors("# nothing\n",
                 {{"v 1 2", "line 2: v: 2 numbers, but x y z, x y z w or x y z r g b was expected"},
                  {"v 1 2 3 4 5", "line 2: v: 5 numbers, but x y z, x y z w or x y z r g b was expected"},
                  {"v 1 2 x", "line 2: v: 'x' is not a number"},
                  {"v 1 2 3x", "line 2: v: '3x' is not a number"},
                  {"v 1 2 0x10", "line 2: v: '0x10' is not a number"},
                  {"v 1,5 2 3", "line 2: v: '1,5' is not a number"},
                  {"v nan 2 3", "line 2: v: 'nan', but a number of at most 1e+09 was expected"},
                  {"v 1 -inf 3", "line 2: v: '-inf', but a number of at most 1e+09 was expected"},
                  {"v 1 2 1e400", "line 2: v: '1e400', but a number of at most 1e+09 was expected"},
                  {"v 1 2 3 1e39", "line 2: v: '1e39', but a number of at most 3e+38 was expected"},
                  {"v 1 2 3 0 2 0", "line 2: v: a colour beyond 0 to 1"},
                  {"vt", "line 2: vt: a number was expected, but the line ends"},
                  {"vn 1 2", "line 2: vn: a number was expected, but the line ends"}});
}

TEST(ObjError, faces) {
    expectErrors(squareVertices() + "vt 0 0\n",
                 {{"f 1 2", "line 6: f: 2 corners, but 3 or more were expected"},
                  {"f", "line 6: f: 0 corners, but 3 or more were expected"},
                  {"f 1 2 99", "line 6: f: vertex 99, but 4 are there"},
                  {"f 1 2 0", "line 6: f: vertex 0, but they count from 1"},
                  {"f 1 2 -5", "line 6: f: vertex -5, but 4 are there"},
                  {"f 1/1 2/2 3/1", "line 6: f: texture coordinate 2, but 1 is there"},
                  {"f 1//1 2//1 3//1", "line 6: f: normal 1, but 0 are there"},
                  {"f 1 2 3.5", "line 6: f: '3.5' is not a whole number"},
                  {"f 1 2 99999999999999999999", "line 6: f: '99999999999999999999' is too large a number"},
                  {"f 1/1/1/1 2 3", "line 6: f: '1/1/1/1', but v, v/t, v//n or v/t/n was expected"},
                  {"f /1 2 3", "line 6: f: '/1', but v, v/t, v//n or v/t/n was expected"},
                  {"f 1/1 2 3", "line 6: f: all corners of a face must have the same form"}});
}

TEST(ObjError, aVertexMustPrecedeItsFace) {
    EXPECT_EQ(errorOfObj("v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\n"), "line 3: f: vertex 3, but 2 are there");
}

TEST(ObjError, lineNumbersIncludeContinuations) {
    EXPECT_EQ(errorOfObj("# a\\\nv 0 \\\n 0 \\\n0\nv 1 0 0\r\n\r\nf 1 \\\n 2 9\n"),
              "line 7: f: vertex 9, but 2 are there");
}

TEST(ObjError, otherStatements) {
    expectErrors(squareVertices(),
                 {{"s maybe", "line 5: s: 'maybe' is not a whole number"},
                  {"s -1", "line 5: s: a group from 0 to 4294967294 was expected"},
                  {"s", "line 5: s: a number or 'off' was expected, but the line ends"},
                  {"mtllib", "line 5: mtllib: a file name was expected"},
                  {"t", "line 5: t: the name of a tag was expected, but the line ends"},
                  {"t hole", "line 5: t: counts such as 2/1/0 was expected, but the line ends"}});
}

TEST(ObjError, fileWithoutElements) {
    for (const char* text : {"", "hello\nworld\n", "v 0 0 0\n"})
        EXPECT_EQ(errorOfObj(text), "no face, line or point was found, but an OBJ file was expected");
}

TEST(ObjError, tags) {
    expectErrors(
        cube(),
        {{"t hole 1/0 1", "line 15: t hole: counts such as 2/1/0 were expected"},
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
         {"t crease 2/1/0 0 6 1", "line 15: t crease: no face has the edge 0 6"},
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
          "line 15: t smoothtriangles: '3', but 'catmark', 'smooth', 1 or 2 was expected"}});
}

TEST(ObjError, theFirstOfSeveralMissingEdgesIsReported) {
    EXPECT_EQ(errorOfObj(cube() + "t crease 2/1/0 0 6 1\nt crease 2/1/0 1 7 1\n"),
              "line 15: t crease: no face has the edge 0 6");
}

TEST(ObjError, loopAcceptsTrianglesOnly) {
    EXPECT_EQ(errorOfObj(squareVertices() + "f 1 2 3\nf 1 2 3 4\n", {}, "?subdivide=loop"),
              "line 6: f: 4 corners, but the Loop scheme takes triangles only");
}

TEST(ObjError, queries) {
    const std::string text = squareVertices() + "f 1 2 3\n";
    const std::vector<Case> cases{
        {"?subdivid", "query: 'subdivid', but subdivide, subdivide=SCHEME or level=N was expected"},
        {"?", "query: '', but subdivide, subdivide=SCHEME or level=N was expected"},
        {"?subdivide&", "query: '', but subdivide, subdivide=SCHEME or level=N was expected"},
        {"?subdivide=doo-sabin",
         "query: subdivide=doo-sabin, but catmullClark, loop or bilinear was expected"},
        {"?level=9", "query: level=9, but 1 to 8 was expected"},
        {"?level=0", "query: level=0, but 1 to 8 was expected"},
        {"?level=", "query: level=, but 1 to 8 was expected"}};
    for (const Case& test : cases) EXPECT_EQ(errorOfObj(text, {}, test.text), test.error);
}

std::string materialError(const std::string& statements, std::vector<SideFile> files = {}) {
    files.push_back({"a.mtl", statements});
    return errorOfObj(squareVertices() + "mtllib a.mtl\nusemtl m\nf 1 2 3\n", files);
}

TEST(ObjError, materials) {
    const std::vector<Case> cases{
        {"Kd", "a.mtl, line 2: Kd: r g b was expected, but the line ends"},
        {"Kd 1 1", "a.mtl, line 2: Kd: r g b was expected, but the line ends"},
        {"Kd 1 1 2", "a.mtl, line 2: Kd: '2', but a number of at most 1 was expected"},
        {"Kd 1 1 -1", "a.mtl, line 2: Kd: '-1', but 0 or more was expected"},
        {"Ke 1 1 1e21", "a.mtl, line 2: Ke: '1e21', but a number of at most 1e+20 was expected"},
        {"Ns x", "a.mtl, line 2: Ns: 'x' is not a number"},
        {"d 2", "a.mtl, line 2: d: '2', but a number of at most 1 was expected"},
        {"Tr -1", "a.mtl, line 2: Tr: '-1', but 0 or more was expected"},
        {"map_Kd", "a.mtl, line 2: map_Kd: a file name was expected"},
        {"map_Kd -clamp on", "a.mtl, line 2: map_Kd: a file name was expected"},
        {"map_Kd -clamp maybe c.png", "a.mtl, line 2: map_Kd: 'maybe', but on or off was expected"},
        {"map_Kd -s c.png", "a.mtl, line 2: map_Kd: 'c.png' is not a number"},
        {"map_Kd -imfchan q c.png", "a.mtl, line 2: map_Kd: -imfchan q, but r, g, b, m or l was expected"}};
    for (const Case& test : cases)
        EXPECT_EQ(materialError(std::string("newmtl m\n") + test.text + "\n"), test.error) << test.text;
    EXPECT_EQ(materialError("# first\nKd 1 1 1\n"), "a.mtl, line 2: Kd: no newmtl precedes it");
}

TEST(ObjError, missingFiles) {
    EXPECT_NE(errorOfObj("mtllib gone.mtl\n" + squareVertices() + "f 1 2 3\n").find("gone.mtl"),
              std::string::npos);
    EXPECT_NE(materialError("newmtl m\nmap_Kd gone.png\n").find("gone.png"), std::string::npos);
    EXPECT_NE(materialError("newmtl m\nmap_Kd ../../gone.png\n").find("gone.png"), std::string::npos);
}

}  // namespace
}  // namespace candela_test
