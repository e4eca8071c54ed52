// How fast shaders shade at most, several backends of the tiles in one run, tables in Markdown, and the
// script that uses all three.
#include "bench_run.h"
#include "command.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

TEST(BenchCeiling, IsWhatTheSharesOfTechniquesAreOf) {
    const Json bench = benchOf({"--lights", "64", "--technique", "tiles,volumes", "--tiles", "compute,cpu",
                                "--ceiling", "--shadows", "off"});
    const double pairsPerSecond = bench["ceiling"]["pairs_per_second"].get<double>();
    EXPECT_GT(pairsPerSecond, 0.0);
    ASSERT_EQ(bench["results"].size(), 3u);
    for (const Json& result : bench["results"]) {
        const bool onCpu = result.value("tile_backend", "") == "cpu";
        ASSERT_EQ(result.contains("ceiling_share"), !onCpu) << result;
        if (onCpu) continue;
        const double rate = result["pairs_lit"].get<double>() / result["lighting_ms"].get<double>() * 1000.0;
        // The share is computed from the same doubles.
        EXPECT_NEAR(result["ceiling_share"].get<double>(), rate / pairsPerSecond,
                    1.0e-9 * rate / pairsPerSecond);
    }
}

TEST(BenchCeiling, PicturesAreComparedWithTheLastBackend) {
    const Json bench = benchOf({"--lights", "64", "--technique", "all", "--tiles", "compute,cpu"});
    ASSERT_EQ(bench["results"].size(), 4u);
    EXPECT_EQ(bench["results"][0]["tile_backend"], "compute");
    EXPECT_EQ(bench["results"][3]["tile_backend"], "cpu");
    EXPECT_FALSE(bench["results"][3].contains("difference")) << "the reference";
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LE(bench["results"][i]["difference"]["mean"].get<double>(), 1.0e-5) << i;
}

TEST(BenchMarkdown, HasARowForEachResult) {
    const TemporaryFolder folder;
    const CommandResult result =
        runCommand({"--lights", "4", "--size", "16x16", "--frames", "1", "--technique", "tiles,volumes",
                    "--markdown", "--ceiling", "--json", "r.json"},
                   {.folder = folder.path()});
    expectSuccess(result);
    EXPECT_NE(result.out.find("| scene | lights | technique |"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("| % of ceiling |\n| --- | ---: |"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\n| plaza | 4 | tiles |"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\n| plaza | 4 | volumes |"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\nceiling: compute shaders shade at most "), std::string::npos) << result.out;
}

CommandResult runScript(std::vector<std::string> arguments, const TemporaryFolder& folder) {
    arguments.insert(arguments.end(), {"--smoke", "--program", CANDELA_COMMAND, "--out", folder.path()});
    return runCommand(arguments, {.folder = folder.path(), .program = CANDELA_GPU_SCRIPT});
}

TEST(BenchmarkGpuScript, ComparesPicturesAndPrintsTables) {
    const TemporaryFolder folder;
    const CommandResult result = runScript({"--budget", "600"}, folder);
    expectSuccess(result);
    EXPECT_EQ(result.out.find("skipped"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("benchmark-gpu: done"), std::string::npos) << result.out;
    std::ifstream file(folder / "tables.md");
    std::ostringstream tables;
    tables << file.rdbuf();
    for (const char* row : {"| plaza | 16 | tiles on compute |", "| rooms | 256 | volumes |",
                            "| plaza | 16 | volumes, shadows |", "| plaza | 16 | fullscreen, shadows |",
                            "| triangles:5000 | 16 | tiles |"})
        EXPECT_NE(tables.str().find(row), std::string::npos) << row << "\n" << tables.str();
}

TEST(BenchmarkGpuScript, NamesWhatDoesNotFitItsBudget) {
    const TemporaryFolder folder;
    const CommandResult result = runScript({"--budget", "5"}, folder);
    EXPECT_NE(result.out.find("skipped: pictures-plaza: it may take 10 s"), std::string::npos) << result.out;
}

TEST(BenchmarkGpuScript, RefusesWrongUsage) {
    const TemporaryFolder folder;
    for (const char* budget : {"0", "soon", "-3"}) {
        const CommandResult result = runScript({"--budget", budget}, folder);
        EXPECT_EQ(result.exitCode, 1);
        EXPECT_NE(result.err.find("expected seconds"), std::string::npos) << result.err;
    }
    EXPECT_NE(runScript({"--no-such-option", "1"}, folder).err.find("usage: "), std::string::npos);
}

}  // namespace
