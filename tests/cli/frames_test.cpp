// --frames: file names, times and interruption.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <thread>

namespace {

using Names = std::vector<std::string>;

CommandResult render(const TemporaryFolder& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--size", "16x16", "--quiet"});
    return runCommand(arguments, {.folder = folder.path()});
}

TEST(Frames, NumberPrecedesTheExtension) {
    const TemporaryFolder folder;
    expectSuccess(render(folder, {"plaza:4", "-o", "walk.png", "--frames", "9-11"}));
    EXPECT_EQ(folder.names(), (Names{"walk.0009.png", "walk.0010.png", "walk.0011.png"}));
}

TEST(Frames, HashesBecomeTheNumber) {
    const TemporaryFolder folder;
    expectSuccess(render(folder, {"plaza:4", "-o", "a#b##.exr", "--frames", "7-8"}));
    EXPECT_EQ(folder.names(), (Names{"a#b07.exr", "a#b08.exr"}));
    expectSuccess(render(folder, {"plaza:4", "-o", "######.png", "--frames", "7-7"}));
    EXPECT_EQ(folder.names(), (Names{"000007.png", "a#b07.exr", "a#b08.exr"}));
}

TEST(Frames, NumberLongerThanItsHashesIsNotTruncated) {
    const TemporaryFolder folder;
    expectSuccess(render(folder, {"plaza:4", "-o", "#.png", "--frames", "123-123"}));
    EXPECT_EQ(folder.names(), Names{"123.png"});
}

TEST(Frames, OneFrameHasItsNumberToo) {
    const TemporaryFolder folder;
    expectSuccess(render(folder, {"plaza:4", "-o", "one.png", "--frames", "7-7"}));
    EXPECT_EQ(folder.names(), Names{"one.0007.png"});
    expectSuccess(render(folder, {"plaza:4", "-o", "one.png", "--frames", "12345"}));
    EXPECT_EQ(folder.names(), (Names{"one.0007.png", "one.12345.png"}));
}

TEST(Frames, WithoutFramesTheNameIsKept) {
    const TemporaryFolder folder;
    expectSuccess(render(folder, {"plaza:4", "-o", "#.png"}));
    EXPECT_EQ(folder.names(), Names{"#.png"});
}

TEST(Frames, ListsAndSteps) {
    const TemporaryFolder folder;
    expectSuccess(render(folder, {"plaza:4", "-o", "f##.png", "--frames", "0-10x5,3,7-8,20-21x9"}));
    EXPECT_EQ(folder.names(),
              (Names{"f00.png", "f03.png", "f05.png", "f07.png", "f08.png", "f10.png", "f20.png"}));
}

TEST(Frames, TwentyFourASecondFromTheStartTime) {
    const TemporaryFolder folder;
    folder.write("square.gltf", sampleScene());
    expectSuccess(render(folder, {"square.gltf", "-o", "f#.exr", "--frames", "12-13"}));
    expectSuccess(render(folder, {"square.gltf", "-o", "t.exr", "--time", "0.5"}));
    expectSuccess(render(folder, {"square.gltf", "-o", "s#.exr", "--time", "0.25", "--frames", "6-6"}));
    const auto half = readExr(folder / "t.exr").channels;
    EXPECT_EQ(readExr(folder / "f12.exr").channels, half);
    EXPECT_EQ(readExr(folder / "s6.exr").channels, half);
    EXPECT_NE(readExr(folder / "f13.exr").channels, half);
}

TEST(Frames, FinishedFramesAreKeptWhenALaterOneFails) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "f2.png");
    expectFault(render(folder, {"plaza:4", "-o", "f#.png", "--frames", "1-3"}), "f2.png", "");
    EXPECT_EQ(folder.names(), (Names{"f1.png", "f2.png"}));
    EXPECT_EQ(readPng(folder / "f1.png").width, 16);
}

TEST(Frames, InterruptionLeavesOnlyCompleteFiles) {
    const TemporaryFolder folder;
    const auto interrupt = [&](int child) {
        for (int tries = 0; tries < 6000 && folder.names().size() < 3; ++tries)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(child, SIGINT);
    };
    const CommandResult result = runCommand(
        {"plaza:4", "-o", "f#.exr", "--frames", "0-100000", "--size", "64x64", "--aov", "all", "--quiet"},
        {.folder = folder.path(),
         .beforeStart = [] { signal(SIGINT, SIG_DFL); },  // background jobs ignore it
         .whileRunning = interrupt});
    EXPECT_EQ(result.signal, SIGINT);
    EXPECT_GE(folder.names().size(), 3u);
    for (const std::string& name : folder.names()) {
        EXPECT_TRUE(name.ends_with(".exr")) << name;
        EXPECT_EQ(readExr(folder / name).width, 64) << name;
    }
}

}  // namespace
