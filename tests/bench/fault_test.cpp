// Input or environment at fault: exit code 1, one line, and no file is left half written.
#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

namespace {

CommandResult runIn(const TemporaryFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--lights", "4", "--size", "16x16", "--frames", "1"});
    return runCommand(arguments, {.folder = folder.path()});
}

TEST(BenchFault, MissingScene) {
    const TemporaryFolder folder;
    expectFault(runIn(folder, {"--scene", "missing.glb", "--json", "r.json"}), "missing.glb", "");
    EXPECT_TRUE(folder.names().empty());
}

TEST(BenchFault, TooManyTriangles) {
    const TemporaryFolder folder;
    expectFault(runIn(folder, {"--scene", "triangles:50000001", "--json", "r.json"}), "triangles:50000001,4",
                "whole number from 1 to 50000000");
}

TEST(BenchFault, MissingOutputFolder) {
    const TemporaryFolder folder;
    expectFault(runIn(folder, {"--json", "nowhere/r.json"}), "nowhere/r.json", "does not exist");
    expectFault(runIn(folder, {"--json", "r.json", "--plot", "nowhere/r.svg"}), "nowhere/r.svg",
                "does not exist");
    EXPECT_TRUE(folder.names().empty()) << "checked before anything is measured";
}

TEST(BenchFault, UnknownView) {
    const TemporaryFolder folder;
    const CommandResult result = runIn(folder, {"--json", "r.json", "--view", "Unknown"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("Unknown"), std::string::npos) << result.err;
    EXPECT_TRUE(folder.names().empty());
}

TEST(BenchFault, MissingPluginFolder) {
    const TemporaryFolder folder;
    const CommandResult result = runIn(folder, {"--json", "r.json", "--plugin-path", "nowhere"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("nowhere"), std::string::npos) << result.err;
}

TEST(BenchFault, ResultsReplaceOlderOnesWhole) {
    const TemporaryFolder folder;
    folder.write("r.json", "older");
    expectSuccess(runIn(folder, {"--json", "r.json", "--quiet"}));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"r.json"});
}

}  // namespace
