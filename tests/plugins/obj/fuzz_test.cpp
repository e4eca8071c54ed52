#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "../gltf/image_files.h"
#include "obj_scene.h"
#include "support/fuzz_iterations.h"

namespace candela_test {
namespace {

using Random = std::mt19937;

const std::string mtl =
    "# materials\nnewmtl stone\nKa 0 0 0\nKd 0.5 0.25 0.125\nKs 1 1 1\nNs 30\nd 0.5\nKe 0 1 2\nillum 2\n"
    "map_Kd -s 2 2 -o 0.5 0 1 -clamp on c.png\nmap_d -imfchan r c.png\nmap_Ke c.png\n"
    "newmtl metal sheet\nPr 0.25\nPm 0.75\nmap_Pr -bm 1 c.png\nmap_Pm -imfchan g c.png\nnorm -bm 0.5 c.png\n"
    "Tr 0.1\nmap_Bump -mm 0 1 c.png\n";

const std::string polygons =
    "# polygons\r\nmtllib a.mtl\nv 0 0 0 1 0 0.5\nv 1 0 0\nv 1 1 0\nv 0 1 0.25\nv 0.5 2 0 1\nvt 0 0\nvt 1 0 "
    "0\n"
    "vt 1\nvn 0 0 1\nvn 0 1 0\no first\ng a b\nusemtl stone\ns 1\nf 1 2 3 4 5\nf 1/1 2/2 3/3\ns off\n"
    "f 1//1 2//2 \\\n 3//1\nusemtl metal sheet\nf -5/-3/-2 -4/-2/-1 -3/-1/-1\no second\nf 4 3 5\nl 1 2 3\np "
    "4\n"
    "cstype bezier\ncurv 0 1 1 2\nend\n";

const std::string tags =
    "t crease 2/1/0 0 1 2.5\nt crease 4/2/0 1 2 5 6 3 4\nt corner 1/1/0 7 1.5\nt corner 2/2/0 0 1 9 9\n"
    "t hole 1/0/0 4\nt interpolateboundary 1/0/0 1\nt facevaryinginterpolateboundary 1/0/0 2\n"
    "t facevaryingpropagatecorners 1/0/0 1\nt creasemethod 0/0/1 chaikin\nt smoothtriangles 0/0/1 smooth\n"
    "t smoothtriangles 1/0/0 2\nt vertexedit 2/3/3 0 1 0 0 1 add P value\n";

const std::vector<std::string>& edgeCaseTokens() {
    static const std::vector<std::string> tokens{"-1",
                                                 "0",
                                                 "1",
                                                 "2",
                                                 "255",
                                                 "-2147483649",
                                                 "4294967295",
                                                 "4294967296",
                                                 "18446744073709551616",
                                                 "1e39",
                                                 "-1e9",
                                                 "1e-400",
                                                 "nan",
                                                 "inf",
                                                 ".",
                                                 "-",
                                                 "+",
                                                 "/",
                                                 "//",
                                                 "1/",
                                                 "1//1",
                                                 "1/1/1/1",
                                                 "0/0/0",
                                                 "9/9/9",
                                                 "#",
                                                 "\\\n",
                                                 "\n",
                                                 "off",
                                                 "o",
                                                 "g",
                                                 "s",
                                                 "f",
                                                 "v",
                                                 "t",
                                                 "crease",
                                                 "hole",
                                                 "usemtl",
                                                 "newmtl",
                                                 "mtllib a.mtl",
                                                 "map_Kd",
                                                 "-s",
                                                 "-clamp",
                                                 "c.png",
                                                 "a.mtl",
                                                 std::string(1, '\0'),
                                                 "\xFF\xFE",
                                                 std::string(300, '7')};
    return tokens;
}

std::size_t below(Random& random, std::size_t limit) {
    return random() % limit;
}

bool isSpace(char c) {
    return c == ' ' || c == '\n';
}

/// Replaces a token by one that is likely to be mishandled.
void replaceToken(std::string& text, Random& random) {
    std::size_t begin = below(random, text.size());
    while (begin > 0 && !isSpace(text[begin - 1])) --begin;
    std::size_t end = begin;
    while (end < text.size() && !isSpace(text[end])) ++end;
    text.replace(begin, end - begin, edgeCaseTokens()[below(random, edgeCaseTokens().size())]);
}

void moveLine(std::string& text, Random& random) {
    const std::size_t begin = text.rfind('\n', below(random, text.size())) + 1;
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string line = text.substr(begin, end - begin);
    if (below(random, 2) == 0) text.erase(begin, end - begin);
    const std::size_t target = text.empty() ? 0 : text.rfind('\n', below(random, text.size())) + 1;
    text.insert(target, line);
}

void mutate(std::string& text, Random& random) {
    if (text.empty()) return;
    const std::size_t at = below(random, text.size());
    switch (below(random, 6)) {
        case 0:
            text[at] = static_cast<char>(random());
            break;
        case 1:
            text.erase(at, below(random, 16));
            break;
        case 2:
            moveLine(text, random);
            break;
        default:
            replaceToken(text, random);
            break;
    }
}

enum class Target { scene, materials };

/// Loads many mutations, of `obj` or of its material file. Each gives a scene or an `Error`, in bounded time.
void fuzz(const std::string& obj, Target target, const std::string& query) {
    const int rounds = fuzzIterations<int>(3000);
    const TemporaryFolder folder;
    folder.write("c.png", makePng(2, 2, 1, 2, 3, 4));
    folder.write("a.mtl", mtl);
    const std::string path = folder.write("scene.obj", obj) + query;
    int accepted = 0, noted = 0;
    for (int round = 0; round < rounds; ++round) {
        Random random(static_cast<Random::result_type>(round));
        std::string changed = target == Target::materials ? mtl : obj;
        for (std::size_t i = 0, count = 1 + below(random, 3); i < count; ++i) mutate(changed, random);
        folder.write(target == Target::materials ? "a.mtl" : "scene.obj", changed);
        const auto start = std::chrono::steady_clock::now();
        try {
            noted += !loadPath(path).report.notes.empty();
            ++accepted;
        } catch (const candela::Error& error) {
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        }
        // Such a file takes about a millisecond; a minute is a hang on any machine.
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(1)) << "round " << round;
    }
    // The mutations have to exercise both: most break a part, and hardly one breaks the whole file.
    EXPECT_GT(accepted, rounds / 2);
    EXPECT_GT(noted, rounds / 50);
}

TEST(ObjFuzz, unmodifiedFilesAreAccepted) {
    const std::vector<SideFile> files{{"a.mtl", mtl}, {"c.png", textOf(makePng(2, 2, 1, 2, 3, 4))}};
    EXPECT_EQ(errorOfObj(polygons, files), "");
    EXPECT_EQ(errorOfObj(polygons, files, "?subdivide"), "");
    EXPECT_EQ(errorOfObj(cube() + tags), "");
}

TEST(ObjFuzz, polygons) {
    fuzz(polygons, Target::scene, "");
}

TEST(ObjFuzz, cages) {
    fuzz(polygons, Target::scene, "?subdivide&level=2");
}

TEST(ObjFuzz, tags) {
    fuzz(cube() + tags, Target::scene, "");
}

TEST(ObjFuzz, materials) {
    fuzz(polygons, Target::materials, "");
}

TEST(ObjFuzz, queries) {
    const TemporaryFolder folder;
    const std::string path = folder.write("scene.obj", cube());
    for (int round = 0; round < fuzzIterations(300); ++round) {
        Random random(static_cast<Random::result_type>(round));
        std::string query = "subdivide=loop&level=3&subdivide=bilinear";
        mutate(query, random);
        std::replace(query.begin(), query.end(), '\n', '&');
        // An error of one line, or a scene.
        EXPECT_EQ(errorOfPath(path + "?" + query).find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace candela_test
