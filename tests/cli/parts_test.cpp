// Pictures of several frames: --tile and --panorama.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
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

TEST_F(Parts, BandsAreThoseOfEveryFormat) {
    const std::vector<std::string> scene{"plaza:64", "--size", "150x170", "--samples",
                                         "1",        "--tile", "64",      "--quiet"};
    const auto drawn = [&](std::vector<std::string> further) {
        further.insert(further.begin(), scene.begin(), scene.end());
        return runCommand(further, {.folder = folder.path()});
    };
    expectSuccess(drawn({"-o", "a.png"}));
    const PngPicture picture = readPng(folder / "a.png");
    ASSERT_EQ(picture.height, 170);
    EXPECT_TRUE(picture.opaque());
    EXPECT_GT(picture.colors(), 100u);
    // Onto standard output, encoded and as bytes.
    const CommandResult raw = drawn({"-o", "-", "--raw", "rgba8"});
    EXPECT_EQ(raw.out, std::string(picture.rgba.begin(), picture.rgba.end()));
    EXPECT_EQ(drawn({"-o", "-"}).out.substr(1, 3), "PNG");
    const CommandResult two = drawn({"-o", "-", "--raw", "rgba8", "--frames", "0-1"});
    EXPECT_EQ(two.out, raw.out + raw.out);
    // The wavelets of PIZ and the deflate of ZIP are without loss.
    expectSuccess(drawn({"-o", "zip.exr", "--aov", "Z,N"}));
    expectSuccess(drawn({"-o", "piz.exr", "--aov", "Z,N", "--compression", "piz"}));
    const ExrPicture zip = readExr(folder / "zip.exr"), piz = readExr(folder / "piz.exr");
    EXPECT_EQ(zip.channels, piz.channels);
    EXPECT_EQ(zip.texts.count("workingSpace"), 1u);
    expectSuccess(drawn({"-o", "half.exr", "--exr", "half"}));
    EXPECT_FALSE(readExr(folder / "half.exr").floats);
}

TEST_F(Parts, AreWholeOrNotThere) {
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    std::filesystem::create_symlink("/dev/full", folder / "full.exr");
    const std::vector<std::string> before = folder.names();
    for (const char* name : {"full.png", "full.exr", "missing/a.png"}) {
        const CommandResult result =
            runCommand({"plaza:64", "--size", "150x170", "--tile", "64", "--quiet", "-o", name},
                       {.folder = folder.path()});
        EXPECT_EQ(result.exitCode, 1) << name;
    }
    EXPECT_EQ(folder.names(), before);
}

TEST_F(Parts, HaveStatistics) {
    const auto stats = [&](std::vector<std::string> further) {
        further.insert(further.begin(), {"plaza:256", "--samples", "2", "--quiet", "--stats", "-"});
        const CommandResult result = runCommand(further, {.folder = folder.path()});
        expectSuccess(result);
        return nlohmann::json::parse(result.out);
    };
    const auto whole = stats({"--size", "150x100", "-o", "a.png"});
    const auto parts = stats({"--size", "150x100", "-o", "a.png", "--tile", "80"});
    EXPECT_EQ(parts["frame_ms"]["count"], 1);
    EXPECT_GT(parts["frame_ms"]["median"], 0.0);
    EXPECT_FALSE(parts["passes"].empty());
    EXPECT_GT(parts["pictures"][0]["encode_ms"], 0.0);
    EXPECT_EQ(parts["pictures"][0]["bytes"], std::filesystem::file_size(folder / "a.png"));
    // The margins of the parts are counted too: 16 pixels on each inner side.
    EXPECT_GE(parts["counters"]["pairs_lit"], whole["counters"]["pairs_lit"]);
    EXPECT_EQ(parts["shadows"].is_null(), whole["shadows"].is_null());
    if (!whole["shadows"].is_null()) {
        EXPECT_GE(parts["shadows"]["rays_asked"], whole["shadows"]["rays_asked"]);
    }
    const auto panorama = stats({"--panorama", "--size", "64x32", "-o", "p.png"});
    EXPECT_GT(panorama["counters"]["pairs_lit"], 0);
    EXPECT_GT(panorama["frame_ms"]["median"], 0.0);
}

TEST_F(Parts, PanoramasHaveAovs) {
    draw({"square.gltf", "--camera", "front", "--panorama", "--size", "128x64", "--samples", "1", "--aov",
          "all", "-o", "p.exr"});
    const ExrPicture picture = readExr(folder / "p.exr");
    EXPECT_EQ(picture.channels.count("motion.X"), 0u);
    // The square lies in a plane 3 m ahead, so that a ray by the angles of a pixel is as long as
    // 3 m / (cos latitude cos longitude). The nearest pixel of a face is read, which is at most half of one
    // away, 2 pi / 128 / 2 of the distance, times the slope of the plane, tan(atan(1 / 3) * sqrt(2)) at most.
    constexpr double pi = std::numbers::pi;
    for (const auto& [x, y] : {std::pair{64, 32}, {60, 30}, {67, 34}}) {
        const double longitude = 2 * pi * ((x + 0.5) / 128 - 0.5), latitude = pi * (0.5 - (y + 0.5) / 64);
        const double expected = 3.0 / (std::cos(latitude) * std::cos(longitude));
        EXPECT_NEAR(picture.at("Z", x, y), expected, expected * pi / 128 * 0.5) << x << ", " << y;
        EXPECT_GE(picture.at("node_id", x, y), 1.0f);
        EXPECT_EQ(picture.at("node_id", x, y), std::round(picture.at("node_id", x, y)));
    }
    EXPECT_EQ(picture.at("Z", 0, 32), 0.0f) << "behind";
    EXPECT_EQ(picture.at("node_id", 0, 32), 0.0f);
}

}  // namespace
