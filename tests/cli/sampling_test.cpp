// --samples, the lens and the shutter.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace {

using Arguments = std::vector<std::string>;

class Samples : public testing::Test {
  protected:
    Samples() { folder.write("square.gltf", sampleScene()); }

    CommandResult run(Arguments arguments) const {
        arguments.insert(arguments.begin(), {"square.gltf", "--size", "49x49", "--quiet"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    ExrPicture exr(Arguments arguments) const {
        arguments.insert(arguments.end(), {"-o", "test.exr"});
        expectSuccess(run(arguments));
        return readExr(folder / "test.exr");
    }
    std::string bytes(Arguments arguments, const std::string& file) const {
        arguments.insert(arguments.end(), {"-o", file});
        expectSuccess(run(arguments));
        std::ifstream stream(folder / file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    static int partlyCovered(const ExrPicture& picture) {
        int count = 0;
        for (const float alpha : picture.channels.at("A")) count += alpha > 0.0f && alpha < 1.0f;
        return count;
    }

    TemporaryFolder folder;
};

TEST_F(Samples, AreSixteenUnlessTheCommandLineSaysOtherwise) {
    const Arguments far{"--camera", "far"};
    const ExrPicture standard = exr(far);
    EXPECT_EQ(standard.texts.at("samples"), "16");
    EXPECT_GT(partlyCovered(standard), 25) << "the edges of the square";
    const ExrPicture one = exr({"--camera", "far", "--samples", "1"});
    EXPECT_EQ(one.texts.count("samples"), 0u);
    EXPECT_EQ(partlyCovered(one), 0);
    EXPECT_EQ(exr({"--camera", "far", "--samples", "16"}).channels, standard.channels);
    EXPECT_NE(exr({"--camera", "far", "--samples", "17"}).channels, standard.channels);
}

TEST_F(Samples, GiveTheSameFileInEachRun) {
    EXPECT_EQ(bytes({"--samples", "5"}, "a.png"), bytes({"--samples", "5"}, "b.png"));
    EXPECT_EQ(bytes({"--samples", "5", "--aov", "all"}, "a.exr"),
              bytes({"--samples", "5", "--aov", "all"}, "b.exr"));
}

TEST_F(Samples, AreOneInADebugView) {
    for (const char* shown : {"normals", "wireframe", "light_count"})
        EXPECT_EQ(bytes({"--show", shown}, "a.png"), bytes({"--show", shown, "--samples", "1"}, "b.png"));
}

TEST_F(Samples, AovsTellHowTheyAreFiltered) {
    const ExrPicture own = exr({"--aov", "Z,P,N,base_color", "--camera", "far"});
    EXPECT_EQ(own.texts.at("filter.Z"), "first");
    EXPECT_EQ(own.texts.at("filter.P"), "first");
    EXPECT_EQ(own.texts.at("filter.N"), "average");
    EXPECT_EQ(own.texts.at("filter.base_color"), "average");
    const ExrPicture average = exr({"--aov", "Z,N", "--aov-filter", "average", "--camera", "far"});
    const ExrPicture first = exr({"--aov", "Z,N", "--aov-filter", "first", "--camera", "far"});
    EXPECT_EQ(average.texts.at("filter.Z"), "average");
    EXPECT_EQ(own.channels.at("Z"), first.channels.at("Z"));
    EXPECT_EQ(own.channels.at("N.Z"), average.channels.at("N.Z"));
    for (const float z : first.channels.at("Z")) EXPECT_TRUE(z == 0.0f || std::abs(z - 6.0f) < 1e-4f) << z;
    EXPECT_NE(average.channels.at("Z"), first.channels.at("Z"));
}

TEST_F(Samples, AreToldByStatsAndTheResult) {
    const CommandResult result = run({"--samples", "3", "--stats", "-"});
    expectSuccess(result);
    const auto stats = nlohmann::json::parse(result.out);
    EXPECT_EQ(stats["samples"], 3);
    std::vector<std::string> passes;
    for (const auto& pass : stats["passes"]) passes.push_back(pass["name"]);
    EXPECT_NE(std::ranges::find(passes, "accumulate"), passes.end());
    EXPECT_EQ(passes.back(), "display");
    const CommandResult told = runCommand({"square.gltf", "--size", "8x8"}, {.folder = folder.path()});
    EXPECT_NE(told.out.find(", 16 samples, "), std::string::npos) << told.out;
}

TEST_F(Samples, ProgressNamesTheSampleOnATerminal) {
    const CommandResult shown =
        runOnTerminal({"square.gltf", "--size", "8x8", "--samples", "40"}, {.folder = folder.path()});
    EXPECT_EQ(shown.exitCode, 0);
    EXPECT_NE(shown.out.find("sample 33 of 40"), std::string::npos) << shown.out;
}

TEST_F(Samples, LensBlursWhatIsOutOfFocus) {
    // The square is 6 m away.
    const auto blurred = [&](const char* focus) {
        return partlyCovered(
            exr({"--camera", "far", "--samples", "64", "--aperture", "0.01", "--focus", focus}));
    };
    const int sharp = blurred("6");
    EXPECT_GT(blurred("3"), 2 * sharp);
    EXPECT_GT(blurred("60"), 2 * sharp);
    EXPECT_EQ(exr({"--camera", "far", "--aperture", "2.8", "--focus", "2", "--samples", "1"}).channels,
              exr({"--camera", "far", "--samples", "1"}).channels)
        << "the first sample is that of a pinhole";
}

TEST_F(Samples, ShutterAveragesTheLightThatMoves) {
    // The light moves from 1 m to 9 m before the square within a second; at one frame a second and a shutter
    // of a whole frame around 0.5 s, it is as often near as far.
    const auto middle = [](const ExrPicture& picture) { return picture.at("R", 24, 24); };
    const Arguments still{"--time", "0.5", "--fps", "1", "--samples", "64"};
    Arguments open = still;
    open.insert(open.end(), {"--shutter", "1"});
    // Over distances from 1 to 9 m the mean of the inverse square is 1 / 9, and in the middle it is 1 / 25.
    const double expected = 25.0 / 9.0 * middle(exr(still));
    EXPECT_NEAR(middle(exr(open)), expected, 0.03 * expected);
}

TEST_F(Samples, FramesFollowTheRate) {
    EXPECT_EQ(bytes({"--samples", "2", "--fps", "4", "--frames", "3"}, "a.png").size(), 0u)
        << "a numbered file is written instead";
    std::ifstream numbered(folder / "a.0003.png", std::ios::binary);
    const std::string drawn{std::istreambuf_iterator<char>(numbered), {}};
    EXPECT_EQ(drawn, bytes({"--samples", "2", "--time", "0.75"}, "b.png"));
}

}  // namespace
