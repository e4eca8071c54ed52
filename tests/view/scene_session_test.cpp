// Scenes are opened by the command line and by dropping files, fail to open, and are closed.

#include "view_session.h"

#include <epoxy/gl.h>
// After epoxy, which replaces the OpenGL headers that GLFW would include.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <nlohmann/json.hpp>

#include <array>
#include <fstream>

namespace {

class SceneSession : public ViewTest {};

TEST_F(SceneSession, ShowsTheImageOfCandelaRender) {
    ViewSession session({"plaza:64", "--size", smallSize});
    session.awaitScene();
    EXPECT_EQ(maxDifference(session.picture(), rendered({"plaza:64", "--size", smallSize})), 0);
    EXPECT_TRUE(session.model().messages.size() == 1) << "the note about the written file";
}

TEST_F(SceneSession, OpensADroppedFile) {
    ViewSession session({"--size", smallSize});
    session.step(3);
    EXPECT_FALSE(session.model().document);
    session.drop(folder / "square.gltf");
    ASSERT_TRUE(session.model().document);
    EXPECT_EQ(session.model().options.scene, folder / "square.gltf");
    const PngPicture square = rendered({"square.gltf", "--size", smallSize});
    EXPECT_EQ(maxDifference(session.picture(), square), 0);
    EXPECT_GT(square.colors(), 20u);
    EXPECT_EQ(session.model().recent, std::vector<std::string>{folder / "square.gltf"});
}

TEST_F(SceneSession, ShowsAnotherVariant) {
    using Json = nlohmann::json;
    Json scene;
    std::ifstream(folder / "square.gltf") >> scene;
    scene["materials"].push_back(
        {{"emissiveFactor", {1, 0, 0}}, {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 1}}}}});
    scene["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}}};
    for (Json& mesh : scene["meshes"])
        for (Json& primitive : mesh["primitives"])
            primitive["extensions"]["KHR_materials_variants"]["mappings"] = {
                {{"material", scene["materials"].size() - 1}, {"variants", {0}}}};
    folder.write("looks.gltf", scene.dump());
    ViewSession session({"looks.gltf", "--size", smallSize});
    session.awaitScene();
    const PngPicture plain = session.picture();
    session.model().requests.variant = "red";
    session.step();
    EXPECT_EQ(session.model().options.variant, "red");
    EXPECT_EQ(
        maxDifference(session.picture(), rendered({"looks.gltf", "--size", smallSize, "--variant", "red"})),
        0);
    EXPECT_NE(maxDifference(session.picture(), plain), 0);
    session.model().requests.variant = "";
    session.step();
    EXPECT_EQ(maxDifference(session.picture(), plain), 0);
}

TEST_F(SceneSession, AnotherSceneStartsWithItsOwnCameraAndLights) {
    ViewSession session({"plaza:64", "--size", smallSize, "--eye", "1,2,3", "--target", "0,0,0", "--fov",
                         "30", "--scatter-lights", "10", "--time", "0.5"});
    session.awaitScene();
    session.drop(folder / "square.gltf");
    EXPECT_EQ(maxDifference(session.picture(), rendered({"square.gltf", "--size", smallSize})), 0);
}

TEST_F(SceneSession, KeepsTheSceneWhenAFileFails) {
    folder.write("broken.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": 7}");
    folder.write("cut.glb", "glTF\2");
    folder.write("picture.jpg", "no plugin reads this");
    ViewSession session({"square.gltf", "--size", smallSize});
    session.awaitScene();
    const PngPicture before = session.picture();
    const Document* const document = session.model().document.get();
    for (const char* file : {"broken.gltf", "cut.glb", "picture.jpg", "absent.gltf", "."}) {
        const std::size_t errors = session.messages(Message::Kind::error);
        session.drop(file);
        ASSERT_EQ(session.messages(Message::Kind::error), errors + 1) << file;
        EXPECT_NE(session.model().messages.back().text.find(file), std::string::npos)
            << session.model().messages.back().text;
        EXPECT_EQ(session.model().document.get(), document);
        EXPECT_EQ(session.model().options.scene, "square.gltf");
        EXPECT_EQ(maxDifference(session.picture(), before), 0);
    }
}

TEST_F(SceneSession, ContinuesWithoutASceneWhenTheFirstFails) {
    ViewSession session({"absent.gltf", "--size", smallSize});
    session.awaitScene();
    EXPECT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_FALSE(session.model().document);
    session.drop("square.gltf");
    EXPECT_TRUE(session.model().document);
}

TEST_F(SceneSession, AnUnknownCameraIsAMessageAndNoScene) {
    ViewSession session({"square.gltf", "--size", smallSize, "--camera", "unknown"});
    session.awaitScene();
    ASSERT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_NE(session.model().messages.back().text.find("unknown"), std::string::npos);
    EXPECT_FALSE(session.model().document);
}

TEST_F(SceneSession, LoadingCanBeCancelled) {
    ViewSession session({"square.gltf", "--size", smallSize});
    session.awaitScene();
    const Document* const document = session.model().document.get();
    session.model().requests.open = "plaza:2000000";
    session.step(2);
    ASSERT_TRUE(session.model().loading);
    EXPECT_EQ(session.model().loading->scene, "plaza:2000000");
    session.model().requests.cancelLoading = true;
    session.step();
    EXPECT_TRUE(session.stepUntil([&] { return !session.model().loading; }));
    session.step(3);
    EXPECT_EQ(session.model().document.get(), document);
    EXPECT_EQ(session.messages(Message::Kind::error), 0u) << "cancelling is no error";
}

TEST_F(SceneSession, TheLastOfTwoScenesWins) {
    ViewSession session({"plaza:2000000", "--size", smallSize});
    session.step(2);
    session.drop("square.gltf");
    ASSERT_TRUE(session.model().document);
    EXPECT_EQ(session.model().options.scene, "square.gltf");
}

TEST_F(SceneSession, EndsWhileASceneIsRead) {
    ViewSession session({"plaza:2000000", "--size", smallSize});
    session.step(2);
    EXPECT_TRUE(session.model().loading);
}

TEST_F(SceneSession, FollowsTheSizeOfTheWindow) {
    ViewSession session({"plaza:64", "--size", smallSize});
    session.awaitScene();
    for (const auto& [width, height] : {std::pair(401, 203), std::pair(97, 300), std::pair(320, 240)}) {
        session.resize(width, height);
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        EXPECT_EQ(maxDifference(session.picture(), rendered({"plaza:64", "--size", size})), 0) << size;
    }
}

TEST_F(SceneSession, ClosingTheWindowEndsTheSessionAndKeepsItsSettings) {
    ViewSession session({"square.gltf", "--size", smallSize});
    session.awaitScene();
    session.model().panels.probe = true;
    glfwSetWindowShouldClose(session.window(), GLFW_TRUE);
    session.application().run();
    const auto settings = nlohmann::json::parse(std::ifstream(folder / "config/candela/view.json"));
    EXPECT_EQ(settings["panels"]["probe"], true);
}

TEST_F(SceneSession, AnInvalidSettingsFileIsAMessage) {
    std::filesystem::create_directories(folder / "config/candela");
    folder.write("config/candela/view.json", "{\"size\": \"large\"}");
    ViewSession session({"square.gltf"});
    session.awaitScene();
    ASSERT_EQ(session.messages(Message::Kind::note), 1u);
    EXPECT_NE(session.model().messages.back().text.find("view.json"), std::string::npos);
    EXPECT_EQ(session.model().options.width, 1280);
    EXPECT_TRUE(session.model().document);
}

TEST_F(SceneSession, AnImageThatCanNotBeWrittenIsAMessage) {
    ViewSession session({"square.gltf", "--size", smallSize});
    session.awaitScene();
    session.model().requests.savePng = folder / "nowhere/picture.png";
    session.step();
    ASSERT_EQ(session.messages(Message::Kind::error), 1u);
    EXPECT_NE(session.model().messages.back().text.find("nowhere"), std::string::npos);
    EXPECT_GT(session.picture().colors(), 20u);
}

/// The number of live objects of each kind in the context.
std::array<int, 9> objectsInUse() {
    // Names start at 1 and are reused: far fewer than this are ever in use here.
    constexpr GLuint maxName = 20'000;
    std::array<int, 9> counts{};
    for (GLuint name = 1; name <= maxName; ++name) {
        counts[0] += glIsTexture(name);
        counts[1] += glIsBuffer(name);
        counts[2] += glIsFramebuffer(name);
        counts[3] += glIsVertexArray(name);
        counts[4] += glIsProgram(name);
        counts[5] += glIsShader(name);
        counts[6] += glIsQuery(name);
        counts[7] += glIsSampler(name);
        counts[8] += glIsRenderbuffer(name);
    }
    return counts;
}

TEST_F(SceneSession, DeletesAllObjectsOfAReplacedScene) {
    ViewSession session({"plaza:64", "--size", smallSize});
    session.awaitScene();
    // The first round creates what lives as long as the window, such as programs.
    std::array<int, 9> first{};
    for (int round = 0; round < 4; ++round) {
        session.drop("square.gltf");
        session.resize(200 + 10 * round, 150);
        session.drop("absent.gltf");
        session.drop("plaza:64");
        session.resize(320, 240);
        session.picture();
        if (round == 0) first = objectsInUse();
    }
    EXPECT_EQ(objectsInUse(), first);
    EXPECT_GT(first[0], 10) << "there are textures to count";
}

}  // namespace
