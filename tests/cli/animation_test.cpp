// Which animations play (--animation, --loop and --list), and what they change.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

/// The sample scene whose square goes from z = 1 to 9 in a second by the animation "There", and the same from
/// z = 9 to 1 by "Back"; seen from z = 12.
class Clips : public testing::Test {
  protected:
    Clips() {
        Json scene = Json::parse(sampleScene());
        scene["nodes"][3]["translation"] = {0, 0, 12};
        scene["animations"][0]["name"] = "There";
        scene["animations"][0]["channels"][0]["target"]["node"] = 0;
        scene["animations"].push_back(scene["animations"][0]);
        scene["animations"][1]["name"] = "Back";
        // The keys of "There" in the opposite order: two accessors of one vector each.
        scene["nodes"][1].erase("extensions");
        scene["materials"][0]["name"] = "paint";
        scene["accessors"].push_back(
            {{"bufferView", 2}, {"componentType", 5126}, {"count", 1}, {"type", "VEC3"}, {"byteOffset", 12}});
        scene["accessors"].push_back({{"bufferView", 1},
                                      {"componentType", 5126},
                                      {"count", 1},
                                      {"type", "SCALAR"},
                                      {"min", {0}},
                                      {"max", {0}}});
        scene["animations"][1]["samplers"][0] = {{"input", 5}, {"output", 4}};
        folder.write("clips.gltf", scene.dump());
    }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "16x16"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    /// The z coordinate of the square.
    float squareAt(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"clips.gltf", "-o", "a.exr", "--aov", "P", "--camera", "far"});
        expectSuccess(run(arguments));
        return readExr(folder / "a.exr").at("P.Z", 8, 8);
    }

    TemporaryFolder folder;
};

TEST_F(Clips, TheFirstPlaysAndTheOthersAreTold) {
    EXPECT_NEAR(squareAt({"--time", "0.5", "--quiet"}), 5.0f, 1e-5f);
    const CommandResult result = run({"clips.gltf"});
    EXPECT_NE(result.err.find("only 0 \"There\" plays; --animation selects others: 1 \"Back\""),
              std::string::npos)
        << result.err;
}

TEST_F(Clips, AnimationSelects) {
    EXPECT_NEAR(squareAt({"--animation", "Back"}), 9.0f, 1e-5f);
    EXPECT_NEAR(squareAt({"--animation", "1"}), 9.0f, 1e-5f);
    EXPECT_NEAR(squareAt({"--animation", "There"}), 1.0f, 1e-5f);
    EXPECT_NEAR(squareAt({"--animation", "all"}), 9.0f, 1e-5f) << "the last one applies";
    EXPECT_NEAR(squareAt({"--animation", "none"}), 0.0f, 1e-5f) << "as the file places it";
    expectFault(run({"clips.gltf", "--quiet", "--animation", "Run"}), "clips.gltf",
                "no animation \"Run\"; there are 0 \"There\", 1 \"Back\"");
}

TEST_F(Clips, HoldTheirEndOrRepeat) {
    EXPECT_NEAR(squareAt({"--time", "1.25"}), 9.0f, 1e-5f);
    EXPECT_NEAR(squareAt({"--time", "1.25", "--loop"}), 3.0f, 1e-5f);
}

TEST_F(Clips, MotionIsThatSinceTheFrameBefore) {
    expectSuccess(run({"clips.gltf", "-o", "m.exr", "--aov", "motion", "--camera", "far", "--time", "0.5",
                       "--fps", "12", "--samples", "1"}));
    const ExrPicture picture = readExr(folder / "m.exr");
    // The square comes from 12 - 5 + 8 / 12 m to 7 m. The pixel right below the middle is 1/16 of half the
    // picture from the axis: 7/16 m.
    const float expected = 7.0f / 16.0f * 8.0f * (1.0f / 7.0f - 1.0f / (7.0f + 8.0f / 12.0f));
    EXPECT_NEAR(picture.at("motion.X", 8, 8), expected, 1e-5f);
    EXPECT_NEAR(picture.at("motion.Y", 8, 8), expected, 1e-5f) << "down";
    EXPECT_NEAR(picture.at("motion.X", 7, 7), -expected, 1e-5f);
}

TEST_F(Clips, AreListed) {
    const auto list = [&](const char* kind) {
        const CommandResult result = runCommand({"--list", kind, "clips.gltf"}, {.folder = folder.path()});
        expectSuccess(result);
        return result.out;
    };
    EXPECT_EQ(list("animations"),
              "0 \"There\": 1 channel, to 1 s  (default)\n1 \"Back\": 1 channel, to 0 s\n");
    EXPECT_EQ(list("cameras"),
              "0 \"front\": perspective, 90 degrees  (default)\n1 \"far\": perspective, 90 degrees\n");
    EXPECT_EQ(list("materials"), "0 \"paint\"\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"clips.gltf"}) << "nothing is drawn";
    expectUsageError(runCommand({"--list", "cameras"}), "SCENE is missing");
}

/// The sample scene without light, whose square emits (0.5, 0.25, 0.125) times a strength that goes from 0 to
/// 1 in a second, by a pointer.
class Pointers : public testing::Test {
  protected:
    Pointers() {
        scene["nodes"][1].erase("extensions");
        Json& material = scene["materials"][0];
        material["emissiveFactor"] = {0.5, 0.25, 0.125};
        material["extensions"]["KHR_materials_emissive_strength"] = Json::object();
        // Accessor 1 is the times 0 and 1, which are the values too.
        animate("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", 1, 1);
    }
    void animate(const std::string& pointer, int times, int values) {
        Json& animation = scene["animations"][0];
        animation["samplers"] = {{{"input", times}, {"output", values}}};
        animation["channels"] = {
            {{"sampler", 0},
             {"target",
              {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", pointer}}}}}}}}};
    }
    ExrPicture drawn(std::vector<std::string> arguments) const {
        folder.write("scene.gltf", scene.dump());
        arguments.insert(arguments.begin(), {"scene.gltf", "-o", "a.exr", "--size", "16x16", "--quiet",
                                             "--default-lights", "off"});
        expectSuccess(runCommand(arguments, {.folder = folder.path()}));
        return readExr(folder / "a.exr");
    }
    float redAt(const std::vector<std::string>& arguments) const { return drawn(arguments).at("R", 8, 8); }

    Json scene = Json::parse(sampleScene());
    TemporaryFolder folder;
};

// Of half floats, which hold emission.
constexpr float halfStep = 1.0f / 2048.0f;

TEST_F(Pointers, ChangeMaterialsOverTime) {
    EXPECT_EQ(redAt({"--time", "0"}), 0.0f);
    EXPECT_NEAR(redAt({"--time", "0.75"}), 0.375f, 0.375f * halfStep);
    EXPECT_NEAR(redAt({"--time", "9"}), 0.5f, 0.5f * halfStep);
    EXPECT_NEAR(redAt({"--time", "1.25", "--loop"}), 0.125f, 0.125f * halfStep);
    EXPECT_NEAR(redAt({"--time", "0.5", "--animation", "none"}), 0.5f, 0.5f * halfStep)
        << "as the file has it";
}

TEST_F(Pointers, AreTakenAtTheTimesOfAnOpenShutter) {
    // From 0.25 s to 0.75 s, and from before the first key to 0.5 s: the mean of 0 and of 0 to 0.5.
    const std::vector<std::string> shutter{"--fps", "1", "--samples", "64"};
    const auto mean = [&](const char* time, const char* open) {
        std::vector<std::string> arguments(shutter);
        arguments.insert(arguments.end(), {"--time", time, "--shutter", open});
        return redAt(arguments);
    };
    // Times are evenly spread to 1 / 64 of the interval.
    EXPECT_NEAR(mean("0.5", "0.5"), 0.25f, 0.5f * 0.5f / 64.0f);
    EXPECT_NEAR(mean("0", "1"), 0.5f * 0.125f, 0.5f / 64.0f);
}

TEST_F(Pointers, ChangeTheCamera) {
    scene["accessors"].push_back(
        {{"bufferView", 1}, {"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}, {"byteOffset", 4}});
    const int one = static_cast<int>(scene["accessors"].size()) - 1;
    animate("/cameras/0/perspective/yfov", one, one);
    const ExrPicture animated = drawn({});
    EXPECT_NE(animated.channels, drawn({"--animation", "none"}).channels);
    scene["cameras"][0]["perspective"]["yfov"] = 1.0;
    EXPECT_EQ(animated.channels, drawn({"--animation", "none"}).channels);
}

}  // namespace
