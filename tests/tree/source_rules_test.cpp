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
    EXPECT_GT(sourceFiles(CANDELA_SOURCE_TREE).size(), 100u) << "the check means nothing without files";
}

using SourceRulesOfAMadeTree = MadeTree;

// Written in halves, so that this file does not break the rules itself.
const std::string mark = std::string("TO") + "DO";
const std::string folder = std::string("/ho") + "me/";

TEST_F(SourceRulesOfAMadeTree, NotesOfUnfinishedWorkAreFound) {
    write("lib/scene/scene.cpp", "int x;\nint y;  // " + mark + ": think\n");
    write("shaders/lib/lighting.glsl", "// " + mark);
    EXPECT_EQ(joined(sourceViolations(root())),
              "lib/scene/scene.cpp:2: a note of unfinished work, " + mark +
                  "\nshaders/lib/lighting.glsl:1: a note of unfinished work, " + mark + "\n");
}

TEST_F(SourceRulesOfAMadeTree, LongerWordsAreNoNotes) {
    write("lib/scene/scene.cpp", "int MAS" + mark + "N;\nint " + mark + "_;\n");
    EXPECT_EQ(joined(sourceViolations(root())), "");
}

TEST_F(SourceRulesOfAMadeTree, PathsOfOneMachineAreFound) {
    write("scripts/demo", "cp \"" + folder + "me/x\" .\n");
    write("scripts/test", "cp build" + folder + "x ${prefix}" + folder + "y .\n");
    EXPECT_EQ(joined(sourceViolations(root())), "scripts/demo:1: a path of one machine, " + folder + "\n");
}

TEST_F(SourceRulesOfAMadeTree, LongFilesAreFound) {
    std::string lines;
    for (std::size_t i = 0; i < maxLines; ++i) lines += "\n";
    write("tests/scene/long_test.cpp", lines);
    EXPECT_EQ(joined(sourceViolations(root())), "");
    write("tests/scene/long_test.cpp", lines + "\n");
    EXPECT_EQ(joined(sourceViolations(root())), "tests/scene/long_test.cpp:421: more than 420 lines\n");
}

TEST_F(SourceRulesOfAMadeTree, BuildFoldersAreNotOurs) {
    write("apps/hello/build/made.cpp", "// " + mark);
    EXPECT_EQ(joined(sourceViolations(root())), "");
}

}  // namespace
}  // namespace candela
