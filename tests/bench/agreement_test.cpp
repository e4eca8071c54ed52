// All techniques draw the same image of every scene; the textbook programs do within the precision of half
// floats.
#include "bench_run.h"

#include <gtest/gtest.h>

namespace {

class BenchScenes : public testing::TestWithParam<const char*> {};

TEST_P(BenchScenes, TechniquesAgree) {
    const Json bench = benchOf({"--scene", GetParam(), "--lights", "64", "--technique", "all"});
    ASSERT_EQ(bench["results"].size(), 3u);
    for (const Json& result : bench["results"]) {
        EXPECT_EQ(result["scene"], GetParam());
        if (result["technique"] == "fullscreen") continue;
        const Json& difference = result["difference"];
        EXPECT_EQ(keysOf(difference), (std::vector<std::string>{"from", "max", "mean"}));
        EXPECT_EQ(difference["from"], "fullscreen");
        // Sums in another order, and arithmetic that is not fused alike: a few units in the last place of
        // single precision, multiplied where a highlight is sharp.
        EXPECT_LE(difference["mean"].get<double>(), 1.0e-5);
    }
}

TEST_P(BenchScenes, TheBaselineAgrees) {
    const Json bench = benchOf(
        {"--scene", GetParam(), "--lights", "64", "--technique", "tiles", "--baseline", "--shadows", "off"});
    for (const char* name : {"textbook_volumes", "textbook_fullscreen"}) {
        const Json difference = resultsOf(bench, name).at(0)["difference"];
        EXPECT_EQ(difference["from"], "tiles");
        // Half floats hold a position of 32 m to 64 m to 1.6 cm an axis, and the lights of the cloud reach 30
        // cm: there the run itself allows 0.38, elsewhere 0.056.
        EXPECT_LE(difference["mean"].get<double>(), 0.38) << name;
    }
}

INSTANTIATE_TEST_SUITE_P(All, BenchScenes, testing::Values("plaza", "cloud", "rooms", "outside", "hidden"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(BenchAgreement, OfManySmallTriangles) {
    const Json bench = benchOf({"--scene", "triangles:20000", "--lights", "64", "--technique", "all"});
    ASSERT_EQ(bench["results"].size(), 3u);
    for (const Json& result : bench["results"]) {
        EXPECT_EQ(result["scene"], "triangles:20000");
        EXPECT_EQ(result["triangles"], 20000);
        EXPECT_EQ(result["lights"], 64);
    }
}

TEST(BenchAgreement, WithTheGltfModel) {
    benchOf({"--lights", "64", "--technique", "all", "--brdf", "gltf"});
}

}  // namespace
