// Which animations play: --animation, --loop and --list.

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

}  // namespace
