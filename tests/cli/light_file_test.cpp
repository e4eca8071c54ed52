// --lights: the lights of another file in place of the scene's, and its cameras.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>

namespace {

using Json = nlohmann::json;

class LightFile : public testing::Test {
  protected:
    LightFile() { folder.write("square.gltf", sampleScene()); }
    /// The sample scene after a change.
    void write(const std::string& name, const std::function<void(Json&)>& change) const {
        Json scene = Json::parse(sampleScene());
        change(scene);
        folder.write(name, scene.dump());
    }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "33x33", "-o", "test.exr"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    ExrPicture drawn(std::vector<std::string> arguments) const {
        expectSuccess(run(std::move(arguments)));
        return readExr(folder / "test.exr");
    }
    std::string cameras(const std::string& lights) const {
        const CommandResult result =
            runCommand({"--list", "cameras", "square.gltf", "--lights", lights}, {.folder = folder.path()});
        expectSuccess(result);
        return result.out;
    }

    TemporaryFolder folder;
};

/// Another light, below a node, without the animation.
void otherLight(Json& scene) {
    scene.erase("animations");
    scene["nodes"][1]["translation"] = {-0.5, 0.25, 0.75};
    scene["extensions"]["KHR_lights_punctual"]["lights"][0] = {
        {"type", "spot"}, {"intensity", 3}, {"color", {1, 0.5, 0.25}}, {"extras", {{"castsShadow", false}}}};
}

TEST_F(LightFile, GivesThePictureOfASceneWithItsLights) {
    write("lit.gltf", otherLight);
    EXPECT_EQ(drawn({"square.gltf", "--lights", "lit.gltf", "--time", "0.5"}).channels,
              drawn({"lit.gltf", "--time", "0.5"}).channels)
        << "the animation of the light's node in the scene does not move it";
    EXPECT_EQ(drawn({"square.gltf", "--lights", "lit.gltf", "--scatter-lights", "9"}).channels,
              drawn({"lit.gltf", "--scatter-lights", "9"}).channels)
        << "others are scattered beside them";
}

TEST_F(LightFile, IsPlacedInTheFileOfAFarScene) {
    constexpr double far = 1048576.0;  // a float there has steps of 0.125
    const auto moveAll = [](Json& scene) {
        otherLight(scene);
        for (Json& node : scene["nodes"]) {
            const Json at = node.value("translation", Json({0.0, 0.0, 0.0}));
            node["translation"] = {at[0].get<double>() + far, at[1], at[2]};
        }
    };
    write("far.gltf", moveAll);
    write("rig.gltf", [&](Json& scene) {
        moveAll(scene);
        scene["nodes"][0].erase("mesh");
    });
    write("other.gltf", [&](Json& scene) {
        moveAll(scene);
        scene["nodes"][1]["translation"][1] = 5;
    });
    EXPECT_EQ(drawn({"other.gltf", "--lights", "rig.gltf"}).channels, drawn({"far.gltf"}).channels);
}

TEST_F(LightFile, ItsCamerasAreAddedOrTakeThePlaceOfThoseOfTheirName) {
    write("cameras.gltf", [](Json& scene) {
        scene["cameras"][0]["name"] = "side";
        scene["cameras"][1]["perspective"]["yfov"] = 0.5;
        scene["nodes"][2]["translation"] = {0, 0, 2};
    });
    const std::string list = cameras("cameras.gltf");
    EXPECT_NE(list.find("0 \"front\": perspective, 90 degrees"), list.npos) << list;
    EXPECT_NE(list.find("1 \"far\": perspective, 28.6479 degrees"), list.npos) << list;
    EXPECT_NE(list.find("2 \"side\": perspective, 90 degrees"), list.npos) << list;
    EXPECT_EQ(drawn({"square.gltf", "--lights", "cameras.gltf", "--camera", "side"}).channels,
              drawn({"cameras.gltf", "--camera", "side"}).channels);
}

TEST_F(LightFile, FaultsNameIt) {
    write("dark.gltf", [](Json& scene) { scene["nodes"][1].erase("extensions"); });
    folder.write("broken.gltf", "{");
    const auto fault = [&](const std::string& lights, const std::string& reason) {
        expectFault(run({"square.gltf", "--lights", lights, "--quiet"}), lights, reason);
    };
    fault("dark.gltf", "has no light");
    fault("absent.gltf", "there is no such file");
    fault("broken.gltf", "");
}

TEST_F(LightFile, TellsWhatIsLeftOut) {
    write("lit.gltf", [](Json& scene) { scene["nodes"][1]["translation"] = {0, 0, 1}; });
    const std::string err = run({"square.gltf", "--lights", "lit.gltf"}).err;
    EXPECT_NE(err.find("lit.gltf: its animations do not play"), err.npos) << err;
}

}  // namespace
