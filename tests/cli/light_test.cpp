// Scenes without light, lights without ranges, and what the pictures tell about themselves.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

class Light : public testing::Test {
  protected:
    /// The sample scene after a change.
    void write(const std::string& name, const std::function<void(Json&)>& change) {
        Json scene = Json::parse(sampleScene());
        change(scene);
        folder.write(name, scene.dump());
    }
    /// A grey square without a light.
    void writeDark() {
        write("dark.gltf", [](Json& scene) {
            scene["nodes"][1].erase("extensions");
            scene["materials"][0]["pbrMetallicRoughness"] = {
                {"baseColorFactor", {0.18, 0.18, 0.18, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
        });
    }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "33x33"});
        const CommandResult result = runCommand(arguments, {.folder = folder.path()});
        expectSuccess(result);
        return result;
    }
    /// The green of the middle pixel.
    int middleOfPng(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"-o", "test.png"});
        run(arguments);
        return readPng(folder / "test.png").rgba[std::size_t{4} * (16 * 33 + 16) + 1];
    }
    float middleOfExr(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"-o", "test.exr"});
        run(arguments);
        return readExr(folder / "test.exr").at("G", 16, 16);
    }
    /// The notes of a run that contain `text`.
    int notes(std::vector<std::string> arguments, const std::string& text) const {
        const std::string err = run(std::move(arguments)).err;
        int count = 0;
        for (std::size_t at = err.find(text); at != err.npos; at = err.find(text, at + 1)) ++count;
        return count;
    }

    TemporaryFolder folder;
};

/// sRGB's code of 0.18; the specular lobe and dither move it by a few.
constexpr int midGreyCode = 118;

TEST_F(Light, DefaultLightsShowMidGreyAsMidGrey) {
    writeDark();
    EXPECT_NEAR(middleOfPng({"dark.gltf", "--environment", "none"}), midGreyCode, 4);
    EXPECT_NEAR(middleOfPng({"dark.gltf", "--environment", "none", "--exposure", "3"}), midGreyCode, 4)
        << "they follow the exposure";
    // Of the surface with its specular lobe, by `evaluateBrdf`. Half a step of the 8-bit base colour is
    // 0.0017.
    EXPECT_NEAR(middleOfExr({"dark.gltf", "--environment", "none"}), 0.1899f, 0.002f);
    EXPECT_EQ(middleOfExr({"dark.gltf", "--environment", "none", "--default-lights", "off"}), 0.0f);
    EXPECT_EQ(notes({"dark.gltf", "--environment", "none"}, "default lights"), 1);
    EXPECT_EQ(notes({"dark.gltf", "--environment", "none", "--quiet"}, "note"), 0);
}

TEST_F(Light, DefaultLightsMoveWithTheCamera) {
    writeDark();
    const auto from = [&](const char* eye) {
        return middleOfExr({"dark.gltf", "--environment", "none", "--eye", eye, "--target", "0,0,0"});
    };
    // The square faces the camera as much from the left as from the right; a light that stands still would
    // not light both alike.
    EXPECT_NEAR(middleOfExr({"dark.gltf", "--environment", "none", "--camera", "1"}), from("0,0,3"), 0.002f);
    EXPECT_GT(from("2,0,3"), 0.02f);
    EXPECT_GT(from("-2,0,3"), 0.02f);
}

TEST_F(Light, ASceneWithLightGetsNoDefaultLights) {
    folder.write("square.gltf", sampleScene());
    EXPECT_EQ(notes({"square.gltf"}, "default lights"), 0);
    EXPECT_EQ(middleOfExr({"square.gltf"}), middleOfExr({"square.gltf", "--default-lights", "off"}));
    EXPECT_GT(middleOfExr({"square.gltf", "--default-lights", "on"}), middleOfExr({"square.gltf"}) + 0.1f);
    EXPECT_EQ(notes({"square.gltf", "--default-lights", "on"}, "default lights"), 0) << "as asked for";
    writeDark();
    EXPECT_EQ(notes({"dark.gltf", "--scatter-lights", "10"}, "default lights"), 0);
    EXPECT_EQ(notes({"dark.gltf"}, "default lights"), 0) << "a studio lights it";
    write("glowing.gltf", [](Json& scene) {
        scene["nodes"][1].erase("extensions");
        scene["materials"][0]["emissiveFactor"] = {0, 0.5, 0};
    });
    EXPECT_EQ(middleOfExr({"glowing.gltf"}), 0.5f);
}

TEST_F(Light, AutomaticExposureBringsTheMedianToMidGrey) {
    write("grey.gltf", [](Json& scene) {
        scene.erase("animations");
        scene["extensions"]["KHR_lights_punctual"]["lights"] = {
            {{"type", "directional"}, {"intensity", 900}}};
        scene["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.5, 0.5, 1};
    });
    // Almost the same all over the square: dither, and the lobe of its roughness, are left.
    EXPECT_NEAR(middleOfPng({"grey.gltf", "--exposure", "auto"}), midGreyCode, 8);
    EXPECT_EQ(notes({"grey.gltf", "--exposure", "auto"}, "--exposure auto is"), 1);
}

TEST_F(Light, AutomaticExposureIsTheSameForAllFrames) {
    folder.write("square.gltf", sampleScene());
    run({"square.gltf", "--exposure", "auto", "--frames", "0-20", "-o", "all.#.png"});
    run({"square.gltf", "--exposure", "auto", "--frames", "20-20", "-o", "part.#.png"});
    EXPECT_EQ(readPng(folder / "all.20.png").rgba, readPng(folder / "part.20.png").rgba);
}

TEST_F(Light, PicturesThatShowNothingSaySo) {
    writeDark();
    folder.write("square.gltf", sampleScene());
    EXPECT_EQ(notes({"square.gltf", "--eye", "0,0,9", "--target", "0,0,10"}, "in view"), 1);
    EXPECT_EQ(
        notes({"dark.gltf", "--environment", "none", "--default-lights", "off"}, "lit: --default-lights on"),
        1);
    EXPECT_EQ(notes({"square.gltf", "--exposure", "-30"}, "--exposure auto brightens"), 1);
    EXPECT_EQ(notes({"square.gltf", "--exposure", "9"}, "--exposure auto darkens"), 1);
    EXPECT_EQ(notes({"square.gltf", "--exposure", "9", "--frames", "0-3"}, "in 4 of 4 pictures"), 1);
    EXPECT_EQ(notes({"square.gltf"}, "exposure auto"), 0);
    EXPECT_EQ(notes({"square.gltf", "--exposure", "9", "--quiet"}, "note"), 0);
}

TEST_F(Light, ManyDimLightsWithoutARangeAreNotLost) {
    write("dim.gltf", [](Json& scene) {
        scene["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 0.02}}};
        scene["animations"] = Json::array();
        scene.erase("animations");
        scene["nodes"][1]["translation"] = {0, 0, 3};
        for (int i = 0; i < 999; ++i) {
            scene["nodes"].push_back(scene["nodes"][1]);
            scene["scenes"][0]["nodes"].push_back(scene["nodes"].size() - 1);
        }
    });
    // 1,000 × 0.02 / 9 lux on a base colour of 0.25, without the specular lobe.
    const float diffuse = 1000.0f * 0.02f / 9.0f * 0.25f / 3.14159265f;
    EXPECT_GT(middleOfExr({"dim.gltf"}), 0.95f * diffuse);
    EXPECT_EQ(notes({"dim.gltf"}, "1000 lights without a range"), 1);
    EXPECT_EQ(notes({"dim.gltf", "--range-loss", "0.5"}, "at most 50 %"), 1);
}

TEST_F(Light, ScatteredLightsLightAnObjectFromOutside) {
    writeDark();
    // The lights hover on the side that the square faces.
    EXPECT_GT(middleOfExr({"dark.gltf", "--scatter-lights", "200"}), 0.01f);
    EXPECT_EQ(middleOfExr({"dark.gltf", "--scatter-lights", "200", "--eye", "0,0,-3", "--target", "0,0,0"}),
              0.0f);
}

}  // namespace
