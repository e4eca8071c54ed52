// --environment and --background.

#include "command.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

/// An uncoded Radiance picture of 128 × 64 texels, grey: `exponent(column, row)` is that of the radiance
/// 2^exponent, -128 for black.
std::string radiancePicture(const std::function<int(int, int)>& exponent) {
    std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n";
    for (int row = 0; row < 64; ++row) {
        for (int column = 0; column < 128; ++column) {
            const char mantissa = static_cast<char>(128);
            bytes += {mantissa, mantissa, mantissa, static_cast<char>(exponent(column, row) + 129)};
        }
    }
    return bytes;
}

class Environment : public testing::Test {
  protected:
    Environment() {
        Json scene = Json::parse(sampleScene());
        scene["nodes"][1].erase("extensions");
        scene.erase("animations");
        scene["materials"][0]["pbrMetallicRoughness"] = {
            {"baseColorFactor", {1, 1, 1, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
        folder.write("dark.gltf", scene.dump());
        folder.write("half.hdr", radiancePicture([](int, int) { return -1; }));
        folder.write("sun.hdr",
                     radiancePicture([](int column, int row) { return column == 4 && row == 24 ? 10 : -3; }));
    }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "33x33", "--shadows", "off"});
        const CommandResult result = runCommand(arguments, {.folder = folder.path()});
        expectSuccess(result);
        return result;
    }
    Json stats(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "dark.gltf");
        arguments.insert(arguments.end(), {"--stats", "-", "--quiet"});
        return Json::parse(run(arguments).out);
    }

    TemporaryFolder folder;
};

TEST_F(Environment, ItsSunIsALight) {
    EXPECT_EQ(stats({"--environment", "sun.hdr"})["counters"]["lights"], 1);
    EXPECT_EQ(stats({"--environment", "sky"})["counters"]["lights"], 1);
    EXPECT_EQ(stats({"--environment", "half.hdr"})["counters"]["lights"], 0);
}

TEST_F(Environment, StatsNameIt) {
    EXPECT_EQ(stats({"--environment", "half.hdr,90"})["environment"], "half.hdr");
    EXPECT_EQ(stats({"--environment", "studio"})["environment"], "studio");
    EXPECT_EQ(stats({"--environment", "sky"})["environment"], "sky");
    EXPECT_EQ(stats({"--environment", "none"})["environment"], "");
}

TEST_F(Environment, FilesThatCanNotBeReadAreNamed) {
    folder.write("broken.hdr", "#?RADIANCE\n\n-Y 4 +X 4\n");
    folder.write("other.exr", "GIF89a");
    const auto fault = [&](const std::string& file, const std::string& reason) {
        expectFault(runCommand({"dark.gltf", "--quiet", "--environment", file}, {.folder = folder.path()}),
                    file, reason);
    };
    fault("missing.hdr", "there is no such file");
    fault("broken.hdr", "ends within its pixels");
    fault("other.exr", "neither a Radiance picture (.hdr) nor an OpenEXR file (.exr)");
}

}  // namespace
