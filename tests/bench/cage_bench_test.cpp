// --scene cages: measures cages and no lights.
#include "bench_run.h"

#include <gtest/gtest.h>

#include "command.h"
#include "temporary_folder.h"

#include <fstream>

namespace {

TEST(BenchCages, MovesTenThousandQuadsAtLevelThree) {
    const TemporaryFolder folder;
    expectSuccess(
        runCommand({"--scene", "cages", "--frames", "1", "--json", "r.json"}, {.folder = folder.path()}));
    std::ifstream file(folder / "r.json");
    const Json row = Json::parse(file)["results"].at(0);
    EXPECT_EQ(row["scene"], "cages");
    EXPECT_EQ(row["quads"], 10000);
    EXPECT_EQ(row["level"], 3);
    // A closed cage of n quads is a surface of n 4^level quads, and of two vertices more.
    EXPECT_EQ(row["vertices"], 640002);
    EXPECT_GT(row["entries"], row["vertices"]);
    for (const char* time : {"move_ms", "opensubdiv_move_ms", "refine_ms", "opensubdiv_refine_ms"})
        EXPECT_GT(row[time].get<double>(), 0.0) << time;
    EXPECT_TRUE(row["evaluator"] == "cpu" || row["evaluator"] == "compute");
}

TEST(BenchCages, NamesTheRequestedEvaluator) {
    const TemporaryFolder folder;
    expectSuccess(runCommand(
        {"--scene", "cages", "--frames", "1", "--subdivision-evaluator", "cpu", "--json", "r.json"},
        {.folder = folder.path()}));
    std::ifstream file(folder / "r.json");
    EXPECT_EQ(Json::parse(file)["results"].at(0)["evaluator"], "cpu");
}

TEST(BenchCages, MeasuresNoLights) {
    expectUsageError(runCommand({"--scene", "cages", "--lights", "4", "--json", "r.json"}),
                     "measures no lights");
    expectUsageError(runCommand({"--scene", "cages", "--shadows", "off", "--json", "r.json"}),
                     "measures no lights");
}

}  // namespace
