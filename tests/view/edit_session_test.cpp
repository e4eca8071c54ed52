// An edit in the window gives the image of a scene that has it from the start.

#include "interaction.h"
#include "sample_scene.h"
#include "temporary_config.h"
#include "view_session.h"

#include <candela/error.h>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using candela::test::configText;
using Visibility = candela::GpuScene::Visibility;

class EditSession : public ViewTest {
  protected:
    /// Writes the sample scene, modified by `change`, as a file of this name.
    template <typename Change>
    void writeChanged(const std::string& name, Change&& change) const {
        nlohmann::json scene = nlohmann::json::parse(std::ifstream(folder / "square.gltf"));
        change(scene);
        folder.write(name, scene.dump());
    }

    static std::vector<std::string> small(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--size", smallSize});
        return arguments;
    }
    void expectPicture(ViewSession& session, std::vector<std::string> arguments) const {
        EXPECT_EQ(maxDifference(session.picture(), rendered(small(std::move(arguments)))), 0);
    }
};

TEST_F(EditSession, AnEditedMaterialIsThatOfANewScene) {
    writeChanged("red.gltf", [](auto& scene) {
        auto& material = scene["materials"][0]["pbrMetallicRoughness"];
        material["baseColorFactor"] = {0.75, 0.0625, 0.03125, 1};
        material["metallicFactor"] = 0.5;
        material["roughnessFactor"] = 0.25;
    });
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    candela::Material material = session.document().scene().materials[0];
    material.baseColor = {0.75f, 0.0625f, 0.03125f, 1.0f};
    material.metallic = 0.5f;
    material.roughness = 0.25f;
    session.document().setMaterial(0, material);
    expectPicture(session, {"red.gltf"});
    ASSERT_EQ(session.document().changes().size(), 1u);
    EXPECT_NE(session.document().changes()[0].find("material 0"), std::string::npos);
}

TEST_F(EditSession, ANodeIsHiddenAndShownAgain) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    session.document().setVisibility(0, Visibility::hidden);
    EXPECT_EQ(session.picture().colors(), 1u);
    EXPECT_EQ(session.document().changes().size(), 1u);
    session.document().setVisibility(0, Visibility::shown);
    expectPicture(session, {"square.gltf"});
    EXPECT_TRUE(session.document().changes().empty());
}

TEST_F(EditSession, ScatteredLightsAreThoseOfTheCommandLine) {
    ViewSession session(small({"square.gltf", "--scatter-lights", "500"}));
    session.awaitScene();
    expectPicture(session, {"square.gltf", "--scatter-lights", "500"});
    session.document().scatterLights({.count = 40, .range = 1.0f, .candela = 0.5f, .seed = 9});
    expectPicture(session, {"square.gltf", "--scatter-lights", "40,1,0.5,9"});
    EXPECT_EQ(session.document().lights().size(), 41u);
    session.document().scatterLights({.count = 0, .range = {}, .candela = {}});
    expectPicture(session, {"square.gltf"});
    EXPECT_TRUE(session.document().changes().empty());
}

TEST_F(EditSession, DefaultLightsAreThoseOfTheCommandLine) {
    writeChanged("dark.gltf", [](auto& scene) { scene["nodes"][1].erase("extensions"); });
    ViewSession session(small({"dark.gltf", "--environment", "none"}));
    session.awaitScene();
    expectPicture(session, {"dark.gltf", "--environment", "none"});
    EXPECT_TRUE(session.document().lights().empty()) << "they are not the scene's";
    session.model().options.camera = "1";
    session.step();
    expectPicture(session, {"dark.gltf", "--environment", "none", "--camera", "1"});
    session.model().options.display.exposure = 2.0;
    session.step();
    expectPicture(session, {"dark.gltf", "--environment", "none", "--camera", "1", "--exposure", "2"});
    session.model().options.defaultLights = DefaultLights::off;
    session.step();
    EXPECT_EQ(session.picture().colors(), 1u);
    session.model().options.defaultLights = DefaultLights::on;
    session.document().addLight({});
    session.step();
    EXPECT_EQ(session.document().lights().size(), 1u);
}

TEST_F(EditSession, TheEnvironmentIsThatOfTheCommandLine) {
    using enum EnvironmentOption::Source;
    ViewSession session(small({"square.gltf", "--environment", "sky,20"}));
    session.awaitScene();
    expectPicture(session, {"square.gltf", "--environment", "sky,20"});
    EXPECT_EQ(session.document().lights().size(), 1u) << "its sun is not the scene's";
    SceneOptions& options = session.model().options;
    options.environment.stops = -1.0;
    options.background = false;
    session.step();
    expectPicture(session, {"square.gltf", "--environment", "sky,20,-1", "--background", "off"});
    options.environment = {studio, "", 0.0, 0.0};
    options.background.reset();
    session.step();
    expectPicture(session, {"square.gltf", "--environment", "studio"});
    options.environment.source = none;
    session.step();
    expectPicture(session, {"square.gltf", "--environment", "none"});
    const EnvironmentOption before = options.environment;
    session.drop("absent.hdr");
    session.step();
    EXPECT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_EQ(options.environment.source, before.source);
    expectPicture(session, {"square.gltf", "--environment", "none"});
}

TEST_F(EditSession, ADroppedPictureBecomesTheEnvironment) {
    folder.write("grey.HDR", "#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x80\x80\x80\x80\x80");
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    session.drop("grey.HDR");
    session.step();
    expectPicture(session, {"square.gltf", "--environment", "grey.HDR"});
    EXPECT_EQ(session.document().scene().environment->picture.name, "grey.HDR");
}

TEST_F(EditSession, AutomaticExposureIsThatOfTheCommandLine) {
    ViewSession session(small({"square.gltf", "--exposure", "auto"}));
    session.awaitScene();
    session.step();
    const double measured = session.model().options.display.exposure;
    EXPECT_NE(measured, 0.0);
    session.model().options.display.exposure = 5.0;
    session.model().options.autoExposure = false;
    session.step();
    session.model().requests.measureExposure = true;
    session.step();
    EXPECT_DOUBLE_EQ(session.model().options.display.exposure, measured);
}

TEST_F(EditSession, TimeMovesTheLightsOfNodesAmongScatteredOnes) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    session.model().options.time = 0.25;
    session.step();
    expectPicture(session, {"square.gltf", "--time", "0.25"});
    session.document().scatterLights({.count = 30, .range = 1.0f, .candela = 0.5f, .seed = 1});
    expectPicture(session, {"square.gltf", "--time", "0.25", "--scatter-lights", "30,1,0.5"});
    session.model().options.time = 0.75;
    session.step();
    expectPicture(session, {"square.gltf", "--time", "0.75", "--scatter-lights", "30,1,0.5"});
}

TEST_F(EditSession, LightsAreScatteredAlikeAtEveryTime) {
    // The square grows: its box at 1 s is another one than at the start.
    writeChanged("growing.gltf",
                 [](auto& scene) { scene["animations"][0]["channels"][0]["target"]["node"] = 0; });
    ViewSession session(
        small({"growing.gltf", "--scatter-lights", "30", "--eye", "0,0,14", "--target", "0,0,0"}));
    session.awaitScene();
    session.model().options.time = 1.0;
    session.step();
    expectPicture(session, {"growing.gltf", "--scatter-lights", "30", "--eye", "0,0,14", "--target", "0,0,0",
                            "--time", "1"});
}

TEST_F(EditSession, TheUserTakesOverFromAnAnimatedCamera) {
    // "front" moves instead of the light: it stands at (0, 0, 5) after half a second.
    writeChanged("moving_camera.gltf",
                 [](auto& scene) { scene["animations"][0]["channels"][0]["target"]["node"] = 2; });
    ViewSession session(small({"moving_camera.gltf"}));
    session.awaitScene();
    session.model().options.time = 0.5;
    session.step();
    expectPicture(session, {"moving_camera.gltf", "--time", "0.5"});
    EXPECT_EQ(session.model().camera.eye(), glm::vec3(0.0f, 0.0f, 5.0f));
}

TEST_F(EditSession, TheUserTakesOverFromAViewThatFramesTheScene) {
    folder.write("plain.gltf", sampleSceneWithoutCameras());
    ViewSession session(small({"plain.gltf"}));
    session.awaitScene();
    const glm::vec3 wide = session.model().camera.eye();
    session.resize(100, 300);
    const glm::vec3 narrow = session.model().camera.eye();
    EXPECT_GT(glm::length(narrow), 1.5f * glm::length(wide)) << "a narrow window moves the camera back";
    const PngPicture framed = session.picture();
    storeCamera(session.model());
    session.step();
    // The user's camera has the framed centre as its target: the same view but for rounding.
    EXPECT_LE(maxDifference(session.picture(), framed), 3);
}

TEST_F(EditSession, TimeDoesNotMoveAViewThatFramesTheScene) {
    writeChanged("growing.gltf", [](auto& scene) {
        scene["animations"][0]["channels"][0]["target"]["node"] = 0;
        scene.erase("cameras");
        scene["nodes"].erase(3);
        scene["nodes"].erase(2);
        scene["scenes"][0]["nodes"] = {0, 1};
    });
    ViewSession session(small({"growing.gltf"}));
    session.awaitScene();
    const glm::vec3 eye = session.model().camera.eye();
    session.model().playing = true;
    ASSERT_TRUE(session.stepUntil([&] { return session.model().options.time > 0.2; }));
    session.model().playing = false;
    session.step();
    EXPECT_EQ(session.model().camera.eye(), eye);
    const PngPicture shown = session.picture();
    EXPECT_EQ(maxDifference(shown, renderedBy(session.copiedCommand())), 0);
}

TEST_F(EditSession, ALightIsReplacedAddedAndRemoved) {
    writeChanged("two.gltf", [](auto& scene) {
        scene["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 4;
        scene["extensions"]["KHR_lights_punctual"]["lights"].push_back(
            {{"type", "point"}, {"color", {0, 1, 0}}, {"intensity", 3}, {"range", 20}});
        scene["nodes"].push_back(
            {{"translation", {0.5, 0, 2}}, {"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
        scene["scenes"][0]["nodes"].push_back(4);
    });
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    candela::WorldLight light = session.document().lights()[0];
    const candela::WorldLight first = light;
    light.intensity = glm::vec3(4.0f);
    session.document().setLight(0, light);
    light.position = {0.5f, 0.0f, 2.0f};
    light.intensity = {0.0f, 3.0f, 0.0f};
    session.document().addLight(light);
    expectPicture(session, {"two.gltf"});
    session.document().removeLight(1);
    session.document().setLight(0, first);
    expectPicture(session, {"square.gltf"});
}

TEST_F(EditSession, AnInvalidLightIsRejectedAndChangesNothing) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    candela::WorldLight light = session.document().lights()[0];
    light.intensity = glm::vec3(-1.0f);
    EXPECT_THROW(session.document().setLight(0, light), candela::Error);
    session.document().setLightMotion({});  // uploads the lights again
    expectPicture(session, {"square.gltf"});
    EXPECT_TRUE(session.document().changes().empty());
}

TEST_F(EditSession, MovingLightsChangeTheImageAndStop) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    session.document().setLightMotion({.moving = true, .radius = 0.5f, .speed = 1.0f});
    session.model().playing = true;
    const double start = session.model().options.time;
    ASSERT_TRUE(session.stepUntil([&] { return session.model().options.time > start + 0.2; }));
    session.model().playing = false;
    session.step();
    const PngPicture moved = session.picture();
    session.step(5);
    EXPECT_EQ(maxDifference(session.picture(), moved), 0);
    EXPECT_GT(maxDifference(moved, rendered(small({"square.gltf"}))), 2);
    session.document().setLightMotion({});
    session.model().options.time = 0.0;
    session.step();
    expectPicture(session, {"square.gltf"});
}

TEST_F(EditSession, DrawingOptionsAreThoseOfTheCommandLine) {
    ViewSession session(small({"plaza:64"}));
    session.awaitScene();
    session.model().options.brdf = candela::BrdfModel::gltf;
    session.model().options.technique = candela::Technique::volumes;
    expectPicture(session, {"plaza:64", "--brdf", "gltf", "--technique", "volumes"});
    session.model().options.debug.view = candela::DebugView::normals;
    expectPicture(session, {"plaza:64", "--show", "normals"});
    session.model().options.debug = {candela::DebugView::lightCount, {.wireframe = true, .cage = false}};
    expectPicture(session, {"plaza:64", "--show", "light_count,wireframe"});
    EXPECT_GT(session.model().maxLightCount, 0u);
}

TEST_F(EditSession, DisplayViewAndExposureAreThoseOfTheCommandLine) {
    ViewSession session(small({"plaza:64"}));
    session.awaitScene();
    session.model().options.display = {"Display P3", "Un-tone-mapped", "", 2.5};
    session.step();
    expectPicture(session,
                  {"plaza:64", "--display", "Display P3", "--view", "Un-tone-mapped", "--exposure", "2.5"});
    session.model().options.display = {"sRGB", "Raw", "", 0.0};
    session.step();
    expectPicture(session, {"plaza:64", "--view", "Raw"});
    session.model().options.display = {"sRGB", "ACES 1.0 SDR", "", 0.0};
    session.step();
    // Two runs may bake this view or not, which differ by a quarter of a code and its rounding.
    EXPECT_LE(maxDifference(session.picture(), rendered(small({"plaza:64", "--view", "ACES 1.0 SDR"}))), 1);
}

TEST_F(EditSession, AnUnknownViewIsAMessageAndKeepsTheImage) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    const PngPicture before = session.picture();
    session.model().options.display.view = "Unknown";
    session.step(5);
    EXPECT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_EQ(maxDifference(session.picture(), before), 0);
}

TEST_F(EditSession, AConfigChangesViewsAndWorkingSpace) {
    folder.write("aces.ocio",
                 configText("  aces_interchange: ACES2065-1\n  scene_linear: ACEScg\n",
                            "  - !<ColorSpace> {name: ACES2065-1, isdata: false}\n"
                            "  - !<ColorSpace>\n"
                            "    name: ACEScg\n"
                            "    to_scene_reference: !<BuiltinTransform> {style: ACEScg_to_ACES2065-1}\n"));
    ViewSession session(small({"square.gltf", "--view", "Raw"}));
    session.awaitScene();
    const PngPicture before = session.picture();
    session.model().requests.ocioConfig = "aces.ocio";
    session.step(2);
    EXPECT_EQ(session.messages(Message::Kind::error), 0u);
    expectPicture(session, {"square.gltf", "--ocio", "aces.ocio"});
    EXPECT_GT(maxDifference(session.picture(), before), 5) << "another working space";
    session.model().requests.ocioConfig = "absent.ocio";
    session.step(2);
    EXPECT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_EQ(session.model().options.ocio, "aces.ocio");
    expectPicture(session, {"square.gltf", "--ocio", "aces.ocio"});
    session.model().requests.ocioConfig = "";
    session.model().options.display.view = "";
    session.step(2);
    expectPicture(session, {"square.gltf"});
}

TEST_F(EditSession, EditsSurviveAChangeOfTheConfig) {
    ViewSession session(small({"square.gltf", "--scatter-lights", "20"}));
    session.awaitScene();
    session.model().options.time = 0.5;
    session.document().setVisibility(0, Visibility::hidden);
    session.document().scatterLights({.count = 10, .range = 2.0f, .candela = 1.0f, .seed = 3});
    session.model().requests.ocioConfig = "";
    session.step(2);
    EXPECT_EQ(session.picture().colors(), 1u);
    session.document().setVisibility(0, Visibility::shown);
    expectPicture(session, {"square.gltf", "--time", "0.5", "--scatter-lights", "10,2,1,3"});
}

}  // namespace
