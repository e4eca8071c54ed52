#include <gtest/gtest.h>

#include "obj_scene.h"

namespace candela_test {
namespace {

struct Case {
    const char* text;
    std::string error;
};

void expectErrors(const std::string& head, const std::vector<Case>& cases, const std::string& tail = "") {
    for (const Case& test : cases)
        EXPECT_EQ(errorOfObj(head + test.text + "\n" + tail), test.error) << test.text;
}

// Where no face can be drawn the first fault is the error.
TEST(ObjError, vertices) {
    const std::string reason = ", but three numbers of at most 1e+09 were expected";
    expectErrors("# nothing\n",
                 {{"v 1", "line 2: v: '1'" + reason},
                  {"v 1 2 x", "line 2: v: '1 2 x'" + reason},
                  {"v 1 2 3x", "line 2: v: '1 2 3x'" + reason},
                  {"v nan 2 3", "line 2: v: 'nan 2 3'" + reason},
                  {"v 1 2 1e400", "line 2: v: '1 2 1e400'" + reason}},
                 "v 0 0 0\nv 1 0 0\nf 2 1 3\n");
}

TEST(ObjError, faces) {
    const std::string reason = "', but the index of a vertex was expected";
    expectErrors(squareVertices() + "vt 0 0\n",
                 {{"f 1 2", "line 6: f: 2 corners, but 3 or more were expected"},
                  {"f", "line 6: f: 0 corners, but 3 or more were expected"},
                  {"f 1 2 99", "line 6: f: vertex 99, but 4 are there"},
                  {"f 1 2 0", "line 6: f: vertex 0, but they count from 1"},
                  {"f 1 2 -5", "line 6: f: vertex -5, but 4 are there"},
                  {"f 1 2 3.5", "line 6: f: '3.5" + reason},
                  {"f 1 2 99999999999999999999", "line 6: f: vertex 99999999999999999999, but 4 are there"},
                  {"f /1 2 3", "line 6: f: '" + reason}});
}

TEST(ObjError, theFirstOfSeveralFaults) {
    EXPECT_EQ(errorOfObj(squareVertices() + "f 1 2 99\nf 1 2 x\n"), "line 5: f: vertex 99, but 4 are there");
    EXPECT_EQ(errorOfObj(squareVertices() + "f 1 2 x\nf 1 2 99\n"),
              "line 5: f: 'x', but the index of a vertex was expected");
}

TEST(ObjError, lineNumbersIncludeContinuations) {
    EXPECT_EQ(errorOfObj("# a\\\nv 0 \\\n 0 \\\n0\nv 1 0 0\r\n\r\nf 1 \\\n 2 9\n"),
              "line 7: f: vertex 9, but 2 are there");
}

TEST(ObjError, fileWithoutElements) {
    for (const char* text : {"", "hello\nworld\n", "v 0 0 0\n"})
        EXPECT_EQ(errorOfObj(text), "no face, line or point was found, but an OBJ file was expected");
}

TEST(ObjError, loopAcceptsTrianglesOnly) {
    EXPECT_EQ(errorOfObj(squareVertices() + "f 1 2 3\nf 1 2 3 4\n", {}, "?subdivide=loop"),
              "line 6: f: 4 corners, but the Loop scheme takes triangles only");
}

TEST(ObjError, queries) {
    const std::string text = squareVertices() + "f 1 2 3\n";
    const std::vector<Case> cases{
        {"?subdivid",
         "query: 'subdivid' is none of the options subdivide[=catmullClark|loop|bilinear], level=1..8"},
        {"?", "query: '' is none of the options subdivide[=catmullClark|loop|bilinear], level=1..8"},
        {"?subdivide&",
         "query: '' is none of the options subdivide[=catmullClark|loop|bilinear], level=1..8"},
        {"?subdivide=doo-sabin",
         "query: subdivide=doo-sabin, but catmullClark, loop or bilinear was expected"},
        {"?level=9", "query: level=9, but an integer from 1 to 8 was expected"},
        {"?level=0", "query: level=0, but an integer from 1 to 8 was expected"},
        {"?level=", "query: level=, but an integer from 1 to 8 was expected"}};
    for (const Case& test : cases) EXPECT_EQ(errorOfObj(text, {}, test.text), test.error);
}

}  // namespace
}  // namespace candela_test
