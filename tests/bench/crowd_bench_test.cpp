// --scene crowd:N: measures skinned characters and no lights.
#include "bench_run.h"

#include <gtest/gtest.h>

#include "command.h"
#include "temporary_folder.h"

#include <fstream>

namespace {

TEST(BenchCrowd, MovesTheCharactersOfTheScene) {
    for (const char* evaluator : {"cpu", "compute"}) {
        const TemporaryFolder folder;
        expectSuccess(runCommand(
            {"--scene", "crowd:3", "--frames", "1", "--subdivision-evaluator", evaluator, "--json", "r.json"},
            {.folder = folder.path()}));
        std::ifstream file(folder / "r.json");
        const Json row = Json::parse(file)["results"].at(0);
        EXPECT_EQ(row["scene"], "crowd:3");
        EXPECT_EQ(row["characters"], 3);
        EXPECT_EQ(row["vertices"], 30000);
        EXPECT_EQ(row["joints"], 180);
        EXPECT_EQ(row["evaluator"], evaluator);
        for (const char* time : {"deform_ms", "copy_ms", "copies"})
            EXPECT_GT(row[time].get<double>(), 0.0) << time;
        EXPECT_GE(row["pose_ms"].get<double>(), 0.0);
    }
}

TEST(BenchCrowd, MeasuresNoLights) {
    expectUsageError(runCommand({"--scene", "crowd:3", "--lights", "4", "--json", "r.json"}),
                     "measures no lights");
    expectUsageError(runCommand({"--scene", "crowd:3", "--shadows", "off", "--json", "r.json"}),
                     "measures no lights");
}

}  // namespace
