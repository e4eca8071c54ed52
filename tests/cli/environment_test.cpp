// --environment and --background.

#include "command.h"
#include "picture_reader.h"
#include "plugins/gltf/gltf_file.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
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
        // Bright behind the camera, which looks along -Z: the outer halves of the columns.
        folder.write("back.hdr",
                     radiancePicture([](int column, int) { return column < 32 || column >= 96 ? 0 : -128; }));
        folder.write("sun.hdr",
                     radiancePicture([](int column, int row) { return column == 4 && row == 24 ? 10 : -3; }));
    }
    /// A polished sphere of metal, without a light.
    void writeBall() const {
        constexpr int rings = 24, segments = 48;
        constexpr float pi = 3.14159265f;
        std::vector<float> points;
        std::vector<std::uint16_t> indices;
        for (int ring = 0; ring <= rings; ++ring) {
            for (int segment = 0; segment <= segments; ++segment) {
                const float polar = pi * static_cast<float>(ring) / rings;
                const float around = 2.0f * pi * static_cast<float>(segment) / segments;
                points.insert(points.end(), {std::sin(polar) * std::sin(around), std::cos(polar),
                                             std::sin(polar) * std::cos(around)});
                if (ring == rings || segment == segments) continue;
                const int a = ring * (segments + 1) + segment, b = a + segments + 1;
                for (const int corner : {a, b, b + 1, a, b + 1, a + 1})
                    indices.push_back(static_cast<std::uint16_t>(corner));
            }
        }
        candela_test::GltfFile file;
        file.addData("VEC3", points);
        file.addData("SCALAR", indices);
        file.add("materials", R"({"pbrMetallicRoughness":{"metallicFactor":1,"roughnessFactor":0.1}})");
        file.addMeshNode(R"("attributes":{"POSITION":0,"NORMAL":0},"indices":1,"material":0)");
        folder.write("ball.gltf", file.text());
    }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "33x33", "--shadows", "off"});
        const CommandResult result = runCommand(arguments, {.folder = folder.path()});
        expectSuccess(result);
        return result;
    }
    ExrPicture picture(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "dark.gltf");
        arguments.insert(arguments.end(), {"-o", "test.exr"});
        run(arguments);
        return readExr(folder / "test.exr");
    }
    float middle(std::vector<std::string> arguments) const {
        return picture(std::move(arguments)).at("G", 16, 16);
    }
    Json stats(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "dark.gltf");
        arguments.insert(arguments.end(), {"--stats", "-", "--quiet"});
        return Json::parse(run(arguments).out);
    }

    TemporaryFolder folder;
};

TEST_F(Environment, AWhiteSurfaceShowsItsRadiance) {
    // A mantissa stands for the middle of its step: 0.5 × 128.5 / 128. The 8 bits of the colour lose nothing
    // of white; what the environment's filter loses is within a percent.
    const float radiance = 0.5f * 128.5f / 128.0f;
    EXPECT_NEAR(middle({"--environment", "half.hdr"}), radiance, 0.01f * radiance);
    EXPECT_NEAR(middle({"--environment", "half.hdr,77,1"}), 2.0f * radiance, 0.02f * radiance);
    EXPECT_EQ(middle({"--environment", "none", "--default-lights", "off"}), 0.0f);
}

TEST_F(Environment, DegreesTurnIt) {
    EXPECT_GT(middle({"--environment", "back.hdr"}), 0.95f);
    // Bright to the right and to the left: half of it each.
    EXPECT_NEAR(middle({"--environment", "back.hdr,90"}), middle({"--environment", "back.hdr,-90"}), 0.01f);
    EXPECT_NEAR(middle({"--environment", "back.hdr,90"}), 0.5f, 0.02f);
    EXPECT_LT(middle({"--environment", "back.hdr,180"}), 0.05f);
}

TEST_F(Environment, IsSeenBehindTheSceneUnlessItIsAStudio) {
    const auto corner = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--camera", "1"});
        const ExrPicture exr = picture(std::move(arguments));
        EXPECT_EQ(exr.at("A", 1, 1), 0.0f);
        return exr.at("G", 1, 1);
    };
    EXPECT_NEAR(corner({"--environment", "half.hdr"}), 0.5f * 128.5f / 128.0f, 1e-3f);
    EXPECT_EQ(corner({"--environment", "half.hdr", "--background", "off"}), 0.0f);
    EXPECT_EQ(corner({"--environment", "studio"}), 0.0f);
    EXPECT_GT(corner({"--environment", "studio", "--background", "on"}), 0.1f);
    EXPECT_GT(corner({"--environment", "sky"}), 0.1f);
    EXPECT_EQ(corner({"--environment", "none"}), 0.0f);
}

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

TEST_F(Environment, ASceneWithoutLightIsLitByAStudio) {
    const auto text = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"-o", "test.png"});
        return run(std::move(arguments)).err;
    };
    const std::string note = "a studio lights it (--environment none leaves it out)";
    EXPECT_NE(text({"dark.gltf"}).find(note), std::string::npos);
    EXPECT_EQ(stats({})["environment"], "studio");
    EXPECT_EQ(stats({})["counters"]["lights"], 0) << "instead of default lights";
    EXPECT_EQ(stats({"--default-lights", "off"})["environment"], "studio");
    EXPECT_EQ(stats({"--default-lights", "on"})["counters"]["lights"], 3);
    EXPECT_EQ(stats({"--environment", "none"})["counters"]["lights"], 3);
    EXPECT_EQ(stats({"--scatter-lights", "5"})["environment"], "");
    folder.write("square.gltf", sampleScene());
    EXPECT_EQ(text({"square.gltf"}).find(note), std::string::npos);
    EXPECT_EQ(text({"dark.gltf", "--environment", "studio"}).find(note), std::string::npos);
    EXPECT_NEAR(middle({}), 0.77f, 0.03f) << "docs/environment.md";
}

TEST_F(Environment, AMetalBallInTheStudioIsNeitherBlackNorBurnt) {
    writeBall();
    const std::string err = run({"ball.gltf", "-o", "ball.png"}).err;
    // The notes on pictures that show nothing: next to nothing lit, too dark, or half of it over white.
    for (const char* fault : {"in view", "is lit", "too dark", "over white"})
        EXPECT_EQ(err.find(fault), std::string::npos) << err;
    const PngPicture picture = readPng(folder / "ball.png");
    EXPECT_GT(picture.mean(), 40.0);
    EXPECT_LT(picture.mean(), 200.0);
    EXPECT_GT(picture.colors(), 50u) << "soft boxes and walls are mirrored in it";
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

TEST_F(Environment, IsListed) {
    const auto listed = [&](const std::string& scene) {
        const CommandResult result = runCommand({"--list", "environment", scene}, {.folder = folder.path()});
        expectSuccess(result);
        return result.out;
    };
    EXPECT_EQ(listed("dark.gltf"), "no environment, and no other light: a studio lights the scene\n");
    EXPECT_EQ(listed("plaza:1"), "no environment\n");
    Json scene = Json::parse(sampleScene());
    // One grey texel a face.
    constexpr const char* face =
        "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mNo"
        "AAAAggCB2kUIOwAAAABJRU5ErkJggg==";
    Json faces = Json::array();
    for (int i = 0; i < 6; ++i) {
        scene["images"].push_back({{"uri", face}});
        faces.push_back(i);
    }
    scene["extensionsUsed"].push_back("EXT_lights_image_based");
    scene["extensions"]["EXT_lights_image_based"]["lights"].push_back(
        {{"name", "hall"},
         {"intensity", 0.5},
         {"specularImageSize", 1},
         {"irradianceCoefficients", Json::array()},
         {"specularImages", Json::array({faces})}});
    scene["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 0;
    folder.write("hall.gltf", scene.dump());
    EXPECT_EQ(listed("hall.gltf"), "\"hall\": 4x2, intensity 0.5, seen behind the scene\n");
}

}  // namespace
