// Results on standard output, notes and progress on standard error, nothing with --quiet.

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>

namespace {

class Verbosity : public testing::Test {
  protected:
    Verbosity() { folder.write("square.gltf", sampleScene()); }

    CommandSetting here() const { return {.folder = folder.path(), .environment = {"TERM=xterm"}}; }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"square.gltf", "--size", "16x16"});
        return runCommand(arguments, here());
    }

    TemporaryFolder folder;
};

TEST_F(Verbosity, ResultIsOneLineThatNamesThePicture) {
    const CommandResult result = run({"-o", "out.png"});
    expectSuccess(result);
    EXPECT_TRUE(result.out.starts_with("wrote out.png: square.gltf, 16x16, 1 light, ")) << result.out;
    EXPECT_EQ(std::ranges::count(result.out, '\n'), 1);
}

TEST_F(Verbosity, NotesGoToStandardErrorAndNoProgressIntoAPipe) {
    const CommandResult result = run({});
    EXPECT_NE(result.err.find("note: "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("VENDOR_unknown"), std::string::npos) << result.err;
    for (std::size_t start = 0; start < result.err.size(); start = result.err.find('\n', start) + 1)
        EXPECT_EQ(result.err.compare(start, 6, "note: "), 0) << result.err;
    EXPECT_EQ(result.err.find('\r'), std::string::npos) << result.err;
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << result.err;
}

TEST_F(Verbosity, StrictTreatsNotesAsErrors) {
    expectFault(run({"--strict"}), "square.gltf", "VENDOR_unknown");
    expectFault(run({"--strict", "--quiet"}), "square.gltf", "VENDOR_unknown");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"square.gltf"});
}

TEST_F(Verbosity, QuietPrintsNothing) {
    const CommandResult result = run({"--quiet"});
    expectSuccess(result);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "");
}

TEST_F(Verbosity, QuietStillPrintsErrors) {
    expectFault(runCommand({"nowhere.gltf", "--quiet"}, here()), "nowhere.gltf", "");
}

TEST_F(Verbosity, StatsOnStandardOutputAreTheOnlyOutputThere) {
    const CommandResult result = run({"--stats", "-"});
    EXPECT_TRUE(result.out.starts_with("{")) << result.out;
    EXPECT_TRUE(result.out.ends_with("}\n")) << result.out;
    EXPECT_NE(result.err.find("wrote candela.png"), std::string::npos) << result.err;
}

TEST_F(Verbosity, ATerminalShowsProgressAndErasesIt) {
    const std::vector<std::string> arguments{"square.gltf", "--size", "16x16", "--frames", "0-1"};
    const CommandResult result = runOnTerminal(arguments, here());
    expectSuccess(result);
    const std::size_t drawing = result.out.find("drawing candela.0001.png (2 of 2)");
    ASSERT_NE(drawing, std::string::npos) << result.out;
    const std::size_t erased = result.out.rfind("\r\x1b[K");
    ASSERT_NE(erased, std::string::npos) << result.out;
    EXPECT_GT(erased, drawing);
    EXPECT_EQ(result.out.find("wrote "), erased + 4) << result.out;
}

TEST_F(Verbosity, QuietShowsNoProgressOnATerminal) {
    const CommandResult result = runOnTerminal({"square.gltf", "--size", "16x16", "--quiet"}, here());
    expectSuccess(result);
    EXPECT_EQ(result.out, "");
}

TEST_F(Verbosity, DisplayOptionsOfAnExrAreNoted) {
    EXPECT_NE(run({"-o", "a.exr", "--exposure", "1"}).err.find("--exposure"), std::string::npos);
    EXPECT_EQ(run({"-o", "a.exr"}).err.find("--exposure"), std::string::npos);
}

TEST_F(Verbosity, AFullStandardOutputIsAnError) {
    CommandSetting setting = here();
    setting.beforeStart = [] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); };
    expectFault(runCommand({"--list", "displays"}, setting), "standard output", "");
}

}  // namespace
