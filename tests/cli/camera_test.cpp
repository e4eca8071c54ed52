// Where pictures are taken from: cameras by their names, and the automatic camera.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;

/// Pictures of 32 × 32 pixels of scenes that a test makes.
class CameraChoice : public testing::Test {
  protected:
    void write(const std::string& name, const Json& scene) const { folder.write(name, scene.dump()); }
    CommandResult run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"--size", "32x32", "--quiet"});
        return runCommand(arguments, {.folder = folder.path()});
    }
    ExrPicture exr(std::vector<std::string> arguments) const {
        arguments.insert(arguments.end(), {"-o", "test.exr", "--aov", "all"});
        expectSuccess(run(arguments));
        return readExr(folder / "test.exr");
    }
    /// The distance of the square of the sample scene in a picture by a camera before it.
    float distanceFrom(const std::string& scene, const std::string& camera) const {
        return exr({scene, "--camera", camera}).at("Z", 16, 16);
    }

    TemporaryFolder folder;
};

Json namedScene() {
    Json scene = Json::parse(sampleScene());
    scene["nodes"][2]["name"] = "Plan";
    scene["nodes"][3]["name"] = "Hero";
    return scene;
}

double coverage(const ExrPicture& picture) {
    double sum = 0.0;
    for (const float alpha : picture.channels.at("A")) sum += alpha;
    return sum / (picture.width * picture.height);
}

TEST_F(CameraChoice, ByTheNodesNameTheCamerasNameAndTheNumber) {
    write("a.gltf", namedScene());
    for (const char* text : {"Plan", "front", "0"}) EXPECT_FLOAT_EQ(distanceFrom("a.gltf", text), 3.0f);
    for (const char* text : {"Hero", "far", "1"}) EXPECT_FLOAT_EQ(distanceFrom("a.gltf", text), 6.0f);
    expectFault(run({"a.gltf", "--camera", "Villain"}), "a.gltf",
                "no camera \"Villain\"; there are 0 \"front\" of node \"Plan\", 1 \"far\" of node \"Hero\"");
}

TEST_F(CameraChoice, NodesGoBeforeCamerasAndNamesBeforeNumbers) {
    Json scene = namedScene();
    scene["nodes"][3]["name"] = "front";
    write("nodes.gltf", scene);
    EXPECT_FLOAT_EQ(distanceFrom("nodes.gltf", "front"), 6.0f);
    scene["nodes"][3]["name"] = "0";
    write("numbers.gltf", scene);
    EXPECT_FLOAT_EQ(distanceFrom("numbers.gltf", "0"), 6.0f);
}

TEST_F(CameraChoice, NumbersAreThoseOfTheFile) {
    Json scene = namedScene();
    scene["nodes"][2]["camera"] = 1;
    scene["nodes"][3]["camera"] = 0;
    write("swapped.gltf", scene);
    EXPECT_FLOAT_EQ(distanceFrom("swapped.gltf", "0"), 6.0f);
    EXPECT_FLOAT_EQ(distanceFrom("swapped.gltf", "1"), 3.0f);
    scene["nodes"][3].erase("camera");
    write("unplaced.gltf", scene);
    EXPECT_FLOAT_EQ(distanceFrom("unplaced.gltf", "1"), 3.0f);
    expectFault(run({"unplaced.gltf", "--camera", "0"}), "unplaced.gltf", "no camera \"0\"");
}

/// The square moves from z = 1 to 9, and no camera is in the file.
Json movingScene() {
    Json scene = Json::parse(sampleSceneWithoutCameras());
    scene["animations"][0]["channels"][0]["target"]["node"] = 0;
    return scene;
}

TEST_F(CameraChoice, TheAutomaticCameraIsTheSameForAllFrames) {
    write("a.gltf", movingScene());
    expectSuccess(run({"a.gltf", "-o", "all#.exr", "--frames", "23-24"}));
    expectSuccess(run({"a.gltf", "-o", "one#.exr", "--frames", "24"}));
    const ExrPicture last = readExr(folder / "one24.exr");
    EXPECT_EQ(readExr(folder / "all24.exr").channels, last.channels);
    EXPECT_GT(coverage(last), 0.01);
    EXPECT_LT(coverage(last), 0.9);
    EXPECT_GT(coverage(exr({"a.gltf"})), 0.01);
}

TEST_F(CameraChoice, TheAutomaticCameraLooksPastWhatIsFarAndTiny) {
    Json scene = Json::parse(sampleSceneWithoutCameras());
    const double alone = (write("alone.gltf", scene), coverage(exr({"alone.gltf"})));
    scene["nodes"].push_back({{"mesh", 0}, {"scale", {0, 0, 0}}, {"translation", {500, 0, 0}}});
    scene["scenes"][0]["nodes"].push_back(2);
    write("hidden.gltf", scene);
    EXPECT_EQ(coverage(exr({"hidden.gltf"})), alone);
    EXPECT_GT(alone, 0.4);
}

TEST_F(CameraChoice, TheAutomaticCameraLooksPastVerticesOfNoFace) {
    Json scene = Json::parse(sampleSceneWithoutCameras());
    write("square.gltf", scene);
    const ExrPicture expected = exr({"square.gltf"});
    // The square's four vertices and one at (1e6, 0, 0), which no triangle uses.
    const std::string bytes =
        "AACAvwAAgL8AAAAAAACAPwAAgL8AAAAAAACAPwAA"
        "gD8AAAAAAACAvwAAgD8AAAAAACR0SQAAAAAAAAAA";
    scene["buffers"].push_back(
        {{"byteLength", 60}, {"uri", "data:application/octet-stream;base64," + bytes}});
    scene["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 60}});
    scene["accessors"][0]["bufferView"] = 4;
    scene["accessors"][0]["count"] = 5;
    scene["accessors"][0]["max"] = {1e6, 1, 0};
    write("stray.gltf", scene);
    EXPECT_EQ(exr({"stray.gltf"}).channels, expected.channels);
}

TEST_F(CameraChoice, OrthographicCamerasShowSizesAtAnyDistance) {
    Json scene = namedScene();
    scene["cameras"][1] = {{"name", "far"},
                           {"type", "orthographic"},
                           {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"zfar", 100}, {"znear", 0}}}};
    write("plan.gltf", scene);
    const ExrPicture plan = exr({"plan.gltf", "--camera", "Hero"});
    EXPECT_EQ(coverage(plan), 0.25) << "a square of 2 m in a picture of 4 m";
    EXPECT_FLOAT_EQ(plan.at("Z", 16, 16), 6.0f);
    EXPECT_NEAR(plan.at("P.X", 16, 16), 4.0f / 64.0f, 1e-6f);
    EXPECT_NEAR(plan.at("P.Z", 16, 16), 0.0f, 1e-5f);
    // The same by the option, from any distance.
    for (const char* eye : {"0,0,6", "0,0,50"}) {
        const ExrPicture parallel = exr({"plan.gltf", "--eye", eye, "--target", "0,0,0", "--ortho", "4"});
        EXPECT_EQ(parallel.channels.at("A"), plan.channels.at("A"));
    }
    EXPECT_EQ(coverage(exr({"plan.gltf", "--camera", "Plan", "--ortho", "8"})), 0.0625);
    EXPECT_FLOAT_EQ(exr({"plan.gltf", "--camera", "Hero", "--fov", "90"}).at("Z", 16, 16), 6.0f);
    expectUsageError(run({"plan.gltf", "--ortho", "2", "--fov", "30"}), "exclude each other");
    expectUsageError(run({"plan.gltf", "--ortho", "0"}), "--ortho");
}

TEST_F(CameraChoice, NothingIsDrawnBeyondTheFarPlane) {
    Json scene = namedScene();
    scene["cameras"][0]["perspective"]["zfar"] = 2.9;
    scene["cameras"][1]["perspective"]["zfar"] = 6.1;
    write("a.gltf", scene);
    EXPECT_EQ(coverage(exr({"a.gltf", "--camera", "Plan"})), 0.0);
    EXPECT_FLOAT_EQ(distanceFrom("a.gltf", "Hero"), 6.0f);
}

TEST_F(CameraChoice, SmallThingsAreSeenFromCloseBy) {
    Json scene = Json::parse(sampleSceneWithoutCameras());
    scene["nodes"][0]["scale"] = {0.001, 0.001, 0.001};
    write("screw.gltf", scene);
    const std::vector<std::string> eye{"--eye", "0,0,0.005", "--target", "0,0,0"};
    const auto seen = [&](const std::string& file) {
        return coverage(exr({file, eye[0], eye[1], eye[2], eye[3]}));
    };
    // 2 mm of 2 × 5 mm × tan(22.5°) = 4.14 mm, squared; pixels of a half at the edges.
    EXPECT_NEAR(seen("screw.gltf"), 0.233, 0.03);
    EXPECT_GT(coverage(exr({"screw.gltf"})), 0.4);
    // Beside something large.
    scene["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, -50}}});
    scene["scenes"][0]["nodes"].push_back(2);
    write("beside.gltf", scene);
    EXPECT_GT(exr({"beside.gltf", eye[0], eye[1], eye[2], eye[3]}).at("Z", 16, 16), 0.0049f);
    EXPECT_LT(exr({"beside.gltf", eye[0], eye[1], eye[2], eye[3]}).at("Z", 16, 16), 0.0051f);
}

}  // namespace
