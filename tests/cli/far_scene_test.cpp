// Scenes far from the origin of their file look as they do at the origin.

#include "command.h"
#include "picture_reader.h"
#include "sample_scene.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using Json = nlohmann::json;

class FarScene : public testing::Test {
  protected:
    ExrPicture picture(const std::string& name, const Json& scene,
                       const std::vector<std::string>& options = {}) const {
        folder.write(name, scene.dump());
        std::vector<std::string> arguments{name,  "-o",     "test.exr", "--aov",
                                           "all", "--size", "48x36",    "--quiet"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expectSuccess(runCommand(arguments, {.folder = folder.path()}));
        return readExr(folder / "test.exr");
    }

    TemporaryFolder folder;
};

/// The sample scene with some more in it: a second square, turned and small, before the first one.
Json scene() {
    Json scene = Json::parse(sampleScene());
    scene["nodes"].push_back({{"mesh", 0},
                              {"translation", {0.3, 0.2, 0.7}},
                              {"rotation", {0.2, 0.4, 0.1, 0.8888194}},
                              {"scale", {0.25, 0.5, 0.25}}});
    scene["scenes"][0]["nodes"].push_back(4);
    return scene;
}

/// Its nodes under one that stands at `x`, `y`, `z`.
Json movedAsAWhole(double x, double y, double z) {
    Json moved = scene();
    moved["nodes"].push_back({{"translation", {x, y, z}}, {"children", {0, 1, 2, 3, 4}}});
    moved["scenes"][0]["nodes"] = {5};
    return moved;
}

/// Each of its nodes moved by that, without the animation, whose keys do not move.
Json movedNodeByNode(double x, double y, double z) {
    Json moved = scene();
    moved.erase("animations");
    for (Json& node : moved["nodes"]) {
        const Json at = node.value("translation", Json({0.0, 0.0, 0.0}));
        node["translation"] = {at[0].get<double>() + x, at[1].get<double>() + y, at[2].get<double>() + z};
    }
    return moved;
}

double meanRelativeError(const ExrPicture& picture, const ExrPicture& expected) {
    double error = 0.0, sum = 0.0;
    for (const char* channel : {"R", "G", "B"}) {
        const auto &actual = picture.channels.at(channel), &right = expected.channels.at(channel);
        for (std::size_t i = 0; i < right.size(); ++i) {
            error += std::abs(double(actual[i]) - right[i]);
            sum += right[i];
        }
    }
    return error / sum;
}

// What the positions' last digits change: single precision within a few metres.
constexpr double tolerance = 1e-4;

TEST_F(FarScene, LooksAsAtTheOrigin) {
    const ExrPicture here = picture("here.gltf", scene());
    for (const double away : {5e5, 4e6, 4000000.3}) {
        SCOPED_TRACE(away);
        EXPECT_LT(meanRelativeError(picture("a.gltf", movedAsAWhole(away, away, 0.0)), here), tolerance);
        EXPECT_LT(meanRelativeError(picture("b.gltf", movedNodeByNode(away, -away, away)), here), tolerance);
    }
}

TEST_F(FarScene, IsComposedInDoublePrecision) {
    // A root in centimetres and turned, and the distance below it.
    Json nested = movedAsAWhole(0.0, 0.0, 0.0);
    const double half = std::sqrt(0.5);
    nested["nodes"][5] = {{"translation", {4e8, 1e8, 30.0}},
                          {"rotation", {0, 0, -half, half}},
                          {"scale", {100, 100, 100}},
                          {"children", {0, 1, 2, 3, 4}}};
    nested["nodes"].push_back(
        {{"rotation", {0, 0, half, half}}, {"scale", {0.01, 0.01, 0.01}}, {"children", {5}}});
    nested["scenes"][0]["nodes"] = {6};
    EXPECT_LT(meanRelativeError(picture("nested.gltf", nested), picture("here.gltf", scene())), tolerance);
}

TEST_F(FarScene, TellsPositionsInTheSpaceOfTheFile) {
    const ExrPicture far = picture("far.gltf", movedAsAWhole(4e6, -5e5, 64.0));
    // The square's middle; a float is off by a quarter of a metre there.
    EXPECT_NEAR(far.at("P.X", 20, 18), 4e6, 1.5);
    EXPECT_NEAR(far.at("P.Y", 20, 18), -5e5, 1.5);
    EXPECT_FLOAT_EQ(far.at("P.Z", 20, 18), 64.0f);
    EXPECT_FLOAT_EQ(far.at("Z", 20, 18), 3.0f);
}

TEST_F(FarScene, IsLookedAtFromAnEyeInTheSpaceOfTheFile) {
    const std::vector<std::string> here{"--eye", "0.4,0.3,2.6", "--target", "0.1,0,0"};
    const std::vector<std::string> there{"--eye", "4000000.4,-499999.7,2.6", "--target",
                                         "4000000.1,-500000,0"};
    const ExrPicture expected = picture("here.gltf", scene(), here);
    EXPECT_LT(meanRelativeError(picture("far.gltf", movedAsAWhole(4e6, -5e5, 0.0), there), expected),
              tolerance);
}

TEST_F(FarScene, IsFramedAndLitAsAtTheOrigin) {
    const std::vector<std::string> scattered{"--scatter-lights", "20"};
    const auto withoutCameras = [](Json scene) {
        for (Json& node : scene["nodes"]) node.erase("camera");
        return scene;
    };
    const ExrPicture here = picture("here.gltf", withoutCameras(scene()), scattered);
    const ExrPicture far = picture("far.gltf", withoutCameras(movedAsAWhole(5e5, 5e5, 0.0)), scattered);
    EXPECT_LT(meanRelativeError(far, here), tolerance);
}

TEST_F(FarScene, MovesAsAtTheOrigin) {
    const ExrPicture here = picture("here.gltf", scene(), {"--time", "0.3"});
    EXPECT_LT(meanRelativeError(picture("far.gltf", movedAsAWhole(4e6, 1e6, 3e5), {"--time", "0.3"}), here),
              tolerance);
}

}  // namespace
