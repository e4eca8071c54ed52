// Lights and cameras that the window has saved: candela-render draws them as the window shows them.

#include "view_session.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <fstream>

namespace {

using Visibility = candela::GpuScene::Visibility;

class LightSavingSession : public ViewTest {
  protected:
    static std::vector<std::string> small(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--size", smallSize});
        return arguments;
    }
    void save(ViewSession& session, const std::string& file) const {
        session.model().requests.saveLights = file;
        session.step();
    }
    nlohmann::json read(const std::string& file) const {
        return nlohmann::json::parse(std::ifstream(folder / file));
    }
};

/// Of every kind, with numbers that decimals do not have exactly.
void editLights(Document& document) {
    candela::WorldLight light = document.lights()[0];
    light.position = {0.7f, 0.1f, 1.3f};
    light.intensity = {3.3f, 0.7f, 0.011f};
    light.range = 0.0f;
    document.setLight(0, light);
    light.type = candela::LightType::spot;
    light.direction = glm::normalize(glm::vec3(-0.3f, 0.1f, -1.0f));
    light.innerConeAngle = 0.3f;
    light.outerConeAngle = 0.9f;
    light.radius = 0.2f;
    light.range = 7.7f;
    document.addLight(light);
    light.type = candela::LightType::directional;
    light.direction = glm::normalize(glm::vec3(0.3f, -0.9f, -1.0f));
    light.intensity = {0.1f, 0.2f, 0.9f};
    light.castsShadow = false;
    light.radius = 0.0f;
    document.addLight(light);
}

TEST_F(LightSavingSession, CandelaRenderDrawsWhatWasSaved) {
    ViewSession session(small({"square.gltf", "--scatter-lights", "7", "--samples", "4"}));
    session.awaitScene();
    editLights(session.document());
    save(session, "lights.gltf");
    EXPECT_EQ(session.messages(Message::Kind::error), 0u);
    const std::string command = session.copiedCommand();
    EXPECT_NE(command.find("--lights lights.gltf"), command.npos) << command;
    EXPECT_EQ(command.find("--scatter-lights"), command.npos) << command;
    EXPECT_TRUE(session.document().changes().empty());
    EXPECT_EQ(maxDifference(session.picture(), renderedBy(command)), 0);
    save(session, "lights.glb");
    EXPECT_EQ(maxDifference(renderedBy(session.copiedCommand()), renderedBy(command)), 0);

    const nlohmann::json file = read("lights.gltf");
    const auto& lights = file["extensions"]["KHR_lights_punctual"]["lights"];
    ASSERT_EQ(lights.size(), 10u);
    EXPECT_EQ(lights[1]["type"], "spot");
    EXPECT_EQ(lights[1]["extras"]["radius"], 0.2);
    EXPECT_EQ(lights[2]["extras"]["castsShadow"], false);
    for (const auto& light : lights)
        for (const double channel : light["color"]) EXPECT_LE(channel, 1.0) << "as the extension has it";
}

TEST_F(LightSavingSession, AnotherWindowBeginsWithThem) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    editLights(session.document());
    save(session, "lights.gltf");
    const PngPicture saved = session.picture();
    session.model().requests.open = "square.gltf";
    session.awaitScene();
    EXPECT_GT(maxDifference(session.picture(), saved), 0) << "of the scene alone";
    EXPECT_EQ(maxDifference(rendered(small({"square.gltf", "--lights", "lights.gltf"})), saved), 0);
}

TEST_F(LightSavingSession, UndoneEditsAreNoLongerThoseOfTheFile) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    candela::WorldLight light = session.document().lights()[0];
    light.intensity *= 0.5f;
    session.document().setLight(0, light);
    session.step();
    save(session, "lights.gltf");
    light.intensity *= 0.5f;
    session.document().setLight(0, light);
    session.step();
    const auto namesFile = [&] { return session.copiedCommand().find("--lights") != std::string::npos; };
    EXPECT_FALSE(namesFile());
    EXPECT_EQ(session.document().changes().size(), 1u);
    session.document().undo(session.model().options);
    EXPECT_TRUE(namesFile());
    EXPECT_EQ(maxDifference(session.picture(), renderedBy(session.copiedCommand())), 0);
    session.document().undo(session.model().options);
    EXPECT_FALSE(namesFile());
    EXPECT_TRUE(session.document().changes().empty()) << "as the scene has them";
    session.document().redo(session.model().options);
    EXPECT_TRUE(namesFile());
}

TEST_F(LightSavingSession, CamerasAreThoseOfTheSceneAndTheWindow) {
    ViewSession session(small({"square.gltf", "--camera", "1"}));
    session.awaitScene();
    save(session, "scene.gltf");
    ASSERT_EQ(read("scene.gltf")["cameras"].size(), 2u);
    session.drag(1, 160, 120, 200, 140);
    save(session, "lights.gltf");
    const nlohmann::json file = read("lights.gltf");
    ASSERT_EQ(file["cameras"].size(), 3u);
    EXPECT_EQ(file["cameras"][2]["name"], "candela-view");
    // Its matrix is made a rotation again, in single precision: an edge may cover another pixel's centre.
    const PngPicture moved = session.picture();
    const PngPicture drawn =
        rendered(small({"square.gltf", "--lights", "lights.gltf", "--camera", "candela-view"}));
    std::size_t others = 0;
    for (std::size_t i = 0; i < moved.rgba.size(); ++i)
        others += std::abs(int{moved.rgba[i]} - int{drawn.rgba[i]}) > 1;
    EXPECT_LE(others, 16u);
    EXPECT_EQ(maxDifference(rendered(small({"square.gltf", "--lights", "lights.gltf", "--camera", "far"})),
                            rendered(small({"square.gltf", "--camera", "far"}))),
              0)
        << "that of the file has taken its place";
}

TEST_F(LightSavingSession, TheStudioOfASceneWithoutLightStays) {
    nlohmann::json scene = read("square.gltf");
    scene["nodes"][1].erase("extensions");
    folder.write("dark.gltf", scene.dump());
    ViewSession session(small({"dark.gltf"}));
    session.awaitScene();
    candela::WorldLight light;
    light.position = {0.2f, 0.3f, 1.0f};
    session.document().addLight(light);
    save(session, "lights.gltf");
    EXPECT_EQ(maxDifference(session.picture(), renderedBy(session.copiedCommand())), 0);
    session.model().options.environment.source = EnvironmentOption::Source::none;
    session.step();
    EXPECT_EQ(maxDifference(session.picture(), renderedBy(session.copiedCommand())), 0)
        << "with the default lights of the window";
}

TEST_F(LightSavingSession, OtherEditsAreNamed) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    session.document().setVisibility(0, Visibility::hidden);
    save(session, "lights.gltf");
    EXPECT_NE(session.model().messages.back().text.find("does not include these edits: hidden node 0"),
              std::string::npos)
        << session.model().messages.back().text;
}

TEST_F(LightSavingSession, AFileThatCanNotBeWrittenIsAnErrorAndStays) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    save(session, "missing/lights.gltf");
    ASSERT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_NE(session.model().messages.back().text.find("missing/lights.gltf"), std::string::npos);
    EXPECT_EQ(session.copiedCommand().find("--lights"), std::string::npos);
    folder.write("lights.gltf", "as it was");
    while (!session.document().lights().empty()) session.document().removeLight(0);
    save(session, "lights.gltf");
    EXPECT_NE(session.model().messages.back().text.find("no light to save"), std::string::npos);
    std::ifstream kept(folder / "lights.gltf");
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), "as it was");
}

TEST_F(LightSavingSession, TheKeyAsksForTheName) {
    ViewSession session(small({"square.gltf"}));
    session.awaitScene();
    session.stepUntilIdle();
    session.sendFast("key --delay 0 ctrl+l");
    session.sendFast("key --delay 0 Return");
    EXPECT_TRUE(std::filesystem::exists(folder / "lights.gltf"));
}

}  // namespace
