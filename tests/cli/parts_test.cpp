// Pictures of several frames: --tile and --panorama.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

class Parts : public testing::Test {
  protected:
    Parts() { folder.write("square.gltf", sampleScene()); }

    void draw(std::vector<std::string> arguments) const {
        arguments.push_back("--quiet");
        expectSuccess(runCommand(arguments, {.folder = folder.path()}));
    }

    TemporaryFolder folder;
};

TEST_F(Parts, MakeUpTheSamePicture) {
    const std::vector<std::string> scene{"plaza:64", "--size",      "150x100", "--samples",
                                         "3",        "--technique", "tiles"};
    const auto picture = [&](const char* name, bool parted) {
        std::vector<std::string> arguments = scene;
        arguments.insert(arguments.end(), {"-o", name});
        if (parted) arguments.insert(arguments.end(), {"--tile", "80"});
        draw(arguments);
        return readPng(folder / name);
    };
    const PngPicture whole = picture("whole.png", false), parted = picture("parted.png", true);
    ASSERT_EQ(parted.width, 150);
    ASSERT_EQ(parted.height, 100);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i) differing += whole.rgba[i] != parted.rgba[i];
    // A silhouette that passes a pixel's centre may be rounded to the other side.
    EXPECT_LT(double(differing), 0.005 * double(whole.rgba.size()));
}

TEST_F(Parts, MakeUpTheSameChannels) {
    const auto picture = [&](const char* name, std::vector<std::string> further) {
        further.insert(further.begin(), {"square.gltf", "--camera", "front", "--size", "130x90", "--samples",
                                         "1", "--aov", "Z,P,node_id", "-o", name});
        draw(further);
        return readExr(folder / name);
    };
    const ExrPicture whole = picture("whole.exr", {}), parted = picture("parted.exr", {"--tile", "64"});
    ASSERT_EQ(whole.names(), parted.names());
    for (const auto& [name, values] : whole.channels) {
        const std::vector<float>& others = parted.channels.at(name);
        std::size_t differing = 0;
        // The rounding of the projection, of some metres.
        for (std::size_t i = 0; i < values.size(); ++i)
            differing += std::abs(values[i] - others[i]) > 1e-4f + 1e-3f * std::abs(values[i]);
        EXPECT_LT(double(differing), 0.005 * double(values.size())) << name;
    }
}

TEST_F(Parts, PanoramasShowWhatIsAhead) {
    draw({"square.gltf", "--camera", "front", "--panorama", "--size", "128x64", "--samples", "1", "-o",
          "p.exr"});
    const ExrPicture picture = readExr(folder / "p.exr");
    ASSERT_EQ(picture.width, 128);
    ASSERT_EQ(picture.height, 64);
    // The square spans 1 m to each side at 3 m ahead: atan(1 / 3) of 2 pi, 6.55 pixels to each side of the
    // middle.
    const auto covered = [&](int x, int y) { return picture.at("A", x, y); };
    EXPECT_EQ(covered(64 + 5, 32), 1.0f);
    EXPECT_EQ(covered(63 - 5, 31), 1.0f);
    EXPECT_EQ(covered(64 + 7, 32), 0.0f);
    EXPECT_EQ(covered(64, 32 + 5), 1.0f);
    EXPECT_EQ(covered(64, 32 + 7), 0.0f);
    EXPECT_EQ(covered(0, 32), 0.0f) << "behind";
    EXPECT_GT(picture.at("R", 64, 32), 0.0f);
    draw({"plaza:1024", "--panorama", "--size", "64x32", "--samples", "2", "-o", "p.png"});
    EXPECT_GT(readPng(folder / "p.png").colors(), 50u);
}

}  // namespace
