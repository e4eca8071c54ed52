// Which variant is drawn: --variant and --list variants.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

/// The sample scene with variants "Red", whose square has a base colour of 1 in red, and "1", with 0.
class Variants : public testing::Test {
  protected:
    Variants() {
        Json scene = Json::parse(sampleScene());
        for (const double red : {1.0, 0.0}) {
            scene["materials"].push_back(scene["materials"][0]);
            scene["materials"].back()["pbrMetallicRoughness"]["baseColorFactor"][0] = red;
        }
        scene["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "Red"}}, {{"name", "1"}}};
        scene["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
            {{"material", 1}, {"variants", {0}}}, {{"material", 2}, {"variants", {1}}}};
        folder.write("looks.gltf", scene.dump());
    }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "16x16", "--quiet"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    /// The red of the square's base colour.
    float redOf(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"looks.gltf", "-o", "a.exr", "--aov", "base_color"});
        expectSuccess(run(arguments));
        return readExr(folder / "a.exr").at("base_color.R", 8, 8);
    }

    TemporaryFolder folder;
};

TEST_F(Variants, AreSelectedByNameOrNumber) {
    EXPECT_NEAR(redOf({}), 0.5f, 0.01f);
    EXPECT_NEAR(redOf({"--variant", "Red"}), 1.0f, 0.01f);
    EXPECT_NEAR(redOf({"--variant", "0"}), 1.0f, 0.01f);
    EXPECT_NEAR(redOf({"--variant", "1"}), 0.0f, 0.01f);
}

TEST_F(Variants, UnknownOnesAreAnErrorThatListsThem) {
    expectFault(run({"looks.gltf", "--variant", "Green"}), "looks.gltf",
                "no variant \"Green\"; there are 0 \"Red\", 1 \"1\"");
    folder.write("plain.gltf", sampleScene());
    expectFault(run({"plain.gltf", "--variant", "Red"}), "plain.gltf",
                "no variant \"Red\"; the scene has none");
}

TEST_F(Variants, AreListed) {
    const CommandResult result = runCommand({"--list", "variants", "looks.gltf"}, {.folder = folder.path()});
    expectSuccess(result);
    EXPECT_EQ(result.out, "0 \"Red\"\n1 \"1\"\n");
}

TEST_F(Variants, AreAmongTheContents) {
    const CommandResult result = runCommand({"--list", "contents", "looks.gltf"}, {.folder = folder.path()});
    expectSuccess(result);
    for (const char* line : {"triangles of meshes: 2\n", "meshes: 1\n", "variants: 2\n", "lights: 1\n",
                             "materials: 3\n", "missing: node 0: what 'VENDOR_unknown' adds to it"})
        EXPECT_NE(result.out.find(line), std::string::npos) << line << " in\n" << result.out;
    const CommandResult drawn = run({"looks.gltf", "-o", "a.png", "--stats", "-"});
    expectSuccess(drawn);
    const Json stats = Json::parse(drawn.out);
    EXPECT_EQ(stats["scene"]["variants"], 2);
    EXPECT_EQ(stats["notes"][0]["kind"], "missing");
}

}  // namespace
