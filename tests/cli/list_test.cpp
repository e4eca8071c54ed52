// --list.

#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

TEST(List, PluginsWithTheirFormats) {
    const CommandResult result = runCommand({"--list", "plugins"});
    expectSuccess(result);
    for (const char* text : {"loaded", "gltf", ".glb", "plaza", "plaza:", "?level=1..8: ", "decodes images"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text << " in\n" << result.out;
}

TEST(List, BrokenPluginsWithTheReason) {
    const TemporaryFolder folder;
    folder.write("text.so", "not a library at all");
    const CommandResult result = runCommand({"--list", "plugins", "--plugin-path", folder.path().string()});
    expectSuccess(result);
    EXPECT_NE(result.out.find((folder / "text.so") + ": not a library"), std::string::npos) << result.out;
}

TEST(List, DevicesAndTheDefault) {
    const CommandResult result = runCommand({"--list", "devices"});
    expectSuccess(result);
    EXPECT_NE(result.out.find("without --device"), std::string::npos) << result.out;
}

TEST(List, DisplaysWithTheDefault) {
    const CommandResult result = runCommand({"--list", "displays"});
    expectSuccess(result);
    EXPECT_NE(result.out.find("sRGB"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("  (default)\n"), std::string::npos) << result.out;
}

TEST(List, ViewsOfAllDisplaysOrOfOne) {
    const CommandResult all = runCommand({"--list", "views"});
    expectSuccess(all);
    const std::string displays = runCommand({"--list", "displays"}).out;
    const std::string first = displays.substr(0, displays.find_first_of("\n("));
    const std::string display = first.substr(0, first.find_last_not_of(' ') + 1);
    const CommandResult one = runCommand({"--list", "views", "--display", display});
    expectSuccess(one);
    EXPECT_TRUE(one.out.starts_with(display + "\n  ")) << one.out;
    EXPECT_LT(one.out.size(), all.out.size());
    EXPECT_NE(all.out.find(one.out), std::string::npos) << all.out;
}

TEST(List, UnknownDisplayIsAFault) {
    const CommandResult result = runCommand({"--list", "views", "--display", "cinema"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.err.find("cinema"), std::string::npos) << result.err;
}

}  // namespace
