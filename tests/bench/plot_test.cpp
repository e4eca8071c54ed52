// --plot, and the table on standard output.
#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace {

std::string textOf(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
    return count;
}

const std::vector<std::string> smallRun{"--lights", "16,64,256", "--technique", "volumes,tiles",
                                        "--size",   "64x36",     "--frames",    "1"};

TEST(BenchPlot, IsAnSvgWithALineATechnique) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = smallRun;
    arguments.insert(arguments.end(), {"--json", "r.json", "--plot", "r.svg"});
    expectSuccess(runCommand(arguments, {.folder = folder.path()}));
    const std::string svg = textOf(folder / "r.svg");
    EXPECT_EQ(svg.find("<svg "), 0u) << svg.substr(0, 80);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_EQ(countOf(svg, "<polyline"), 2u);
    EXPECT_NE(svg.find(">tiles</text>"), svg.npos);
    EXPECT_NE(svg.find(">volumes</text>"), svg.npos);
    EXPECT_NE(svg.find("milliseconds"), svg.npos) << "the axis names its unit";
    EXPECT_NE(svg.find("lights</text>"), svg.npos);
    EXPECT_EQ(svg.find("nan"), svg.npos);
    EXPECT_EQ(svg.find("inf"), svg.npos);
}

TEST(BenchPlot, PlotsASingleNumberOfLights) {
    const TemporaryFolder folder;
    expectSuccess(runCommand(
        {"--lights", "0", "--size", "16x16", "--frames", "1", "--json", "r.json", "--plot", "r.svg"},
        {.folder = folder.path()}));
    const std::string svg = textOf(folder / "r.svg");
    EXPECT_EQ(svg.find("nan"), svg.npos) << svg;
    EXPECT_EQ(svg.find("inf"), svg.npos) << svg;
}

TEST(BenchTable, GoesToStandardOutputAndNoProgressIntoAPipe) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = smallRun;
    arguments.insert(arguments.end(), {"--json", "r.json"});
    const CommandResult result = runCommand(arguments, {.folder = folder.path()});
    expectSuccess(result);
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(countOf(result.out, "volumes"), 3u) << result.out;
    EXPECT_EQ(countOf(result.out, "tiles"), 3u) << result.out;
    EXPECT_NE(result.out.find("lighting"), result.out.npos);
}

TEST(BenchTable, ATerminalShowsProgress) {
    const TemporaryFolder folder;
    std::vector<std::string> arguments = smallRun;
    arguments.insert(arguments.end(), {"--json", "r.json"});
    const CommandResult result =
        runOnTerminal(arguments, {.folder = folder.path(), .environment = {"TERM=xterm"}});
    expectSuccess(result);
    EXPECT_NE(result.out.find("plaza with 64 lights"), result.out.npos) << result.out;
}

}  // namespace
