// --samples: a row for each number of samples.
#include "bench_run.h"

#include "command.h"

#include <gtest/gtest.h>

namespace {

TEST(BenchSamples, ARowForEachNumberHasItsCostInSingleFrames) {
    const Json bench = benchOf({"--lights", "64", "--samples", "1,4"});
    const Json &one = bench["results"].at(0), &four = bench["results"].at(1);
    EXPECT_FALSE(one.contains("samples"));
    EXPECT_FALSE(one.contains("single_frames"));
    EXPECT_EQ(four["samples"], 4);
    EXPECT_EQ(one["frames"], four["frames"]) << "drawn alternately";
    EXPECT_NEAR(four["single_frames"].get<double>(),
                four["picture_ms"].get<double>() / one["picture_ms"].get<double>(), 1e-6);
    EXPECT_GT(four["picture_ms"].get<double>(), 0.0);
}

TEST(BenchSamples, PicturesOfTheSameNumberAreCompared) {
    const Json bench = benchOf({"--lights", "64", "--samples", "3", "--technique", "all"});
    for (const Json& row : bench["results"]) EXPECT_EQ(row["samples"], 3);
    EXPECT_LT(bench["results"].at(0)["difference"]["mean"].get<double>(), 1e-5);
}

TEST(BenchSamples, AnEnvironmentHasItsPasses) {
    const Json bench = benchOf({"--lights", "1", "--technique", "volumes", "--environment", "sky,30"});
    EXPECT_EQ(bench["setup"]["environment"], "sky,30");
    const Json& row = bench["results"].at(0);
    EXPECT_GT(row["background_ms"].get<double>(), 0.0);
    EXPECT_GT(row["environment_ms"].get<double>(), 0.0);
}

}  // namespace
