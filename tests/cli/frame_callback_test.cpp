// A scene that a plugin moves from frame to frame: tests/import/fixtures/wave.cpp.

#include "command.h"
#include "picture_reader.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

namespace {

constexpr int size = 16;
constexpr double pi = std::numbers::pi;

/// The height of the sheet, which is straight between its nine columns.
double heightAt(double x, double seconds) {
    const auto heightOf = [seconds](double column) {
        return 0.25 * std::sin(2.0 * pi * (column / 8.0 - seconds));
    };
    const double column = std::min(std::floor(8.0 * x), 7.0), share = 8.0 * x - column;
    return (1.0 - share) * heightOf(column) + share * heightOf(column + 1.0);
}

class WaveCommand : public testing::Test {
  protected:
    CommandResult run(const std::string& mode, std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "wave:" + mode);
        arguments.insert(arguments.end(), {"--plugin-path", CANDELA_TEST_FRAMES, "--quiet"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    CommandResult draw(const std::string& mode, std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "16x16", "--shadows", "off"});
        return run(mode, std::move(arguments));
    }
    std::string bytesOf(const std::string& name) const {
        std::ifstream file(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    TemporaryFolder folder;
};

TEST_F(WaveCommand, AFrameAloneIsThatOfTheSequence) {
    expectSuccess(draw("flat", {"-o", "all-##.png", "--frames", "10-13"}));
    for (const char* number : {"12", "10"})
        expectSuccess(draw("flat", {"-o", "one-##.png", "--frames", number}));
    EXPECT_FALSE(bytesOf("all-12.png").empty());
    EXPECT_EQ(bytesOf("all-12.png"), bytesOf("one-12.png"));
    EXPECT_EQ(bytesOf("all-10.png"), bytesOf("one-10.png"));
    EXPECT_NE(bytesOf("all-10.png"), bytesOf("all-12.png"));
}

TEST_F(WaveCommand, PositionsAndMotionAreThoseOfTheWave) {
    constexpr double now = 12.0 / 24.0, then = 11.0 / 24.0;
    expectSuccess(draw("flat", {"-o", "a-#.exr", "--frames", "12", "--aov", "P,node_id,motion"}));
    const ExrPicture picture = readExr(folder / "a-12.exr");
    // The eye is at (0.5, 0.5, 4) and sees 45 degrees.
    const double pixels = 0.5 * size / std::tan(0.5 * 0.785398);
    int seen = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            if (picture.at("node_id", x, y) != 1.0f) continue;
            ++seen;
            const double px = picture.at("P.X", x, y), py = picture.at("P.Y", x, y);
            // Depth in single precision, 4 m away, where the sheet is up to 1.6 steep.
            EXPECT_NEAR(picture.at("P.Z", x, y), heightAt(px, now), 2e-5);
            const double scale = pixels / (4.0 - heightAt(px, now)) - pixels / (4.0 - heightAt(px, then));
            EXPECT_NEAR(picture.at("motion.X", x, y), scale * (px - 0.5), 2e-4);
            EXPECT_NEAR(picture.at("motion.Y", x, y), -scale * (py - 0.5), 2e-4);
        }
    }
    EXPECT_GE(seen, 9) << "a metre is 4.8 pixels";
}

TEST_F(WaveCommand, AnOpenShutterShowsTheWaveAtSeveralTimes) {
    const std::vector<std::string> common{"--samples", "4", "--time", "0.5"};
    const auto drawn = [&](const std::string& name, const std::string& shutter) {
        std::vector<std::string> arguments{"-o", name, "--shutter", shutter};
        arguments.insert(arguments.end(), common.begin(), common.end());
        expectSuccess(draw("flat", arguments));
        return bytesOf(name);
    };
    EXPECT_NE(drawn("closed.png", "0"), drawn("open.png", "1"));
}

TEST_F(WaveCommand, AFaultAtTheThirdFrameIsOneErrorAfterTwoFrames) {
    const std::pair<const char*, const char*> faults[] = {
        {"fails", "the frame at 0.0833333 s, by the plugin 'wave': cache 'sheet.pc': it ends at 0.08 s"},
        {"nan", "mesh 0 'sheet': position 1 has the component nan"},
        {"count", "vertex_count is 80, but it has 81 vertices"},
        {"null", "position is NULL"},
    };
    for (const auto& [mode, text] : faults) {
        SCOPED_TRACE(mode);
        const std::string name = mode;
        expectFault(draw(name, {"-o", name + "-#.png", "--frames", "0-4"}), "wave:" + name, text);
        EXPECT_FALSE(bytesOf(name + "-1.png").empty());
        EXPECT_FALSE(std::filesystem::exists(folder / (name + "-2.png")));
    }
}

TEST_F(WaveCommand, TheListOfAnimationsTellsOfIt) {
    const CommandResult result = run("flat", {"--list", "animations"});
    expectSuccess(result);
    EXPECT_EQ(result.out, "frame callback of the plugin: to 2 s\n");
}

}  // namespace
