#include "source_rules.h"

#include "generated_tree.h"

#include <gtest/gtest.h>

#include <string>

namespace candela {
namespace {

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

TEST(SourceRules, OfThisTreeHold) {
    EXPECT_EQ(joined(sourceViolations(CANDELA_SOURCE_TREE)), "");
    EXPECT_GT(sourceFiles(CANDELA_SOURCE_TREE).size(), 100u) << "there have to be files to check";
}

TEST(SourceRules, NoBannedWordIsUsed) {
    const std::vector<BannedWord> words = readBannedWords(CANDELA_SOURCE_TREE "/tests/tree/banned_words.txt");
    EXPECT_GT(words.size(), 10u);
    EXPECT_EQ(joined(wordViolations(CANDELA_SOURCE_TREE, words)), "");
}

TEST(SourceRules, FilesThatDocumentsNameExist) {
    EXPECT_EQ(joined(missingFilesOfDocuments(CANDELA_SOURCE_TREE)), "");
}

TEST(SourceRules, EveryPublicStructIsInitializedByName) {
    EXPECT_EQ(joined(structsNotInitialized(CANDELA_SOURCE_TREE)), "");
}

// A file holds one subject with all that belongs to it. Some are short; their share must not grow
// unnoticed.
TEST(SourceRules, ShareOfShortFilesDoesNotGrow) {
    EXPECT_LE(shortFileShare(CANDELA_SOURCE_TREE), maxShortFileShare);
}

using SourceRulesOfGeneratedTree = GeneratedTree;

// Written in halves, so that this file does not break the rules itself.
const std::string mark = std::string("TO") + "DO";
const std::string folder = std::string("/ho") + "me/";

TEST_F(SourceRulesOfGeneratedTree, NotesOfUnfinishedWorkAreFound) {
    write("lib/scene/scene.cpp", "int x;\nint y;  // " + mark + ": think\n");
    write("shaders/lib/lighting.glsl", "// " + mark);
    EXPECT_EQ(joined(sourceViolations(root())),
              "lib/scene/scene.cpp:2: a note of unfinished work, " + mark +
                  "\nshaders/lib/lighting.glsl:1: a note of unfinished work, " + mark + "\n");
}

TEST_F(SourceRulesOfGeneratedTree, LongerWordsAreAccepted) {
    write("lib/scene/scene.cpp", "int MAS" + mark + "N;\nint " + mark + "_;\n");
    EXPECT_EQ(joined(sourceViolations(root())), "");
}

TEST_F(SourceRulesOfGeneratedTree, PathsOfOneMachineAreFound) {
    write("scripts/demo", "cp \"" + folder + "me/x\" .\n");
    write("scripts/test", "cp build" + folder + "x ${prefix}" + folder + "y .\n");
    EXPECT_EQ(joined(sourceViolations(root())), "scripts/demo:1: a path of one machine, " + folder + "\n");
}

TEST_F(SourceRulesOfGeneratedTree, LongFilesAreFound) {
    std::string lines;
    for (std::size_t i = 0; i < maxLines; ++i) lines += "\n";
    write("tests/scene/long_test.cpp", lines);
    EXPECT_EQ(joined(sourceViolations(root())), "");
    write("tests/scene/long_test.cpp", lines + "\n");
    EXPECT_EQ(joined(sourceViolations(root())), "tests/scene/long_test.cpp:421: more than 420 lines\n");
}

TEST_F(SourceRulesOfGeneratedTree, BannedWordsAreFoundInAnyCaseAndAsWholeWords) {
    const std::vector<BannedWord> words{{"odd word", "plain word"}};
    write("lib/scene/scene.cpp", "// An Odd Word.\n// An odd wording.\n");
    write("docs/page.md", "odd word\n");
    write("CHANGELOG.md", "odd word\n");
    EXPECT_EQ(joined(wordViolations(root(), words)),
              "lib/scene/scene.cpp:1: \"odd word\"; say plain word\n"
              "docs/page.md:1: \"odd word\"; say plain word\n");
}

TEST_F(SourceRulesOfGeneratedTree, MissingFilesOfDocumentsAreFound) {
    write("lib/scene/scene.cpp", "");
    write("docs/page.md", "`lib/scene/scene.cpp` and `lib/scene` and `lib/x.h`, `lib/NAME.h`, `a/b`\n");
    EXPECT_EQ(joined(missingFilesOfDocuments(root())), "docs/page.md:1: there is no lib/x.h\n");
}

TEST_F(SourceRulesOfGeneratedTree, StructsThatAreNotInitializedAreFound) {
    write("include/candela/scene.h", "struct Scene {\n};\nstruct CANDELA_API Bounds {\n};\nstruct State;\n");
    write("tests/tree/designated_initializers.cpp", "use(Bounds{.min = {}}, LongScene{.x = 1}, Scene{});\n");
    EXPECT_EQ(joined(structsNotInitialized(root())), "include/candela/scene.h:1: Scene is not initialised\n");
}

TEST_F(SourceRulesOfGeneratedTree, ShortFilesAreCounted) {
    write("lib/scene/short.cpp", "\n");
    write("lib/scene/long.cpp", std::string(minLines, '\n'));
    EXPECT_EQ(shortFileShare(root()), 0.5);
}

TEST_F(SourceRulesOfGeneratedTree, BuildFoldersAreSkipped) {
    write("apps/hello/build/generated.cpp", "// " + mark);
    EXPECT_EQ(joined(sourceViolations(root())), "");
}

}  // namespace
}  // namespace candela
